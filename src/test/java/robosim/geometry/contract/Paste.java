package robosim.geometry.contract;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Objects as Java that can be pasted into a test. */
final class Paste {
    private Paste() {}

    static String of(List<GeometryObject> objects) {
        return objects.stream().map(Paste::of).collect(Collectors.joining(",\n    "));
    }

    /** An object at its place, but for what its place has lost. */
    static String of(GeometryObject object) {
        String name = object.name();
        String named =
                name == null ? "" : object.isMoveable() ? ".moveable(\"" + name + "\")" : ".named(\"" + name + "\")";
        return shape(object) + ".movedTo(" + of(object.center()) + ").oriented(new double[] "
                + Arrays.toString(object.rotation()).replace('[', '{').replace(']', '}') + ")" + named;
    }

    static String of(Point p) {
        return "new Point(" + p.x() + ", " + p.y() + ", " + p.z() + ")";
    }

    private static String shape(GeometryObject object) {
        return switch (object.kind()) {
            case BOX -> {
                BoxObject box = (BoxObject) object;
                yield "new BoxObject(new Point(), " + box.width() + ", " + box.height() + ", " + box.length() + ")";
            }
            case CYLINDER -> {
                CylinderObject cylinder = (CylinderObject) object;
                yield "new CylinderObject(new Point(), " + cylinder.radius() + ", " + cylinder.height() + ")";
            }
            case SPHERE -> "new SphereObject(new Point(), " + ((SphereObject) object).radius() + ")";
            case CAPSULE -> {
                CapsuleObject capsule = (CapsuleObject) object;
                yield "new CapsuleObject(new Point(), " + capsule.radius() + ", " + capsule.segment() + ")";
            }
            case MESH -> {
                MeshObject mesh = (MeshObject) object;
                yield "new MeshObject(List.of("
                        + mesh.vertices().stream().map(Paste::of).collect(Collectors.joining(", ")) + "), new int[][] "
                        + Arrays.deepToString(mesh.faces()).replace('[', '{').replace(']', '}') + ")"
                        + (mesh.isSolid() ? ".solid()" : "");
            }
            case GRID -> throw new IllegalArgumentException("no grids here (got: " + object + ")");
            case GROUP ->
                "new ObjectGroup(List.of("
                        + ((ObjectGroup) object)
                                .members().stream().map(Paste::of).collect(Collectors.joining(", "))
                        + "))";
        };
    }
}
