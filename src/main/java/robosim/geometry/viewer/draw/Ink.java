package robosim.geometry.viewer.draw;

/**
 * A colour in both themes.
 *
 * @param light 0xRRGGBB on a light background
 * @param dark  0xRRGGBB on a dark background
 */
public record Ink(int light, int dark) {
    public int in(Theme theme) {
        return theme == Theme.LIGHT ? light : dark;
    }

    /** A colour as SVG writes it. */
    static String hex(int rgb) {
        String digits = Integer.toHexString(rgb & 0xffffff);
        return "#" + "0".repeat(6 - digits.length()) + digits;
    }
}
