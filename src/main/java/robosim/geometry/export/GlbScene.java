package robosim.geometry.export;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;

/** The nodes, meshes and materials of a glTF file, as JSON, and the numbers that they refer to. */
final class GlbScene {
    /** glTF's constants: numbers of the type float, of the type unsigned int; buffers of vertices, of indices. */
    private static final int FLOAT = 5126;

    private static final int UNSIGNED_INT = 5125;
    private static final int VERTICES = 34962;
    private static final int INDICES = 34963;

    /** A shape in a colour. */
    private record Painted(int shape, int material) {}

    /** A capsule that is no sphere: no scale makes one of another one's proportions. */
    private record Oblong(double radius, double segment) {}

    /** The binary part. */
    final Packed numbers = new Packed();

    private final List<String> views = new ArrayList<>();
    private final List<String> accessors = new ArrayList<>();
    private final List<String> nodes = new ArrayList<>();
    private final Map<Painted, Integer> meshes = new LinkedHashMap<>();

    /** Of each shape, its attributes and indices. */
    private final List<String> shapes = new ArrayList<>();

    private final Map<Object, Integer> known = new HashMap<>();
    private final Map<String, Integer> materials = new LinkedHashMap<>();

    /** Adds an object and returns the number of its node. */
    int object(GeometryObject object, int colour, String name) {
        Pose pose = object.pose();
        switch (object.kind()) {
            case BOX -> {
                BoxObject box = (BoxObject) object;
                int shape = shape("box", GlbShape::box);
                return leaf(name, pose, shape, colour, box.width(), box.height(), box.length());
            }
            case CYLINDER -> {
                CylinderObject cylinder = (CylinderObject) object;
                int shape = shape("cylinder", GlbShape::cylinder);
                return leaf(name, pose, shape, colour, cylinder.radius(), cylinder.height(), cylinder.radius());
            }
            case SPHERE -> {
                double radius = ((SphereObject) object).radius();
                return leaf(name, pose, ball(), colour, radius, radius, radius);
            }
            case CAPSULE -> {
                CapsuleObject capsule = (CapsuleObject) object;
                double radius = capsule.radius();
                double segment = capsule.segment();
                if (segment == 0) {
                    return leaf(name, pose, ball(), colour, radius, radius, radius);
                }
                int shape = shape(new Oblong(radius, segment), () -> GlbShape.capsule(radius, segment));
                return leaf(name, pose, shape, colour, 1, 1, 1);
            }
            case MESH -> {
                MeshObject mesh = (MeshObject) object;
                int shape = shape(mesh.triangles(), () -> GlbShape.mesh(mesh.triangles()));
                return leaf(name, pose, shape, colour, 1, 1, 1);
            }
            case GRID -> {
                GridObject grid = (GridObject) object;
                return leaf(name, pose, shape(grid, () -> GlbShape.grid(grid)), colour, 1, 1, 1);
            }
            case GROUP -> {
                List<Integer> members = new ArrayList<>();
                for (GeometryObject member : ((ObjectGroup) object).members()) {
                    String called = member.name();
                    members.add(object(
                            member, colour, called == null ? member.kind().word() : called));
                }
                return node(placed(name, pose) + ",\"children\":" + members);
            }
        }
        throw new IllegalStateException("an object of no kind (got: " + object + ")");
    }

    /** Adds the node that holds all others, in metres, and returns its number. */
    int root(String name, double metres, List<Integer> children) {
        String scale = metres == 1 ? "" : ",\"scale\":" + List.of(metres, metres, metres);
        return node("\"name\":" + text(name) + scale + (children.isEmpty() ? "" : ",\"children\":" + children));
    }

    /** The JSON part, of a scene with one node. */
    String json(int root) {
        List<String> painted = new ArrayList<>();
        for (Painted each : meshes.keySet()) {
            painted.add("{\"primitives\":[{" + shapes.get(each.shape) + ",\"material\":" + each.material + "}]}");
        }
        StringBuilder json = new StringBuilder("{\"asset\":{\"version\":\"2.0\",\"generator\":\"robosim-geometry\"}");
        json.append(",\"scene\":0,\"scenes\":[{\"nodes\":[").append(root).append("]}]");
        list(json, "nodes", nodes);
        list(json, "meshes", painted);
        list(json, "materials", List.copyOf(materials.keySet()));
        list(json, "accessors", accessors);
        list(json, "bufferViews", views);
        if (numbers.size() > 0) {
            json.append(",\"buffers\":[{\"byteLength\":").append(numbers.size()).append("}]");
        }
        return json.append('}').toString();
    }

    private static void list(StringBuilder json, String name, List<String> items) {
        if (!items.isEmpty()) { // glTF has no empty lists
            json.append(",\"")
                    .append(name)
                    .append("\":[")
                    .append(String.join(",", items))
                    .append(']');
        }
    }

    private int ball() {
        return shape("ball", () -> GlbShape.capsule(1, 0));
    }

    private int leaf(String name, Pose pose, int shape, int colour, double x, double y, double z) {
        int mesh = mesh(new Painted(shape, material(colour)));
        String scale = x == 1 && y == 1 && z == 1 ? "" : ",\"scale\":" + List.of(x, y, z);
        return node(placed(name, pose) + scale + ",\"mesh\":" + mesh);
    }

    private int node(String members) {
        nodes.add("{" + members + "}");
        return nodes.size() - 1;
    }

    private static String placed(String name, Pose pose) {
        Turned turned = Turned.of(pose);
        return "\"name\":" + text(name) + ",\"translation\":"
                + List.of(pose.center().x(), pose.center().y(), pose.center().z())
                + (turned.equals(Turned.NONE)
                        ? ""
                        : ",\"rotation\":" + List.of(turned.x(), turned.y(), turned.z(), turned.w()));
    }

    private int mesh(Painted painted) {
        Integer number = meshes.get(painted);
        if (number == null) {
            number = meshes.size();
            meshes.put(painted, number);
        }
        return number;
    }

    /** Shown from both sides, as a mesh may be a mere surface. */
    private int material(int colour) {
        String factor = List.of(linear(colour >> 16), linear(colour >> 8), linear(colour), 1.0)
                .toString();
        String json = "{\"pbrMetallicRoughness\":{\"baseColorFactor\":" + factor
                + ",\"metallicFactor\":0,\"roughnessFactor\":0.7},\"doubleSided\":true}";
        Integer number = materials.get(json);
        if (number == null) {
            number = materials.size();
            materials.put(json, number);
        }
        return number;
    }

    /** A component of sRGB, its lowest byte, as light. */
    private static double linear(int component) {
        double v = (component & 255) / 255.0;
        return v <= 0.04045 ? v / 12.92 : StrictMath.pow((v + 0.055) / 1.055, 2.4);
    }

    private int shape(Object key, Supplier<GlbShape> made) {
        Integer number = known.get(key);
        if (number == null) {
            number = shapes.size();
            known.put(key, number);
            GlbShape shape = made.get();
            float[] normals = shape.normals();
            shapes.add("\"attributes\":{\"POSITION\":" + vectors(shape.points(), true)
                    + (normals == null ? "" : ",\"NORMAL\":" + vectors(normals, false)) + "},\"indices\":"
                    + indices(shape.indices()));
        }
        return number;
    }

    private int vectors(float[] values, boolean bounded) {
        int begin = numbers.size();
        for (float value : values) {
            numbers.real(value);
        }
        String bounds = bounded ? ",\"min\":" + bound(values, -1) + ",\"max\":" + bound(values, 1) : "";
        return accessor(begin, VERTICES, FLOAT, values.length / 3, "VEC3", bounds);
    }

    /** The largest of the numbers along each axis, or the smallest: all digits of the floats, as readers compare them. */
    private static List<Double> bound(float[] values, int sign) {
        double[] bound = {-sign * Double.MAX_VALUE, -sign * Double.MAX_VALUE, -sign * Double.MAX_VALUE};
        for (int k = 0; k < values.length; k++) {
            if (sign * values[k] > sign * bound[k % 3]) {
                bound[k % 3] = values[k];
            }
        }
        return List.of(bound[0], bound[1], bound[2]);
    }

    private int indices(int[] values) {
        int begin = numbers.size();
        for (int value : values) {
            for (int shift = 0; shift < 32; shift += 8) {
                numbers.octet(value >> shift);
            }
        }
        return accessor(begin, INDICES, UNSIGNED_INT, values.length, "SCALAR", "");
    }

    private int accessor(int begin, int target, int component, int count, String type, String bounds) {
        views.add("{\"buffer\":0,\"byteOffset\":" + begin + ",\"byteLength\":" + (numbers.size() - begin)
                + ",\"target\":" + target + "}");
        accessors.add("{\"bufferView\":" + (views.size() - 1) + ",\"componentType\":" + component + ",\"count\":"
                + count + ",\"type\":\"" + type + "\"" + bounds + "}");
        return accessors.size() - 1;
    }

    /** A string of JSON. */
    static String text(@Nullable String text) {
        StringBuilder quoted = new StringBuilder("\"");
        String plain = text == null ? "" : text;
        for (int k = 0; k < plain.length(); k++) {
            char c = plain.charAt(k);
            if (c == '"' || c == '\\') {
                quoted.append('\\').append(c);
            } else if (c < ' ' || c > '~') {
                quoted.append(String.format("\\u%04x", (int) c));
            } else {
                quoted.append(c);
            }
        }
        return quoted.append('"').toString();
    }
}
