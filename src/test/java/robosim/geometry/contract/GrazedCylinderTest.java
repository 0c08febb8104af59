package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.cone.SpatialCone;
import robosim.geometry.narrow.leaf.LeafKind;

/** Cones in space whose border just reaches the rim of a cylinder: what is heard there is not nearer than it is. */
class GrazedCylinderTest {
    /** The expected distances come from decimals of 60 digits. */
    @Test
    void aGrazedRimIsHeardWhereItIs() {
        assertThat(heard(
                        new CylinderObject(
                                new Point(-21.22204150244127, 4.673739427734503, -61.58879462117476),
                                59.765562534177334,
                                0.18346029535455163),
                        new Point(-1.4849939976385218, 4.704649762223038, -2.7299793918300663),
                        new Point(-0.27600300961580126, -0.25635041883247145, 0.977170450234617),
                        143.72458052517769))
                .isCloseTo(16.6773798007651366, within(16.7 * 0x1p-40));
        assertThat(heard(
                        new CylinderObject(
                                new Point(-756406.321846854, 117879.33054872451, -12670.231435646232),
                                729530.853685894,
                                250480.3798569886),
                        new Point(0, 0, 0),
                        new Point(-0.006618857188483096, -0.7535981819758941, 0.048922520695666716),
                        147.78183112990496))
                .isCloseTo(28737.994659085865, within(28738 * 0x1p-40));
    }

    /** The two ends that are proved of what grazes by 10^-16 to 10^-8 radian are within 2^-40 of each other. */
    @Test
    void bothEndsMeetWhereARimIsGrazed() {
        SplittableRandom random = new SplittableRandom(551);
        Scratch s = new Scratch();
        int heard = 0;
        for (int k = 0; k < 20_000; k++) {
            double[] row = new double[16];
            for (int i = 0; i < 3; i++) {
                row[i] = random.nextDouble(-3, 3);
            }
            row[3] = StrictMath.pow(10, random.nextDouble(-1, 0.5));
            row[4] = StrictMath.pow(10, random.nextDouble(-3, 0.5));
            double[] u = new double[3];
            for (int i = 0; i < 3; i++) {
                u[i] = random.nextDouble(-1, 1);
            }
            double most = mostAhead(row, u, k % 2 == 0 ? 1 : -1);
            double cos = most - StrictMath.pow(10, random.nextDouble(-16, -8));
            double inside = Math.hypot(row[0], row[2]) - row[3];
            if (!(cos > 0 && cos < 1) || (inside <= 0 && Math.abs(row[1]) <= row[4])) {
                continue;
            }
            double low = SpatialCone.distance(
                    new BeamAxis().line(0, 0, 0, u[0], u[1], u[2]).widen(cos, Math.sqrt((1 - cos) * (1 + cos))),
                    LeafKind.UPRIGHT_CYLINDER,
                    row,
                    0,
                    Double.POSITIVE_INFINITY,
                    s.cone);
            if (low < Double.POSITIVE_INFINITY && low > 1e-3) {
                double high = SpatialCone.upperEnd(s.cone);
                assertThat(high - low)
                        .as("cylinder %s, towards %s, cosine %s", Arrays.toString(row), Arrays.toString(u), cos)
                        .isLessThanOrEqualTo(low * 0x1p-40);
                heard++;
            }
        }
        assertThat(heard).isGreaterThan(5_000);
    }

    /** Radius 0, the apex beside the segment by 10^-9 of its length or less, and a narrow cone that looks away from it. */
    @Test
    void aSegmentBesideTheApexIsNotHeardByAConeThatPassesIt() {
        assertThat(heard(
                        new CylinderObject(
                                new Point(2.5138658625464494, -2.6508832998246863, -2.6768071617310722),
                                0.0,
                                0.9210860253780406),
                        new Point(2.5138658625487977, -2.190340287135666, -2.6768071617322464),
                        new Point(-0.1966189213954792, -0.6919462872002065, 0.36394162219877746),
                        1e-5))
                .isInfinite();
        SplittableRandom random = new SplittableRandom(44);
        for (int k = 0; k < 5_000; k++) {
            double beside = StrictMath.pow(10, random.nextDouble(-12, -8));
            CylinderObject segment = new CylinderObject(new Point(-beside, random.nextDouble(-0.4, 0.4), 0), 0, 1);
            double width = StrictMath.pow(10, random.nextDouble(-5, 1));
            Point way = new Point(random.nextDouble(-0.4, 1), random.nextDouble(-1, 1), random.nextDouble(0.5, 1));
            assertThat(heard(segment, new Point(), way, width))
                    .as("%s towards %s, width %s", segment, way, width)
                    .isInfinite();
        }
    }

    // The greatest cosine, with a direction, of a rim's places seen from the origin.
    private static double mostAhead(double[] row, double[] u, double side) {
        double length = Math.sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
        double best = -1;
        double at = 0;
        for (double step = 0.05; step > 1e-9; step /= 10) {
            double middle = at;
            for (int i = -63; i <= 63; i++) {
                double angle = middle + i * step;
                double x = row[0] + row[3] * StrictMath.cos(angle);
                double y = row[1] + row[4] * side;
                double z = row[2] + row[3] * StrictMath.sin(angle);
                double cos = (x * u[0] + y * u[1] + z * u[2]) / (length * Math.sqrt(x * x + y * y + z * z));
                if (cos > best) {
                    best = cos;
                    at = angle;
                }
            }
        }
        return best;
    }

    private static double heard(CylinderObject cylinder, Point from, Point way, double width) {
        Geometry geometry = new Geometry(1e9, 1e9, 1e9);
        assertThat(geometry.addObjectUnchecked(cylinder)).isTrue();
        return geometry.getRayDistance(new Ray(from, way), 0, Double.POSITIVE_INFINITY, width);
    }
}
