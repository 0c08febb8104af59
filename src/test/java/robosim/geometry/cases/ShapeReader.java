package robosim.geometry.cases;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.Vectors;

/**
 * Objects as the files write them. Where a source has Z up, all is turned cyclically, which rounds nothing: its x, y, z
 * become our z, x, y.
 */
final class ShapeReader {
    private static final Set<String> PLACE = Set.of("at", "heading", "turned", "rotation", "quat");

    private final boolean zUp;

    ShapeReader(boolean zUp) {
        this.zUp = zUp;
    }

    /** Decimal or hexadecimal numbers between blanks. */
    static double[] numbers(Object text) {
        return Arrays.stream(text.toString().trim().split("[\\s,]+"))
                .mapToDouble(Double::parseDouble)
                .toArray();
    }

    double[] vector(Object text) {
        double[] v = numbers(text);
        if (v.length != 3) {
            throw new IllegalArgumentException("a vector must have three numbers (got: " + text + ")");
        }
        return zUp ? new double[] {v[1], v[2], v[0]} : v;
    }

    private static Point point(double[] v) {
        return new Point(v[0], v[1], v[2]);
    }

    GeometryObject object(Map<String, Object> text) {
        String shape = text.keySet().iterator().next();
        Object body = text.get(shape);
        for (String key : text.keySet()) {
            if (!key.equals(shape)
                    && !PLACE.contains(key)
                    && !Set.of("faces", "solid").contains(key)) {
                throw new IllegalArgumentException("an object must have known attributes (got: " + key + ")");
            }
        }
        GeometryObject object = switch (shape) {
            case "box" -> {
                double[] size = vector(body);
                yield new BoxObject(new Point(), size[0], size[1], size[2]);
            }
            case "cylinder" -> new CylinderObject(new Point(), numbers(body)[0], numbers(body)[1]);
            case "sphere" -> new SphereObject(new Point(), numbers(body)[0]);
            case "triangle", "quad" -> mesh(body, null);
            case "vertices" -> mesh(body, text.get("faces"));
            case "group" -> new ObjectGroup(members(body));
            default -> throw new IllegalArgumentException("an object must have a known shape (got: " + shape + ")");
        };
        if (object instanceof MeshObject mesh && "yes".equals(text.get("solid"))) {
            object = mesh.solid();
        }
        return placed(object, text);
    }

    @SuppressWarnings("unchecked")
    private List<GeometryObject> members(Object list) {
        List<GeometryObject> members = new ArrayList<>();
        ((List<Map<String, Object>>) list).forEach(member -> members.add(object(member)));
        return members;
    }

    /** One face of all the vertices, or the faces that are given. */
    private MeshObject mesh(Object vertices, @Nullable Object faces) {
        double[] flat = numbers(vertices);
        List<Point> points = new ArrayList<>();
        for (int k = 0; k < flat.length; k += 3) {
            points.add(point(vector(flat[k] + " " + flat[k + 1] + " " + flat[k + 2])));
        }
        int[][] indices;
        if (faces instanceof List<?> list) {
            indices = list.stream()
                    .map(face ->
                            Arrays.stream(numbers(face)).mapToInt(v -> (int) v).toArray())
                    .toArray(int[][]::new);
        } else {
            indices = new int[][] {
                java.util.stream.IntStream.range(0, points.size()).toArray()
            };
        }
        return new MeshObject(points, indices);
    }

    private GeometryObject placed(GeometryObject object, Map<String, Object> text) {
        GeometryObject placed = object;
        Object turned = text.get("turned");
        if (turned != null) {
            double[] degrees = numbers(turned);
            placed = placed.turned(degrees[0], degrees[1]);
        }
        Object heading = text.get("heading");
        if (heading != null) {
            placed = placed.turned(0, numbers(heading)[0]);
        }
        Object rotation = text.get("rotation");
        if (rotation != null) {
            placed = placed.oriented(cyclic(numbers(rotation)));
        }
        Object quaternion = text.get("quat");
        if (quaternion != null) {
            placed = placed.oriented(cyclic(matrix(numbers(quaternion))));
        }
        Object at = text.get("at");
        return at == null ? placed : placed.movedTo(point(vector(at)));
    }

    private double[] cyclic(double[] r) {
        if (!zUp) {
            return r;
        }
        return new double[] {r[4], r[5], r[3], r[7], r[8], r[6], r[1], r[2], r[0]};
    }

    /** Of a quaternion w, x, y, z of any length. */
    private static double[] matrix(double[] q) {
        double s = 2 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        return Vectors.rotation(s, q[0], q[1], q[2], q[3]);
    }
}
