package robosim.geometry.export;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.RoundedBox;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Quaternion;
import robosim.geometry.render.Light;
import robosim.geometry.world.shared.JsonText;

/** The nodes, meshes and materials of a glTF file, as JSON, and the numbers that they refer to. */
final class GlbScene {
    /** glTF's constants: numbers of the type float, of the type unsigned int; buffers of vertices, of indices. */
    private static final int FLOAT = 5126;

    private static final int UNSIGNED_INT = 5125;
    private static final int VERTICES = 34962;
    private static final int INDICES = 34963;

    /** The extension of glTF for lights. */
    private static final String LIGHTS = "KHR_lights_punctual";

    /** A shape of a material. */
    private record Painted(int shape, int material) {}

    /** A shape that no scale makes of another one, with what places its texture. */
    private record Sized(RoundedBox box, GlbMaterials.@Nullable Mapping mapping) {}

    /** Triangles or cells, or a part of them, with what places their texture. */
    private record Placed(Object shape, GlbMaterials.@Nullable Mapping mapping) {}

    /** The binary part. */
    final PackedStream numbers = new PackedStream();

    private final List<String> views = new ArrayList<>();
    private final List<String> accessors = new ArrayList<>();
    private final List<String> nodes = new ArrayList<>();
    private final List<String> lights = new ArrayList<>();
    private final Map<List<Painted>, Integer> meshes = new LinkedHashMap<>();

    /** Of each shape, its attributes and indices. */
    private final List<String> shapes = new ArrayList<>();

    private final Map<Object, Integer> known = new HashMap<>();
    private final GlbMaterials materials = new GlbMaterials(numbers, views);

    /**
     * Adds an object and returns the number of its node.
     *
     * @param material of what has no other one
     */
    int object(GeometryObject object, Material material, String name) {
        Material own = object.material().within(material);
        String placed = placed(name, object.pose());
        GlbMaterials.Mapping mapping = GlbMaterials.Mapping.of(own.texture());
        if (object instanceof ObjectGroup group) {
            List<Integer> members = new ArrayList<>();
            for (GeometryObject member : group.members()) {
                String called = member.name();
                members.add(object(member, own, called == null ? member.kind().word() : called));
            }
            return node(placed + ",\"children\":" + members);
        }
        if (object instanceof MeshObject mesh) {
            return node(placed + ",\"mesh\":" + mesh(triangles(mesh.triangles(), own)));
        }
        if (object instanceof GridObject grid) {
            int shape = shape(
                    new Placed(grid, mapping),
                    mapping,
                    () -> mapping == null ? GlbShape.grid(grid) : GlbShape.texturedGrid(grid));
            return node(placed + ",\"mesh\":" + mesh(List.of(painted(shape, own))));
        }
        return leaf(placed, own, object.roundedBox(), mapping);
    }

    /** A node of a shape that is scaled, if it has no texture and no scale makes an ellipsoid of it. */
    private int leaf(String placed, Material material, RoundedBox box, GlbMaterials.@Nullable Mapping mapping) {
        boolean isOblong = box.ball() > 0 && box.halfHeight() > 0;
        boolean isScaled = mapping == null && !isOblong;
        double half = box.isRound() ? 0 : 0.5;
        RoundedBox drawn = isScaled
                ? new RoundedBox(half, box.ball() > 0 ? 0 : 0.5, half, box.disc() > 0 ? 1 : 0, box.ball() > 0 ? 1 : 0)
                : box;
        List<Double> scale = List.of(
                2 * box.halfWidth() + box.radius(),
                2 * box.halfHeight() + box.ball(),
                2 * box.halfLength() + box.radius());
        boolean isUnit = !isScaled || scale.equals(List.of(1.0, 1.0, 1.0));
        int number = shape(new Sized(drawn, mapping), mapping, () -> GlbShape.of(drawn));
        return node(placed + (isUnit ? "" : ",\"scale\":" + scale) + ",\"mesh\":"
                + mesh(List.of(painted(number, material))));
    }

    /** A picture is placed by texture coordinates, where there are some; then the other faces are plain. */
    private List<Painted> triangles(TriangleMesh mesh, Material material) {
        GlbMaterials.Mapping mapping = GlbMaterials.Mapping.of(material.texture());
        int pictured = 0;
        for (int t = 0; t < mesh.size(); t++) {
            pictured += mesh.isTextured(t) ? 1 : 0;
        }
        if (mapping == null) {
            return List.of(painted(shape(new Placed(mesh, null), null, () -> GlbShape.mesh(mesh)), material));
        }
        if (pictured == 0 || !(material.texture() instanceof ImageTexture)) {
            return List.of(
                    painted(shape(new Placed(mesh, mapping), mapping, () -> GlbShape.faces(mesh, true)), material));
        }
        List<Painted> both = new ArrayList<>();
        GlbMaterials.Mapping shares = GlbMaterials.Mapping.SHARES;
        both.add(painted(shape(new Placed(mesh, shares), shares, () -> GlbShape.pictured(mesh)), material));
        if (pictured < mesh.size()) {
            int rest = shape(new Placed(List.of(mesh), null), null, () -> GlbShape.faces(mesh, false));
            both.add(painted(rest, material.withTexture(null)));
        }
        return List.copyOf(both);
    }

    private Painted painted(int shape, Material material) {
        return new Painted(shape, materials.number(material));
    }

    /**
     * Adds a light and returns the number of its node. glTF's lights are in lux and candela, by which white surfaces that they
     * face scatter a share of 1 / pi; they fall with the square of the distance, so that one that falls otherwise is right at
     * a distance of one world unit.
     */
    int light(Light light, double metres) {
        boolean isSun = light instanceof Light.Sun;
        Light.Falloff falloff = light instanceof Light.Lamp lamp
                ? lamp.falloff()
                : light instanceof Light.Spot spot ? spot.falloff() : Light.Falloff.SQUARE;
        double intensity = Math.PI
                * light.strength()
                * (isSun ? 1 : metres * metres)
                / (falloff.constant() + falloff.linear() + falloff.quadratic());
        Color color = light.color();
        String kind = isSun ? "directional" : light instanceof Light.Spot ? "spot" : "point";
        StringBuilder json = new StringBuilder("{\"type\":\"" + kind + "\",\"color\":")
                .append(List.of(color.linearRed(), color.linearGreen(), color.linearBlue()))
                .append(",\"intensity\":")
                .append(intensity);
        if (falloff.range() < Double.POSITIVE_INFINITY) {
            json.append(",\"range\":").append(falloff.range() * metres);
        }
        String placed = "\"name\":\"" + kind + " light " + (lights.size() + 1) + "\"";
        if (light instanceof Light.Sun sun) {
            placed += faced(sun.direction());
        } else if (light instanceof Light.Spot spot) {
            double half = Degrees.toRadians(spot.degrees() / 2);
            json.append(",\"spot\":{\"innerConeAngle\":" + 0.75 * half + ",\"outerConeAngle\":" + half + "}");
            placed += at(spot.place()) + faced(spot.direction());
        } else {
            placed += at(((Light.Lamp) light).place());
        }
        lights.add(json.append('}').toString());
        return node(placed + ",\"extensions\":{\"" + LIGHTS + "\":{\"light\":" + (lights.size() - 1) + "}}");
    }

    private static String at(Point place) {
        return ",\"translation\":" + List.of(place.x(), place.y(), place.z());
    }

    /** The rotation of a node whose light shines along its -Z. */
    private static String faced(Point direction) {
        double length = VectorMath.length(direction.x(), direction.y(), direction.z());
        double x = direction.y() / length;
        double y = -direction.x() / length;
        double w = 1 - direction.z() / length;
        double norm = VectorMath.length(x, y, w);
        return norm < 1e-9 // the opposite way
                ? ",\"rotation\":" + List.of(0.0, 1.0, 0.0, 0.0)
                : ",\"rotation\":" + List.of(x / norm, y / norm, 0.0, w / norm);
    }

    /** Adds the node that holds all others, in metres, and returns its number. */
    int root(String name, double metres, List<Integer> children) {
        String scale = metres == 1 ? "" : ",\"scale\":" + List.of(metres, metres, metres);
        return node("\"name\":" + JsonText.of(name) + scale + (children.isEmpty() ? "" : ",\"children\":" + children));
    }

    /** The JSON part, of a scene with one node. */
    String json(int root) {
        List<String> painted = new ArrayList<>();
        for (List<Painted> each : meshes.keySet()) {
            List<String> primitives = new ArrayList<>();
            for (Painted part : each) {
                primitives.add("{" + shapes.get(part.shape) + ",\"material\":" + part.material + "}");
            }
            painted.add("{\"primitives\":[" + String.join(",", primitives) + "]}");
        }
        StringBuilder json = new StringBuilder("{\"asset\":{\"version\":\"2.0\",\"generator\":\"robosim-geometry\"}");
        json.append(",\"scene\":0,\"scenes\":[{\"nodes\":[").append(root).append("]}]");
        list(json, "nodes", nodes);
        list(json, "meshes", painted);
        list(json, "materials", materials.materials());
        list(json, "textures", materials.textures());
        list(json, "images", materials.images());
        list(json, "samplers", materials.samplers());
        list(json, "accessors", accessors);
        list(json, "bufferViews", views);
        if (!lights.isEmpty()) {
            json.append(",\"extensionsUsed\":[\"" + LIGHTS + "\"],\"extensions\":{\"" + LIGHTS + "\":{\"lights\":")
                    .append(lights)
                    .append("}}");
        }
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

    private int node(String members) {
        nodes.add("{" + members + "}");
        return nodes.size() - 1;
    }

    private static String placed(String name, Pose pose) {
        Quaternion turned = Quaternion.of(pose);
        return "\"name\":" + JsonText.of(name) + ",\"translation\":"
                + List.of(pose.center().x(), pose.center().y(), pose.center().z())
                + (turned.equals(Quaternion.NONE)
                        ? ""
                        : ",\"rotation\":" + List.of(turned.x(), turned.y(), turned.z(), turned.w()));
    }

    private int mesh(List<Painted> painted) {
        Integer number = meshes.get(painted);
        if (number == null) {
            number = meshes.size();
            meshes.put(painted, number);
        }
        return number;
    }

    private int shape(Object key, GlbMaterials.@Nullable Mapping mapping, Supplier<GlbShape> made) {
        Integer number = known.get(key);
        if (number == null) {
            number = shapes.size();
            known.put(key, number);
            GlbShape shape = made.get();
            float[] normals = shape.normals();
            String places =
                    mapping == null ? "" : ",\"TEXCOORD_0\":" + vectors(mapping.shares(shape.places()), "VEC2", false);
            shapes.add("\"attributes\":{\"POSITION\":" + vectors(shape.points(), "VEC3", true)
                    + (normals == null ? "" : ",\"NORMAL\":" + vectors(normals, "VEC3", false)) + places
                    + "},\"indices\":" + indices(shape.indices()));
        }
        return number;
    }

    private int vectors(float[] values, String type, boolean bounded) {
        int begin = numbers.size();
        for (float value : values) {
            numbers.real(value);
        }
        String bounds = bounded ? ",\"min\":" + bound(values, -1) + ",\"max\":" + bound(values, 1) : "";
        return accessor(begin, VERTICES, FLOAT, values.length / (type.equals("VEC2") ? 2 : 3), type, bounds);
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
            numbers.number(value, Integer.BYTES);
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
}
