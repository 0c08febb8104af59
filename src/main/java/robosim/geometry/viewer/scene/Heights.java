package robosim.geometry.viewer.scene;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.TriangleMesh;

/** Orders objects by height: seen from above, a higher object covers a lower one. In plain doubles. */
public final class Heights {
    private Heights() {}

    private record Ranked(Scene.Thing thing, double top) {}

    /** Objects in painting order: the lowest top first, in the given order for equal tops. */
    public static List<Scene.Thing> fromBelow(List<Scene.Thing> things) {
        List<Ranked> ranked = new ArrayList<>();
        for (Scene.Thing thing : things) {
            ranked.add(new Ranked(thing, top(thing.object())));
        }
        ranked.sort(Comparator.comparingDouble(Ranked::top)); // stable
        return ranked.stream().map(Ranked::thing).toList();
    }

    /** The largest Y of an object. */
    public static double top(GeometryObject object) {
        return top(object, Footprint.Frame.world());
    }

    /** The largest Y of an object within an outer frame. */
    static double top(GeometryObject object, Footprint.Frame outer) {
        Footprint.Frame frame = outer.then(object);
        return switch (object.kind()) {
            case BOX -> {
                BoxObject box = (BoxObject) object;
                yield frame.reach(box.width() / 2, box.height() / 2, box.length() / 2);
            }
            case CYLINDER -> {
                CylinderObject cylinder = (CylinderObject) object;
                yield frame.top(cylinder.radius(), cylinder.height() / 2);
            }
            case SPHERE -> frame.top(0, 0) + ((SphereObject) object).radius();
            case CAPSULE -> {
                CapsuleObject capsule = (CapsuleObject) object;
                yield frame.top(0, capsule.segment() / 2) + capsule.radius();
            }
            case MESH -> {
                TriangleMesh mesh = ((MeshObject) object).triangles();
                double most = Double.NEGATIVE_INFINITY;
                for (int corner = 0; corner < 3 * mesh.size(); corner++) {
                    int v = mesh.vertex(corner / 3, corner % 3);
                    most = Math.max(
                            most, frame.height(mesh.coordinate(v, 0), mesh.coordinate(v, 1), mesh.coordinate(v, 2)));
                }
                yield most;
            }
            case GRID -> object.center().y() + ((GridObject) object).height() / 2;
            case GROUP -> {
                double most = Double.NEGATIVE_INFINITY;
                for (GeometryObject member : ((ObjectGroup) object).members()) {
                    most = Math.max(most, top(member, frame));
                }
                yield most;
            }
        };
    }
}
