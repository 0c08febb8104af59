package robosim.geometry.sensor.effects;

/**
 * Random numbers by their place: each is a function of a key and an index, so neither the order in which they are drawn
 * nor the threads matter. Number k of a key is the finalizer of SplittableRandom (Steele, Lea and Flood 2014)
 * applied to a Weyl sequence whose start and step are hashes of the key.
 *
 * <p>Normal numbers come from the ziggurat of Marsaglia and Tsang (2000), in the form of Doornik (2005) that takes the
 * layer and the number from different bits. Its tables are computed with StrictMath, and everything else is sums,
 * products and comparisons, so that all numbers are the same bits on every JVM.
 */
public final class Draws {
    private static final long GOLDEN = 0x9e3779b97f4a7c15L;
    private static final double UNIT = 0x1p-53;

    private static final int LAYERS = 256;

    /** Where the tail begins, so that all layers have the same area under exp(-x*x/2). */
    private static final double TAIL = 3.654152885361009;

    /** The area of a layer: TAIL * exp(-TAIL^2 / 2) plus the integral of the tail. */
    private static final double AREA = 0.004928673233974658;

    /** The right end of each layer; layer 0 is the base with the tail, as a rectangle of the same area. */
    private static final double[] END = new double[LAYERS + 1];

    /** The part of each layer that lies under the one above it, and so under the curve. */
    private static final double[] CORE = new double[LAYERS];

    static {
        END[0] = AREA / density(TAIL);
        END[1] = TAIL;
        for (int k = 2; k < LAYERS; k++) {
            END[k] = StrictMath.sqrt(-2 * StrictMath.log(AREA / END[k - 1] + density(END[k - 1])));
        }
        for (int k = 0; k < LAYERS; k++) {
            CORE[k] = END[k + 1] / END[k];
        }
    }

    private Draws() {}

    private static double density(double x) {
        return StrictMath.exp(-0.5 * x * x);
    }

    /** A key, from a key and a number. */
    public static long key(long key, long number) {
        return mix(key + number + GOLDEN);
    }

    /** A number that stands for a name: another one for another name. */
    public static long number(String name) {
        long number = name.length();
        for (int k = 0; k < name.length(); k++) {
            number = key(number, name.charAt(k));
        }
        return number;
    }

    /** The step of a key's Weyl sequence, an odd number. */
    public static long step(long key) {
        return mix(key + GOLDEN) | 1;
    }

    /** The 64 bits of an index. */
    public static long bits(long key, long step, int index) {
        return mix(key + (index + 1) * step);
    }

    /** Further bits, from some. */
    public static long more(long bits) {
        return mix(bits + GOLDEN);
    }

    private static long mix(long bits) {
        long z = (bits ^ (bits >>> 30)) * 0xbf58476d1ce4e5b9L;
        z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
        return z ^ (z >>> 31);
    }

    /** A number from 0 up to, not including, 1. */
    public static double uniform(long bits) {
        return (bits >>> 11) * UNIT;
    }

    /** A normal number of mean 0 and variance 1. */
    public static double normal(long bits) {
        int layer = (int) bits & (LAYERS - 1);
        double part = (bits >> 11) * 0x1p-52; // from -1 up to, not including, 1
        if (Math.abs(part) < CORE[layer]) {
            return part * END[layer];
        }
        return outside(bits, layer, part);
    }

    /** A normal number, given bits that fell outside the cores: one draw in 80. */
    private static double outside(long given, int firstLayer, double firstPart) {
        long bits = given;
        int layer = firstLayer;
        double part = firstPart;
        while (true) {
            if (layer == 0) {
                return tail(bits, part < 0);
            }
            double x = part * END[layer];
            // The layer's lower and upper edge, as multiples of the density at x.
            double low = StrictMath.exp(-0.5 * (END[layer] * END[layer] - x * x));
            double high = StrictMath.exp(-0.5 * (END[layer + 1] * END[layer + 1] - x * x));
            bits = more(bits);
            if (low + uniform(bits) * (high - low) < 1) {
                return x;
            }
            bits = more(bits);
            layer = (int) bits & (LAYERS - 1);
            part = (bits >> 11) * 0x1p-52;
            if (Math.abs(part) < CORE[layer]) {
                return part * END[layer];
            }
        }
    }

    /** Beyond the last layer, by Marsaglia's (1964) method. */
    private static double tail(long given, boolean isNegative) {
        long bits = given;
        while (true) {
            bits = more(bits);
            double x = StrictMath.log(1 - uniform(bits)) / TAIL;
            bits = more(bits);
            double y = StrictMath.log(1 - uniform(bits));
            if (-2 * y >= x * x) {
                return isNegative ? x - TAIL : TAIL - x;
            }
        }
    }
}
