package robosim.geometry.world.sdf;

import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Pose;

/**
 * A sensor of a link, as a file describes it.
 *
 * @param name    those of its models and its link, and its own, separated by {@code ::}
 * @param type    as in the file
 * @param carrier the name of the moveable object that carries it; null for one that stands in the world
 * @param pose    in the frame of the carrier, or in the world
 * @param values  the texts of its elements by their paths, as {@code scan/horizontal/samples}
 * @param file    where it is described
 */
public record SensorElement(
        String name,
        String type,
        @Nullable String carrier,
        Pose pose,
        Map<String, String> values,
        String file,
        int line) {

    static SensorElement of(String name, SdfElement element, @Nullable String carrier, Pose pose) {
        Map<String, String> values = new TreeMap<>();
        for (SdfElement child : element.children) {
            if (child.name.equals("update_rate")) {
                values.put(child.name, child.value());
            } else if (!child.name.equals("pose")) { // the device: lidar, ray or camera
                collect(child, "", values);
            }
        }
        return new SensorElement(
                name, element.attribute("type"), carrier, pose, Map.copyOf(values), element.file.shown(), element.line);
    }

    private static void collect(SdfElement element, String path, Map<String, String> values) {
        String type = element.attribute("type");
        if (element.name.equals("noise") && !type.isEmpty()) {
            values.put(path + "type", type);
        }
        for (SdfElement child : element.children) {
            if (child.children.isEmpty() && !child.name.equals("noise")) {
                values.putIfAbsent(path + child.name, child.value());
            }
            collect(child, path + child.name + "/", values);
        }
    }
}
