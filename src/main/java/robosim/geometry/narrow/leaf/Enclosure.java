package robosim.geometry.narrow.leaf;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Attitude;
import robosim.geometry.exact.Rotations;
import robosim.geometry.exact.UpwardRounding;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.exact.WorkCounter;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * The single leaf that stands for an object at an accuracy other than EXACT. Every enclosure is rounded outward by more
 * than the rounding of the numbers that it is computed from, so that it meets everything that the object itself meets.
 */
public final class Enclosure {
    /** Outward rounding, relative to the numbers used: at most some 30 roundings of 2^-53, times eight. */
    private static final double WIDEN = 0x1p-45;

    /** More than some 30 products lose to underflow. */
    private static final double UNDERFLOW = 64 * Double.MIN_VALUE;

    private static final double ROOT_TWO = 1.4142135623730951; // rounded up: the root of two is below

    private static final double[] IDENTITY = {1, 0, 0, 0, 1, 0, 0, 0, 1};

    private final Accuracy accuracy;
    private final LocalLeaves leaves;

    /** The leaves at the place in question, in a column of their own. */
    private final LeafColumn placed = new LeafColumn(1);

    /** Minimum and maximum along the object's own axes; for levels that turn with it. */
    private final double[] box = new double[6];

    /** Negative until it is first needed. */
    private double radius;

    private double levelRadius;

    /**
     * Whether one shape given by sizes is enclosed, about the object's centre and along its axes. Its enclosures have exactly this
     * centre, and sizes that depend on the attitude alone, so that they keep their shape as the object moves on.
     */
    private final boolean isCentred;

    /** For the corners of meshes that lie farthest out; null until the first. */
    private @Nullable MeshWalk walk;

    /** The attitude in which {@link #around} holds the object; NaN before the first. */
    private final double[] attitude = new double[9];

    /**
     * What holds the object in that attitude about its centre: pairs of bounds of x, z, x + z, x - z and y, the sums for
     * prisms only.
     */
    private final double[] around = new double[10];

    private final double[] halves = new double[5];
    private final double[] part = new double[6];

    private final double[] ownAttitude = new double[Attitude.STRIDE];

    /** Measures an object in its own frame, as far as the accuracy needs that. */
    public Enclosure(Accuracy accuracy, LocalLeaves own) {
        this.accuracy = accuracy;
        leaves = own;
        isCentred = own.size() == 1 && !own.hasMesh() && isInOwnFrame(own.own().rows());
        placed.append(own.size());
        measure();
    }

    /** The enclosure of an object of the same shape, which need not be measured again. */
    public Enclosure(Enclosure of) {
        accuracy = of.accuracy;
        leaves = of.leaves;
        isCentred = of.isCentred;
        placed.append(leaves.size());
        System.arraycopy(of.box, 0, box, 0, 6);
        radius = of.radius;
        levelRadius = of.levelRadius;
        System.arraycopy(of.attitude, 0, attitude, 0, 9);
        System.arraycopy(of.around, 0, around, 0, 10);
        System.arraycopy(of.placed.rows(), 0, placed.rows(), 0, isCentred ? Leaf.STRIDE : 0);
        System.arraycopy(of.halves, 0, halves, 0, halves.length);
    }

    /** Measures the leaves, which have changed. */
    void measure() {
        attitude[0] = Double.NaN;
        radius = -1;
        levelRadius = -1;
        if (isCentred) {
            measureCentred(leaves.own().kind(0), leaves.own().rows());
            return;
        }
        if (accuracy == Accuracy.AABB || accuracy == Accuracy.DOP) {
            return; // these are taken from the leaves as placed
        }
        LeafColumn column = leaves.own();
        Arrays.fill(box, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(box, 3, 6, Double.NEGATIVE_INFINITY);
        for (int leaf = 0; leaf < column.size(); leaf++) {
            if (column.kind(leaf).isMesh()) {
                walk().tightBounds(column, leaf, part);
            } else {
                LeafBounds.of(column.kind(leaf), column.rows(), leaf * Leaf.STRIDE, part);
            }
            include(part, box);
        }
    }

    /** The box of a shape given by sizes follows from these, and the ball of a ball. */
    private void measureCentred(LeafKind kind, double[] row) {
        boolean isBall = kind == LeafKind.SPHERE;
        double halfHeight = isBall ? row[3] : kind == LeafKind.CAPSULE ? UpwardRounding.sum(row[4], row[3]) : row[4];
        box[3] = row[3];
        box[4] = halfHeight;
        box[5] = kind.isRound() ? row[3] : row[5];
        for (int k = 0; k < 3; k++) {
            box[k] = -box[3 + k];
        }
        if (isBall) {
            radius = row[3];
            levelRadius = row[3];
        }
    }

    private static void include(double[] one, double[] all) {
        for (int k = 0; k < 3; k++) {
            all[k] = Math.min(all[k], one[k]);
            all[3 + k] = Math.max(all[3 + k], one[3 + k]);
        }
    }

    private MeshWalk walk() {
        MeshWalk made = walk;
        if (made == null) {
            made = new MeshWalk(new WorkCounter());
            walk = made;
        }
        return made;
    }

    /** The radius about the middle of the box, in all directions or only horizontally. */
    private double radius(boolean level) {
        double known = level ? levelRadius : radius;
        if (known < 0) {
            double farthest = 0;
            LeafColumn column = leaves.own();
            for (int leaf = 0; leaf < column.size(); leaf++) {
                farthest = Math.max(farthest, reach(column, leaf, level));
            }
            known = farthest + (WIDEN * size() + UNDERFLOW);
            if (level) {
                levelRadius = known;
            } else {
                radius = known;
            }
        }
        return known;
    }

    private double middle(int axis) {
        return box[axis] / 2 + box[3 + axis] / 2;
    }

    private double size() {
        double size = 0;
        for (double b : box) {
            size += Math.abs(b);
        }
        return size;
    }

    /** How far a leaf extends from the centre of the box, in all directions or only horizontally. */
    private double reach(LeafColumn column, int leaf, boolean level) {
        double[] row = column.rows();
        int at = leaf * Leaf.STRIDE;
        LeafKind kind = column.kind(leaf);
        double dx = row[at] - middle(0);
        double dy = level ? 0 : row[at + 1] - middle(1);
        double dz = row[at + 2] - middle(2);
        double centre = VectorMath.anyLength(dx, dy, dz);
        return switch (kind) {
            case SPHERE -> centre + row[at + 3];
            case CYLINDER -> {
                double ay = row[at + Leaf.ROTATION + 4];
                double half = row[at + 4];
                yield level && Math.abs(ay) == 1
                        ? centre + row[at + 3]
                        : cylinderReach(dx, dy, dz, row, at, half, row[at + 3]);
            }
            case CAPSULE -> capsuleReach(dx, dy, dz, row, at, level) + row[at + 3];
            case UPRIGHT_BOX, BOX -> boxReach(row, at, level);
            case MESH, SOLID_MESH -> meshReach(column.mesh(leaf), row, at, level);
            case UPRIGHT_CYLINDER, TRIANGLE, PRISM, UPRIGHT_CAPSULE, GRID -> throw kind.refused(); // nothing enclosed
        };
    }

    private static double cylinderReach(
            double dx, double dy, double dz, double[] row, int at, double half, double radius) {
        int r = at + Leaf.ROTATION + 1;
        double axial = Math.abs(dx * row[r] + dy * row[r + 3] + dz * row[r + 6]);
        double across = crossLength(dx, dy, dz, row, r);
        return VectorMath.legs(axial + half, across + radius);
    }

    /** How far the ends of a capsule's segment are from a point. */
    private static double capsuleReach(double dx, double dy, double dz, double[] row, int at, boolean level) {
        int r = at + Leaf.ROTATION + 1;
        double hx = row[at + 4] * row[r];
        double hy = level ? 0 : row[at + 4] * row[r + 3];
        double hz = row[at + 4] * row[r + 6];
        double one = VectorMath.anyLength(dx + hx, dy + hy, dz + hz);
        double two = VectorMath.anyLength(dx - hx, dy - hy, dz - hz);
        return Math.max(one, two);
    }

    private double boxReach(double[] row, int at, boolean level) {
        if (isCentred) { // all corners are as far
            return VectorMath.anyLength(row[at + 3], level ? 0 : row[at + 4], row[at + 5]);
        }
        double[] offset = new double[3];
        double farthest = 0;
        for (int corner = 0; corner < 8; corner++) {
            for (int axis = 0; axis < 3; axis++) {
                int r = at + Leaf.ROTATION + 3 * axis;
                double p = row[at + axis] - middle(axis);
                p += (corner & 1) == 0 ? -row[r] * row[at + 3] : row[r] * row[at + 3];
                p += (corner & 2) == 0 ? -row[r + 1] * row[at + 4] : row[r + 1] * row[at + 4];
                p += (corner & 4) == 0 ? -row[r + 2] * row[at + 5] : row[r + 2] * row[at + 5];
                offset[axis] = level && axis == 1 ? 0 : p;
            }
            farthest = Math.max(farthest, VectorMath.anyLength(offset[0], offset[1], offset[2]));
        }
        return farthest;
    }

    /** Whether the only leaf is no member of a group that may be placed and turned in it. */
    private static boolean isInOwnFrame(double[] row) {
        return row[0] == 0
                && row[1] == 0
                && row[2] == 0
                && Arrays.equals(row, Leaf.ROTATION, Leaf.ROTATION + 9, IDENTITY, 0, 9);
    }

    private double meshReach(TriangleMesh mesh, double[] row, int at, boolean level) {
        double farthest = 0;
        for (int t = 0; t < mesh.size(); t++) {
            for (int corner = 0; corner < 3; corner++) {
                int v = mesh.vertex(t, corner);
                double dx = mesh.placed(v, 0, row, at) - middle(0);
                double dy = level ? 0 : mesh.placed(v, 1, row, at) - middle(1);
                double dz = mesh.placed(v, 2, row, at) - middle(2);
                farthest = Math.max(farthest, VectorMath.anyLength(dx, dy, dz));
            }
        }
        return farthest;
    }

    /**
     * Writes the leaf that encloses the object at a place.
     *
     * @param rotation its attitude: nine numbers from {@code at} on
     */
    public void place(
            Dimension dimension, double cx, double cy, double cz, double[] rotation, int at, LeafColumn out, int leaf) {
        switch (accuracy) {
            case SPHERE, OBB -> placeMeasured(dimension, cx, cy, cz, rotation, at, out, leaf);
            case AABB, DOP -> {
                if (!isCentred) {
                    turnTo(rotation, at);
                    placeAround(cx, cy, cz, out, leaf);
                    return;
                }
                turnCentredTo(rotation, at);
                if (accuracy == Accuracy.AABB) {
                    placeBox(cx, cy, cz, out, leaf);
                } else {
                    placePrism(cx, cy, cz, out, leaf);
                }
            }
            case EXACT -> throw new IllegalArgumentException("accuracy must be below EXACT (got: EXACT)");
        }
    }

    /**
     * Measures the only leaf in an attitude, unless it was in that one last: writes its box to {@link #placed}, or how far it
     * extends to {@link #halves}.
     */
    private void turnCentredTo(double[] rotation, int at) {
        if (Arrays.equals(attitude, 0, 9, rotation, at, at + 9)) {
            return;
        }
        if (leaves.own().kind(0).isRound() && Rotations.isUpright(rotation, at)) {
            System.arraycopy(box, 3, placed.rows(), Leaf.SIZE, 3);
            Rotations.identity(placed.rows(), Leaf.ROTATION);
            double diagonal = ROOT_TWO * box[3];
            halves[0] = box[3];
            halves[1] = box[3];
            halves[2] = diagonal;
            halves[3] = diagonal;
            halves[4] = box[4];
        } else {
            leaves.place(0, 0, 0, rotation, at, placed, 0);
            if (accuracy == Accuracy.DOP) {
                measureHalves(placed.kind(0), placed.rows());
            } else if (!isAlongAxes(placed)) {
                LeafBounds.of(placed.kind(0), placed.rows(), 0, part);
                axisBox(part, placed, 0);
            }
        }
        System.arraycopy(rotation, at, attitude, 0, 9);
    }

    /** How far the placed leaf extends from its centre to either side, along the five directions of a prism. */
    private void measureHalves(LeafKind kind, double[] row) {
        halves[0] = halfExtent(kind, row, 0, 1, 0, 0, 1);
        halves[1] = halfExtent(kind, row, 0, 0, 0, 1, 1);
        halves[2] = halfExtent(kind, row, 0, 1, 0, 1, ROOT_TWO);
        halves[3] = halfExtent(kind, row, 0, 1, 0, -1, ROOT_TWO);
        halves[4] = halfExtent(kind, row, 0, 0, 1, 0, 1);
    }

    /** Writes the prism of these about a centre. */
    private void placePrism(double cx, double cy, double cz, LeafColumn out, int leaf) {
        double[] row = out.rows();
        int to = leaf * Leaf.STRIDE;
        double level = Math.abs(cx) + Math.abs(cz);
        range(row, to, cx, halves[0], Math.abs(cx));
        range(row, to + 2, cz, halves[1], Math.abs(cz));
        range(row, to + 4, cx + cz, halves[2], level);
        range(row, to + 6, cx - cz, halves[3], level);
        range(row, to + 8, cy, halves[4], Math.abs(cy));
        out.setKind(leaf, LeafKind.PRISM);
    }

    private static void range(double[] row, int to, double middle, double half, double size) {
        double widen = WIDEN * (size + half) + UNDERFLOW;
        row[to] = middle - half - widen;
        row[to + 1] = middle + half + widen;
    }

    /** Writes the upright box in {@link #placed} about a centre. */
    private void placeBox(double cx, double cy, double cz, LeafColumn out, int leaf) {
        double[] row = out.rows();
        int to = leaf * Leaf.STRIDE;
        System.arraycopy(placed.rows(), 0, row, to, Leaf.STRIDE);
        row[to] = cx;
        row[to + 1] = cy;
        row[to + 2] = cz;
        out.setKind(leaf, LeafKind.UPRIGHT_BOX);
    }

    /** Writes the leaf that encloses an object given by sizes where it stands; these leaves become its own. */
    public void placeSized(Dimension dimension, GeometryObject object, LeafColumn out, int leaf) {
        if (leaves.set(object)) {
            measure();
        }
        object.pose().attitude(ownAttitude, 0);
        Point c = object.center();
        place(dimension, c.x(), c.y(), c.z(), ownAttitude, 0, out, leaf);
    }

    private void placeMeasured(
            Dimension dimension, double cx, double cy, double cz, double[] rotation, int at, LeafColumn out, int leaf) {
        double[] row = out.rows();
        int to = leaf * Leaf.STRIDE;
        double widen = 0;
        if (isCentred) {
            row[to] = cx;
            row[to + 1] = cy;
            row[to + 2] = cz;
            // The axes of a box around a round shape are rounded, while a ball allows for that in its radius.
            boolean isRounded = accuracy == Accuracy.OBB && leaves.own().kind(0).isRound();
            widen = isRounded ? WIDEN * size() + UNDERFLOW : 0;
        } else {
            placeMiddle(cx, cy, cz, rotation, at, row, to);
            widen = widen(row, to);
        }
        if (accuracy == Accuracy.SPHERE) {
            out.setKind(leaf, LeafKind.SPHERE);
            row[to + 3] = radius(dimension == Dimension.PLANAR && Rotations.isUpright(rotation, at)) + widen;
            return;
        }
        for (int k = 0; k < 3; k++) {
            row[to + 3 + k] = Math.max(box[3 + k] - middle(k), middle(k) - box[k]) + widen;
        }
        System.arraycopy(rotation, at, row, to + Leaf.ROTATION, 9);
        out.setKind(leaf, UprightDetection.kind(LeafKind.BOX, row, to));
    }

    /** Measures the object about its centre in an attitude, unless it was in that one last. */
    private void turnTo(double[] rotation, int at) {
        if (Arrays.equals(attitude, 0, 9, rotation, at, at + 9)) {
            return;
        }
        leaves.place(0, 0, 0, rotation, at, placed, 0);
        for (int k = 0; k < 10; k += 2) {
            around[k] = Double.POSITIVE_INFINITY;
            around[k + 1] = Double.NEGATIVE_INFINITY;
        }
        for (int each = 0; each < placed.size(); each++) {
            extendAround(each, 0, 1, 0, 0);
            extendAround(each, 2, 0, 0, 1);
            extendAround(each, 8, 0, 1, 0);
            if (accuracy == Accuracy.DOP) {
                extendAround(each, 4, 1, 0, 1);
                extendAround(each, 6, 1, 0, -1);
            }
        }
        System.arraycopy(rotation, at, attitude, 0, 9);
    }

    private void extendAround(int leaf, int pair, double x, double y, double z) {
        if (placed.kind(leaf).isMesh()) {
            MeshWalk corners = walk();
            around[pair] = Math.min(around[pair], -corners.farthest(placed, leaf, -x, -y, -z));
            around[pair + 1] = Math.max(around[pair + 1], corners.farthest(placed, leaf, x, y, z));
        } else {
            extend(placed, leaf, around, pair, x, y, z);
        }
    }

    /** Writes what holds the object about a centre, in the attitude taken last. */
    private void placeAround(double cx, double cy, double cz, LeafColumn out, int leaf) {
        double size = Math.abs(cx) + Math.abs(cy) + Math.abs(cz);
        for (int k = 0; k < 4; k++) {
            size += Math.abs(around[k]);
        }
        size += Math.abs(around[8]) + Math.abs(around[9]);
        double widen = WIDEN * size + UNDERFLOW;
        if (accuracy == Accuracy.AABB) {
            part[0] = cx + around[0] - widen;
            part[1] = cy + around[8] - widen;
            part[2] = cz + around[2] - widen;
            part[3] = cx + around[1] + widen;
            part[4] = cy + around[9] + widen;
            part[5] = cz + around[3] + widen;
            axisBox(part, out, leaf);
            return;
        }
        double[] row = out.rows();
        int to = leaf * Leaf.STRIDE;
        shift(row, to, 0, cx, widen);
        shift(row, to, 2, cz, widen);
        shift(row, to, 4, cx + cz, widen);
        shift(row, to, 6, cx - cz, widen);
        shift(row, to, 8, cy, widen);
        out.setKind(leaf, LeafKind.PRISM);
    }

    private void shift(double[] row, int to, int pair, double by, double widen) {
        row[to + pair] = by + around[pair] - widen;
        row[to + pair + 1] = by + around[pair + 1] + widen;
    }

    /** Writes an enclosure that is wider by a margin on all sides as the only leaf of a column. */
    public static void widen(LeafColumn enclosures, int leaf, double margin, LeafColumn out) {
        LeafKind kind = enclosures.kind(leaf);
        double[] row = out.rows();
        System.arraycopy(enclosures.rows(leaf), enclosures.at(leaf), row, 0, Leaf.STRIDE);
        out.setKind(0, kind);
        switch (kind) {
            case SPHERE -> row[3] += margin;
            case UPRIGHT_BOX, BOX -> {
                row[3] += margin;
                row[4] += margin;
                row[5] += margin;
            }
            case PRISM -> {
                for (int pair = 0; pair < 10; pair += 2) {
                    row[pair] -= 2 * margin; // the sums of x and z reach farther by the root of two
                    row[pair + 1] += 2 * margin;
                }
            }
            case UPRIGHT_CYLINDER, CYLINDER, TRIANGLE, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID ->
                throw kind.refused();
        }
    }

    private static boolean isAlongAxes(LeafColumn placed) {
        double[] row = placed.rows();
        return placed.kind(0) == LeafKind.UPRIGHT_BOX && (row[Leaf.ROTATION] == 0 || row[Leaf.ROTATION + 2] == 0);
    }

    private void placeMiddle(double cx, double cy, double cz, double[] rotation, int at, double[] row, int to) {
        double x = middle(0);
        double y = middle(1);
        double z = middle(2);
        row[to] = rotation[at] * x + rotation[at + 1] * y + rotation[at + 2] * z + cx;
        row[to + 1] = rotation[at + 3] * x + rotation[at + 4] * y + rotation[at + 5] * z + cy;
        row[to + 2] = rotation[at + 6] * x + rotation[at + 7] * y + rotation[at + 8] * z + cz;
    }

    private double widen(double[] row, int to) {
        return WIDEN * (size() + Math.abs(row[to]) + Math.abs(row[to + 1]) + Math.abs(row[to + 2])) + UNDERFLOW;
    }

    private static void axisBox(double[] bounds, LeafColumn out, int leaf) {
        double[] row = out.rows();
        int to = leaf * Leaf.STRIDE;
        for (int k = 0; k < 3; k++) {
            row[to + k] = bounds[k] / 2 + bounds[3 + k] / 2;
            row[to + 3 + k] = Math.nextUp(Math.max(bounds[3 + k] - row[to + k], row[to + k] - bounds[k]));
        }
        Rotations.identity(row, to + Leaf.ROTATION);
        out.setKind(leaf, LeafKind.UPRIGHT_BOX);
    }

    /** Writes the prism around the only leaf of a column, which is not a mesh. */
    static void prism(LeafColumn placed, LeafColumn out) {
        double[] row = out.rows();
        for (int k = 0; k < 10; k += 2) {
            row[k] = Double.POSITIVE_INFINITY;
            row[k + 1] = Double.NEGATIVE_INFINITY;
        }
        extend(placed, 0, row, 0, 1, 0, 0);
        extend(placed, 0, row, 2, 0, 0, 1);
        extend(placed, 0, row, 4, 1, 0, 1);
        extend(placed, 0, row, 6, 1, 0, -1);
        extend(placed, 0, row, 8, 0, 1, 0);
        out.setKind(0, LeafKind.PRISM);
    }

    /** Extends one pair of the prism's bounds to include a leaf along (x, y, z). */
    private static void extend(LeafColumn placed, int leaf, double[] prism, int pair, double x, double y, double z) {
        double[] row = placed.rows();
        int at = leaf * Leaf.STRIDE;
        double middle = row[at] * x + row[at + 1] * y + row[at + 2] * z;
        double length = x != 0 && z != 0 ? ROOT_TWO : 1;
        double half = halfExtent(placed.kind(leaf), row, at, x, y, z, length);
        double size = Math.abs(row[at] * x) + Math.abs(row[at + 1] * y) + Math.abs(row[at + 2] * z) + half;
        hold(prism, pair, middle, half, size);
    }

    private static double halfExtent(LeafKind kind, double[] row, int at, double x, double y, double z, double length) {
        int r = at + Leaf.ROTATION;
        return switch (kind) {
            case SPHERE -> row[at + 3] * length;
            case UPRIGHT_CYLINDER -> y != 0 ? row[at + 4] : row[at + 3] * length;
            case UPRIGHT_CAPSULE -> (y != 0 ? row[at + 4] : 0) + row[at + 3] * length;
            case CAPSULE ->
                row[at + 4] * Math.abs(row[r + 1] * x + row[r + 4] * y + row[r + 7] * z) + row[at + 3] * length;
            case CYLINDER -> {
                double along = Math.abs(row[r + 1] * x + row[r + 4] * y + row[r + 7] * z);
                yield row[at + 4] * along + row[at + 3] * crossLength(x, y, z, row, r + 1);
            }
            case UPRIGHT_BOX, BOX ->
                row[at + 3] * Math.abs(row[r] * x + row[r + 3] * y + row[r + 6] * z)
                        + row[at + 4] * Math.abs(row[r + 1] * x + row[r + 4] * y + row[r + 7] * z)
                        + row[at + 5] * Math.abs(row[r + 2] * x + row[r + 5] * y + row[r + 8] * z);
            case TRIANGLE, PRISM, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    /**
     * The length of the component of (x, y, z) perpendicular to an own axis; as a cross product, which does not suffer
     * from cancellation.
     */
    private static double crossLength(double x, double y, double z, double[] row, int axis) {
        double a = y * row[axis + 6] - z * row[axis + 3];
        double b = z * row[axis] - x * row[axis + 6];
        double c = x * row[axis + 3] - y * row[axis];
        return VectorMath.anyLength(a, b, c);
    }

    private static void hold(double[] prism, int pair, double middle, double half, double size) {
        double widen = WIDEN * size + UNDERFLOW;
        prism[pair] = Math.min(prism[pair], middle - half - widen);
        prism[pair + 1] = Math.max(prism[pair + 1], middle + half + widen);
    }

    /** The leaves that are enclosed. */
    public LocalLeaves leaves() {
        return leaves;
    }
}
