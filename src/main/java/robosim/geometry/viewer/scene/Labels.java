package robosim.geometry.viewer.scene;

import java.util.Locale;
import robosim.geometry.exact.NumberText;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.protocol.Text;

/** Objects and numbers in words for people. */
public final class Labels {
    private Labels() {}

    /** The name; of an object without one its kind and place. */
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

    /** To a thousandth. */
    public static String number(double value) {
        return NumberText.places(value, 3);
    }
}
