package robosim.geometry.engine.objects;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.Expansion;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.index.cells.PlacedCells;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * The bounds of a world: a closed box centred at the origin that every leaf must stay inside. Decided exactly for the
 * stored numbers: in doubles where that is certain, else in exact arithmetic.
 */
public final class WorldBounds {
    /**
     * In u = 2^-53 of the sum of the magnitudes: a box's extent is off by 3u (products, and the sum of three), a
     * cylinder's by 8u (the radius's share: a root 2u, a root 3u, a product and a quotient; the sum 1u); the sum with
     * the coordinate adds 1u, and the difference to half the world keeps its sign.
     */
    private static final double ROUNDING = 9.01 * 0x1p-53;

    private static final double FILTER = FilterBound.bound(4.01 * 0x1p-53);
    private static final double CYLINDER_FILTER = FilterBound.bound(ROUNDING);
    /** Shares of a way, and cosines, that differ by less are the same where a contact is described. */
    private static final double SAME = 0x1p-40;

    private static final StageCounters.Counter SUMS = StageCounters.counter("WorldBounds sums");
    private static final StageCounters.Counter EXACT = StageCounters.counter("WorldBounds");

    /** Half the world along x, y and z. */
    private final double[] half;

    private final Dimension dimension;
    private final double[] box = new double[6];

    /** A cell of a grid. */
    private final LeafColumn piece = new LeafColumn(1);

    /**
     * The terms of a sum that is added without rounding: two doubles, and a product of two parts for each half size.
     */
    private final double[] sum = new double[8];

    public WorldBounds(double width, double height, double length, Dimension dimension) {
        half = new double[] {width / 2, height / 2, length / 2};
        this.dimension = dimension;
    }

    private int step() {
        return dimension == Dimension.PLANAR ? 2 : 1;
    }

    /**
     * The share of a way along an axis during which an object keeps a clearance from the side of the world that it
     * comes nearer to: 0 where it is nearer at the start, +Infinity where it keeps it to the end.
     */
    public double share(LeafColumn column, int axis, double way, double clearance) {
        if (way == 0 || (axis == 1 && step() > 1)) {
            return Double.POSITIVE_INFINITY;
        }
        double room = Double.POSITIVE_INFINITY;
        for (int leaf = 0; leaf < column.size(); leaf++) {
            room = Math.min(room, half[axis] - reach(column, leaf, axis, way > 0 ? 1 : -1));
        }
        double spare = room - clearance - 0x1p-50 * half[axis];
        return spare >= Math.abs(way) ? Double.POSITIVE_INFINITY : Math.max(0, spare / Math.abs(way));
    }

    /** Whether some leaves of a column are inside, touching allowed. */
    public boolean holds(LeafColumn column, int first, int count) {
        for (int leaf = first; leaf < first + count; leaf++) {
            if (!holds(column, leaf)) {
                return false;
            }
        }
        return true;
    }

    /**
     * Whether a box, six numbers, is inside by such a margin that everything in it is inside despite rounding: the
     * margin is 2^-30 of half the world, and a coordinate within is rounded by at most 2^-53 of that.
     */
    public boolean clearlyHolds(double[] box) {
        for (int axis = 0; axis < 3; axis += step()) {
            double most = half[axis] * (1 - 0x1p-30);
            if (!(-box[axis] < most && box[3 + axis] < most)) {
                return false;
            }
        }
        return true;
    }

    /** The same along X and Z alone, for what stays at the heights at which it is. */
    public boolean clearlyHoldsSides(double[] box) {
        double mostX = half[0] * (1 - 0x1p-30);
        double mostZ = half[2] * (1 - 0x1p-30);
        return -box[0] < mostX && box[3] < mostX && -box[2] < mostZ && box[5] < mostZ;
    }

    /** Whether a box, six numbers, is inside to within rounding, touching allowed. */
    public boolean nearlyHolds(double[] box) {
        for (int axis = 0; axis < 3; axis += step()) {
            double slack = 2 * ROUNDING * (half[axis] + Math.abs(box[axis]) + Math.abs(box[3 + axis]));
            if (-box[axis] > half[axis] + slack || box[3 + axis] > half[axis] + slack) {
                return false;
            }
        }
        return true;
    }

    private boolean holds(LeafColumn column, int leaf) {
        LeafKind kind = column.kind(leaf);
        if (kind.isGrid()) {
            return holdsGrid(column, leaf);
        }
        if (kind.isMesh()) {
            column.bounds(leaf, box);
            if (clearlyHolds(box)) {
                return true;
            }
        }
        double[] row = column.rows();
        int at = leaf * Leaf.STRIDE;
        for (int axis = 0; axis < 3; axis += step()) {
            if (kind.isMesh()) {
                if (!holdsMesh(column.mesh(leaf), row, at, axis)) {
                    return false;
                }
            } else if (!holds(kind, row, at, axis, 1) || !holds(kind, row, at, axis, -1)) {
                return false;
            }
        }
        return true;
    }

    private boolean holdsGrid(LeafColumn column, int leaf) {
        column.bounds(leaf, box);
        if (clearlyHolds(box)) {
            return true;
        }
        PlacedCells cells = column.cells(leaf);
        if (cells.isAlongAxes()) { // then the outermost lines of all cells are those of one box, to the bit
            piece.setPiece(column, leaf, cells.map.next(0));
            cells.occupiedRectangle(piece.rows(), 0);
            return holds(piece, 0);
        }
        for (int cell = cells.map.next(0); cell >= 0; cell = cells.map.next(cell + 1)) {
            piece.setPiece(column, leaf, cell);
            if (!holds(piece, 0)) {
                return false;
            }
        }
        return true;
    }

    private boolean holdsMesh(TriangleMesh mesh, double[] row, int at, int axis) {
        for (int t = 0; t < mesh.size(); t++) {
            for (int corner = 0; corner < 3; corner++) {
                if (!(Math.abs(mesh.placed(mesh.vertex(t, corner), axis, row, at)) <= half[axis])) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean holds(LeafKind kind, double[] row, int at, int axis, int sign) {
        double reach = sign * row[at + axis] + extent(kind, row, at, axis);
        double bound = filter(kind) * (Math.abs(row[at + axis]) + extent(kind, row, at, axis) + half[axis]);
        if (Math.abs(reach - half[axis]) > bound) {
            return reach < half[axis];
        }
        if (!FilterBound.isOff() && fits(kind, row, at, axis)) {
            SUMS.count();
            return roomAsSum(kind, row, at, axis, sign) >= 0;
        }
        return holdsExactly(kind, row, at, axis, sign);
    }

    private static double filter(LeafKind kind) {
        return switch (kind) {
            case UPRIGHT_BOX, UPRIGHT_CYLINDER, SPHERE, BOX -> FILTER;
            case CYLINDER, UPRIGHT_CAPSULE, CAPSULE -> CYLINDER_FILTER;
            case TRIANGLE, PRISM, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    /** Whether a leaf's extent is a sum of numbers of its row, or of products of two that lose nothing. */
    private static boolean fits(LeafKind kind, double[] row, int at, int axis) {
        return switch (kind) {
            case UPRIGHT_BOX, BOX -> productsFit(row, at, axis);
            case UPRIGHT_CYLINDER, SPHERE -> true;
            case CYLINDER, UPRIGHT_CAPSULE, CAPSULE -> false;
            case TRIANGLE, PRISM, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    private static boolean productsFit(double[] row, int at, int axis) {
        int r = at + Leaf.ROTATION + 3 * axis;
        for (int k = 0; k < 3; k++) {
            if (!Expansion.fits(row[at + 3 + k], 2) || !Expansion.fits(row[r + k], 2)) {
                return false;
            }
        }
        return true;
    }

    /**
     * The sign of the room between a leaf and the world's bounds; exact, since all terms are added without rounding.
     */
    private int roomAsSum(LeafKind kind, double[] row, int at, int axis, int sign) {
        sum[0] = half[axis];
        int terms = Expansion.grow(sum, 1, -sign * row[at + axis]);
        if (!kind.isBox()) {
            return Expansion.sign(sum, Expansion.grow(sum, terms, -extent(kind, row, at, axis)));
        }
        int r = at + Leaf.ROTATION + 3 * axis;
        for (int k = 0; k < 3; k++) {
            double part = row[at + 3 + k] * -Math.abs(row[r + k]);
            if (part != 0) {
                terms = Expansion.grow(sum, terms, part);
                double tail = DoubleDouble.productTail(row[at + 3 + k], -Math.abs(row[r + k]), part);
                terms = tail == 0 ? terms : Expansion.grow(sum, terms, tail);
            }
        }
        return Expansion.sign(sum, terms);
    }

    /** How far a leaf extends from its centre along an axis of the world, to within rounding. */
    private static double extent(LeafKind kind, double[] row, int at, int axis) {
        int r = at + Leaf.ROTATION + 3 * axis;
        return switch (kind) {
            case SPHERE -> row[at + 3];
            case UPRIGHT_CYLINDER -> axis == 1 ? row[at + 4] : row[at + 3];
            case CYLINDER -> {
                double along = row[r + 1];
                double a = row[at + Leaf.ROTATION + 1 + 3 * ((axis + 1) % 3)];
                double b = row[at + Leaf.ROTATION + 1 + 3 * ((axis + 2) % 3)];
                double across = Math.sqrt(a * a + b * b);
                yield row[at + 4] * Math.abs(along) + row[at + 3] * across / Math.sqrt(along * along + across * across);
            }
            case UPRIGHT_CAPSULE -> (axis == 1 ? row[at + 4] : 0) + row[at + 3];
            case CAPSULE -> row[at + 4] * Math.abs(row[r + 1]) + row[at + 3];
            case UPRIGHT_BOX, BOX ->
                row[at + 3] * Math.abs(row[r])
                        + row[at + 4] * Math.abs(row[r + 1])
                        + row[at + 5] * Math.abs(row[r + 2]);
            case TRIANGLE, PRISM, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    private boolean holdsExactly(LeafKind kind, double[] row, int at, int axis, int sign) {
        EXACT.count();
        Dyadic room = Dyadic.difference(half[axis], sign * row[at + axis]);
        int r = at + Leaf.ROTATION + 3 * axis;
        return switch (kind) {
            case UPRIGHT_CYLINDER, SPHERE ->
                room.subtract(Dyadic.of(extent(kind, row, at, axis))).signum() >= 0;
            case UPRIGHT_CAPSULE, CAPSULE -> {
                double along = kind.isTurned() ? row[r + 1] : axis == 1 ? 1 : 0;
                yield room.subtract(Dyadic.product(row[at + 4], Math.abs(along)))
                                .subtract(Dyadic.of(row[at + 3]))
                                .signum()
                        >= 0;
            }
            case CYLINDER -> {
                Dyadic squared = Dyadic.ZERO;
                for (int k = 0; k < 3; k++) {
                    double a = row[at + Leaf.ROTATION + 1 + 3 * k];
                    squared = squared.add(Dyadic.product(a, a));
                }
                Dyadic rest = room.subtract(Dyadic.product(row[at + 4], Math.abs(row[r + 1])));
                Dyadic across = squared.subtract(Dyadic.product(row[r + 1], row[r + 1]));
                Dyadic radius = Dyadic.product(row[at + 3], row[at + 3]).multiply(across);
                yield rest.signum() >= 0
                        && rest.multiply(rest)
                                        .multiply(squared)
                                        .subtract(radius)
                                        .signum()
                                >= 0;
            }
            case UPRIGHT_BOX, BOX -> {
                for (int k = 0; k < 3; k++) {
                    room = room.subtract(Dyadic.product(row[at + 3 + k], Math.abs(row[r + k])));
                }
                yield room.signum() >= 0;
            }
            case TRIANGLE, PRISM, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    /**
     * The fraction of a translation after which leaves that are inside first touch the world's bounds: at most 1 if
     * they leave the world, to within rounding.
     */
    public double share(LeafColumn column, int first, int count, double dx, double dy, double dz) {
        double least = Double.POSITIVE_INFINITY;
        for (int leaf = first; leaf < first + count; leaf++) {
            for (int axis = 0; axis < 3; axis += step()) {
                double d = axis == 0 ? dx : axis == 1 ? dy : dz;
                if (d != 0) {
                    double room = half[axis] - reach(column, leaf, axis, d > 0 ? 1 : -1);
                    least = Math.min(least, Math.max(0, room) / Math.abs(d));
                }
            }
        }
        return least;
    }

    private static double reach(LeafColumn column, int leaf, int axis, int sign) {
        double[] row = column.rows();
        int at = leaf * Leaf.STRIDE;
        LeafKind kind = column.kind(leaf);
        if (!kind.isMesh()) {
            return sign * row[at + axis] + extent(kind, row, at, axis);
        }
        TriangleMesh mesh = column.mesh(leaf);
        double greatest = Double.NEGATIVE_INFINITY;
        for (int t = 0; t < mesh.size(); t++) {
            for (int corner = 0; corner < 3; corner++) {
                greatest = Math.max(greatest, sign * mesh.placed(mesh.vertex(t, corner), axis, row, at));
            }
        }
        return greatest;
    }

    /**
     * Finds where an object that would leave the world touches its bounds: on the side that it crosses and is nearest to, of
     * several on the one that it would cross most.
     *
     * @param beyond the bounds of all places of the object on the motion
     * @param column the object where it stops
     * @param out    a point of the world's bounds, then the unit normal there, inward
     */
    public void contact(double[] beyond, LeafColumn column, double[] out) {
        double[] within = box;
        column.bounds(0, column.size(), within);
        double soonest = Double.POSITIVE_INFINITY;
        double farthest = Double.NEGATIVE_INFINITY;
        int side = 1;
        int across = 0;
        for (int axis = 0; axis < 3; axis += step()) {
            for (int sign = -1; sign <= 1; sign += 2) {
                double now = sign > 0 ? within[3 + axis] : -within[axis];
                double over = (sign > 0 ? beyond[3 + axis] : -beyond[axis]) - now;
                if (!(over > 0)) {
                    continue;
                }
                double share = Math.max(0, (half[axis] - now) / over);
                boolean isSame = Math.abs(share - soonest) <= SAME;
                if (isSame ? over > farthest : share < soonest) {
                    soonest = share;
                    farthest = over;
                    side = sign;
                    across = axis;
                }
            }
        }
        for (int axis = 0; axis < 3; axis++) {
            out[3 + axis] = axis == across ? -side : 0;
        }
        farthestPoint(column, across, side, out);
        out[across] = side * half[across];
    }

    /** Writes a point of an object that is foremost along an axis; of a flat side its middle. */
    private static void farthestPoint(LeafColumn column, int axis, int sign, double[] out) {
        int foremost = 0;
        for (int leaf = 1; leaf < column.size(); leaf++) {
            if (reach(column, leaf, axis, sign) > reach(column, foremost, axis, sign)) {
                foremost = leaf;
            }
        }
        double[] row = column.rows();
        int at = foremost * Leaf.STRIDE;
        LeafKind kind = column.kind(foremost);
        if (kind.isMesh()) {
            farthestVertex(column.mesh(foremost), row, at, axis, sign, out);
            return;
        }
        System.arraycopy(row, at, out, 0, 3);
        switch (kind) {
            case UPRIGHT_BOX, BOX -> {
                for (int k = 0; k < 3; k++) {
                    advance(row, at, k, row[at + 3 + k], axis, sign, out);
                }
            }
            case CYLINDER -> {
                advance(row, at, 1, row[at + 4], axis, sign, out);
                rim(row, at, axis, sign, out);
            }
            case CAPSULE -> advance(row, at, 1, row[at + 4], axis, sign, out);
            case UPRIGHT_CYLINDER, UPRIGHT_CAPSULE, SPHERE -> {}
            case TRIANGLE, PRISM, MESH, SOLID_MESH, GRID -> throw kind.refused();
        }
    }

    /** Goes along one of a leaf's own axes, unless that is square to the world's axis. */
    private static void advance(double[] row, int at, int own, double by, int axis, int sign, double[] out) {
        double along = row[at + Leaf.ROTATION + 3 * axis + own];
        if (Math.abs(along) > SAME) {
            for (int k = 0; k < 3; k++) {
                out[k] += Math.signum(along) * sign * by * row[at + Leaf.ROTATION + 3 * k + own];
            }
        }
    }

    /** Goes from the middle of a cylinder's cap to the foremost point of its rim, unless the cap lies flat. */
    private static void rim(double[] row, int at, int axis, int sign, double[] out) {
        double along = row[at + Leaf.ROTATION + 3 * axis + 1];
        double across = Math.sqrt(Math.max(0, 1 - along * along));
        if (across > Math.sqrt(SAME)) {
            for (int k = 0; k < 3; k++) {
                double cap = row[at + Leaf.ROTATION + 3 * k + 1];
                out[k] += sign * row[at + 3] * ((k == axis ? 1 : 0) - along * cap) / across;
            }
        }
    }

    private static void farthestVertex(TriangleMesh mesh, double[] row, int at, int axis, int sign, double[] out) {
        double farthest = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < 3 * mesh.size(); k++) {
            int vertex = mesh.vertex(k / 3, k % 3);
            double along = sign * mesh.placed(vertex, axis, row, at);
            if (along > farthest) {
                farthest = along;
                for (int m = 0; m < 3; m++) {
                    out[m] = mesh.placed(vertex, m, row, at);
                }
            }
        }
    }
}
