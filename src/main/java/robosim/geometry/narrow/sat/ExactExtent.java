package robosim.geometry.narrow.sat;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * The extent of a leaf along a direction, without rounding: from {@code low} minus a root to {@code high} plus that
 * root, the root of {@code root / under}. In the plane the direction has y = 0.
 */
public record ExactExtent(Dyadic low, Dyadic high, Dyadic root, Dyadic under) {
    /** The extent of a leaf of any convex kind, along a direction of any length. */
    public static ExactExtent of(ExactVector n, Leaf leaf) {
        return switch (leaf.kind) {
            case UPRIGHT_BOX, BOX -> {
                Dyadic half = Dyadic.ZERO;
                for (int k = 0; k < 3; k++) {
                    Dyadic along = n.dot(ExactVector.of(leaf.row, leaf.at + Leaf.ROTATION + k, 3));
                    half = half.add(along.abs().multiply(Dyadic.of(leaf.get(Leaf.SIZE + k))));
                }
                yield around(n, leaf.row, leaf.at, half, Dyadic.ZERO, Dyadic.ONE);
            }
            case SPHERE ->
                around(n, leaf.row, leaf.at, Dyadic.ZERO, n.square().multiply(square(leaf.row, leaf.at)), Dyadic.ONE);
            case UPRIGHT_CAPSULE, CAPSULE -> {
                Dyadic half = n.dot(axis(leaf)).abs().multiply(Dyadic.of(leaf.get(4)));
                yield around(n, leaf.row, leaf.at, half, n.square().multiply(square(leaf.row, leaf.at)), Dyadic.ONE);
            }
            case UPRIGHT_CYLINDER, CYLINDER -> {
                ExactVector axis = axis(leaf);
                Dyadic half = n.dot(axis).abs().multiply(Dyadic.of(leaf.get(4)));
                Dyadic across = n.cross(axis).square();
                yield around(n, leaf.row, leaf.at, half, across.multiply(square(leaf.row, leaf.at)), axis.square());
            }
            case TRIANGLE -> {
                Dyadic a = n.dot(ExactVector.of(leaf.row, leaf.at, 1));
                Dyadic b = n.dot(ExactVector.of(leaf.row, leaf.at + 3, 1));
                Dyadic c = n.dot(ExactVector.of(leaf.row, leaf.at + 6, 1));
                yield new ExactExtent(a.min(b).min(c), a.max(b).max(c), Dyadic.ZERO, Dyadic.ONE);
            }
            case PRISM, MESH, SOLID_MESH, GRID -> throw leaf.kind.refused();
        };
    }

    /** The axis of a cylinder or capsule, as stored. */
    public static ExactVector axis(Leaf leaf) {
        return leaf.kind.isTurned()
                ? ExactVector.of(leaf.row, leaf.at + Leaf.ROTATION + 1, 3)
                : ExactVector.of(0, 1, 0);
    }

    /** The extent after a displacement by so much along the direction. */
    public ExactExtent movedBy(Dyadic by) {
        return new ExactExtent(low.add(by), high.add(by), root, under);
    }

    /** Sign of the gap from the end of this to the start of another: at least 0 where the other lies wholly beyond. */
    public int gapTo(ExactExtent beyond) {
        Dyadic gap = beyond.low.subtract(high);
        boolean plain = root.signum() == 0;
        if (plain || beyond.root.signum() == 0) {
            Dyadic one = plain ? beyond.root : root;
            return signLessRoot(gap, one, plain ? beyond.under : under);
        }
        if (gap.signum() <= 0) {
            return -1;
        }
        // gap against the root of p/s plus the root of q/t: gap^2 - p/s - q/t against twice the root of pq/(st).
        Dyadic both = under.multiply(beyond.under);
        Dyadic rest = gap.square()
                .multiply(both)
                .subtract(root.multiply(beyond.under))
                .subtract(beyond.root.multiply(under));
        return signLessRoot(rest, root.multiply(beyond.root).multiply(both).scale(2), Dyadic.ONE);
    }

    /** Sign of a number minus the root of a ratio. */
    private static int signLessRoot(Dyadic number, Dyadic root, Dyadic under) {
        return root.signum() == 0 || number.signum() < 0
                ? root.signum() == 0 ? number.signum() : -1
                : number.square().multiply(under).compareTo(root);
    }

    private static Dyadic square(double[] row, int at) {
        return Dyadic.of(row[at + Leaf.SIZE]).square();
    }

    private static ExactExtent around(ExactVector n, double[] row, int at, Dyadic half, Dyadic root, Dyadic under) {
        Dyadic middle = n.dot(ExactVector.of(row, at, 1));
        return new ExactExtent(middle.subtract(half), middle.add(half), root, under);
    }
}
