package robosim.geometry.report.speed;

import java.util.Iterator;
import java.util.List;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.geometry.Circle;
import org.dyn4j.geometry.Transform;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.DetectFilter;
import org.dyn4j.world.World;
import org.dyn4j.world.result.ConvexDetectResult;
import org.dyn4j.world.result.RaycastResult;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Ray;
import robosim.geometry.report.Dyn4jPeer;
import robosim.geometry.report.Outline;
import robosim.geometry.report.Peer.CannotException;

/** Objects in projection as bodies of a dyn4j world: its dynamic tree of boxes, and Gjk. */
final class Dyn4jScene {
    private final World<Body> world = new World<>();
    private final DetectFilter<Body, BodyFixture> all = new DetectFilter<>(false, false, null);

    Dyn4jScene(List<GeometryObject> objects) {
        for (GeometryObject object : objects) {
            add(object);
        }
    }

    private void add(GeometryObject object) {
        try {
            Outline outline = Outline.of(object);
            Body body = new Body();
            body.getTransform().translate(outline.pivot()[0], outline.pivot()[1]);
            for (Outline.Piece piece : outline.pieces()) {
                body.addFixture(Dyn4jPeer.shape(piece, outline.pivot()));
            }
            world.addBody(body);
        } catch (CannotException e) {
            throw new IllegalStateException(e);
        }
    }

    InTurn.Batch probes(CylinderObject[] probes) {
        return (from, count) -> {
            int hits = 0;
            for (int k = from; k < from + count; k++) {
                hits += isHit(probes[k]) ? 1 : 0;
            }
            return hits;
        };
    }

    private boolean isHit(CylinderObject probe) {
        Circle disc = new Circle(probe.radius());
        Transform place = new Transform();
        place.translate(probe.center().x(), probe.center().z());
        Iterator<ConvexDetectResult<Body, BodyFixture>> found = world.detectIterator(disc, place, all);
        while (found.hasNext()) {
            // Misses are among the results, as those of nobody.
            if (found.next().getBody() != null) {
                return true;
            }
        }
        return false;
    }

    InTurn.Batch rays(Ray[] rays, double range) {
        return (from, count) -> {
            double sum = 0;
            for (int k = from; k < from + count; k++) {
                sum += distance(rays[k], range);
            }
            return sum;
        };
    }

    private double distance(Ray ray, double range) {
        org.dyn4j.geometry.Ray cast = new org.dyn4j.geometry.Ray(
                new Vector2(ray.start().x(), ray.start().z()),
                new Vector2(ray.direction().x(), ray.direction().z()));
        RaycastResult<Body, BodyFixture> nearest = world.raycastClosest(cast, range, all);
        return nearest == null ? range : nearest.getRaycast().getDistance();
    }
}
