package robosim.geometry.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.sensor.effects.NoisyFrame;

/** Each effect does what its page says, by its moments over many rays. */
class NoiseTest {
    private static final int COUNT = Effort.cases(1_000_000);
    private static final double NOTHING = Double.POSITIVE_INFINITY;

    private static NoisyFrame measured(double distance, double cosine, double front) {
        NoisyFrame measured = new NoisyFrame();
        measured.distances = filled(distance);
        measured.incidence = filled(cosine);
        measured.cones = filled(front);
        measured.count = COUNT;
        measured.max = 100;
        return measured;
    }

    private static double[] filled(double value) {
        double[] filled = new double[COUNT];
        Arrays.fill(filled, value);
        return filled;
    }

    private static double[] of(Noise noise, NoisyFrame measured) {
        noise.apply(42, 3, 17, measured);
        return measured.distances;
    }

    private static double[] of(Noise noise, double distance) {
        return of(noise, measured(distance, 1, distance));
    }

    private static double mean(double[] values) {
        return Arrays.stream(values).filter(Double::isFinite).average().orElse(Double.NaN);
    }

    private static double deviation(double[] values) {
        double mean = mean(values);
        return Math.sqrt(Arrays.stream(values)
                .filter(Double::isFinite)
                .map(value -> (value - mean) * (value - mean))
                .average()
                .orElse(Double.NaN));
    }

    private static double lost(double[] values) {
        return Arrays.stream(values).filter(value -> value == NOTHING).count() / (double) values.length;
    }

    private static Offset<Double> five(double deviation) {
        return Offset.offset(5 * deviation / Math.sqrt(COUNT));
    }

    @Test
    void normalErrors() {
        double[] values = of(Noise.gaussian(0.1, 0.02), 5);
        assertThat(mean(values)).isCloseTo(5.1, five(0.02));
        assertThat(deviation(values)).isCloseTo(0.02, five(0.02));
        double[] proportional = of(Noise.proportional(0.01), 7);
        assertThat(mean(proportional)).isCloseTo(7, five(0.07));
        assertThat(deviation(proportional)).isCloseTo(0.07, five(0.07));
        // Two effects draw different numbers: their variances add up.
        assertThat(deviation(of(Noise.gaussian(0.03).and(Noise.gaussian(0.04)), 5)))
                .isCloseTo(0.05, five(0.05));
        assertThat(lost(of(Noise.gaussian(1).and(Noise.proportional(0.1)), NOTHING)))
                .isEqualTo(1);
    }

    @Test
    void aBiasIsOneForAllFramesAndRays() {
        Noise bias = Noise.bias(0.5, 0.1);
        double first = of(bias, 5)[0];
        assertThat(of(bias, 5)).containsOnly(first);
        NoisyFrame later = measured(5, 1, 5);
        bias.apply(42, 3, 18, later);
        assertThat(later.distances[9]).isEqualTo(first);
        double sum = 0;
        double squares = 0;
        int sensors = 100_000;
        for (int sensor = 0; sensor < sensors; sensor++) {
            NoisyFrame one = new NoisyFrame();
            one.distances = new double[1];
            one.count = 1;
            bias.apply(1, sensor, 0, one);
            sum += one.distances[0];
            squares += (one.distances[0] - 0.5) * (one.distances[0] - 0.5);
        }
        assertThat(sum / sensors).isCloseTo(0.5, Offset.offset(5 * 0.1 / Math.sqrt(sensors)));
        assertThat(Math.sqrt(squares / sensors)).isCloseTo(0.1, Offset.offset(5 * 0.1 / Math.sqrt(sensors)));
    }

    @Test
    void wholeSteps() {
        double[] values = of(Noise.gaussian(0.1).and(Noise.quantized(0.25)), 5);
        assertThat(Arrays.stream(values).distinct().sorted().toArray()).contains(4.75, 5, 5.25);
        for (double value : values) {
            assertThat(value * 4).isEqualTo(Math.rint(value * 4));
        }
        assertThat(of(Noise.quantized(0.25), NOTHING)).containsOnly(NOTHING);
    }

    @Test
    void lostAndFalseEchoes() {
        assertThat(lost(of(Noise.dropout(0.3), 5))).isCloseTo(0.3, five(0.5));
        assertThat(lost(of(Noise.dropout(0), 5))).isZero();
        assertThat(lost(of(Noise.dropout(1), 5))).isEqualTo(1);
        // A tenth is even from 0 to 5, which has a mean of 2.5.
        double[] dusty = of(Noise.falseEchoes(0.1), 5);
        assertThat(Arrays.stream(dusty).filter(value -> value != 5).count() / (double) COUNT)
                .isCloseTo(0.1, five(0.3));
        assertThat(mean(dusty)).isCloseTo(4.75, five(1));
        assertThat(Arrays.stream(dusty).min().getAsDouble()).isBetween(0.0, 0.01);
        double[] sky = of(Noise.falseEchoes(0.1), NOTHING);
        assertThat(lost(sky)).isCloseTo(0.9, five(0.3));
        assertThat(mean(sky)).isCloseTo(50, five(30 * Math.sqrt(10)));
        NoisyFrame endless = measured(NOTHING, -1, NOTHING);
        endless.max = NOTHING;
        assertThat(of(Noise.falseEchoes(1), endless)).containsOnly(NOTHING);
    }

    @Test
    void worseAtGrazingIncidence() {
        Noise grazing = Noise.grazing(0.01, 80);
        assertThat(deviation(of(grazing, measured(5, 1, 5)))).isZero();
        double[] slanted = of(grazing, measured(5, 0.5, 5)); // 60 degrees
        assertThat(deviation(slanted)).isCloseTo(0.01 * Math.sqrt(3), five(0.02));
        assertThat(mean(slanted)).isCloseTo(5, five(0.02));
        assertThat(lost(of(grazing, measured(5, 0.17, 5)))).isEqualTo(1); // beyond 80 degrees
        assertThat(lost(of(grazing, measured(5, 0.18, 5)))).isZero();
        assertThat(of(grazing, measured(5, -1, 5))).containsOnly(5); // no surface, as within a solid
    }

    @Test
    void mixedPixels() {
        Noise mixed = Noise.mixedPixels(2, 0.1);
        double[] edge = of(mixed, measured(5, 1, 3));
        assertThat(mean(edge)).isCloseTo(4, five(1));
        assertThat(deviation(edge)).isCloseTo(2 / Math.sqrt(12), five(1));
        assertThat(Arrays.stream(edge).allMatch(value -> value >= 3 && value < 5))
                .isTrue();
        assertThat(of(mixed, measured(5, 1, 4.95))).containsOnly(5); // within the gap
        double[] sky = of(mixed, measured(NOTHING, -1, 3));
        assertThat(lost(sky)).isCloseTo(0.5, five(0.5));
        assertThat(mean(sky)).isEqualTo(3);
        // A wall at 80 degrees fills 4.58 to 5.53 of a beam of 2 degrees: it is not an edge.
        double cosine = Math.cos(Math.toRadians(80));
        double near = 5 * cosine / Math.cos(Math.toRadians(79));
        assertThat(near).isCloseTo(4.55, Offset.offset(0.01));
        assertThat(of(mixed, measured(5, cosine, near))).containsOnly(5);
        assertThat(mean(of(mixed, measured(5, cosine, near - 0.11)))).isLessThan(4.9);
    }

    @Test
    void aNumberDependsOnSeedSensorFrameRayAndPlaceAlone() {
        Noise noise = Noise.gaussian(1);
        double[] whole = of(noise, 0);
        NoisyFrame few = new NoisyFrame();
        few.distances = new double[10];
        few.count = 10;
        noise.apply(42, 3, 17, few);
        assertThat(few.distances).isEqualTo(Arrays.copyOf(whole, 10));
        for (long[] other : new long[][] {{43, 3, 17}, {42, 4, 17}, {42, 3, 18}, {3, 42, 17}, {42, 17, 3}}) {
            NoisyFrame different = new NoisyFrame();
            different.distances = new double[10];
            different.count = 10;
            noise.apply(other[0], other[1], other[2], different);
            for (int k = 0; k < 10; k++) {
                assertThat(different.distances[k]).isNotEqualTo(whole[k]);
            }
        }
    }

    /** Named sensors of one seed: no two of them have anything in common, and each is the same again. */
    @Test
    void sensorsWithNamesHaveErrorsOfTheirOwn() {
        Geometry world = new Geometry(40, 4, 40);
        world.addObject(new BoxObject(new Point(6, 0, 0), 1, 2, 30));
        Lidar plain = Lidar.of(RayPattern.fan(-45, 0.09, 1001), SenseOptions.range(0, 30));
        LidarFrame frame = new LidarFrame();
        plain.read(world, frame);
        double[] truth = frame.ranges().clone();
        String[] names = {"la", "lb", "al", "l", "la ", "bot::base::la", ""};
        double[][] errors = new double[names.length][];
        for (int k = 0; k < names.length; k++) {
            plain.withNoise(Noise.gaussian(0.05), 7, names[k]).read(world, 3, frame);
            errors[k] = new double[frame.size()];
            for (int ray = 0; ray < frame.size(); ray++) {
                errors[k][ray] = (frame.range(ray) - truth[ray]) / 0.05;
            }
        }
        for (int a = 0; a < names.length; a++) {
            for (int b = 0; b <= a; b++) {
                double product = 0;
                for (int ray = 0; ray < frame.size(); ray++) {
                    product += errors[a][ray] * errors[b][ray] / frame.size();
                }
                // Of 1001 independent normal numbers: 5 standard deviations are 0.16.
                assertThat(product).isBetween(a == b ? 0.75 : -0.16, a == b ? 1.25 : 0.16);
            }
        }
        plain.withNoise(Noise.gaussian(0.05), 7, names[0]).read(world, 3, frame);
        assertThat((frame.range(0) - truth[0]) / 0.05).isEqualTo(errors[0][0]);
        assertThat(plain.withNoise(Noise.gaussian(1), 7, "la"))
                .isEqualTo(plain.withNoise(Noise.gaussian(1), 7, "la"))
                .isNotEqualTo(plain.withNoise(Noise.gaussian(1), 7, "lb"));
    }

    @Test
    void aValue() {
        Noise noise = Noise.gaussian(0.01).and(Noise.dropout(0.1));
        assertThat(noise)
                .isEqualTo(Noise.gaussian(0, 0.01).and(Noise.dropout(0.1)))
                .hasSameHashCodeAs(Noise.gaussian(0.01).and(Noise.dropout(0.1)));
        assertThat(noise).isNotEqualTo(Noise.dropout(0.1).and(Noise.gaussian(0.01)));
        assertThat(Noise.NONE.isNone()).isTrue();
        assertThat(Noise.NONE.and(noise)).isEqualTo(noise);
        assertThat(noise.toString()).contains("deviation=0.01").contains("probability=0.1");
    }

    @Test
    void refused() {
        refused("deviation must be a number from 0 to 2^100 (got: -1.0)", () -> Noise.gaussian(-1));
        refused("mean must be a number from -2^100 to 2^100 (got: NaN)", () -> Noise.gaussian(Double.NaN, 1));
        refused("share must be from 0 to 1 (got: 1.5)", () -> Noise.proportional(1.5));
        refused("step must be from 2^-100 to 2^100 (got: 0.0)", () -> Noise.quantized(0));
        refused("probability must be from 0 to 1 (got: NaN)", () -> Noise.dropout(Double.NaN));
        refused("limitDegrees must be above 0 and at most 90 (got: 91.0)", () -> Noise.grazing(0, 91));
        refused("widthDegrees must be above 0 and below 90 (got: 0.0)", () -> Noise.mixedPixels(0, 0));
        refused("next must be given (got: null)", () -> Noise.NONE.and(null));
        Noise mixed = Noise.mixedPixels(1, 0);
        refused("a noise must have mixed pixels at most once", () -> mixed.and(mixed));
        Noise many = Noise.NONE;
        for (int k = 0; k < 64; k++) {
            many = many.and(Noise.gaussian(1));
        }
        Noise most = many;
        refused("a noise has at most 64 effects (got: 65)", () -> most.and(Noise.gaussian(1)));
    }

    private static void refused(String message, Runnable call) {
        assertThatThrownBy(call::run)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(message);
    }
}
