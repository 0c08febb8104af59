package robosim.geometry.sensor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.model.RayPattern;

/** The lidars with presets are those of their manuals. */
class LidarTest {
    private static final Offset<Double> ROUNDING = Offset.offset(1e-9);

    private static Lidar preset(String name) {
        return switch (name) {
            case "VLP-16" -> Lidar.velodyneVlp16(10);
            case "VLP-32C" -> Lidar.velodyneVlp32c(10);
            case "OS1-64" -> Lidar.ousterOs1With64(10);
            case "OS1-128" -> Lidar.ousterOs1With128(10);
            case "UTM-30LX" -> Lidar.hokuyoUtm30lx();
            default -> Lidar.robotisLds02();
        };
    }

    private static double elevation(RayPattern pattern, int ray) {
        return Math.toDegrees(Math.asin(pattern.y(ray)));
    }

    /** Degrees counter-clockwise from forward. */
    private static double azimuth(RayPattern pattern, int ray) {
        return Math.toDegrees(Math.atan2(-pattern.z(ray), pattern.x(ray)));
    }

    @ParameterizedTest
    @CsvSource({
        "VLP-16, 16, 1808, -15, 15, 0.1, 100",
        "VLP-32C, 32, 1808, -25, 15, 0.1, 200",
        "OS1-64, 64, 1024, -16.6, 16.6, 0.1, 120",
        "OS1-128, 128, 1024, -22.5, 22.5, 0.1, 120",
        "UTM-30LX, 1, 1081, 0, 0, 0.018767, 30",
        "LDS-02, 1, 360, 0, 0, 0.2, 8"
    })
    void asInTheManuals(String name, int rows, int columns, double low, double high, double turn, double max) {
        Lidar lidar = preset(name);
        RayPattern pattern = lidar.pattern();
        assertThat(pattern.rows()).isEqualTo(rows);
        assertThat(pattern.columns()).isEqualTo(columns);
        assertThat(lidar.options().max()).isEqualTo(max);
        assertThat(elevation(pattern, 0)).isCloseTo(low, ROUNDING);
        assertThat(elevation(pattern, pattern.size() - 1)).isCloseTo(high, ROUNDING);
        double last = -91;
        for (int row = 0; row < rows; row++) {
            double elevation = elevation(pattern, row * columns);
            assertThat(elevation).isGreaterThan(last);
            last = elevation;
        }
        double end = 0;
        for (int k = 0; k < pattern.size(); k++) {
            assertThat(lidar.time(k)).isBetween(0.0, turn);
            end = Math.max(end, lidar.time(k));
        }
        assertThat(end).isCloseTo(turn, Offset.offset(turn / columns * 1.01));
    }

    @Test
    void lasersOfOneVelodyneFireOneAfterAnother() {
        Lidar lidar = Lidar.velodyneVlp16(10);
        int columns = lidar.pattern().columns();
        // In firing order the manual has -15, 1, -13, 3, -11, 5, -9, 7, -7, 9, -5, 11, -3, 13, -1, 15.
        int[] order = {-15, 1, -13, 3, -11, 5, -9, 7, -7, 9, -5, 11, -3, 13, -1, 15};
        for (int k = 0; k < 16; k++) {
            int row = (order[k] + 15) / 2;
            assertThat(lidar.time(row * columns)).isCloseTo(k * 2.304e-6, ROUNDING);
            assertThat(lidar.time(row * columns + 3)).isCloseTo(k * 2.304e-6 + 3 * 55.296e-6, ROUNDING);
        }
        // Clockwise, and straight ahead in the middle.
        RayPattern pattern = lidar.pattern();
        double step = 360 * 10 * 55.296e-6;
        assertThat(azimuth(pattern, columns / 2)).isCloseTo(0, ROUNDING);
        assertThat(azimuth(pattern, columns / 2 + 1)).isCloseTo(-step, ROUNDING);
        Lidar fast = Lidar.velodyneVlp16(20);
        assertThat(fast.pattern().columns()).isEqualTo(904);
        assertThat(azimuth(fast.pattern(), 453)).isCloseTo(-2 * step, ROUNDING);
    }

    @Test
    void lasersOfTheOtherFireInPairsToFourSides() {
        Lidar lidar = Lidar.velodyneVlp32c(10);
        RayPattern pattern = lidar.pattern();
        int columns = pattern.columns();
        Set<Double> sides = new HashSet<>();
        int[] firings = new int[16];
        for (int row = 0; row < 32; row++) {
            double side = azimuth(pattern, row * columns + columns / 2);
            sides.add(Math.rint(side * 10) / 10);
            assertThat(Math.abs(side * 10)).isCloseTo(Math.rint(Math.abs(side * 10)), ROUNDING);
            firings[(int) Math.rint(lidar.time(row * columns) / 2.304e-6)]++;
        }
        assertThat(sides).containsExactlyInAnyOrder(-4.2, -1.4, 1.4, 4.2);
        assertThat(firings).containsOnly(2);
    }

    @Test
    void planarLasersCountFromTheRightAndFromBehind() {
        RayPattern laser = Lidar.hokuyoUtm30lx().pattern();
        assertThat(azimuth(laser, 0)).isCloseTo(-135, ROUNDING);
        assertThat(azimuth(laser, 540)).isZero();
        assertThat(azimuth(laser, 1080)).isCloseTo(135, ROUNDING);
        RayPattern all = Lidar.robotisLds02().pattern();
        assertThat(Math.abs(azimuth(all, 0))).isCloseTo(180, ROUNDING);
        assertThat(azimuth(all, 270)).isCloseTo(90, ROUNDING);
    }
}
