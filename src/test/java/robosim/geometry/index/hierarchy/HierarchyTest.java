package robosim.geometry.index.hierarchy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.exact.BeamAxis;

/** The hierarchy and its cursors against a list of the same boxes. */
class HierarchyTest {
    private static final int MOST = 250;
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    /** What scenes are like. */
    private enum Scene {
        CUBE,
        COLUMNS,
        LATTICE,
        ONE_PLACE,
        TINY_AMONG_HUGE,
        FAR_OUT,
        GROWING
    }

    private final SplittableRandom random = new SplittableRandom(51);
    private final double[] boxes = new double[6 * MOST];
    private final TreeSet<Integer> in = new TreeSet<>();
    private int built;
    private final Hierarchy tree = new Hierarchy(() -> built++);
    private final Hierarchy other = new Hierarchy(() -> {});
    private final RayCursor rays = new RayCursor();
    private final BoxCursor inBox = new BoxCursor();
    private final ConeCursor cones = new ConeCursor();
    private final NearestCursor nearest = new NearestCursor();
    private int met;
    private int passedBy;

    @ParameterizedTest
    @EnumSource
    void findsWhatAListFinds(Scene scene) {
        for (double scale : new double[] {1, 0x1p-100, 0x1p90}) {
            for (int round = 0; round < Effort.cases(30); round++) {
                for (int k = 0; k < 30; k++) {
                    change(scene, random.nextInt(round < 25 ? MOST : 20), scale);
                }
                assertSound();
                for (int k = 0; k < 4; k++) {
                    askBox(scale);
                    askRay(scale);
                    askPoint(scale);
                    askCone(scale);
                }
            }
            for (int id : List.copyOf(in)) {
                tree.remove(id);
                in.remove(id);
            }
            assertSound();
        }
        assertThat(built).as("times it was built anew").isGreaterThan(Effort.cases(5));
        assertThat(met).isGreaterThan(Effort.cases(1000));
        assertThat(passedBy).isGreaterThan(Effort.cases(1000));
    }

    /** Adds, removes or moves an object: not at all, a little, or far. */
    private void change(Scene scene, int id, double scale) {
        if (!in.contains(id)) {
            place(scene, id, scale);
            tree.add(id, boxes);
            in.add(id);
        } else if (random.nextInt(3) == 0) {
            tree.remove(id);
            in.remove(id);
        } else if (random.nextInt(4) == 0) {
            place(scene, id, scale);
            tree.move(id, boxes);
        } else {
            double by = scale * random.nextDouble(-1, 1) * (random.nextBoolean() ? 0 : 1);
            for (int side = 0; side < 6; side++) {
                boxes[6 * id + side] += side % 3 == id % 3 ? by : 0;
            }
            tree.move(id, boxes);
        }
    }

    private void place(Scene scene, int id, double scale) {
        for (int axis = 0; axis < 3; axis++) {
            double center = random.nextDouble(-20, 20);
            double half = random.nextInt(5) == 0 ? 0 : random.nextDouble(1);
            switch (scene) {
                case CUBE -> {}
                case COLUMNS -> center = axis == 1 ? center : Math.rint(center / 10) * 10;
                case LATTICE -> {
                    center = Math.rint(center / 2) * 2;
                    half = 1;
                }
                case ONE_PLACE -> {
                    center = 5;
                    half = id % 3 == 0 ? half : 1;
                }
                case TINY_AMONG_HUGE -> half = id % 20 == 0 ? 15 : 1e-6 * half;
                case FAR_OUT -> center = id % 2 == 0 ? center : 1e6 + center;
                case GROWING -> {
                    half = Math.scalb(1, id % 60 - 30);
                    center = 3 * half;
                }
            }
            boxes[6 * id + axis] = scale * (center - half);
            boxes[6 * id + 3 + axis] = scale * (center + half);
        }
    }

    /** Every node has the bounds of its children, rounded outward, and at least two; every object hangs once. */
    private void assertSound() {
        tree.takeIn();
        Set<Integer> seen = new HashSet<>();
        assertSound(0, seen);
        assertThat(seen).isEqualTo(in);
        assertThat(tree.size()).isEqualTo(in.size());
    }

    private float[] assertSound(int node, Set<Integer> seen) {
        float[] all = {1 / 0f, 1 / 0f, 1 / 0f, -1 / 0f, -1 / 0f, -1 / 0f};
        int children = 0;
        for (int k = 0; k < Hierarchy.WIDTH; k++) {
            int at = Hierarchy.STRIDE * node + Hierarchy.PART * k;
            int link = Float.floatToRawIntBits(tree.nodes[Hierarchy.STRIDE * node + Hierarchy.LINKS + k]);
            float[] part = Arrays.copyOfRange(tree.nodes, at, at + Hierarchy.PART);
            if (link == Hierarchy.NONE) {
                assertThat(part[0]).isEqualTo(1 / 0f);
                continue;
            }
            children++;
            if (link >= 0) {
                assertThat(part).isEqualTo(assertSound(link, seen));
            } else {
                int id = link & Integer.MAX_VALUE;
                assertThat(seen.add(id)).isTrue();
                for (int axis = 0; axis < 3; axis++) {
                    assertThat((double) part[axis]).isLessThanOrEqualTo(boxes[6 * id + axis]);
                    assertThat((double) Math.nextUp(part[axis])).isGreaterThan(boxes[6 * id + axis]);
                    assertThat((double) part[3 + axis]).isGreaterThanOrEqualTo(boxes[6 * id + 3 + axis]);
                    assertThat((double) Math.nextDown(part[3 + axis])).isLessThan(boxes[6 * id + 3 + axis]);
                }
            }
            for (int axis = 0; axis < 3; axis++) {
                all[axis] = Math.min(all[axis], part[axis]);
                all[3 + axis] = Math.max(all[3 + axis], part[3 + axis]);
            }
        }
        assertThat(children >= 2 || node == 0).isTrue();
        return all;
    }

    private void askBox(double scale) {
        double[] box = new double[6];
        for (int axis = 0; axis < 3; axis++) {
            box[axis] = scale * random.nextDouble(-25, 20);
            box[3 + axis] = box[axis] + scale * random.nextDouble(12);
        }
        if (!in.isEmpty() && random.nextInt(3) == 0) { // touches one
            int id = in.ceiling(random.nextInt(in.last() + 1));
            box[0] = boxes[6 * id + 3];
            box[3] = Math.max(box[0], box[3]);
        }
        List<Integer> found = new ArrayList<>();
        inBox.startSettled(tree, box);
        for (int id = inBox.next(); id >= 0; id = inBox.next()) {
            found.add(id);
        }
        List<Integer> truth = new ArrayList<>();
        for (int id : in) {
            boolean meets = true;
            for (int axis = 0; axis < 3; axis++) {
                meets &= boxes[6 * id + axis] <= box[3 + axis] && box[axis] <= boxes[6 * id + 3 + axis];
            }
            if (meets) {
                truth.add(id);
            }
        }
        count(found, truth);
    }

    /** Rays from anywhere, also parallel to axes, along faces of boxes, nearly flat, and from far away. */
    private void askRay(double scale) {
        double[] d = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            int how = random.nextInt(6);
            d[axis] = how == 0 ? 0 : how == 1 ? random.nextDouble(-1e-14, 1e-14) : random.nextDouble(-1, 1);
        }
        double length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        if (length < 0.01) {
            return;
        }
        double[] o = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            d[axis] /= length;
            o[axis] = scale * random.nextDouble(-30, 30);
        }
        if (!in.isEmpty() && random.nextInt(2) == 0) {
            int id = in.ceiling(random.nextInt(in.last() + 1));
            double back = scale * random.nextDouble(0, 30);
            for (int axis = 0; axis < 3; axis++) {
                o[axis] = boxes[6 * id + axis + (random.nextBoolean() ? 3 : 0)] - back * d[axis];
            }
        }
        double limit = random.nextInt(4) == 0 ? INFINITE : scale * random.nextDouble(60);
        rays.aim(new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]), tree.most());
        rays.start(tree);
        List<Integer> found = new ArrayList<>();
        for (int id = rays.next(limit); id >= 0; id = rays.next(limit)) {
            found.add(id);
        }
        count(found, in.stream().filter(id -> meets(id, o, d, limit)).toList());
        if (scale == 1 && limit < INFINITE) {
            double slack = 1e-5 * (tree.most() + 30);
            assertThat(found).allMatch(id -> isNear(id, o, d, limit + slack, slack));
        }
    }

    /** Whether a ray meets a closed box within a limit, exactly. */
    private boolean meets(int id, double[] o, double[] d, double limit) {
        // All parameters are numbers over one denominator: the product of the components that are not 0.
        BigDecimal whole = BigDecimal.ONE;
        for (double each : d) {
            whole = each == 0 ? whole : whole.multiply(new BigDecimal(Math.abs(each)));
        }
        BigDecimal enter = BigDecimal.ZERO;
        BigDecimal leave = limit == INFINITE ? null : new BigDecimal(limit).multiply(whole);
        for (int axis = 0; axis < 3; axis++) {
            BigDecimal start = new BigDecimal(o[axis]);
            BigDecimal low = new BigDecimal(boxes[6 * id + axis]).subtract(start);
            BigDecimal high = new BigDecimal(boxes[6 * id + 3 + axis]).subtract(start);
            if (d[axis] == 0) {
                if (low.signum() > 0 || high.signum() < 0) {
                    return false;
                }
                continue;
            }
            BigDecimal others = BigDecimal.ONE;
            for (int other = 0; other < 3; other++) {
                others = other == axis || d[other] == 0 ? others : others.multiply(new BigDecimal(Math.abs(d[other])));
            }
            BigDecimal first = (d[axis] > 0 ? low : high.negate()).multiply(others);
            BigDecimal last = (d[axis] > 0 ? high : low.negate()).multiply(others);
            enter = enter.max(first);
            leave = leave == null ? last : leave.min(last);
        }
        return leave == null || enter.compareTo(leave) <= 0;
    }

    private boolean isNear(int id, double[] o, double[] d, double limit, double slack) {
        double enter = 0;
        double leave = limit;
        for (int axis = 0; axis < 3; axis++) {
            double a = (boxes[6 * id + axis] - slack - o[axis]) / d[axis];
            double b = (boxes[6 * id + 3 + axis] + slack - o[axis]) / d[axis];
            if (!Double.isNaN(a) && !Double.isNaN(b)) {
                enter = Math.max(enter, Math.min(a, b));
                leave = Math.min(leave, Math.max(a, b));
            }
        }
        return enter <= leave;
    }

    private void askPoint(double scale) {
        double[] p = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            p[axis] = scale * random.nextDouble(-20, 20);
        }
        double limit = random.nextInt(8) == 0 ? INFINITE : scale * random.nextDouble(15);
        nearest.around(p[0], p[1], p[2]);
        startNearest();
        List<Integer> found = new ArrayList<>();
        for (int id = nearest.next(limit); id >= 0; id = nearest.next(limit)) {
            found.add(id);
        }
        count(found, in.stream().filter(id -> distance(id, p) <= limit).toList());
    }

    /** In the first place or in the second, beside a hierarchy without objects. */
    private void startNearest() {
        if (random.nextBoolean()) {
            nearest.start(tree, other);
        } else {
            nearest.start(other, tree);
        }
    }

    private double distance(int id, double[] p) {
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double d = Math.max(0, Math.max(boxes[6 * id + axis] - p[axis], p[axis] - boxes[6 * id + 3 + axis]));
            square += d * d;
        }
        return Math.sqrt(square);
    }

    /** What a cone leaves out has a point of its box neither at the apex nor within the cone. */
    private void askCone(double scale) {
        double[] d = {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextBoolean() ? 1 : -1};
        if (random.nextInt(3) == 0) {
            Arrays.fill(d, 0);
            d[random.nextInt(3)] = random.nextBoolean() ? 1 : -1;
        }
        double length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        double half = StrictMath.toRadians(random.nextDouble(1, 89));
        double cos = StrictMath.cos(half);
        double limit = random.nextInt(8) == 0 ? INFINITE : scale * random.nextDouble(40);
        double[] o = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            d[axis] /= length;
            o[axis] = scale * random.nextDouble(-20, 20);
        }
        cones.aim(
                new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]).widen(cos, StrictMath.sin(half)), tree.most());
        boolean isFirst = random.nextBoolean();
        cones.start(isFirst ? tree : other, isFirst ? other : tree);
        List<Integer> found = new ArrayList<>();
        for (int id = cones.next(limit); id >= 0; id = cones.next(limit)) {
            found.add(id);
        }
        List<Integer> truth = new ArrayList<>();
        for (int id : in) {
            for (int k = 0; k < 30; k++) {
                double square = 0;
                double ahead = 0;
                for (int axis = 0; axis < 3; axis++) {
                    double low = boxes[6 * id + axis];
                    double high = boxes[6 * id + 3 + axis];
                    double from = (low + (high - low) * random.nextInt(3) / 2 - o[axis]) / scale;
                    square += from * from;
                    ahead += from * d[axis];
                }
                double away = Math.sqrt(square);
                if (away < limit / scale * (1 - 1e-9) && ahead > away * cos * (1 + 1e-9)) {
                    truth.add(id);
                    break;
                }
            }
        }
        count(found, truth);
    }

    private void count(List<Integer> found, List<Integer> truth) {
        assertThat(found).doesNotHaveDuplicates().containsAll(truth);
        assertThat(in).containsAll(found);
        met += truth.size();
        passedBy += in.size() - found.size();
    }

    /** Nearer nodes come first, so that a limit that shrinks to what was found leaves out nearly all. */
    @Test
    void aShrinkingLimitLeavesOutWhatIsBehind() {
        int taken = 0;
        for (int id = 0; id < MOST; id++) {
            place(Scene.CUBE, id, 1);
            tree.add(id, boxes);
            in.add(id);
        }
        tree.freeze();
        for (int k = 0; k < 200; k++) {
            double[] p = {random.nextDouble(-20, 20), random.nextDouble(-20, 20), random.nextDouble(-20, 20)};
            nearest.around(p[0], p[1], p[2]);
            startNearest();
            double limit = INFINITE;
            for (int id = nearest.next(limit); id >= 0; id = nearest.next(limit)) {
                limit = Math.min(limit, distance(id, p));
                taken++;
            }
            assertThat(limit)
                    .isEqualTo(
                            in.stream().mapToDouble(id -> distance(id, p)).min().orElseThrow());
        }
        assertThat(taken).isBetween(200, 200 * 12);
    }

    /** What is nearer within the cone comes first: of level cones through a crowd, hardly anything but what they meet. */
    @Test
    void aShrinkingLimitEndsACone() {
        int taken = 0;
        for (int id = 0; id < MOST; id++) {
            place(Scene.CUBE, id, 1);
            tree.add(id, boxes);
            in.add(id);
        }
        tree.freeze();
        double cos = StrictMath.cos(StrictMath.toRadians(15));
        double sin = StrictMath.sin(StrictMath.toRadians(15));
        for (int k = 0; k < 200; k++) {
            double angle = random.nextDouble(6.28);
            double ux = StrictMath.cos(angle);
            double uz = StrictMath.sin(angle);
            cones.aim(new BeamAxis().line(0, 0, 0, ux, 0, uz).widen(cos, sin), tree.most());
            cones.start(tree, other);
            double limit = INFINITE;
            for (int id = cones.next(limit); id >= 0; id = cones.next(limit)) {
                limit = Math.min(limit, distance(id, new double[3]) + 2);
                taken++;
            }
        }
        assertThat(taken).isBetween(150, 200 * 5);
    }

    /** Each object encloses those before it, so that each goes down from the top: the tree would become a list. */
    @Test
    void whatBecomesTooDeepIsBuiltAnew() {
        double[] many = new double[6 * 2000];
        Hierarchy deep = new Hierarchy(() -> built++);
        int deepest = 0;
        for (int id = 0; id < 2000; id++) {
            double size = Math.scalb(1 + id * 1e-6, id / 10 - 100);
            Arrays.fill(many, 6 * id, 6 * id + 3, -size);
            Arrays.fill(many, 6 * id + 3, 6 * id + 6, size);
            deep.add(id, many);
            deep.takeIn();
            deepest = Math.max(deepest, depth(deep, 0));
        }
        assertThat(deepest).isBetween(100, 124);
        assertThat(built).as("times it was built anew as it became too deep").isGreaterThan(0);
    }

    private static int depth(Hierarchy of, int node) {
        int most = 0;
        for (int k = 0; k < Hierarchy.WIDTH; k++) {
            int link = Float.floatToRawIntBits(of.nodes[Hierarchy.STRIDE * node + Hierarchy.LINKS + k]);
            most = link >= 0 && link != Hierarchy.NONE ? Math.max(most, depth(of, link)) : most;
        }
        return most + 1;
    }

    /** Many objects are not hung one by one; those that are taken away or moved before any query are hung first. */
    @Test
    void whatIsAddedInBulkIsBuiltAtOnce() {
        for (int id = 0; id < MOST; id++) {
            place(Scene.CUBE, id, 1);
            tree.add(id, boxes);
            in.add(id);
        }
        assertThat(built).isZero();
        assertSound();
        assertThat(built).isEqualTo(1);
        tree.remove(3);
        tree.add(3, boxes);
        tree.remove(3);
        in.remove(3);
        tree.remove(4);
        tree.add(4, boxes);
        place(Scene.FAR_OUT, 4, 1);
        tree.move(4, boxes);
        assertThat(tree.size()).isEqualTo(MOST - 1);
        assertSound();
        assertThat(built).isEqualTo(1);
    }

    @Test
    void refusesAnIdTwiceAndOneThatIsNotThere() {
        tree.add(7, boxes);
        assertThatThrownBy(() -> tree.add(7, boxes)).hasMessageContaining("(got: 7)");
        tree.remove(7);
        assertThat(tree.contains(7)).isFalse();
        assertThatThrownBy(() -> tree.remove(7)).hasMessageContaining("id must be in the tree (got: 7)");
        assertThatThrownBy(() -> tree.move(8, boxes)).hasMessageContaining("id must be in the tree (got: 8)");
        assertSound();
    }
}
