package robosim.geometry.material;

import java.io.Serial;
import java.io.Serializable;
import java.util.HexFormat;
import robosim.geometry.check.Checks;

/**
 * A colour in sRGB, as in picture files and on web pages. Light is added and multiplied in linear components, which
 * {@link #linear} gives; they are the same bits on every JVM.
 *
 * @param red   share of red, encoded as in sRGB, from 0 to 1
 * @param green share of green
 * @param blue  share of blue
 */
public record Color(double red, double green, double blue) implements Serializable {
    public static final Color BLACK = new Color(0, 0, 0);
    public static final Color WHITE = new Color(1, 1, 1);

    @Serial
    private static final long serialVersionUID = 1;

    private static final int MOST = 255;

    /** By component of 8 bits: its linear value. */
    private static final double[] LINEAR = new double[MOST + 1];

    /** By component of 8 bits: the least linear value that is rounded to it, halfway between its encoding and the one below. */
    private static final double[] LEAST = new double[MOST + 1];

    /** Parts of the linear values from 0 to 1, for a first guess; a power of two. */
    private static final int PARTS = 4096;

    /** By part: the component of the least value in it. At most one or two more are in the same part. */
    private static final int[] FROM = new int[PARTS];

    static {
        for (int k = 0; k <= MOST; k++) {
            LINEAR[k] = decoded((double) k / MOST);
            LEAST[k] = k == 0 ? 0 : decoded((k - 0.5) / MOST);
        }
        int component = 0;
        for (int k = 0; k < PARTS; k++) {
            component = upFrom(component, (double) k / PARTS);
            FROM[k] = component;
        }
    }

    public Color {
        red = Checks.share("red", red);
        green = Checks.share("green", green);
        blue = Checks.share("blue", blue);
    }

    /** The colour of a text: {@code #rrggbb}, six hexadecimal digits. */
    public static Color parse(String text) {
        if (!Checks.present("color", text).matches("#[0-9a-fA-F]{6}")) {
            throw new IllegalArgumentException("color must be #rrggbb, six hexadecimal digits (got: " + text + ")");
        }
        return ofPacked(Integer.parseInt(text.substring(1), 16));
    }

    /** The colour of a packed pixel, {@code 0xrrggbb}; higher bits are ignored. */
    public static Color ofPacked(int pixel) {
        return new Color(
                (double) (pixel >> 16 & MOST) / MOST,
                (double) (pixel >> 8 & MOST) / MOST,
                (double) (pixel & MOST) / MOST);
    }

    /** The colour of linear components from 0 to 1; {@link #linear} of it gives these again, except for rounding. */
    public static Color ofLinear(double red, double green, double blue) {
        return new Color(
                encoded(Checks.share("red", red)),
                encoded(Checks.share("green", green)),
                encoded(Checks.share("blue", blue)));
    }

    /** The three components rounded to 8 bits each, {@code 0xrrggbb}. */
    public int packed() {
        return (int) (red * MOST + 0.5) << 16 | (int) (green * MOST + 0.5) << 8 | (int) (blue * MOST + 0.5);
    }

    /** Whether each component is one of 8 bits, so that {@link #toString} tells all. */
    public boolean isPacked() {
        return equals(ofPacked(packed()));
    }

    /** The linear share of red, from 0 to 1. */
    public double linearRed() {
        return linear(red);
    }

    /** The linear share of green. */
    public double linearGreen() {
        return linear(green);
    }

    /** The linear share of blue. */
    public double linearBlue() {
        return linear(blue);
    }

    /**
     * The linear value of one component.
     *
     * @param component encoded as in sRGB, from 0 to 1
     */
    public static double linear(double component) {
        return decoded(Checks.share("component", component));
    }

    /**
     * The linear value of one component of 8 bits, from a table.
     *
     * @param component from 0 to 255
     */
    public static double linear(int component) {
        return LINEAR[component];
    }

    /**
     * One component of 8 bits for a linear value: the nearest encoding, from a table.
     *
     * @param linear any number; below 0 and NaN count as 0, above 1 as 1
     */
    public static int component(double linear) {
        if (linear >= 1) {
            return MOST;
        }
        return linear > 0 ? upFrom(FROM[(int) (linear * PARTS)], linear) : 0;
    }

    private static int upFrom(int first, double linear) {
        int least = first;
        while (least < MOST && linear >= LEAST[least + 1]) {
            least++;
        }
        return least;
    }

    // The two formulae of IEC 61966-2-1. Not Math.pow, whose last bits may differ between JVMs.
    private static double decoded(double c) {
        return c <= 0.04045 ? c / 12.92 : Math.min(1, StrictMath.pow((c + 0.055) / 1.055, 2.4));
    }

    private static double encoded(double c) {
        return c <= 0.0031308 ? c * 12.92 : Math.min(1, 1.055 * StrictMath.pow(c, 1 / 2.4) - 0.055);
    }

    /** {@code #rrggbb}: the components rounded to 8 bits. */
    @Override
    public String toString() {
        return "#" + text(packed());
    }

    /** A packed pixel as six hexadecimal digits, {@code rrggbb}. */
    public static String text(int pixel) {
        return HexFormat.of().toHexDigits(pixel, 6);
    }
}
