package robosim.geometry.viewer.draw;

import org.jspecify.annotations.Nullable;

/**
 * How a shape is drawn.
 *
 * @param fill    the ink inside; null for none
 * @param fillOpacity from 0 to 1
 * @param stroke  the ink of the outline; null for none
 * @param width   width of the outline, pixels
 * @param strokeOpacity from 0 to 1
 * @param dash    pixels drawn and pixels left out, in turn; 0 for an unbroken outline
 */
public record Style(
        @Nullable Ink fill, double fillOpacity, @Nullable Ink stroke, double width, double strokeOpacity, double dash) {

    public static Style filled(Ink ink, double opacity) {
        return new Style(ink, opacity, null, 0, 0, 0);
    }

    public static Style line(Ink ink, double width, double opacity) {
        return new Style(null, 0, ink, width, opacity, 0);
    }

    public Style outlined(Ink ink, double lineWidth, double opacity) {
        return new Style(fill, fillOpacity, ink, lineWidth, opacity, dash);
    }

    Style dashed(double pixels) {
        return new Style(fill, fillOpacity, stroke, width, strokeOpacity, pixels);
    }
}
