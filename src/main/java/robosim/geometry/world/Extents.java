package robosim.geometry.world;

import java.util.List;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.narrow.LeafColumn;
import robosim.geometry.narrow.OwnLeaves;

/**
 * The box along the world's axes around objects, rounded outwards: how far they reach.
 *
 * @param minX the least X of any of them, in world units; above {@code maxX} where there is none
 */
public record Extents(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {
    private static final Extents NONE = new Extents(1 / 0.0, 1 / 0.0, 1 / 0.0, -1 / 0.0, -1 / 0.0, -1 / 0.0);

    /** Of all objects of a world. */
    public static Extents of(List<WorldObject> objects) {
        Extents extents = NONE;
        for (WorldObject object : objects) {
            extents = extents.and(of(object.object()));
        }
        return extents;
    }

    static Extents of(GeometryObject object) {
        LeafColumn leaves = OwnLeaves.placed(object);
        Extents extents = NONE;
        double[] b = new double[6];
        for (int leaf = 0; leaf < leaves.size(); leaf++) {
            leaves.bounds(leaf, b);
            extents = extents.and(new Extents(b[0], b[1], b[2], b[3], b[4], b[5]));
        }
        return extents;
    }

    private Extents and(Extents other) {
        return new Extents(
                Math.min(minX, other.minX),
                Math.min(minY, other.minY),
                Math.min(minZ, other.minZ),
                Math.max(maxX, other.maxX),
                Math.max(maxY, other.maxY),
                Math.max(maxZ, other.maxZ));
    }

    /** Whether there is nothing. */
    public boolean isEmpty() {
        return minX > maxX;
    }

    /** The least X (0), Y (1) or Z (2). */
    public double least(int axis) {
        return axis == 0 ? minX : axis == 1 ? minY : minZ;
    }

    /** The greatest X (0), Y (1) or Z (2). */
    public double most(int axis) {
        return axis == 0 ? maxX : axis == 1 ? maxY : maxZ;
    }

    /** The farthest from the origin along an axis, on either side. */
    double farthest(int axis) {
        return isEmpty() ? 0 : Math.max(Math.abs(least(axis)), Math.abs(most(axis)));
    }

    /** Along X and Z, from corner to corner. */
    double diagonal() {
        return Math.hypot(maxX - minX, maxZ - minZ);
    }

    /** The smaller one of those along X and Z. */
    double narrow() {
        return Math.min(maxX - minX, maxZ - minZ);
    }

    /** Whether the two have a height in common. */
    boolean meetsLevels(Extents other) {
        return other.minY <= maxY && minY <= other.maxY;
    }

    /** The largest of all three. */
    double size() {
        return Math.max(maxY - minY, Math.max(maxX - minX, maxZ - minZ));
    }
}
