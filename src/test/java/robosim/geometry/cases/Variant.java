package robosim.geometry.cases;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;

/**
 * A case as it is asked: in space or in projection, everything times a power of two, everything moved, or the objects in
 * the other order.
 *
 * @param scale a power of two, which rounds nothing
 * @param exact whether the offset rounds nothing either; else the question is that of the rounded numbers
 */
public record Variant(String name, Dimension dimension, double scale, Point offset, boolean exact, boolean swapped) {
    private static final Point NOWHERE = new Point();

    /** Halves and quarters of some 2^20: far from the origin, and few bits. */
    private static final double[] FAR = {0x1.4p20, -0x1.8p19, 0x1p20};

    /** All ways to ask a question of a case. */
    public static List<Variant> of(HardCase hard, Map<String, GeometryObject> objects, double[] more) {
        List<Variant> variants = new ArrayList<>();
        for (Dimension dimension : List.of(Dimension.SPATIAL, Dimension.PLANAR)) {
            String in = dimension == Dimension.PLANAR ? "planar, " : "";
            variants.add(new Variant(in + "as given", dimension, 1, NOWHERE, true, false));
            variants.add(new Variant(in + "other order", dimension, 1, NOWHERE, true, true));
            for (int power : new int[] {-40, -20, 20, 40}) {
                if (Math.abs(power) <= hard.reach()) {
                    double scale = Math.scalb(1.0, power);
                    variants.add(new Variant(in + "times 2^" + power, dimension, scale, NOWHERE, true, false));
                }
            }
            for (int power = 40; power >= 0; power -= 4) {
                Point offset = offset(Math.scalb(1.0, power - 20));
                if (objects.values().stream().allMatch(object -> staysExact(object, offset))
                        && staysExact(more, offset)) {
                    variants.add(new Variant(in + "moved by 2^" + power, dimension, 1, offset, true, false));
                    break;
                }
            }
            variants.add(new Variant(in + "moved by 2^20, rounded", dimension, 1, offset(1.1), false, false));
        }
        return variants.stream().distinct().toList();
    }

    private static Point offset(double times) {
        return new Point(FAR[0] * times, FAR[1] * times, FAR[2] * times);
    }

    private static boolean staysExact(GeometryObject object, Point offset) {
        Point c = object.center();
        boolean exact = staysExact(new double[] {c.x(), c.y(), c.z()}, offset);
        // Placed vertices and members are rounded at their place: exact are those that only the centre moves.
        if (object instanceof MeshObject mesh) {
            return exact
                    && object.pose().equals(Pose.ORIGIN)
                    && mesh.vertices().stream().allMatch(v -> staysExact(new double[] {v.x(), v.y(), v.z()}, offset));
        }
        return exact && object.kind() != GeometryObject.Kind.GROUP;
    }

    private static boolean staysExact(double[] point, Point offset) {
        double[] by = {offset.x(), offset.y(), offset.z()};
        for (int k = 0; k < point.length; k++) {
            double sum = point[k] + by[k % 3];
            if (sum - by[k % 3] != point[k] || sum - point[k] != by[k % 3]) {
                return false;
            }
        }
        return true;
    }

    /** A point where this variant has it. */
    public Point place(Point p) {
        return new Point(p.x() * scale + offset.x(), p.y() * scale + offset.y(), p.z() * scale + offset.z());
    }

    /** An object where this variant has it, at its size there. */
    public GeometryObject place(GeometryObject object) {
        if (object instanceof ObjectGroup group && group.pose().equals(Pose.ORIGIN)) {
            return new ObjectGroup(group.members().stream().map(this::place).toList());
        }
        GeometryObject scaled = scaled(object);
        return scaled.at(object.pose().movedTo(place(object.center())));
    }

    private GeometryObject scaled(GeometryObject object) {
        return switch (object.kind()) {
            case BOX -> {
                BoxObject box = (BoxObject) object;
                yield new BoxObject(NOWHERE, box.width() * scale, box.height() * scale, box.length() * scale);
            }
            case CYLINDER -> {
                CylinderObject cylinder = (CylinderObject) object;
                yield new CylinderObject(NOWHERE, cylinder.radius() * scale, cylinder.height() * scale);
            }
            case SPHERE -> new SphereObject(NOWHERE, ((SphereObject) object).radius() * scale);
            case CAPSULE -> {
                CapsuleObject capsule = (CapsuleObject) object;
                yield new CapsuleObject(NOWHERE, capsule.radius() * scale, capsule.segment() * scale);
            }
            case MESH -> {
                MeshObject mesh = (MeshObject) object;
                List<Point> vertices = mesh.vertices().stream()
                        .map(v -> new Point(v.x() * scale, v.y() * scale, v.z() * scale))
                        .toList();
                MeshObject scaled = new MeshObject(vertices, mesh.faces());
                yield mesh.isSolid() ? scaled.solid() : scaled;
            }
            case GROUP ->
                new ObjectGroup(((ObjectGroup) object)
                        .members().stream()
                                .map(member -> new Variant(name, dimension, scale, NOWHERE, true, false).place(member))
                                .toList());
            case GRID -> throw new IllegalArgumentException("no case has a grid (got: " + object + ")");
        };
    }

    /** Whether the answers must be those to the question as given, times the scale, bit by bit. */
    public boolean isScaled() {
        return scale != 1;
    }
}
