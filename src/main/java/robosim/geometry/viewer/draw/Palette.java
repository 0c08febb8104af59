package robosim.geometry.viewer.draw;

import robosim.geometry.model.GeometryObject;

/** The colours: muted for static objects, vivid for moveable objects and measurements. */
public final class Palette {
    public static final Ink PAPER = new Ink(0xfbfaf7, 0x14171c);
    public static final Ink FLOOR = new Ink(0xffffff, 0x1b1f26);
    static final Ink GRID = new Ink(0xe4e3dd, 0x2a303a);
    public static final Ink BORDER = new Ink(0x8b8f96, 0x6d7581);
    public static final Ink TEXT = new Ink(0x22262b, 0xe6e8eb);
    public static final Ink QUIET = new Ink(0x6a7078, 0x98a0ab);
    public static final Ink REFUSED = new Ink(0xc8102e, 0xff5c6c);

    static final Ink GOAL = new Ink(0x1e7a34, 0x6fd98a);

    static final Ink PICKED = new Ink(0x1a1d21, 0xffffff);

    private static final Ink BOX = new Ink(0x9aa3ae, 0x5a6472);
    private static final Ink CYLINDER = new Ink(0xb79f7f, 0x7d6a50);
    private static final Ink CAPSULE = new Ink(0xb58f8f, 0x7a5757);
    private static final Ink SPHERE = new Ink(0x7fa8a3, 0x47706b);
    private static final Ink MESH = new Ink(0xa795b5, 0x6c5a7b);
    private static final Ink GROUP = new Ink(0xa3ab88, 0x666e4c);

    /** Darker than other objects, as cells have no edges. */
    private static final Ink GRID_CELL = new Ink(0x5f6974, 0x8b96a5);

    /** Hues that differ in lightness too, for colour-blind readers (after Okabe and Ito). */
    private static final Ink[] ROBOTS = {
        new Ink(0x0067a8, 0x56b4e9), new Ink(0xc85a00, 0xff9f45), new Ink(0x00805a, 0x2fd0a0),
                new Ink(0xa8447f, 0xf19fcf),
        new Ink(0x6a4fc0, 0xb3a1ff), new Ink(0x8a7300, 0xf0e442), new Ink(0x00758a, 0x62dbe8),
                new Ink(0x7a4a2b, 0xd7a27e)
    };

    /** Steps of the ramp of distances. */
    static final int RAMP = 64;

    private static final Ink[] DISTANCES = ramp();

    private Palette() {}

    public static Ink of(GeometryObject.Kind kind) {
        return switch (kind) {
            case BOX -> BOX;
            case CYLINDER -> CYLINDER;
            case SPHERE -> SPHERE;
            case CAPSULE -> CAPSULE;
            case MESH -> MESH;
            case GROUP -> GROUP;
            case GRID -> GRID_CELL;
        };
    }

    public static Ink robot(int number) {
        return ROBOTS[Math.floorMod(number, ROBOTS.length)];
    }

    /**
     * The colour of a distance as a fraction of the largest, from 0 to 1: nearer ones contrast more with the
     * background.
     */
    public static Ink distance(double share) {
        double step = Math.max(0, Math.min(1, share)) * (RAMP - 1);
        return DISTANCES[(int) Math.round(step)];
    }

    /** Even steps of lightness and of hue in OKLCh (Ottosson 2020), so that the order of the colours is visible. */
    private static Ink[] ramp() {
        Ink[] ramp = new Ink[RAMP];
        for (int k = 0; k < RAMP; k++) {
            double far = k / (RAMP - 1.0);
            double hue = 20 + 190 * far;
            ramp[k] = new Ink(
                    okLch(0.52 + 0.30 * far, 0.20 - 0.09 * far, hue), okLch(0.80 - 0.36 * far, 0.17 - 0.08 * far, hue));
        }
        return ramp;
    }

    /** Lightness, chroma and hue in degrees of OKLCh to sRGB. */
    private static int okLch(double lightness, double chroma, double hue) {
        double a = chroma * StrictMath.cos(StrictMath.toRadians(hue));
        double b = chroma * StrictMath.sin(StrictMath.toRadians(hue));
        double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
        double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
        double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
        int red = gamma(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s);
        int green = gamma(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s);
        int blue = gamma(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s);
        return red << 16 | green << 8 | blue;
    }

    private static double cube(double v) {
        return v * v * v;
    }

    private static int gamma(double linear) {
        double v = Math.max(0, Math.min(1, linear));
        double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * StrictMath.pow(v, 1 / 2.4) - 0.055;
        return (int) Math.round(255 * encoded);
    }
}
