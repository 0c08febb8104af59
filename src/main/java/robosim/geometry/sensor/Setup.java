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
        @Nullable SenseOptions cones) {

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
        SenseOptions wide = cones == null ? null : given.withWidth(cones.width());
        return new Setup(mounting, pattern, given, noise, seed, sensor, wide);
    }

    Setup with(Noise given, long itsSeed, long itsSensor) {
        double width = Checks.present("noise", given).coneWidth();
        if (options.width() > 0 && given.needsIncidence()) {
            throw new IllegalArgumentException(
                    "noise must not need the normals of rays, as grazing and mixedPixels do, where beams are cones (got: "
                            + given + ")");
        }
        SenseOptions wide = width == 0 ? null : options.withWidth(width);
        return new Setup(mounting, pattern, options, given, itsSeed, itsSensor, wide);
    }
}
