package robosim.geometry.model;

import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;

/**
 * How the beams of a {@link RayPattern} are asked: their ranges and width, what they ignore, how the
 * sensor moves meanwhile, and on how many threads.
 *
 * <pre>{@code
 * SenseOptions laser = SenseOptions.range(0.1, 30);
 * SenseOptions sonars = SenseOptions.range(0, 4).withWidth(15);
 * SenseOptions camera = SenseOptions.range(0.3, 10).withThreads(4);
 * camera.threads(); // 4
 * }</pre>
 *
 * @param min         blind range in world units
 * @param max         range in world units; may be infinite
 * @param width       full opening angle of each beam in degrees; 0 for rays
 * @param carrier     whether the sensor sees the object that carries it
 * @param threads     how many threads may work on the answer
 * @param motion      how the sensor moves during the scan; null if it stands still
 * @param seesHeights whether the beams see heights in a PLANAR world too, whichever way they look
 * @param ignored     names of objects that do not echo, or of {@linkplain GeometryObject#layers layers} of which none does; an
 *                    object comes before a layer of the same name
 */
public record SenseOptions(
        double min,
        double max,
        double width,
        Carrier carrier,
        int threads,
        @Nullable Twist motion,
        boolean seesHeights,
        Set<String> ignored) {

    /** Whether a sensor sees the object that carries it. */
    public enum Carrier {
        /** It does not echo, as with {@code getSonarDistance} and {@code scan}. */
        IGNORED,
        /** It echoes like any other object; a sensor inside a solid carrier then sees nothing else. */
        SEEN
    }

    /** Refuses null, and numbers that are out of range. */
    public SenseOptions {
        Checks.range(min, max);
        min += 0.0;
        max += 0.0;
        width = Checks.width(width) + 0.0;
        Checks.present("carrier", carrier);
        Checks.threads(threads);
        ignored = Checks.names("ignored", ignored);
    }

    /**
     * Rays with given ranges, which ignore the object that carries the sensor, on one thread.
     *
     * @param min blind range, world units; a nearer echo is reported as {@code min} and still hides what is behind it
     * @param max range, world units, {@code min <= max}; may be infinite
     */
    public static SenseOptions range(double min, double max) {
        return new SenseOptions(min, max, 0, Carrier.IGNORED, 1, null, false, Set.of());
    }

    /**
     * These options with beams of another width.
     *
     * @param degrees full opening angle of each beam, from 0 (a ray) up to, not including, 180
     */
    public SenseOptions withWidth(double degrees) {
        return new SenseOptions(min, max, degrees, carrier, threads, motion, seesHeights, ignored);
    }

    /** These options for a sensor that sees or does not see the object that carries it. */
    public SenseOptions withCarrier(Carrier seen) {
        return new SenseOptions(min, max, width, seen, threads, motion, seesHeights, ignored);
    }

    /**
     * These options on up to so many threads. No answer depends on the number. A world is used by one thread at a time
     * and takes one whatever this says; a snapshot takes more.
     *
     * @param count 1 to 1024
     */
    public SenseOptions withThreads(int count) {
        return new SenseOptions(min, max, width, carrier, count, motion, seesHeights, ignored);
    }

    /**
     * These options for a sensor that moves during the scan: a beam begins where the object that carries it, or a sensor
     * that nothing carries, is {@linkplain Twist#after after} the {@linkplain RayPattern#time time} of the beam. All else
     * stands still, and nothing is moved in the world. Each answer is, to the bit, that of a call with the carrier there.
     * Without times in the pattern nothing moves.
     *
     * <p>The object that carries the sensor must be {@link Carrier#IGNORED}.
     */
    public SenseOptions withMotion(Twist velocity) {
        return new SenseOptions(
                min, max, width, carrier, threads, Checks.present("velocity", velocity), seesHeights, ignored);
    }

    /** These options for a sensor that stands still during the scan. */
    public SenseOptions withoutMotion() {
        return new SenseOptions(min, max, width, carrier, threads, null, seesHeights, ignored);
    }

    /** These options with other ranges, as in {@link #range}. */
    public SenseOptions withRange(double least, double most) {
        return new SenseOptions(least, most, width, carrier, threads, motion, seesHeights, ignored);
    }

    /**
     * These options for beams that see the objects of a PLANAR world with their heights. Without it sonars and level lasers
     * measure in the plane there, and only a sensor that looks up or down sees heights. In a SPATIAL world it has no effect.
     */
    public SenseOptions withHeights() {
        return new SenseOptions(min, max, width, carrier, threads, motion, true, ignored);
    }

    /**
     * These options without some objects, as if they were not there.
     *
     * @param names of objects or {@linkplain GeometryObject#layers layers}, all of which must be in the world that is queried
     */
    public SenseOptions ignoring(String... names) {
        return new SenseOptions(min, max, width, carrier, threads, motion, seesHeights, Set.of(names));
    }
}
