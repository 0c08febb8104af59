package robosim.geometry.sensor;

import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;

/**
 * What all sensors with rays have in common.
 *
 * @param cones how the cones that the noise needs are asked; null if it needs none
 */
record Setup(
        Mounting mounting,
        RayPattern pattern,
        SenseOptions options,
        Noise noise,
        long seed,
        long sensor,
        @Nullable Cones cones) {

    /**
     * How cones are asked.
     *
     * @param flat with rays that measure in the plane of a PLANAR world
     * @param tall with rays that see heights
     */
    record Cones(SenseOptions flat, SenseOptions tall) {
        private static @Nullable Cones of(SenseOptions options, double width) {
            if (width == 0) {
                return null;
            }
            SenseOptions wide = options.withWidth(width);
            return new Cones(wide, wide.withHeights());
        }
    }

    static Setup of(RayPattern pattern, SenseOptions options) {
        return new Setup(
                Mounting.ORIGIN,
                Checks.present("pattern", pattern),
                Checks.present("options", options),
                Noise.NONE,
                0,
                0,
                null);
    }

    Setup with(Mounting place) {
        return new Setup(place, pattern, options, noise, seed, sensor, cones);
    }

    Setup with(SenseOptions given) {
        return new Setup(mounting, pattern, given, noise, seed, sensor, Cones.of(given, noise.coneWidth()));
    }

    Setup with(Noise given, long itsSeed, long itsSensor) {
        double width = Checks.present("noise", given).coneWidth();
        if (options.width() > 0 && given.needsIncidence()) {
            throw new IllegalArgumentException(
                    "noise must not need the normals of rays, as grazing and mixedPixels do, where beams are cones (got: "
                            + given + ")");
        }
        return new Setup(mounting, pattern, options, given, itsSeed, itsSensor, Cones.of(options, width));
    }
}
