package robosim.geometry.cli;

import robosim.geometry.model.GeometryObject;

/** Names of objects in texts for people. */
final class ObjectNames {
    private ObjectNames() {}

    /** An object's name, or its kind and place where it has none. */
    static String text(GeometryObject object) {
        String name = object.name();
        return name != null ? name : "a " + kind(object.kind()) + " at " + place(object);
    }

    static String kind(GeometryObject.Kind kind) {
        return switch (kind) {
            case BOX -> "box";
            case CYLINDER -> "cylinder";
            case SPHERE -> "sphere";
            case MESH -> "mesh";
            case GROUP -> "group";
        };
    }

    /** The noun for a kind, singular or plural. */
    static String kinds(GeometryObject.Kind kind, int count) {
        String one = kind(kind);
        return count == 1 ? one : one.endsWith("x") || one.endsWith("sh") ? one + "es" : one + "s";
    }

    private static String place(GeometryObject object) {
        return "(" + (float) object.center().x() + ", "
                + (float) object.center().z() + ")";
    }
}
