package robosim.geometry.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class RayPatternTest {
    private static final Offset<Double> ROUNDING = Offset.offset(0x1p-51);

    private static double length(RayPattern pattern, int k) {
        return Math.sqrt(pattern.x(k) * pattern.x(k) + pattern.y(k) * pattern.y(k) + pattern.z(k) * pattern.z(k));
    }

    private static void areUnit(RayPattern pattern) {
        for (int k = 0; k < pattern.size(); k++) {
            assertThat(length(pattern, k)).isCloseTo(1, ROUNDING);
        }
    }

    @Test
    void aFanTurnsCounterClockwise() {
        RayPattern fan = RayPattern.fan(-90, 45, 5);
        assertThat(fan.size()).isEqualTo(5);
        assertThat(fan.rows()).isEqualTo(1);
        assertThat(fan.columns()).isEqualTo(5);
        assertThat(fan.direction(0)).isEqualTo(new Point(0, 0, 1)); // to the right
        assertThat(fan.direction(2)).isEqualTo(new Point(1, 0, 0));
        assertThat(fan.direction(4)).isEqualTo(new Point(0, 0, -1)); // to the left
        areUnit(RayPattern.fan(-135.3, 0.25, 1081));
    }

    @Test
    void layersComeRowByRow() {
        RayPattern lidar = RayPattern.layers(new double[] {-90, 0, 30, 90}, 180, -90, 4);
        assertThat(lidar.rows()).isEqualTo(4);
        assertThat(lidar.columns()).isEqualTo(4);
        for (int k = 0; k < 4; k++) {
            assertThat(lidar.direction(k)).isEqualTo(new Point(0, -1, 0));
            assertThat(lidar.direction(12 + k)).isEqualTo(new Point(0, 1, 0));
            assertThat(lidar.direction(4 + k))
                    .isEqualTo(RayPattern.fan(180, -90, 4).direction(k));
            assertThat(lidar.y(8 + k)).isEqualTo(0.5);
        }
        assertThat(lidar.z(9)).isCloseTo(-Math.sqrt(0.75), ROUNDING); // an azimuth of 90: to the left
        areUnit(RayPattern.layers(new double[] {-25, -3.3, 0.1, 15}, 0, 0.2, 1800));
    }

    @Test
    void layersMayBeTurnedAgainstEachOther() {
        double[] elevations = {-10, 0, 10};
        RayPattern turned = RayPattern.layers(elevations, new double[] {1.5, 0, -30}, 20, -2, 50);
        for (int row = 0; row < 3; row++) {
            double first = row == 0 ? 21.5 : row == 1 ? 20 : -10;
            RayPattern alone = RayPattern.layers(new double[] {elevations[row]}, first, -2, 50);
            for (int k = 0; k < 50; k++) {
                assertThat(turned.direction(50 * row + k)).isEqualTo(alone.direction(k));
            }
        }
        assertThatThrownBy(() -> RayPattern.layers(elevations, new double[2], 0, 1, 5))
                .hasMessage("offsetsDegrees must have one number for each elevation, 3 (got: 2)");
        assertThatThrownBy(() -> RayPattern.layers(elevations, new double[] {0, 0, Double.NaN}, 0, 1, 5))
                .hasMessageContaining("an offset must be a finite angle");
    }

    @Test
    void aPinholeByItsIntrinsics() {
        RayPattern camera = RayPattern.pinhole(6, 4, 3, 5, 1.5, 2);
        assertThat(camera.rows()).isEqualTo(4);
        assertThat(camera.columns()).isEqualTo(6);
        for (int v = 0; v < 4; v++) {
            for (int u = 0; u < 6; u++) {
                int k = 6 * v + u;
                assertThat(camera.z(k) / camera.x(k)).isCloseTo((u - 1.5) / 3, ROUNDING); // to the right
                assertThat(-camera.y(k) / camera.x(k)).isCloseTo((v - 2) / 5.0, ROUNDING); // down
            }
        }
        areUnit(camera);
        // The same camera, by its field of view: 90 degrees over 320 pixels are a focal length of 160.
        RayPattern wide = RayPattern.pinhole(320, 200, 90);
        RayPattern same = RayPattern.pinhole(320, 200, 160, 160, 159.5, 99.5);
        for (int k = 0; k < wide.size(); k++) {
            assertThat(same.x(k)).isCloseTo(wide.x(k), ROUNDING);
            assertThat(same.y(k)).isCloseTo(wide.y(k), ROUNDING);
            assertThat(same.z(k)).isCloseTo(wide.z(k), ROUNDING);
        }
        areUnit(RayPattern.pinhole(3, 2, 0x1p-100, 0x1p100, 0x1p100, -0x1p100));
        assertThatThrownBy(() -> RayPattern.pinhole(3, 2, 0, 1, 1, 1))
                .hasMessage("fx must be from 2^-100 to 2^100 (got: 0.0)");
        assertThatThrownBy(() -> RayPattern.pinhole(3, 2, 1, Double.NaN, 1, 1)).hasMessageContaining("fy must be");
        assertThatThrownBy(() -> RayPattern.pinhole(3, 2, 1, 1, Double.POSITIVE_INFINITY, 1))
                .hasMessageContaining("cx must be");
        assertThatThrownBy(() -> RayPattern.pinhole(0, 2, 1, 1, 1, 1)).hasMessageContaining("width must be from 1");
    }

    @Test
    void aPinholeLooksAlongX() {
        RayPattern camera = RayPattern.pinhole(5, 3, 90);
        assertThat(camera.rows()).isEqualTo(3);
        assertThat(camera.columns()).isEqualTo(5);
        assertThat(camera.direction(7)).isEqualTo(new Point(1, 0, 0));
        assertThat(camera.y(0)).isPositive(); // the top row
        assertThat(camera.z(0)).isNegative(); // its left end
        areUnit(camera);
        // The field of view ends at the edges of the image: two fifths of the way out is the middle of the next pixel
        // but one.
        assertThat(camera.z(9) / camera.x(9)).isCloseTo(0.8, ROUNDING);
        assertThat(camera.y(2) / camera.x(2)).isCloseTo(0.4, ROUNDING); // pixels are square
        RayPattern even = RayPattern.pinhole(320, 240, 87);
        for (int row = 0; row < 240; row++) {
            for (int column = 0; column < 320; column++) {
                int k = 320 * row + column;
                int mirrored = 320 * row + 319 - column;
                int below = 320 * (239 - row) + column;
                assertThat(even.z(k)).isEqualTo(-even.z(mirrored));
                assertThat(even.y(k)).isEqualTo(-even.y(below));
                assertThat(even.x(k)).isEqualTo(even.x(mirrored)).isEqualTo(even.x(below));
            }
        }
        areUnit(even);
        areUnit(RayPattern.pinhole(3, 2, Double.MIN_VALUE));
        areUnit(RayPattern.pinhole(3, 2, Math.nextDown(180)));
    }

    @Test
    void anyDirectionsAreKept() {
        double[] numbers = {1, 2, 3, 0, 0, -5e-300};
        RayPattern any = RayPattern.of(numbers);
        numbers[0] = 9;
        assertThat(any.direction(0)).isEqualTo(new Point(1, 2, 3));
        assertThat(any.z(1)).isEqualTo(-5e-300);
        double[] out = new double[5];
        any.directions(1, 1, out, 2);
        assertThat(out).containsExactly(0, 0, 0, 0, -5e-300);
    }

    @Test
    void equalByValue() {
        RayPattern fan = RayPattern.fan(0, 90, 4);
        RayPattern same = RayPattern.of(new double[] {1, 0, 0, -0.0, 0, -1, -1, 0, 0, 0, 0, 1});
        assertThat(fan).isEqualTo(same).hasSameHashCodeAs(same).isNotEqualTo(RayPattern.fan(0, 91, 4));
        assertThat(RayPattern.pinhole(2, 1, 60)).isNotEqualTo(RayPattern.pinhole(1, 2, 60));
        assertThat(fan).hasToString("RayPattern of 1 x 4 beams");
        SenseOptions options = SenseOptions.range(0, 5).withWidth(3);
        assertThat(options)
                .isEqualTo(SenseOptions.range(-0.0, 5).withWidth(3))
                .hasSameHashCodeAs(SenseOptions.range(0, 5).withWidth(3))
                .isNotEqualTo(options.withThreads(2))
                .isNotEqualTo(options.withCarrier(SenseOptions.Carrier.SEEN))
                .hasToString("SenseOptions[min=0.0, max=5.0, width=3.0, carrier=IGNORED, threads=1, motion=null,"
                        + " seesHeights=false, ignored=[]]");
    }

    @Test
    void badArgumentsAreNamed() {
        refused("count must be from 1 to 16777216 (got: 0)", () -> RayPattern.fan(0, 1, 0));
        refused("firstDegrees must be a finite angle in degrees (got: NaN)", () -> RayPattern.fan(Double.NaN, 1, 1));
        refused("stepDegrees must be a finite", () -> RayPattern.fan(0, Double.NEGATIVE_INFINITY, 1));
        refused("angle of the last beam must be a finite", () -> RayPattern.fan(0, Double.MAX_VALUE, 3));
        refused("elevationsDegrees must have at least one", () -> RayPattern.layers(new double[0], 0, 1, 1));
        refused(
                "an elevation must be from -90 to 90 degrees (got: 90.5)",
                () -> RayPattern.layers(new double[] {0, 90.5}, 0, 1, 1));
        refused(
                "count must be from 1 to 8388608 columns of 2 rows (got: 8388609)",
                () -> RayPattern.layers(new double[2], 0, 1, 8388609));
        refused("width must be from 1 to 16777216 (got: -1)", () -> RayPattern.pinhole(-1, 1, 60));
        refused(
                "height must be from 1 to 4096 rows of 4096 pixels (got: 4097)",
                () -> RayPattern.pinhole(4096, 4097, 60));
        refused(
                "horizontalFieldOfViewDegrees must be above 0 and below 180 (got: 180.0)",
                () -> RayPattern.pinhole(1, 1, 180));
        refused("directions must have three numbers for each beam", () -> RayPattern.of(new double[4]));
        refused("direction 1 must not be zero", () -> RayPattern.of(new double[] {1, 0, 0, 0, 0, 0}));
        refused("directions[1] must be a number", () -> RayPattern.of(new double[] {1, Double.NaN, 0}));
        RayPattern fan = RayPattern.fan(0, 1, 3);
        refused("beam must be from 0 to 2 (got: 3)", () -> fan.x(3));
        refused(
                "first and count must tell beams from 0 to 2 (got: 2 and 2)",
                () -> fan.directions(2, 2, new double[9], 0));
        refused(
                "at must leave room for 6 numbers in an array of 9 (got: 4)",
                () -> fan.directions(0, 2, new double[9], 4));
    }

    private static void refused(String message, Runnable call) {
        assertThatThrownBy(call::run)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith(message);
    }
}
