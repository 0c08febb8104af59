package robosim.geometry.dynamics.spatial;

import java.util.Arrays;
import robosim.geometry.engine.motion.Placer;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;

/** Copies of the convex pieces around a body: of other objects, and of the border of the world. */
final class NearbyPieces implements Placer.Pieces {
    private static final int FIRST = 64;

    int count;
    int[] object = new int[FIRST];
    LeafKind[] kind = new LeafKind[FIRST];

    /** {@link Leaf#STRIDE} numbers each. */
    double[] rows = new double[FIRST * Leaf.STRIDE];

    /** A unit direction that separates the body from the piece, three numbers each, and whether one is known. */
    double[] direction = new double[3 * FIRST];

    boolean[] isKnown = new boolean[FIRST];

    /** How far they were apart when that was measured, at least; minus infinity before. */
    double[] apart = new double[FIRST];

    /** The same, at most. */
    double[] most = new double[FIRST];

    private final Placer placer;
    private final double[] half;
    private final double[] box = new double[6];

    NearbyPieces(Placer placer, double[] half) {
        this.placer = placer;
        this.half = half;
    }

    /**
     * Finds all that is near a body on a straight way, or at a place.
     *
     * @param reach how far from the centre it may be
     */
    void find(RigidBody body, double dx, double dy, double dz, double reach) {
        count = 0;
        for (int axis = 0; axis < 3; axis++) {
            double by = axis == 0 ? dx : axis == 1 ? dy : dz;
            box[axis] = body.place[axis] + Math.min(0, by) - reach;
            box[3 + axis] = body.place[axis] + Math.max(0, by) + reach;
        }
        placer.around(body.id, box, this);
        for (int axis = 0; axis < 3; axis++) {
            if (box[axis] <= -half[axis]) {
                addBorder(axis, -1);
            }
            if (box[3 + axis] >= half[axis]) {
                addBorder(axis, 1);
            }
        }
    }

    @Override
    public void piece(int of, LeafKind as, double[] row, int at) {
        int to = claim(of, as);
        System.arraycopy(row, at, rows, to, Math.min(Leaf.STRIDE, row.length - at));
    }

    private int claim(int of, LeafKind as) {
        if (count == object.length) {
            object = Arrays.copyOf(object, 2 * count);
            kind = Arrays.copyOf(kind, 2 * count);
            rows = Arrays.copyOf(rows, 2 * count * Leaf.STRIDE);
            direction = Arrays.copyOf(direction, 6 * count);
            isKnown = Arrays.copyOf(isKnown, 2 * count);
            apart = Arrays.copyOf(apart, 2 * count);
            most = Arrays.copyOf(most, 2 * count);
        }
        isKnown[count] = false;
        apart[count] = Double.NEGATIVE_INFINITY;
        object[count] = of;
        kind[count] = as;
        return Leaf.STRIDE * count++;
    }

    /** A box beyond a side of the world, as large as what is looked at. */
    private void addBorder(int across, int sign) {
        int to = claim(-1, LeafKind.BOX);
        Arrays.fill(rows, to, to + Leaf.STRIDE, 0);
        double thick = box[3 + across] - box[across];
        for (int axis = 0; axis < 3; axis++) {
            double size = 0.5 * (box[3 + axis] - box[axis]);
            rows[to + axis] = axis == across ? sign * (half[axis] + thick) : box[axis] + size;
            rows[to + Leaf.SIZE + axis] = axis == across ? thick : 2 * size;
            rows[to + Leaf.ROTATION + 4 * axis] = 1;
        }
    }

    /** Whether two bodies pass through each other. */
    boolean arePassing(RigidBody one, RigidBody other) {
        return placer.passing.has(one.id, other.id);
    }

    /** Writes the leaf of a body at a place. */
    void leaf(RigidBody body, double[] place, LeafColumn out) {
        placer.leaves(body.id, place, out);
    }
}
