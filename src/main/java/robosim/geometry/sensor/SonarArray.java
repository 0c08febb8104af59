package robosim.geometry.sensor;

import robosim.geometry.SenseBuffer;
import robosim.geometry.check.Checks;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;

/**
 * Sonars that sit together: cones, each of which hears the nearest point of anything within it.
 *
 * <pre>{@code
 * SonarArray ring = SonarArray.ring(16, 15, 0.1, 5).on("robot", Pose.ORIGIN); // all round, 15 degrees wide
 * SonarArray front = SonarArray.of(RayPattern.fan(-60, 30, 5), SenseOptions.range(0.1, 5).withWidth(20));
 * ring.pattern().size(); // 16
 * }</pre>
 */
public final class SonarArray extends RaySensor<SonarArray, SonarFrame> {
    private SonarArray(Setup setup) {
        super(setup);
    }

    /**
     * Sonars all round, the first of them straight ahead and the others counter-clockwise from there.
     *
     * @param count number of sonars, at least 1
     * @param width full opening angle of each in degrees, from 0 (a ray) up to, not including, 180
     * @param min   blind range in world units
     * @param max   range in world units; may be infinite
     */
    public static SonarArray ring(int count, double width, double min, double max) {
        return of(
                RayPattern.fan(0, 360.0 / Math.max(count, 1), count),
                SenseOptions.range(min, max).withWidth(width));
    }

    /** Sonars in any directions; the width of the options is theirs. */
    public static SonarArray of(RayPattern pattern, SenseOptions options) {
        return new SonarArray(Setup.of(Checks.present("pattern", pattern), Checks.present("options", options)));
    }

    @Override
    SonarArray with(Setup other) {
        return new SonarArray(other);
    }

    @Override
    boolean needs(SenseBuffer.Extra extra, SonarFrame out) {
        return extra == SenseBuffer.Extra.OBJECTS;
    }
}
