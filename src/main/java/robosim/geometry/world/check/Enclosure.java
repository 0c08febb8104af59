package robosim.geometry.world.check;

import robosim.geometry.model.GeometryObject;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.OwnLeaves;
import robosim.geometry.world.Extents;

/**
 * A box along the world's axes that surely holds an object, for finding who may be near whom; {@link Extents} are tighter.
 */
record Enclosure(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {
    static Enclosure of(GeometryObject object) {
        LeafColumn leaves = OwnLeaves.placed(object);
        double[] all = {1 / 0.0, 1 / 0.0, 1 / 0.0, -1 / 0.0, -1 / 0.0, -1 / 0.0};
        double[] one = new double[6];
        for (int leaf = 0; leaf < leaves.size(); leaf++) {
            leaves.bounds(leaf, one);
            for (int axis = 0; axis < 3; axis++) {
                all[axis] = Math.min(all[axis], one[axis]);
                all[axis + 3] = Math.max(all[axis + 3], one[axis + 3]);
            }
        }
        return new Enclosure(all[0], all[1], all[2], all[3], all[4], all[5]);
    }

    /** Along X and Z, from corner to corner. */
    double diagonal() {
        return StrictMath.hypot(maxX - minX, maxZ - minZ);
    }

    /** The smaller one of those along X and Z. */
    double narrow() {
        return Math.min(maxX - minX, maxZ - minZ);
    }

    /** Whether the two have a height in common. */
    boolean meetsLevels(Enclosure other) {
        return other.minY <= maxY && minY <= other.maxY;
    }

    /** The largest of all three. */
    double size() {
        return Math.max(maxY - minY, Math.max(maxX - minX, maxZ - minZ));
    }
}
