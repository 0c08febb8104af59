package robosim.geometry.world.sdf;

import java.util.Map;

/**
 * What SDFormat before 1.2 wrote otherwise: as attributes what later versions have as elements, an {@code origin} for a
 * {@code pose}, and the file of a mesh as its {@code filename}.
 */
final class SdfOld {
    private SdfOld() {}

    /** Adds the elements that an element of an old file has as attributes. */
    static void complete(SdfElement element) {
        switch (element.name) {
            case "box" -> add(element, "size", "size");
            case "sphere" -> add(element, "radius", "radius");
            case "cylinder", "capsule" -> {
                add(element, "radius", "radius");
                add(element, "length", "length");
            }
            case "plane" -> add(element, "normal", "normal");
            case "mesh" -> {
                add(element, "filename", "uri");
                add(element, "scale", "scale");
            }
            case "include" -> add(element, "filename", "uri");
            case "model" -> add(element, "static", "static");
            default -> {}
        }
    }

    private static void add(SdfElement element, String attribute, String name) {
        String value = element.attribute(attribute);
        if (!value.isEmpty()) {
            SdfElement child = new SdfElement(element.file, name, element.line, element.column, Map.of());
            child.text.append(value);
            element.children.add(child);
        }
    }
}
