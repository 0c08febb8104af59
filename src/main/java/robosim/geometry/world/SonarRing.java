package robosim.geometry.world;

import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/**
 * Range sensors of a robot that point outward from its centre, horizontally in its own frame.
 *
 * <p>Sensor {@code k} points {@code first + k * step} degrees, counter-clockwise from forward.
 *
 * @param count number of sensors, 1 to 10,000
 * @param first degrees from forward to the first of them
 * @param step  degrees from one to the next
 * @param min   blind range in world units; at least 0
 * @param max   range in world units, {@code min <= max}; may be infinite
 * @param width full opening angle of each in degrees, from 0 (a line) up to, not including, 180
 */
public record SonarRing(int count, double first, double step, double min, double max, double width) {
    /** The maximum number of sensors, more than any scanner has. */
    static final int MAX_COUNT = 10_000;

    /** Refuses numbers out of range. */
    public SonarRing {
        if (count < 1 || count > MAX_COUNT) {
            throw new IllegalArgumentException("count must be 1 to " + MAX_COUNT + " (got: " + count + ")");
        }
        if (!Double.isFinite(first)) {
            throw new IllegalArgumentException("first must be a finite angle in degrees (got: " + first + ")");
        }
        if (!Double.isFinite(step)) {
            throw new IllegalArgumentException("step must be a finite angle in degrees (got: " + step + ")");
        }
        if (!(min >= 0 && min <= 0x1p100)) {
            throw new IllegalArgumentException("min must be from 0 to 2^100 (got: " + min + ")");
        }
        if (!(max >= min)) {
            throw new IllegalArgumentException("max must be at least min, " + min + " (got: " + max + ")");
        }
        if (!(width >= 0 && width < 180)) {
            throw new IllegalArgumentException("width must be 0 to below 180 degrees (got: " + width + ")");
        }
        first += 0.0; // no -0.0
        step += 0.0;
        min += 0.0;
        max += 0.0;
        width += 0.0;
    }

    /** Sensors all round, the first of them straight ahead. */
    public SonarRing(int count, double min, double max, double width) {
        this(count, 0, 360.0 / Math.max(count, 1), min, max, width);
    }

    /** The direction of a sensor in the robot's own frame, a unit vector. */
    public Point direction(int sensor) {
        if (sensor < 0 || sensor >= count) {
            throw new IllegalArgumentException("sensor must be 0 to " + (count - 1) + " (got: " + sensor + ")");
        }
        double degrees = first + sensor * step;
        return new Point(Degrees.cos(degrees), 0, -Degrees.sin(degrees));
    }

    /** A sensor as a ray in the robot's own frame, from its centre. */
    public Ray mount(int sensor) {
        return new Ray(new Point(), direction(sensor));
    }
}
