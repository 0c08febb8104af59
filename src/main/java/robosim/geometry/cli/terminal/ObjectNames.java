package robosim.geometry.cli.terminal;

import robosim.geometry.model.GeometryObject;

/** What objects are called in texts for people. */
public final class ObjectNames {
    private ObjectNames() {}

    /** Its name; without one, what it is and where. */
    public static String text(GeometryObject object) {
        String name = object.name();
        return name != null ? name : "a " + kind(object.kind()) + " at " + place(object);
    }

    public static String kind(GeometryObject.Kind kind) {
        return switch (kind) {
            case BOX -> "box";
            case CYLINDER -> "cylinder";
            case SPHERE -> "sphere";
            case MESH -> "mesh";
            case GROUP -> "group";
        };
    }

    /** One or more of a kind. */
    public static String kinds(GeometryObject.Kind kind, int count) {
        String one = kind(kind);
        return count == 1 ? one : one.endsWith("x") || one.endsWith("sh") ? one + "es" : one + "s";
    }

    private static String place(GeometryObject object) {
        return "(" + (float) object.center().x() + ", "
                + (float) object.center().z() + ")";
    }
}
