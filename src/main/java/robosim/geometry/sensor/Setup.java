package robosim.geometry.sensor;

import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;

/**
 * What all sensors with rays have in common.
 *
 * @param asked what follows from the others
 */
record Setup(
        Mounting mounting,
        RayPattern pattern,
        SenseOptions options,
        OutOfRange outOfRange,
        Errors errors,
        Asked asked) {

    /** What happens to true distances. */
    record Errors(Noise noise, long seed, long sensor) {
        private static final Errors NONE = new Errors(Noise.NONE, 0, 0);
    }

    /**
     * How a world is asked.
     *
     * @param rays  without the blind range, so that what is nearer can be told from what is there
     * @param cones that the noise needs, with rays that measure in the plane of a PLANAR world; null if it needs none
     * @param tall  the same with rays that see heights
     */
    record Asked(
            SenseOptions rays,
            @Nullable SenseOptions cones,
            @Nullable SenseOptions tall) {
        private static Asked of(SenseOptions options, double coneWidth) {
            SenseOptions rays = options.min() == 0 ? options : options.withRange(0, options.max());
            if (coneWidth == 0) {
                return new Asked(rays, null, null);
            }
            SenseOptions wide = options.withWidth(coneWidth);
            return new Asked(rays, wide, wide.withHeights());
        }
    }

    static Setup of(RayPattern pattern, SenseOptions options) {
        return new Setup(
                Mounting.ORIGIN,
                Checks.present("pattern", pattern),
                Checks.present("options", options),
                OutOfRange.CLAMPED,
                Errors.NONE,
                Asked.of(options, 0));
    }

    Noise noise() {
        return errors.noise;
    }

    Setup with(Mounting place) {
        return new Setup(place, pattern, options, outOfRange, errors, asked);
    }

    Setup with(SenseOptions given) {
        return new Setup(mounting, pattern, given, outOfRange, errors, Asked.of(given, noise().coneWidth()));
    }

    Setup with(OutOfRange reported) {
        return new Setup(mounting, pattern, options, Checks.present("reported", reported), errors, asked);
    }

    Setup with(Noise given, long seed, long sensor) {
        double width = Checks.present("noise", given).coneWidth();
        if (options.width() > 0 && given.needsIncidence()) {
            throw new IllegalArgumentException(
                    "noise must not need the normals of rays, as grazing and mixedPixels do, where beams are cones (got: "
                            + given + ")");
        }
        Errors other = new Errors(given, seed, sensor);
        return new Setup(mounting, pattern, options, outOfRange, other, Asked.of(options, width));
    }
}
