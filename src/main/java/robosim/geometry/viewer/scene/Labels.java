package robosim.geometry.viewer.scene;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Locale;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.protocol.Text;

/** Objects and numbers as text for people. */
public final class Labels {
    private Labels() {}

    /** The name of an object, or its kind and place if it has none. */
    public static String name(GeometryObject object) {
        String name = object.name();
        return name != null
                ? Text.line(name)
                : "a " + kind(object) + " at (" + number(object.center().x()) + ", "
                        + number(object.center().z()) + ")";
    }

    public static String kind(GeometryObject object) {
        return object.kind().name().toLowerCase(Locale.ROOT);
    }

    /** A number to a thousandth, without trailing zeros; the same text on every JVM. */
    public static String number(double value) {
        if (!(Math.abs(value) < 1e9)) {
            return String.valueOf((float) value);
        }
        BigDecimal rounded =
                new BigDecimal(value).setScale(3, RoundingMode.HALF_EVEN).stripTrailingZeros();
        return rounded.signum() == 0 ? "0" : rounded.toPlainString();
    }
}
