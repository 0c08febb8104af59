package robosim.geometry.sensor;

import org.jspecify.annotations.Nullable;
import robosim.geometry.SenseBuffer;
import robosim.geometry.Snapshot;
import robosim.geometry.WorldQueries;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.sensor.effects.Draws;

/**
 * A sensor with rays: what lidars, cameras and sonars share. Immutable; each {@code with} returns a new sensor.
 *
 * @param <S> the sensor itself
 * @param <F> what it is read into
 */
public abstract class RaySensor<S extends RaySensor<S, F>, F extends RayFrame> {
    final Setup setup;

    RaySensor(Setup setup) {
        this.setup = setup;
    }

    /** The same kind of sensor, set up otherwise. */
    abstract S with(Setup other);

    /** Computes what the frame has beside distances, objects and normals; distances may have noise by now. */
    void finish(F out) {}

    /** Whether the frame needs something beside distances, whatever the noise. */
    boolean needs(SenseBuffer.Extra extra, F out) {
        return false;
    }

    /**
     * This sensor on a moveable object.
     *
     * @param carrier the object's name
     * @param mount   where the sensor is and which way it faces, in the object's own frame
     */
    public S on(String carrier, Pose mount) {
        return with(setup.with(Mounting.on(carrier, mount)));
    }

    /** This sensor at a place in the world, carried by nothing. */
    public S at(Pose sensor) {
        return with(setup.with(Mounting.at(sensor)));
    }

    /**
     * This sensor with other ranges.
     *
     * @param min blind range in world units; a nearer echo is reported as {@code min}, except {@link #withRep117}, and still hides what is behind it
     * @param max range in world units, {@code min <= max}; may be infinite
     */
    public S withRange(double min, double max) {
        return with(setup.with(setup.options().withRange(min, max)));
    }

    /**
     * This sensor with the values of ROS (REP 117) and Gazebo for what is out of its range: {@code -Infinity} for an echo nearer than
     * the blind range, {@code +Infinity} for none within the range, and NaN for a reading that {@link Noise#dropout} lost. Such a
     * ray has no point and no intensity, and clouds leave it out.
     */
    public S withRep117() {
        return withOutOfRange(OutOfRange.REP_117);
    }

    /**
     * This sensor with the blind range for an echo nearer than that, and {@code +Infinity} for none within the range and for a lost
     * reading, which is the default except for sensors from SDFormat. Such a ray has no point and no intensity either.
     */
    public S withClampedRanges() {
        return withOutOfRange(OutOfRange.CLAMPED);
    }

    S withOutOfRange(OutOfRange reported) {
        return with(setup.with(reported));
    }

    /** This sensor, seeing or not seeing the object that carries it. Unless told otherwise it does not. */
    public S withCarrier(SenseOptions.Carrier seen) {
        return with(setup.with(setup.options().withCarrier(seen)));
    }

    /**
     * This sensor on up to so many threads, 1 to 1024, where it reads a {@link Snapshot}. No answer depends on the number.
     */
    public S withThreads(int count) {
        return with(setup.with(setup.options().withThreads(count)));
    }

    /**
     * This sensor with noise. Its readings then need the number of their frame.
     *
     * @param seed   of a whole run
     * @param sensor any number, another one for each sensor of a run: two sensors with the same seed and number have the same
     *               errors
     */
    public S withNoise(Noise noise, long seed, long sensor) {
        return with(setup.with(noise, seed, sensor));
    }

    /**
     * This sensor with noise that depends on its name, so that two sensors of one run have errors of their own. Its readings
     * then need the number of their frame.
     *
     * @param seed of a whole run
     * @param name of the sensor, as in a file; any text
     */
    public S withNoise(Noise noise, long seed, String name) {
        return withNoise(noise, seed, Draws.number(Checks.present("name", name)));
    }

    /** The directions of the rays in the sensor's own frame, and their order. */
    public RayPattern pattern() {
        return setup.pattern();
    }

    /** Ranges, carrier and threads. */
    public SenseOptions options() {
        return setup.options();
    }

    OutOfRange outOfRange() {
        return setup.outOfRange();
    }

    /** The noise; {@link Noise#NONE} unless one was given. */
    public Noise noise() {
        return setup.noise();
    }

    /** The object that carries the sensor; null if nothing does. */
    public @Nullable String carrier() {
        return setup.mounting().carrier();
    }

    /** Where the sensor is and which way it faces: in the frame of its carrier, or in the world. */
    public Pose mount() {
        return setup.mounting().pose();
    }

    /** Reads a sensor without noise. One with noise must be told the number of the frame. */
    public void read(WorldQueries world, F out) {
        if (!setup.noise().isNone()) {
            throw new IllegalArgumentException(
                    "a sensor with noise must be told the number of its frame, as in read(world, 17, out)"
                            + " (got: none; the noise is " + setup.noise() + ")");
        }
        read(world, 0, out);
    }

    /**
     * Reads the sensor: a world on the calling thread, a {@link Snapshot} on as many threads as the sensor may take. A snapshot
     * may be read by many threads at once, each with a frame of its own.
     *
     * @param frame the number of the reading, which the noise depends on; count them as the simulation goes on
     */
    public void read(WorldQueries world, long frame, F out) {
        Checks.present("world", world);
        Checks.present("out", out);
        boolean needsIncidence = setup.noise().needsIncidence();
        out.prepare(
                needs(SenseBuffer.Extra.OBJECTS, out),
                needs(SenseBuffer.Extra.PARTS, out),
                needs(SenseBuffer.Extra.NORMALS, out) || needsIncidence,
                setup.options().width() > 0);
        setup.mounting().sense(world, setup.pattern(), setup.asked().rays(), out.buffer());
        out.filled(setup, frame);
        if (!setup.noise().isNone()) {
            boolean isFlat = out.buffer().dimension() == Dimension.PLANAR;
            SenseOptions cones = isFlat ? setup.asked().cones() : setup.asked().tall();
            if (cones != null) {
                setup.mounting().sense(world, setup.pattern(), cones, out.cones());
            }
        }
        out.measure(setup);
        finish(out);
        out.finished();
    }

    @Override
    @SuppressWarnings("EqualsGetClass") // all kinds of sensors are final, and two kinds are never equal
    public boolean equals(@Nullable Object other) {
        return other != null && getClass() == other.getClass() && setup.equals(((RaySensor<?, ?>) other).setup);
    }

    @Override
    public int hashCode() {
        return setup.hashCode();
    }

    @Override
    public String toString() {
        return getClass().getSimpleName() + " " + setup.mounting() + ", " + setup.pattern() + ", " + setup.options()
                + ", " + setup.outOfRange() + ", " + setup.noise();
    }
}
