package robosim.geometry.index;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Objects;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Allocated;
import robosim.geometry.Effort;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.Degrees;
import robosim.geometry.index.quadtree.Regions;
import robosim.geometry.index.tiles.OrientedRectangle;
import robosim.geometry.index.tiles.Tiles;

public class QuadTreeTest {
    private static final double WORLD = 500;

    /** Where boxes are and how large, in ways that are hard on a tree. */
    public enum Scene {
        SPREAD,
        GRID,
        ONE_PLACE,
        POINTS_ON_A_LATTICE,
        HUGE_AMONG_TINY,
        ONE_CORNER,
        CLOSE_PAIRS,
        OUTSIDE,
        LONG_WALLS,
        CROWDS;

        public double[] box(SplittableRandom random) {
            return switch (this) {
                case SPREAD -> around(random, any(random), any(random), random.nextDouble(8), random.nextDouble(8));
                case GRID -> corner(random.nextInt(-50, 50) * 8, random.nextInt(-50, 50) * 8, 8, 8);
                case ONE_PLACE -> around(random, 3, -7, random.nextDouble(50), random.nextDouble(50));
                case POINTS_ON_A_LATTICE -> corner(random.nextInt(-9, 10) * 0.5, random.nextInt(-9, 10) * 0.5, 0, 0);
                case HUGE_AMONG_TINY -> {
                    double reach = random.nextInt(20) == 0 ? WORLD / 2 : 0x1p-10;
                    yield around(random, any(random) / 2, any(random) / 2, reach, reach);
                }
                case ONE_CORNER ->
                    corner(WORLD - random.nextDouble() * 1e-9, WORLD - random.nextDouble() * 1e-9, 1e-12, 1e-12);
                case CLOSE_PAIRS ->
                    corner(
                            random.nextInt(-20, 20) * 25 + random.nextInt(2) * 1e-10,
                            random.nextInt(-20, 20) * 25,
                            1,
                            1);
                case OUTSIDE -> around(random, any(random) * 1e6, any(random) * 1e-6, 1e5, 1);
                case LONG_WALLS ->
                    random.nextBoolean()
                            ? around(random, any(random), any(random), 200, 0.1)
                            : around(random, any(random), any(random), 0.1, 200);
                case CROWDS -> {
                    // Some of the crowds hold crowds; a few large boxes stand around and across them.
                    double spread = random.nextBoolean() ? 1 : 0x1p-6;
                    double x = random.nextInt(-1, 2) * 300 + random.nextDouble(spread);
                    double reach = random.nextInt(30) == 0 ? 40 : random.nextDouble(0.1 * spread);
                    yield around(random, x, random.nextDouble(spread) - 100, reach, reach);
                }
            };
        }

        private static double any(SplittableRandom random) {
            return random.nextDouble(-WORLD, WORLD);
        }

        private static double[] corner(double x, double z, double width, double length) {
            return new double[] {x, z, x + width, z + length};
        }

        private static double[] around(SplittableRandom random, double x, double z, double reachX, double reachZ) {
            double halfX = random.nextInt(8) == 0 ? 0 : reachX;
            double halfZ = random.nextInt(8) == 0 ? 0 : reachZ;
            return new double[] {x - halfX, z - halfZ, x + halfX, z + halfZ};
        }
    }

    @ParameterizedTest
    @EnumSource
    void boxesFindWhatTheListFinds(Scene scene) {
        SplittableRandom random = new SplittableRandom(51 + scene.ordinal());
        double[][] boxes = new double[400][];
        QuadTree tree = new QuadTree(-WORLD, -WORLD, WORLD, WORLD);
        QuadCursor cursor = tree.cursor();
        int found = 0;
        int asked = 0;
        int steps = Effort.cases(3000, 600);
        for (int step = 0; step < steps; step++) {
            int id = random.nextInt(boxes.length);
            churn(tree, boxes, id, scene, random, step);
            if (step % 4 == 0) {
                double[] query = random.nextInt(3) == 0 ? touching(boxes, random) : scene.box(random);
                found += assertBox(tree, cursor, boxes, query);
                assertGathered(cursor, boxes, query, random.nextInt(-1, boxes.length));
                asked += tree.size();
            }
        }
        assertThat(found).isBetween(1, asked - (scene == Scene.ONE_PLACE ? 0 : 1));
        for (int id = 0; id < boxes.length; id++) {
            assertThat(tree.remove(id)).isEqualTo(boxes[id] != null);
        }
        assertThat(tree.size()).isZero();
        assertThat(tree.regions()).isEqualTo(1);
        assertBox(tree, cursor, new double[0][], new double[] {-1e300, -1e300, 1e300, 1e300});
    }

    private static boolean meet(double[] a, double[] b) {
        return a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3];
    }

    /** What touches the box is gathered, except one. */
    private static void assertGathered(QuadCursor cursor, double[][] boxes, double[] query, int but) {
        BitSet missed = meeting(boxes, query);
        if (but >= 0) {
            missed.clear(but);
        }
        int count = cursor.gather(query[0], query[1], query[2], query[3], but, outlines(cursor));
        for (int k = 0; k < count; k++) {
            assertThat(cursor.gathered(k)).isNotEqualTo(but);
            missed.clear(cursor.gathered(k));
        }
        assertThat(missed.isEmpty())
                .as("%s misses %s", Arrays.toString(query), missed)
                .isTrue();
    }

    private static BitSet meeting(double[][] boxes, double[] query) {
        BitSet ids = new BitSet();
        for (int id = 0; id < boxes.length; id++) {
            ids.set(id, boxes[id] != null && meet(boxes[id], query));
        }
        return ids;
    }

    @ParameterizedTest
    @EnumSource
    void raysFindWhatTheListFinds(Scene scene) {
        SplittableRandom random = new SplittableRandom(71 + scene.ordinal());
        double[][] boxes = new double[150][];
        QuadTree tree = new QuadTree(-WORLD, -WORLD, WORLD, WORLD);
        QuadCursor cursor = tree.cursor();
        int hits = 0;
        int misses = 0;
        int steps = Effort.cases(900);
        for (int step = 0; step < steps; step++) {
            churn(tree, boxes, random.nextInt(boxes.length), scene, random, step);
            if (step % 3 != 0) {
                continue;
            }
            double[] ray = ray(boxes, scene, random);
            double limit = random.nextInt(3) == 0 ? random.nextDouble(3) : Double.POSITIVE_INFINITY;
            BitSet ids = collectRay(cursor, ray, limit);
            for (int id = 0; id < boxes.length; id++) {
                BigDecimal truth = boxes[id] == null ? null : Entry.exact(ray, boxes[id]);
                boolean hit = truth != null
                        && (limit == Double.POSITIVE_INFINITY || truth.compareTo(new BigDecimal(limit)) <= 0);
                if (hit) {
                    assertThat(ids.get(id)).as("box %d on the ray", id).isTrue();
                    hits++;
                } else if (boxes[id] != null && !ids.get(id)) {
                    misses++;
                }
            }
        }
        assertThat(hits).isGreaterThan(Effort.cases(50));
        boolean isCrowd = scene == Scene.ONE_PLACE || scene == Scene.ONE_CORNER;
        assertThat(misses).as("left out").isGreaterThan(isCrowd ? 0 : Effort.cases(50));
    }

    @ParameterizedTest
    @EnumSource
    void pointsFindWhatTheListFinds(Scene scene) {
        SplittableRandom random = new SplittableRandom(91 + scene.ordinal());
        double[][] boxes = new double[150][];
        QuadTree tree = new QuadTree(-WORLD, -WORLD, WORLD, WORLD);
        QuadCursor cursor = tree.cursor();
        int inside = 0;
        int near = 0;
        int steps = Effort.cases(900);
        for (int step = 0; step < steps; step++) {
            churn(tree, boxes, random.nextInt(boxes.length), scene, random, step);
            double[] at = random.nextInt(3) == 0 ? touching(boxes, random) : scene.box(random);
            double limit = random.nextInt(4) == 0 ? 0 : random.nextDouble(scene == Scene.OUTSIDE ? 1e8 : 300);
            double last = 0;
            BitSet ids = new BitSet();
            cursor.startPoint(at[0], at[1]);
            for (int id = cursor.next(limit); id >= 0; id = cursor.next(limit)) {
                ids.set(id);
                assertThat(cursor.entry()).isBetween(last, limit);
                last = cursor.entry();
                BigDecimal truth = Entry.squareOfDistance(at[0], at[1], boxes[id]);
                assertThat(new BigDecimal(last).pow(2)).isLessThanOrEqualTo(truth);
                assertThat(last * (1 + 0x1p-19) + 1e-300).isGreaterThan(Math.sqrt(truth.doubleValue()));
            }
            for (int id = 0; id < boxes.length; id++) {
                if (boxes[id] != null
                        && Entry.squareOfDistance(at[0], at[1], boxes[id]).compareTo(new BigDecimal(limit).pow(2))
                                <= 0) {
                    assertThat(ids.get(id)).isTrue();
                    near++;
                    inside += limit == 0 ? 1 : 0;
                }
            }
        }
        assertThat(near).isGreaterThan(Effort.cases(100));
        assertThat(inside).isPositive();
    }

    /** What a sector leaves out has no point of its box that is certainly in it. */
    @ParameterizedTest
    @EnumSource
    void sectorsFindWhatTheListFinds(Scene scene) {
        SplittableRandom random = new SplittableRandom(101 + scene.ordinal());
        double[][] boxes = new double[150][];
        QuadTree tree = new QuadTree(-WORLD, -WORLD, WORLD, WORLD);
        QuadCursor cursor = tree.cursor();
        int met = 0;
        int passedBy = 0;
        int steps = Effort.cases(900);
        for (int step = 0; step < steps; step++) {
            churn(tree, boxes, random.nextInt(boxes.length), scene, random, step);
            double[] at = random.nextInt(3) == 0 ? touching(boxes, random) : scene.box(random);
            double aim = random.nextInt(4) == 0 ? random.nextInt(8) * 45 : random.nextDouble(360);
            double half = random.nextDouble(0.5, 89);
            double limit = random.nextInt(3) == 0
                    ? Double.POSITIVE_INFINITY
                    : random.nextDouble(scene == Scene.OUTSIDE ? 1e8 : 300);
            double ux = Degrees.cos(aim);
            double uz = Degrees.sin(aim);
            cursor.startSector(
                    new BeamAxis().line(at[0], 0, at[1], ux, 0, uz).widen(Degrees.cos(half), Degrees.sin(half)));
            BitSet ids = new BitSet();
            for (int id = cursor.next(limit); id >= 0; id = cursor.next(limit)) {
                assertThat(ids.get(id)).isFalse();
                ids.set(id);
            }
            for (int id = 0; id < boxes.length; id++) {
                if (boxes[id] != null && isHeld(at, ux, uz, Degrees.cos(half), limit, boxes[id])) {
                    assertThat(ids.get(id)).isTrue();
                    met++;
                } else if (boxes[id] != null && !ids.get(id)) {
                    passedBy++;
                }
            }
        }
        assertThat(met).isGreaterThan(Effort.cases(100));
        assertThat(passedBy).isGreaterThan(Effort.cases(100));
    }

    /** Whether a corner of a box, or a middle, is certainly in a sector within a limit. */
    private static boolean isHeld(double[] at, double ux, double uz, double cos, double limit, double[] box) {
        for (int k = 0; k < 9; k++) {
            double x = box[0] + (box[2] - box[0]) * (k % 3) / 2 - at[0];
            double z = box[1] + (box[3] - box[1]) * (k / 3) / 2 - at[1];
            double length = Math.sqrt(x * x + z * z);
            if (length < limit * (1 - 1e-9) && x * ux + z * uz > length * (cos + 1e-9) + 1e-9) {
                return true;
            }
        }
        return false;
    }

    /** The nearer comes first, so that a limit that shrinks to what was found leaves out nearly all. */
    @Test
    void aShrinkingLimitEndsASector() {
        QuadTree tree = new QuadTree(-100, -100, 100, 100);
        SplittableRandom random = new SplittableRandom(9);
        for (int id = 0; id < 1000; id++) {
            double x = random.nextDouble(-99, 98);
            double z = random.nextDouble(-99, 98);
            tree.add(id, x, z, x + 1, z + 1);
        }
        QuadCursor cursor = tree.cursor();
        int taken = 0;
        for (int k = 0; k < 200; k++) {
            double aim = random.nextDouble(360);
            BeamAxis beam = new BeamAxis().line(0, 0, 0, Degrees.cos(aim), 0, Degrees.sin(aim));
            cursor.startSector(beam.widen(Degrees.cos(7.5), Degrees.sin(7.5)));
            double limit = 1000;
            for (int id = cursor.next(limit); id >= 0; id = cursor.next(limit)) {
                double[] b = Arrays.copyOfRange(cursor.boxes(), 6 * id, 6 * id + 6);
                double middle = (b[0] + b[3]) / 2 * Degrees.cos(aim) + (b[2] + b[5]) / 2 * Degrees.sin(aim);
                limit = Math.min(limit, middle + 1);
                taken++;
            }
        }
        assertThat(taken).isBetween(200, 200 * 4);
    }

    @Test
    void aShrinkingLimitEndsARay() {
        QuadTree tree = new QuadTree(-100, -100, 100, 100);
        for (int id = 0; id < 100; id++) {
            tree.add(id, id, 0, id + 0.5, 1);
        }
        QuadCursor cursor = tree.cursor();
        BitSet near = new BitSet();
        double[] outlines = outlines(cursor);
        cursor.startRay(-5, 0.5, 1, 0);
        for (int id = cursor.nextOnRay(100, outlines); id >= 0; id = cursor.nextOnRay(6, outlines)) {
            near.set(id);
        }
        assertThat(near.get(0, 2).cardinality()).isEqualTo(2);
        assertThat(near.cardinality()).isLessThan(6);
        BitSet ids = collectRay(cursor, new double[] {50.25, 0.5, 0x1p-1040, 0}, Double.POSITIVE_INFINITY);
        assertThat(ids.get(50, 100).cardinality())
                .as("all that a slow ray comes to")
                .isEqualTo(50);
    }

    /** A ray that is fast enough for a walk over small tiles, and too slow for one over the large ones after them. */
    @Test
    void aSlowRayGoesOnToLargerTiles() {
        SplittableRandom random = new SplittableRandom(72);
        QuadTree tree = new QuadTree(0, 0, 256, 256);
        for (int id = 0; id < 500; id++) {
            double size = id < 400 ? 1 : 60;
            double x = random.nextDouble(200);
            double z = random.nextDouble(200);
            tree.add(id, x, z, x + size, z + size);
        }
        tree.settle();
        Tiles small = tree.tiles.get(0);
        Tiles large = tree.tiles.get(1);
        assertThat(large.isSingle()).isFalse();
        double least = Math.min(small.scaleX, small.scaleZ);
        double most = Math.max(large.scaleX, large.scaleZ);
        assertThat(least).isGreaterThan(1.1 * most);
        double slow = 0x1p-300 / Math.sqrt(least * most);
        double[][] boxes = new double[500][];
        QuadCursor cursor = tree.cursor();
        for (int id = 0; id < boxes.length; id++) {
            double[] b = tree.boxes();
            boxes[id] = new double[] {b[6 * id], b[6 * id + 2], b[6 * id + 3], b[6 * id + 5]};
        }
        double[] ray = {1, 1, slow, slow};
        BitSet ids = collectRay(cursor, ray, Double.POSITIVE_INFINITY);
        int hits = 0;
        for (int id = 0; id < boxes.length; id++) {
            if (Entry.exact(ray, boxes[id]) != null) {
                assertThat(ids.get(id)).as("box %d", id).isTrue();
                hits += id < 400 ? 0 : 1;
            }
        }
        assertThat(hits).isPositive();
    }

    /** A ray of every slope from every side of a lattice of boxes that touch the lines between tiles, to the bit. */
    @Test
    void raysBesideTheLinesBetweenTilesMissNothing() {
        int side = 32;
        double[][] boxes = new double[side * side][];
        QuadTree tree = new QuadTree(0, 0, side, side);
        for (int id = 0; id < boxes.length; id++) {
            int x = id % side;
            int z = id / side;
            boxes[id] = new double[] {x, z, x + (x == side - 1 ? 1 : 0), z + (z == side - 1 ? 1 : 0)};
            tree.add(id, boxes[id][0], boxes[id][1], boxes[id][2], boxes[id][3]);
        }
        QuadCursor cursor = tree.cursor();
        SplittableRandom random = new SplittableRandom(65);
        int hits = 0;
        for (int k = 0; k < 300; k++) {
            double x = random.nextInt(-2, side + 2);
            double z = random.nextInt(-2, side + 2);
            double dx = random.nextInt(-4, 5) * (random.nextInt(3) == 0 ? 0x1p-40 : 1);
            double dz = random.nextInt(-4, 5) * (random.nextInt(3) == 0 ? 0x1p-62 : 1);
            double far = random.nextInt(4) == 0 ? 1e7 : 1;
            double[] ray = {x - far * dx, z - far * dz, dx, dz};
            if (dx == 0 && dz == 0) {
                continue;
            }
            BitSet ids = collectRay(cursor, ray, Double.POSITIVE_INFINITY);
            for (int id = 0; id < boxes.length; id++) {
                if (Entry.exact(ray, boxes[id]) != null) {
                    assertThat(ids.get(id))
                            .as("box %d on the ray %s", id, Arrays.toString(ray))
                            .isTrue();
                    hits++;
                }
            }
        }
        assertThat(hits).isGreaterThan(1000);
    }

    @Test
    void raysAlongBordersMeetThem() {
        QuadTree tree = new QuadTree(-10, -10, 10, 10);
        tree.add(0, 1, 1, 2, 2);
        QuadCursor cursor = tree.cursor();
        double[][] rays = {
            {0, 1, 1, 0},
            {0, 2, 5, -0.0},
            {1, 0, 0, 1},
            {2, 5, -0.0, -3},
            {2, 2, 1, 1},
            {2, 2, -0.0, 1},
            {1, 1, -1, 0},
            {0, 0, 1, 1},
            {0, 3, 1, -1},
            {0, 0, 0x1p-1030, 0x1p-1030},
            {0, 0, 0x1p1000, 0x1p1000}
        };
        for (double[] ray : rays) {
            assertThat(collectRay(cursor, ray, Double.POSITIVE_INFINITY).cardinality())
                    .as(Arrays.toString(ray))
                    .isEqualTo(1);
        }
    }

    @Test
    void aReachBeyondTheObjectsIsNoneWhateverTheSpeed() {
        QuadTree tree = new QuadTree(-10, -10, 10, 10);
        tree.add(0, 1, 1, 2, 2);
        QuadCursor cursor = tree.cursor();
        for (int power = -1020; power <= 1000; power += 20) {
            double speed = Math.scalb(1.0, power);
            double[] ray = {0, 0, speed, speed};
            double reach = Math.min(Double.MAX_VALUE, Math.scalb(3.0, -power));
            assertThat(collectRay(cursor, ray, reach).cardinality())
                    .as("speed " + speed)
                    .isEqualTo(1);
        }
    }

    @Test
    void queriesLookIntoFewRegions() {
        SplittableRandom random = new SplittableRandom(61);
        int n = 20_000;
        double side = Math.sqrt(n) * 5;
        QuadTree tree = new QuadTree(0, 0, side, side);
        for (int id = 0; id < n; id++) {
            double x = random.nextDouble(side);
            double z = random.nextDouble(side);
            tree.add(id, x, z, x + 1, z + 1);
        }
        assertThat(tree.regions()).isLessThan(4 * n);
        QuadCursor cursor = tree.cursor();
        int queries = 1000;
        for (int i = 0; i < queries; i++) {
            double x = random.nextDouble(side);
            double z = random.nextDouble(side);
            cursor.startBox(x, z, x + 1, z + 1);
            while (cursor.next() >= 0) {}
        }
        long byBoxes = cursor.visited();
        double[] outlines = outlines(cursor);
        assertThat(byBoxes).isBetween((long) queries, 3L * queries);
        for (int i = 0; i < queries; i++) {
            double angle = random.nextDouble(2 * Math.PI);
            cursor.startRay(
                    random.nextDouble(side), random.nextDouble(side), StrictMath.cos(angle), StrictMath.sin(angle));
            if (cursor.nextOnRay(Double.POSITIVE_INFINITY, outlines) >= 0) {
                while (cursor.nextOnRay(0, outlines) >= 0) {}
            }
        }
        assertThat(cursor.visited() - byBoxes).isBetween((long) queries, 12L * queries);
    }

    @Test
    void linesOfClosePairsStaySmall() {
        QuadTree tree = new QuadTree(0, 0, 1000, 1000);
        for (int id = 0; id < 1000; id++) {
            double x = id / 2 + id % 2 * 1e-11;
            tree.add(id, x, x, x, x);
        }
        assertThat(tree.regions()).isLessThan(4 * 1000);
    }

    @Test
    void everyObjectHasARegionOfItsOwn() {
        SplittableRandom random = new SplittableRandom(62);
        QuadTree tree = new QuadTree(-WORLD, -WORLD, WORLD, WORLD);
        for (int id = 0; id < 2000; id++) {
            double[] box = Scene.SPREAD.box(random);
            tree.add(id, box[0], box[1], box[2], box[3]);
        }
        int objects = 0;
        for (int region = 0; region < tree.regions(); region++) {
            int link = tree.grown().links[region];
            objects += link < 0 && link != Regions.EMPTY && ~link <= QuadTree.MAX_ID ? 1 : 0;
        }
        assertThat(objects).isEqualTo(2000);
    }

    @Test
    void queriesAllocateNothing() {
        SplittableRandom random = new SplittableRandom(63);
        QuadTree tree = new QuadTree(-WORLD, -WORLD, WORLD, WORLD);
        for (int id = 0; id < 2000; id++) {
            double[] box = Scene.SPREAD.box(random);
            tree.add(id, box[0], box[1], box[2], box[3]);
        }
        QuadCursor cursor = tree.cursor();
        double[] outlines = outlines(cursor);
        assertThat(Allocated.everyTime(() -> query(cursor, outlines, 3000))).isLessThan(3000);
    }

    private static void query(QuadCursor cursor, double[] outlines, int count) {
        for (int i = 0; i < count; i++) {
            double x = (i * 37) % 1000 - WORLD;
            double z = (i * 91) % 1000 - WORLD;
            cursor.startRay(x, z, i % 7 - 3, i % 5 + 1);
            while (cursor.nextOnRay(1000, outlines) >= 0) {}
            cursor.startPoint(x, z);
            while (cursor.next(100) >= 0) {}
            cursor.startBox(x, z, x + 50, z + 50);
            while (cursor.next() >= 0) {}
        }
    }

    @Test
    void refusesWhatItCannotHold() {
        QuadTree tree = new QuadTree(0, 0, 0, 0);
        tree.add(3, 1, 1, 1, 1);
        assertThat(tree.contains(3)).isTrue();
        assertThat(tree.contains(4)).isFalse();
        assertThat(tree.remove(4)).isFalse();
        assertThat(tree.remove(-1)).isFalse();
        assertThat(tree.remove(1 << 30)).isFalse();
        assertThatThrownBy(() -> tree.add(3, 0, 0, 1, 1)).hasMessageContaining("got: 3");
        assertThatThrownBy(() -> tree.add(-1, 0, 0, 1, 1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> tree.add(1, 0, Double.NaN, 1, 1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> tree.add(1, 2, 0, 1, 1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> trace(tree, 0, -0.0)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> trace(tree, Double.NaN, 1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new QuadTree(0, 0, Double.NaN, 1)).isInstanceOf(IllegalArgumentException.class);
        assertThat(tree.size()).isEqualTo(1);
    }

    // One change; at first mostly additions, so that there is something to find.
    private static void churn(QuadTree tree, double[][] boxes, int id, Scene scene, SplittableRandom random, int step) {
        if (boxes[id] == null) {
            double[] box = scene.box(random);
            tree.add(id, box[0], box[1], box[2], box[3]);
            boxes[id] = box;
        } else if (step > boxes.length && random.nextBoolean()) {
            assertThat(tree.remove(id)).isTrue();
            assertThat(tree.contains(id)).isFalse();
            boxes[id] = null;
        }
    }

    private static double[] touching(double[][] boxes, SplittableRandom random) {
        double[] box = boxes[random.nextInt(boxes.length)];
        return box == null
                ? new double[] {0, 0, 0, 0}
                : new double[] {
                    box[2], random.nextBoolean() ? box[3] : Math.nextUp(box[3]), box[2] + 1, Math.nextUp(box[3]) + 1
                };
    }

    private static int assertBox(QuadTree tree, QuadCursor cursor, double[][] boxes, double[] query) {
        BitSet expected = meeting(boxes, query);
        BitSet ids = new BitSet();
        cursor.startBox(query[0], query[1], query[2], query[3]);
        for (int id = cursor.next(); id >= 0; id = cursor.next()) {
            assertThat(ids.get(id)).as("once only").isFalse();
            ids.set(id);
        }
        assertThat(ids).isEqualTo(expected);
        assertNear(cursor, query, expected);
        assertThat((long) tree.size())
                .isEqualTo(Arrays.stream(boxes).filter(Objects::nonNull).count());
        return ids.cardinality();
    }

    /** What is near a small box is all that meets it. */
    private static void assertNear(QuadCursor cursor, double[] query, BitSet expected) {
        BitSet ids = near(cursor, outlines(cursor), query);
        if (ids != null) {
            BitSet missed = (BitSet) expected.clone();
            missed.andNot(ids);
            assertThat(missed.isEmpty()).as("missed: %s", missed).isTrue();
        }
    }

    /** Only on one tile, but with a middle so far away that rounding could lose the end there. */
    @Test
    void boxesFromFarAwayAreNotSmall() {
        QuadTree tree = new QuadTree(0, 0, 64, 64);
        for (int id = 0; id < 100; id++) {
            tree.add(id, id % 10 * 6, id / 10 * 6, id % 10 * 6 + 1, id / 10 * 6 + 1);
        }
        QuadCursor cursor = tree.cursor();
        for (double reach = 64; reach < 0x1p90; reach *= 4) {
            BitSet beside = near(cursor, outlines(cursor), new double[] {0.5 - 2 * reach, 0, 0.5, 1});
            assertThat(beside == null ? reach > 0x1p20 : reach < 0x1p40 && beside.get(0))
                    .as("reach %s", reach)
                    .isTrue();
        }
    }

    /** A long box that ends in a divided tile: of the small parts of that it reaches over many more than of the tiles. */
    @Test
    void boxesFromFarAwayMeetCrowds() {
        SplittableRandom random = new SplittableRandom(71);
        QuadTree tree = new QuadTree(0, 0, 64, 64);
        for (int id = 0; id < 300; id++) {
            double width = id < 100 ? 64 : id < 200 ? 1 : 0x1p-6;
            double x = random.nextDouble(width);
            double z = random.nextDouble(width);
            tree.add(id, x, z, x, z);
        }
        QuadCursor cursor = tree.cursor();
        int small = 0;
        for (double reach = 1; reach < 0x1p40; reach *= 2) {
            BitSet near = near(cursor, outlines(cursor), new double[] {0x1p-6 - 2 * reach, 0, 0x1p-6, 0x1p-6});
            if (near != null) {
                assertThat(near.get(200, 300).cardinality())
                        .as("reach %s", reach)
                        .isEqualTo(100);
                small++;
            }
        }
        assertThat(small).isBetween(20, 30);
    }

    @Test
    void halvesReachBothEnds() {
        SplittableRandom random = new SplittableRandom(17);
        for (int k = 0; k < 10_000; k++) {
            double min = random.nextDouble(-1, 1) * Math.scalb(1.0, random.nextInt(-5, 5));
            double max = Math.max(min, random.nextInt(4) == 0 ? Math.nextUp(min) : random.nextDouble(-1, 1));
            BigDecimal middle = new BigDecimal(min / 2 + max / 2);
            BigDecimal half = new BigDecimal(QuadCursor.half(min, max));
            assertThat(middle.subtract(half)).isLessThanOrEqualTo(new BigDecimal(min));
            assertThat(middle.add(half)).isGreaterThanOrEqualTo(new BigDecimal(max));
            assertThat(half).isLessThanOrEqualTo(new BigDecimal((max - min) * 0.5 + 0x1p-50 * (max + 2 - min) * 32));
        }
    }

    /** Who is near a box, or null where it is not small. */
    public static @Nullable BitSet near(QuadCursor cursor, double[] outlines, double[] box) {
        BitSet ids = new BitSet();
        double halfX = QuadCursor.half(box[0], box[2]);
        double halfZ = QuadCursor.half(box[1], box[3]);
        int asked = cursor.near(box[0] / 2 + box[2] / 2, box[1] / 2 + box[3] / 2, halfX, halfZ, outlines, id -> {
            ids.set(id);
            return false;
        });
        assertThat(asked).isNotEqualTo(QuadCursor.ENOUGH);
        return asked == QuadCursor.ALL ? ids : null;
    }

    // Some at random, some along the axes, some exactly at corners or along borders.
    private static double[] ray(double[][] boxes, Scene scene, SplittableRandom random) {
        double[] from = scene.box(random);
        double[] to = scene.box(random);
        double[] target = boxes[random.nextInt(boxes.length)];
        double[] ray = {from[0], from[1], to[0] - from[0], to[1] - from[1]};
        switch (random.nextInt(6)) {
            case 0 -> ray[2] = random.nextBoolean() ? 0.0 : -0.0;
            case 1 -> ray[3] = random.nextBoolean() ? 0.0 : -0.0;
            case 2 -> {
                if (target != null) {
                    ray = new double[] {target[0] - 3, target[1] - 4, 3, 4};
                }
            }
            case 3 -> {
                if (target != null) {
                    ray = new double[] {target[0], from[1], -0.0, random.nextBoolean() ? 1 : -1};
                }
            }
            case 4 -> {
                if (target != null) {
                    ray = new double[] {target[2], target[3], random.nextInt(-1, 2), random.nextInt(-1, 2)};
                }
            }
            default -> {}
        }
        return ray[2] == 0 && ray[3] == 0 ? new double[] {from[0], from[1], 1, 0} : ray;
    }

    private static BitSet collectRay(QuadCursor cursor, double[] ray, double limit) {
        BitSet ids = new BitSet();
        // The caller's part: what rounding may do to the way to a box.
        double slack =
                0x1p-44 * ((Math.abs(ray[0]) + Math.abs(ray[1])) / (Math.abs(ray[2]) + Math.abs(ray[3])) + limit);
        double[] outlines = outlines(cursor);
        cursor.startRay(ray[0], ray[1], ray[2], ray[3]);
        for (int id = cursor.nextOnRay(limit + slack, outlines); id >= 0; ) {
            ids.set(id);
            id = cursor.nextOnRay(limit + slack, outlines);
        }
        return ids;
    }

    private static void trace(QuadTree tree, double dx, double dz) {
        QuadCursor cursor = tree.cursor();
        cursor.startRay(0, 0, dx, dz);
    }

    /** An outline of every box. */
    public static double[] outlines(QuadCursor cursor) {
        double[] boxes = cursor.boxes();
        double[] outlines = OrientedRectangle.rows(boxes.length / 6, 0);
        for (int id = 0; id < boxes.length / 6; id++) {
            int at = 6 * id;
            OrientedRectangle.write(outlines, id, boxes[at], boxes[at + 2], boxes[at + 3], boxes[at + 5]);
        }
        return outlines;
    }

    /** The exact twin of a ray against a box. */
    public static final class Entry {
        private static final MathContext DIGITS = new MathContext(80);

        private Entry() {}

        // The parameter of entry, rounded in the 80th digit, or null; decided by cross-multiplied rationals.
        public static BigDecimal exact(double[] ray, double[] box) {
            BigDecimal[][] interval = new BigDecimal[2][];
            for (int axis = 0; axis < 2; axis++) {
                BigDecimal direction = new BigDecimal(ray[2 + axis]);
                BigDecimal low = new BigDecimal(box[axis]).subtract(new BigDecimal(ray[axis]));
                BigDecimal high = new BigDecimal(box[2 + axis]).subtract(new BigDecimal(ray[axis]));
                if (direction.signum() == 0) {
                    if (low.signum() > 0 || high.signum() < 0) {
                        return null;
                    }
                    continue;
                }
                boolean back = direction.signum() < 0;
                interval[axis] =
                        new BigDecimal[] {back ? high.negate() : low, back ? low.negate() : high, direction.abs()};
                if (interval[axis][1].signum() < 0) {
                    return null;
                }
            }
            BigDecimal enter = BigDecimal.ZERO;
            for (BigDecimal[] own : interval) {
                if (own != null) {
                    enter = enter.max(own[0].divide(own[2], DIGITS));
                    for (BigDecimal[] other : interval) {
                        if (other != null && own[0].multiply(other[2]).compareTo(other[1].multiply(own[2])) > 0) {
                            return null;
                        }
                    }
                }
            }
            return enter;
        }

        static BigDecimal squareOfDistance(double x, double z, double[] box) {
            BigDecimal dx = outside(x, box[0], box[2]);
            BigDecimal dz = outside(z, box[1], box[3]);
            return dx.multiply(dx).add(dz.multiply(dz));
        }

        private static BigDecimal outside(double x, double min, double max) {
            return x < min
                    ? new BigDecimal(min).subtract(new BigDecimal(x))
                    : x > max ? new BigDecimal(x).subtract(new BigDecimal(max)) : BigDecimal.ZERO;
        }
    }
}
