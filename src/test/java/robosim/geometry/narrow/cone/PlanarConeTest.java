package robosim.geometry.narrow.cone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.PlanarRows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.ray.PlanarRay;
import robosim.geometry.narrow.ray.PlanarRayTest;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.SectorTwin;

class PlanarConeTest {
    private final Scratch scratch = new Scratch();

    private double cone(double ox, double oz, double aim, double half, LeafKind kind, double[] row) {
        return PlanarCone.distance(
                new BeamAxis()
                        .line(ox, 0, oz, StrictMath.cos(aim), 0, StrictMath.sin(aim))
                        .widen(StrictMath.cos(half), StrictMath.sin(half)),
                kind,
                row,
                0,
                Double.POSITIVE_INFINITY,
                scratch.cone);
    }

    @Test
    void nearestPointWithinTheSectorIsThatOfTheShapeCutByIt() {
        PlanarRows rows = new PlanarRows(21);
        int hits = 0;
        int edges = 0;
        int inside = 0;
        int count = Effort.cases(7000);
        for (int k = 0; k < count; k++) {
            LeafKind kind = Leaves.KINDS[k % 9];
            double[] row = rows.row(kind, 1, 1);
            double ox = rows.between(2);
            double oz = rows.between(2);
            double aim = rows.between(3.2);
            double half = 0.01 + 1.5 * rows.random().nextDouble();
            PlanarTwin twin = PlanarRows.twin(kind, row);
            double away = PlanarRows.point(ox, oz).partedRoughly(twin);
            double distance = cone(ox, oz, aim, half, kind, row);
            String text = PlanarRayTest.text(ox, oz, aim, half, kind, row);
            if (away <= 0) {
                assertThat(distance).as(text).isLessThanOrEqualTo(1e-11);
                hits++;
                inside++;
                continue;
            }
            double[] apex = {ox, oz};
            double[] way = {StrictMath.cos(aim), StrictMath.sin(aim)};
            double truth = SectorTwin.nearest(twin, apex, way, StrictMath.cos(half), 0);
            // Of ovals, what is past an edge by less than the search resolves may be heard.
            double least =
                    twin.isOval ? SectorTwin.nearest(twin.grown(1e-11), apex, way, StrictMath.cos(half), 1e-11) : truth;
            if (truth < Double.POSITIVE_INFINITY) {
                assertThat(distance).as(text).isBetween(least - 1e-10, truth + 1e-11);
                hits++;
                edges += distance > away + 1e-3 ? 1 : 0;
            } else {
                assertThat(distance).as(text).isGreaterThanOrEqualTo(least - 1e-10);
            }
        }
        assertThat(hits).isBetween(count * 3 / 10, count * 8 / 10);
        assertThat(edges).isGreaterThan(count / 20);
        assertThat(inside).isGreaterThan(count / 50);
    }

    @Test
    void aThinPoleBetweenAllRaysIsHeard() {
        double[] pole = new double[Leaf.STRIDE];
        pole[0] = 100 * StrictMath.cos(0.1234);
        pole[2] = 100 * StrictMath.sin(0.1234);
        pole[3] = 1e-6;
        assertThat(cone(0, 0, 0, 0.2, LeafKind.UPRIGHT_CYLINDER, pole)).isBetween(100 - 1.1e-6, 100 - 0.9e-6);
        assertThat(cone(0, 0, 0, 0.12, LeafKind.UPRIGHT_CYLINDER, pole)).isInfinite();
        pole[3] = 0;
        assertThat(cone(0, 0, 0, 0.2, LeafKind.SPHERE, pole)).isBetween(100 - 1e-13, 100 + 1e-13);
        pole[3] = 1;
        assertThat(cone(0, 0, Math.PI, 0.2, LeafKind.SPHERE, pole)).isInfinite();
        assertThat(cone(pole[0], pole[2], 0, 0.2, LeafKind.SPHERE, pole)).isZero();
    }

    /** Of a thin cylinder the nearest point is within the sector by 2e-8 radian: half of it is nearer than where edges cut it. */
    @Test
    void theNearestPointOfAThinTippedCylinderJustWithin() {
        Geometry world = new Geometry(1e6, 1e6, 1e6, Dimension.PLANAR, Accuracy.EXACT);
        double c = 0.19822396935131023;
        double s = 0.9801567517364816;
        world.addObjectUnchecked(new CylinderObject(
                        new Point(26014.48327229044, 0, 5245.556404148815), 1.9686211026532975E-7, 2.3462392314694314)
                .oriented(new double[] {c, s, 0, 0, 0, -1, -s, c, 0}));
        Ray ray = new Ray(new Point(), new Point(0.7842446722995322, 0, -0.6204516854435962));
        assertThat(world.getRayDistance(ray, 0, Double.POSITIVE_INFINITY, 99.49874525957496))
                .isBetween(26536.8, 26536.8977);
    }

    /** Whatever the axis meets is heard, though a sector be as narrow as rounding of the direction. */
    @Test
    void whatTheAxisMeetsIsHeardHoweverNarrowTheSector() {
        SplittableRandom random = new SplittableRandom(24);
        int met = 0;
        for (int k = 0; k < 4000; k++) {
            double dx = random.nextInt(-40, 41);
            double dz = random.nextInt(-40, 41);
            if (dx == 0 && dz == 0) {
                continue;
            }
            double times = random.nextInt(1, 30) / (random.nextBoolean() ? 1.0 : 3.0);
            PlanarRows rows = new PlanarRows(k);
            LeafKind kind = Leaves.KINDS[k % 6];
            double[] row = rows.row(kind, 0, random.nextBoolean() ? 1e-3 : 1);
            if (kind == LeafKind.SPHERE || kind == LeafKind.UPRIGHT_CYLINDER) {
                row[3] = 0;
            }
            for (int corner = 0; corner < (kind == LeafKind.TRIANGLE ? 9 : 3); corner += 3) {
                row[corner] += times * dx;
                row[corner + 2] += times * dz;
            }
            double axis = PlanarRay.distance(new BeamAxis().line(0, 0, 0, dx, 0, dz), kind, row, 0, scratch.ray);
            for (double half : new double[] {1e-3, 1e-9, 1e-15, 1e-200}) {
                double heard = PlanarCone.distance(
                        new BeamAxis().line(0, 0, 0, dx, 0, dz).widen(StrictMath.cos(half), StrictMath.sin(half)),
                        kind,
                        row,
                        0,
                        Double.POSITIVE_INFINITY,
                        scratch.cone);
                assertThat(heard)
                        .as("kind %s along (%s, %s), half angle %s: %s", kind, dx, dz, half, Arrays.toString(row))
                        .isLessThanOrEqualTo(axis * (1 + 0x1p-48));
            }
            met += axis < Double.POSITIVE_INFINITY ? 1 : 0;
        }
        assertThat(met).isGreaterThan(1000);
        Geometry world = new Geometry(100, 100, 100, Dimension.PLANAR, Accuracy.EXACT);
        world.addObjectUnchecked(new SphereObject(new Point(1, 0, 3), 0));
        Ray ray = new Ray(new Point(), new Point(1, 0, 3));
        double line = world.getRayDistance(ray, 0, 100, 0);
        assertThat(line).isCloseTo(Math.sqrt(10), within(1e-15));
        for (double width : new double[] {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, Double.MIN_VALUE}) {
            assertThat(world.getRayDistance(ray, 0, 100, width))
                    .as("width " + width)
                    .isCloseTo(line, within(1e-15));
        }
    }

    @Test
    void aCornerOnTheEdgeOfTheSectorIsWithin() {
        double[] row = new double[Leaf.STRIDE];
        row[0] = 5;
        row[2] = 2;
        row[3] = 1;
        row[5] = 1;
        for (int quarter = 0; quarter < 4; quarter++) {
            PlanarRows.upright(row, 90 * quarter);
            // the nearest corner (4, 1) is on one edge, the rest beyond
            double half = StrictMath.atan2(1, 4);
            assertThat(cone(0, 0, 0, half, LeafKind.UPRIGHT_BOX, row))
                    .isBetween(Math.sqrt(17) - 1e-15, Math.sqrt(17) + 1e-12);
        }
        // 3, 4, 5: the nearest corner is on an edge of the sector, but for the rounding of the cosine, which decides
        double[] far = triangle(4, 3, 5, 8, 0, 9);
        assertThat(PlanarCone.distance(
                        new BeamAxis().line(0, 0, 0, 1, 0, 0).widen(0.8, 0.6),
                        LeafKind.TRIANGLE,
                        far,
                        0,
                        Double.POSITIVE_INFINITY,
                        scratch.cone))
                .isInfinite(); // 0.8 is stored as a little more
        assertThat(PlanarCone.distance(
                        new BeamAxis().line(0, 0, 0, 1, 0, 0).widen(Math.nextDown(0.8), 0.6),
                        LeafKind.TRIANGLE,
                        far,
                        0,
                        Double.POSITIVE_INFINITY,
                        scratch.cone))
                .isBetween(5 - 1e-15, 5 + 1e-15);
    }

    /** A box of 1e-14 seen from 3e-11 away: 1,000 ulp too near while its foot was taken from the product of two corners. */
    @Test
    void aShortSideFarAwayIsAsFarAsItIs() {
        double[] box = {
            -8.663945152728643E-13,
            -2.7370550793081655E-16,
            9.531610107526493E-13,
            0.0,
            8.123408717164015E-15,
            2.7195137119011268E-15,
            0.9457495619676907,
            -0.322141398179341,
            -0.04222186183697213,
            0.2960991396515765,
            0.9081027469373674,
            -0.2960991396515766,
            0.13372757956202322,
            0.26753377466007344,
            0.9542235659847308,
            0.0
        };
        double half = 1.305;
        double distance = PlanarCone.distance(
                new BeamAxis()
                        .line(
                                1.6739333017957895E-11,
                                0,
                                2.2160537056585827E-11,
                                -0.018906939144769708,
                                0,
                                -0.022766126703541056)
                        .widen(StrictMath.cos(half), StrictMath.sin(half)),
                LeafKind.BOX,
                box,
                0,
                Double.POSITIVE_INFINITY,
                scratch.cone);
        double corner = 2.756099438844037991918081911386361370588574992677922998494749844508841E-11;
        assertThat(distance).isBetween(corner - 8 * Math.ulp(corner), corner + 8 * Math.ulp(corner));
    }

    private static double[] triangle(double ax, double az, double bx, double bz, double cx, double cz) {
        return new double[] {ax, 0, az, bx, 0, bz, cx, 0, cz, 0, 0, 0, 0, 0, 0, 0};
    }
}
