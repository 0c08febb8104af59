package robosim.geometry.world.shared;

import robosim.geometry.check.Checks;
import robosim.geometry.check.NumberText;
import robosim.geometry.check.Text;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/** What objects are called in messages. */
public final class ObjectNames {
    private ObjectNames() {}

    /**
     * The name of an object for messages, on one line: its own name, or else its kind and its place to a thousandth.
     */
    public static String of(GeometryObject object) {
        String name = Checks.present("object", object).name();
        if (name != null) {
            return Text.line(name);
        }
        Point center = object.center();
        return "a " + object.kind().word() + " at (" + NumberText.places(center.x(), 3) + ", "
                + NumberText.places(center.y(), 3) + ", " + NumberText.places(center.z(), 3) + ")";
    }

    /** As in {@code box "wall 3"} or {@code mesh without a name}, on one line. */
    public static String kindAndName(GeometryObject object) {
        String name = Checks.present("object", object).name();
        return object.kind().word() + (name == null ? " without a name" : " " + Text.quoted(name));
    }
}
