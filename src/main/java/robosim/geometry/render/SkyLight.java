package robosim.geometry.render;

import robosim.geometry.material.Color;

/** A {@link Sky} in linear components. */
final class SkyLight {
    private final double[] zenith = new double[3];
    private final double[] horizon = new double[3];
    private final double[] ground = new double[3];
    private final double[] above = new double[3];
    private final double[] below = new double[3];

    SkyLight(Sky sky) {
        set(zenith, sky.zenith());
        set(horizon, sky.horizon());
        set(ground, sky.ground());
        Color light = sky.light();
        if (light != null) {
            set(above, light);
            set(below, light);
        }
        for (int k = 0; k < 3; k++) {
            above[k] = sky.strength() * (light == null ? (zenith[k] + horizon[k]) / 2 : above[k]);
            below[k] = sky.strength() * (light == null ? ground[k] : below[k]);
        }
    }

    private static void set(double[] out, Color color) {
        out[0] = color.linearRed();
        out[1] = color.linearGreen();
        out[2] = color.linearBlue();
    }

    /** Adds what is seen in a direction: from the horizon up it fades by the third power, and down it soon is the ground. */
    void addSeen(double up, double weight, double[] out, int at) {
        double[] end = up >= 0 ? zenith : ground;
        double rest = 1 - Math.min(1, Math.abs(up) * (up >= 0 ? 1 : 3));
        double share = rest * rest * rest;
        for (int k = 0; k < 3; k++) {
            out[at + k] += weight * (end[k] + (horizon[k] - end[k]) * share);
        }
    }

    /** The even light on a surface, by how far its unit normal goes up. */
    double ambient(int component, double up) {
        return below[component] + (above[component] - below[component]) * (0.5 + 0.5 * up);
    }
}
