package robosim.geometry.index.tiles;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.BitSet;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Effort;
import robosim.geometry.index.QuadCursor;
import robosim.geometry.index.QuadTree;
import robosim.geometry.index.QuadTreeTest;

/** Rectangles at any heading, of which a query must not miss one; the twin separates them from it exactly. */
class OrientedRectangleTest {
    private static final int COUNT = 300;

    private final SplittableRandom random = new SplittableRandom(5);
    private final double[] outlines = OrientedRectangle.rows(COUNT, 0);

    private QuadCursor scene(double size, double offset) {
        QuadTree tree = new QuadTree(-size, -size, size, size);
        for (int id = 0; id < COUNT; id++) {
            int at = OrientedRectangle.at(id);
            double heading = random.nextInt(3) == 0 ? random.nextInt(4) * Math.PI / 2 : random.nextDouble(7);
            outlines[at + OrientedRectangle.X] = offset + random.nextDouble(-size, size);
            outlines[at + OrientedRectangle.Z] = random.nextDouble(-size, size);
            outlines[at + OrientedRectangle.HALF_X] = random.nextInt(6) == 0 ? 0 : random.nextDouble(size / 8);
            outlines[at + OrientedRectangle.HALF_Z] = random.nextInt(6) == 0 ? 0 : random.nextDouble(size / 64);
            outlines[at + OrientedRectangle.COS] = StrictMath.cos(heading);
            outlines[at + OrientedRectangle.SIN] = StrictMath.sin(heading);
            double wide = extent(at, OrientedRectangle.COS, OrientedRectangle.SIN);
            double deep = extent(at, OrientedRectangle.SIN, OrientedRectangle.COS);
            double x = outlines[at + OrientedRectangle.X];
            double z = outlines[at + OrientedRectangle.Z];
            tree.add(
                    id, Math.nextDown(x - wide), Math.nextDown(z - deep), Math.nextUp(x + wide), Math.nextUp(z + deep));
        }
        return tree.cursor();
    }

    /** Half of the extent along a world's axis, rounded up. */
    private double extent(int at, int first, int second) {
        double sum = outlines[at + OrientedRectangle.HALF_X] * Math.abs(outlines[at + first])
                + outlines[at + OrientedRectangle.HALF_Z] * Math.abs(outlines[at + second]);
        return sum * (1 + 0x1p-50);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e7, 1e15})
    void raysMissNone(double offset) {
        QuadCursor cursor = scene(64, offset);
        int hits = 0;
        int leftOut = 0;
        for (int k = 0; k < Effort.cases(400); k++) {
            double[] corner =
                    corner(random.nextInt(COUNT), random.nextBoolean() ? 1 : -1, random.nextBoolean() ? 1 : -1);
            double ox = offset + random.nextInt(-64, 64);
            double oz = random.nextInt(-64, 64);
            boolean isAimed = random.nextInt(3) > 0;
            double dx = isAimed ? corner[0] - ox : random.nextInt(-3, 4);
            double dz = isAimed ? corner[1] - oz : 1;
            if (dx == 0 && dz == 0) {
                continue;
            }
            double limit = random.nextInt(3) == 0 ? 0.5 : 2;
            BitSet ids = new BitSet();
            double slack = 0x1p-44 * (Math.abs(ox) + Math.abs(oz)) / (Math.abs(dx) + Math.abs(dz));
            cursor.startRay(ox, oz, dx, dz);
            for (int id = cursor.nextOnRay(limit + slack, outlines); id >= 0; ) {
                ids.set(id);
                id = cursor.nextOnRay(limit + slack, outlines);
            }
            for (int id = 0; id < COUNT; id++) {
                if (!isSeparate(id, ox, oz, dx, dz, limit)) {
                    assertThat(ids.get(id))
                            .as("%d on the ray %s, %s, %s, %s", id, ox, oz, dx, dz)
                            .isTrue();
                    hits++;
                }
            }
            leftOut += COUNT - ids.cardinality();
        }
        assertThat(hits).isGreaterThan(Effort.cases(1000));
        assertThat(leftOut).isGreaterThan(Effort.cases(20_000));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e7, 1e15})
    void boxesMissNone(double offset) {
        QuadCursor cursor = scene(64, offset);
        int near = 0;
        int small = 0;
        int leftOut = 0;
        for (int k = 0; k < Effort.cases(1000); k++) {
            double[] corner = corner(random.nextInt(COUNT), random.nextBoolean() ? 1 : -1, 1);
            double width = random.nextInt(3);
            double[] box = {corner[0], corner[1], corner[0] + width, corner[1] + width};
            BitSet ids = QuadTreeTest.near(cursor, outlines, box);
            int count = cursor.gather(corner[0], corner[1], corner[0] + width, corner[1] + width, -1, outlines);
            BitSet gathered = new BitSet();
            for (int i = 0; i < count; i++) {
                gathered.set(cursor.gathered(i));
            }
            for (int id = 0; id < COUNT; id++) {
                // The box as its diagonal, which is enough of it.
                if (!isSeparate(id, corner[0], corner[1], width, width, 1)) {
                    assertThat(gathered.get(id))
                            .as("%d near %s, %s", id, corner[0], corner[1])
                            .isTrue();
                    assertThat(ids == null || ids.get(id))
                            .as("%d near %s, %s", id, corner[0], corner[1])
                            .isTrue();
                    near++;
                }
            }
            small += ids != null ? 1 : 0;
            leftOut += COUNT - gathered.cardinality();
        }
        assertThat(small).isGreaterThan(Effort.cases(300));
        assertThat(near).isGreaterThan(Effort.cases(500));
        assertThat(leftOut).isGreaterThan(Effort.cases(100_000));
    }

    /** From a corner of the world over up to a hundred tiles, wherever in its tile the point lies. */
    @Test
    void raysReachPointsFarAway() {
        int count = 10_000;
        QuadTree tree = new QuadTree(0, 0, 1, 1);
        double[] points = OrientedRectangle.rows(count, 0);
        for (int id = 0; id < count; id++) {
            double x = random.nextDouble();
            double z = random.nextDouble();
            tree.add(id, x, z, x, z);
            OrientedRectangle.write(points, id, x, z, x, z);
        }
        QuadCursor cursor = tree.cursor();
        long met = 0;
        for (int id = 0; id < count; id++) {
            int target = id;
            BitSet ids = new BitSet();
            double x = points[OrientedRectangle.at(id) + OrientedRectangle.X];
            double z = points[OrientedRectangle.at(id) + OrientedRectangle.Z];
            cursor.startRay(0, 0, x, z);
            for (int each = cursor.nextOnRay(1 + 0x1p-40, points); each >= 0; ) {
                ids.set(each);
                each = cursor.nextOnRay(1 + 0x1p-40, points);
            }
            assertThat(ids.get(target)).as("point %s, %s", x, z).isTrue();
            met += ids.cardinality();
        }
        assertThat(met).as("hardly any but those aimed at").isLessThan(count + 100);
        assertThat(cursor.visited()).as("tiles").isGreaterThan(50L * count);
    }

    /** Down through a crowd in a tile of few ulps, whose parts could not be placed where they belong. */
    @Test
    void raysMeetCrowdsFarFromTheOrigin() {
        int count = 160;
        int rays = Effort.cases(200);
        int hits = 0;
        for (int scene = 0; scene < 20; scene++) {
            double base = Math.scalb(1.0, 30 + scene);
            QuadTree tree = new QuadTree(base, 0, base + 280, 1);
            double[] rows = OrientedRectangle.rows(count, 0);
            double[][] boxes = new double[count][];
            for (int id = 0; id < count; id++) {
                double x = base + (id % 2 == 0 ? random.nextInt(280) : 100 + random.nextInt(8));
                double z = id % 2 == 0 ? random.nextDouble() : random.nextDouble(0.02);
                boxes[id] = new double[] {x, z, x + random.nextInt(2), z};
                tree.add(id, boxes[id][0], z, boxes[id][2], z);
                OrientedRectangle.write(rows, id, boxes[id][0], z, boxes[id][2], z);
            }
            QuadCursor cursor = tree.cursor();
            for (int k = 0; k < rays; k++) {
                double[] ray = {base + 100 + random.nextInt(10), 1.5, random.nextDouble(-1, 1), -1};
                BitSet ids = new BitSet();
                cursor.startRay(ray[0], ray[1], ray[2], ray[3]);
                for (int id = cursor.nextOnRay(2, rows); id >= 0; ) {
                    ids.set(id);
                    id = cursor.nextOnRay(2, rows);
                }
                for (int id = 0; id < count; id++) {
                    if (QuadTreeTest.Entry.exact(ray, boxes[id]) != null) {
                        assertThat(ids.get(id))
                                .as("%d of %s from %s", id, base, ray[0])
                                .isTrue();
                        hits++;
                    }
                }
            }
        }
        assertThat(hits).isGreaterThan(20 * rays);
    }

    /** No limit and no direction is too great or too small to tell. */
    @Test
    void raysOfAnySpeedMeetWhatTheyStartIn() {
        QuadCursor cursor = scene(64, 0);
        for (double speed : new double[] {0x1p-1000, 0x1p-470, 1, 0x1p470, 0x1p640, 0x1p1000}) {
            for (double limit : new double[] {0, 1, 0x1p1000, Double.MAX_VALUE, Double.POSITIVE_INFINITY}) {
                for (int id = 0; id < COUNT; id++) {
                    int at = OrientedRectangle.at(id);
                    cursor.startRay(
                            outlines[at + OrientedRectangle.X], outlines[at + OrientedRectangle.Z], speed, -speed);
                    BitSet ids = new BitSet();
                    for (int each = cursor.nextOnRay(limit, outlines); each >= 0; ) {
                        ids.set(each);
                        each = cursor.nextOnRay(limit, outlines);
                    }
                    assertThat(ids.get(id))
                            .as("%d at %s up to %s", id, speed, limit)
                            .isTrue();
                }
            }
        }
    }

    /** A corner, rounded. */
    private double[] corner(int id, int signX, int signZ) {
        int at = OrientedRectangle.at(id);
        double a = signX * outlines[at + OrientedRectangle.HALF_X];
        double b = signZ * outlines[at + OrientedRectangle.HALF_Z];
        double cos = outlines[at + OrientedRectangle.COS];
        double sin = outlines[at + OrientedRectangle.SIN];
        return new double[] {
            outlines[at + OrientedRectangle.X] + a * cos + b * sin,
            outlines[at + OrientedRectangle.Z] - a * sin + b * cos
        };
    }

    /** Whether a line keeps the rectangle and the way from o to o + limit d apart: along one of its sides, or the way. */
    private boolean isSeparate(int id, double ox, double oz, double dx, double dz, double limit) {
        int at = OrientedRectangle.at(id);
        BigDecimal cos = new BigDecimal(outlines[at + OrientedRectangle.COS]);
        BigDecimal sin = new BigDecimal(outlines[at + OrientedRectangle.SIN]);
        BigDecimal x = new BigDecimal(dx);
        BigDecimal z = new BigDecimal(dz);
        BigDecimal[][] normals = {{cos, sin.negate()}, {sin, cos}, {z, x.negate()}};
        for (BigDecimal[] n : normals) {
            BigDecimal middle = new BigDecimal(outlines[at + OrientedRectangle.X])
                    .multiply(n[0])
                    .add(new BigDecimal(outlines[at + OrientedRectangle.Z]).multiply(n[1]));
            BigDecimal half = n[0].multiply(cos)
                    .subtract(n[1].multiply(sin))
                    .abs()
                    .multiply(new BigDecimal(outlines[at + OrientedRectangle.HALF_X]))
                    .add(n[0].multiply(sin)
                            .add(n[1].multiply(cos))
                            .abs()
                            .multiply(new BigDecimal(outlines[at + OrientedRectangle.HALF_Z])));
            BigDecimal from = new BigDecimal(ox).multiply(n[0]).add(new BigDecimal(oz).multiply(n[1]));
            BigDecimal to =
                    from.add(new BigDecimal(limit).multiply(x.multiply(n[0]).add(z.multiply(n[1]))));
            if (from.min(to).compareTo(middle.add(half)) > 0 || from.max(to).compareTo(middle.subtract(half)) < 0) {
                return true;
            }
        }
        return false;
    }
}
