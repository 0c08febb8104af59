package robosim.geometry.sensor;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import robosim.geometry.check.Checks;
import robosim.geometry.sensor.effects.Draws;
import robosim.geometry.sensor.effects.NoiseEffect;
import robosim.geometry.sensor.effects.NoisyFrame;

/**
 * What a sensor does to a true distance: a list of effects, each of which takes what the one before it left. Immutable;
 * equal where the effects are.
 *
 * <pre>{@code
 * Noise laser = Noise.gaussian(0.01).and(Noise.proportional(0.002)).and(Noise.quantized(0.001));
 * Noise cheap = laser.and(Noise.dropout(0.02)).and(Noise.grazing(0.005, 80));
 * Noise.NONE.and(laser).equals(laser); // true
 * Lidar noisy = Lidar.velodyneVlp16(10).withNoise(cheap, 42, 1);
 * }</pre>
 *
 * <p>Random numbers are drawn by place and not in turn: a number depends on the seed, the sensor, the frame, the ray and
 * the position of its effect in the list, and on nothing else. So a reading is the same whatever was read before it, on any
 * number of threads, and on every JVM to the bit.
 *
 * <p>After all effects, a distance below the sensor's blind range is reported as that range, or by {@link
 * RaySensor#withRep117 another value}, and one beyond its range as no echo. A ray without an echo stays without one, except by {@link #falseEchoes}.
 */
public final class Noise {
    /** No noise: distances as they are. */
    public static final Noise NONE = new Noise(List.of());

    private static final int MOST = 64;

    private final List<NoiseEffect> effects;
    private final boolean needsIncidence;
    private final double coneWidth;

    private Noise(List<NoiseEffect> effects) {
        this.effects = effects;
        needsIncidence = effects.stream().anyMatch(NoiseEffect::needsIncidence);
        coneWidth = effects.stream().mapToDouble(NoiseEffect::coneWidth).sum(); // at most one needs cones
    }

    /**
     * A normal error of the same size at any distance.
     *
     * @param deviation standard deviation in world units; at least 0
     */
    public static Noise gaussian(double deviation) {
        return gaussian(0, deviation);
    }

    /**
     * A normal error with a mean.
     *
     * @param mean      world units
     * @param deviation standard deviation in world units; at least 0
     */
    public static Noise gaussian(double mean, double deviation) {
        return of(new NoiseEffect.Gaussian(Checks.coordinate("mean", mean), Checks.size("deviation", deviation)));
    }

    /**
     * A normal error that grows with the distance.
     *
     * @param share standard deviation over the distance; from 0 to 1
     */
    public static Noise proportional(double share) {
        return of(new NoiseEffect.Proportional(share("share", share)));
    }

    /**
     * An error that is drawn once for a seed and a sensor and is the same in all its frames and rays.
     *
     * @param mean      world units
     * @param deviation standard deviation in world units; at least 0
     */
    public static Noise bias(double mean, double deviation) {
        return of(new NoiseEffect.Bias(Checks.coordinate("mean", mean), Checks.size("deviation", deviation)));
    }

    /**
     * Distances in whole steps: each is rounded to the nearest multiple.
     *
     * @param step world units; from 2<sup>-100</sup> on
     */
    public static Noise quantized(double step) {
        if (!(step >= 0x1p-100 && step <= Checks.LIMIT)) {
            throw new IllegalArgumentException("step must be from 2^-100 to 2^100 (got: " + step + ")");
        }
        return of(new NoiseEffect.Quantized(step));
    }

    /**
     * Echoes that get lost.
     *
     * @param probability from 0 to 1, of each
     */
    public static Noise dropout(double probability) {
        return of(new NoiseEffect.Dropout(share("probability", probability)));
    }

    /**
     * Worse at grazing incidence: a normal error whose standard deviation is {@code deviation * tan(incidence)}, and no echo
     * beyond a limit. The angle of incidence is that between the ray and the surface normal. It needs normals, which the
     * frame then computes.
     *
     * @param deviation    standard deviation at 45 degrees in world units; at least 0
     * @param limitDegrees greatest angle of incidence with an echo, above 0 and at most 90
     */
    public static Noise grazing(double deviation, double limitDegrees) {
        if (!(limitDegrees > 0 && limitDegrees <= 90)) {
            throw new IllegalArgumentException(
                    "limitDegrees must be above 0 and at most 90 (got: " + limitDegrees + ")");
        }
        return of(new NoiseEffect.Grazing(Checks.size("deviation", deviation), limitDegrees));
    }

    /**
     * Mixed pixels: a real beam has a width, and at the edge of an object a part of it passes on to what is behind. Where
     * something within the cone around a ray is nearer, by more than a gap, than anything of the plane that the ray meets,
     * the distance is drawn evenly from between the two; where the ray itself meets nothing, it is the nearer one for half of
     * the rays and no echo for the others. It needs normals, and one cone for each ray: it takes several times as long as a
     * reading without it. Put it before effects that add errors; a noise has it at most once.
     *
     * @param widthDegrees full opening angle of the beam, above 0 and below 90
     * @param gap          world units; at least 0
     */
    public static Noise mixedPixels(double widthDegrees, double gap) {
        if (!(widthDegrees > 0 && widthDegrees < 90)) {
            throw new IllegalArgumentException("widthDegrees must be above 0 and below 90 (got: " + widthDegrees + ")");
        }
        return of(new NoiseEffect.MixedPixels(widthDegrees, Checks.size("gap", gap)));
    }

    /**
     * Echoes of dust, rain or another sensor's light: a distance that is even between the sensor's blind range and what the
     * ray would have measured, or the sensor's range where that is nothing. With an infinite range a ray without an echo has
     * no false one.
     *
     * @param probability from 0 to 1, of each ray
     */
    public static Noise falseEchoes(double probability) {
        return of(new NoiseEffect.FalseEchoes(share("probability", probability)));
    }

    private static Noise of(NoiseEffect effect) {
        return new Noise(List.of(effect));
    }

    private static double share(String argument, double value) {
        if (!(value >= 0 && value <= 1)) { // written so that NaN fails it
            throw new IllegalArgumentException(argument + " must be from 0 to 1 (got: " + value + ")");
        }
        return value + 0.0;
    }

    /** This noise, then another one; at most 64 effects. */
    public Noise and(Noise next) {
        if (Checks.present("next", next).coneWidth() > 0 && coneWidth() > 0) {
            throw new IllegalArgumentException(
                    "a noise must have mixed pixels at most once (got: " + this + ", and " + next + ")");
        }
        List<NoiseEffect> all = new ArrayList<>(effects);
        all.addAll(next.effects);
        if (all.size() > MOST) {
            throw new IllegalArgumentException("a noise has at most " + MOST + " effects (got: " + all.size() + ")");
        }
        return new Noise(List.copyOf(all));
    }

    /** Whether it changes nothing. */
    public boolean isNone() {
        return effects.isEmpty();
    }

    boolean needsIncidence() {
        return needsIncidence;
    }

    /** The opening angle of the cones that are needed; 0 for none. */
    double coneWidth() {
        return coneWidth;
    }

    /** Changes distances. */
    void apply(long seed, long sensor, long frame, NoisyFrame measured) {
        long ofSensor = Draws.key(Draws.key(0, seed), sensor);
        long ofFrame = Draws.key(ofSensor, frame);
        for (int k = 0; k < effects.size(); k++) {
            NoiseEffect effect = effects.get(k);
            long key = Draws.key(effect.isConstant() ? ofSensor : ofFrame, k);
            effect.apply(key, Draws.step(key), measured);
        }
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Noise that && effects.equals(that.effects);
    }

    @Override
    public int hashCode() {
        return effects.hashCode();
    }

    @Override
    public String toString() {
        return effects.isEmpty()
                ? "no noise"
                : effects.stream().map(NoiseEffect::toString).collect(Collectors.joining(", then "));
    }
}
