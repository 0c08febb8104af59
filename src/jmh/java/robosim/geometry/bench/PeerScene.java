package robosim.geometry.bench;

import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.Ray;
import org.dyn4j.geometry.Transform;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.DetectFilter;
import org.dyn4j.world.World;
import org.dyn4j.world.result.RaycastResult;
import org.jspecify.annotations.Nullable;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.index.ItemVisitor;
import org.locationtech.jts.index.strtree.STRtree;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.Overlap;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;
import robosim.geometry.narrow.ray.PlanarRay;

/**
 * The objects and questions of a {@link FlatScene} for other libraries: JTS's packed tree of envelopes before the module's
 * own kernels, as JTS knows no discs, and a world of dyn4j's bodies.
 */
@State(Scope.Thread)
public class PeerScene {
    /** How many static objects. */
    @Param({"100", "1000", "10000", "100000"})
    public int objects;

    private final FlatScene scene = new FlatScene();
    private final STRtree tree = new STRtree();
    private final World<Body> world = new World<>();
    private final LeafColumn leaves = new LeafColumn(16);
    private final Scratch scratch = new Scratch();
    private final BeamAxis beam = new BeamAxis();
    private final double[] box = new double[6];
    private double nearest;
    private boolean found;

    /** Builds both, and asks them and the module some of the questions: they must agree. */
    @Setup
    public void build() {
        scene.objects = objects;
        scene.build();
        for (GeometryObject thing : scene.things) {
            LeafColumn leaf = LocalLeaves.placed(thing);
            int at = leaves.appendWhole(leaf, 0, 1);
            tree.insert(envelope(leaf, 0), at);
            world.addBody(body(thing));
        }
        tree.build();
        for (int k = 0; k < 500; k++) {
            robosim.geometry.model.Ray ray = scene.ray();
            double truth = scene.geometry.getRayDistance(ray, 0, FlatScene.RANGE, 0);
            double other = dyn4j(ray);
            // dyn4j looks out of what it starts in.
            boolean near = other == truth || Math.abs(other - truth) < 1e-6 || truth == 0;
            if (jts(ray) != truth || !near) {
                throw new IllegalStateException("must agree at " + ray + ": " + truth + ", " + jts(ray) + ", " + other);
            }
        }
    }

    private Envelope envelope(LeafColumn leaf, int at) {
        LeafBounds.of(leaf.kind(at), leaf.rows(), at * Leaf.STRIDE, box);
        return new Envelope(box[0], box[3], box[2], box[5]);
    }

    /** X is X and Z is Y: what turns counter-clockwise seen from above turns clockwise there. */
    private static Body body(GeometryObject thing) {
        Body body = new Body();
        if (thing instanceof BoxObject boxObject) {
            body.addFixture(Geometry.createRectangle(boxObject.width(), boxObject.length()));
            body.rotate(-Math.toRadians(thing.heading()));
        } else if (thing instanceof CylinderObject cylinder) {
            body.addFixture(Geometry.createCircle(cylinder.radius()));
        }
        Point center = thing.center();
        body.translate(center.x(), center.z());
        return body;
    }

    robosim.geometry.model.Ray ray() {
        return scene.ray();
    }

    GeometryObject probe() {
        return scene.probe();
    }

    double jts(robosim.geometry.model.Ray ray) {
        Point from = ray.start();
        Point way = ray.direction();
        nearest = FlatScene.RANGE;
        Envelope swept = new Envelope(
                from.x(), from.x() + FlatScene.RANGE * way.x(), from.z(), from.z() + FlatScene.RANGE * way.z());
        ItemVisitor visitor = item -> {
            int at = (Integer) item;
            double distance = PlanarRay.distance(
                    beam.line(from.x(), 0, from.z(), way.x(), 0, way.z()),
                    leaves.kind(at),
                    leaves.rows(),
                    at * Leaf.STRIDE,
                    scratch.ray);
            nearest = Math.min(nearest, distance);
        };
        tree.query(swept, visitor);
        return nearest < FlatScene.RANGE ? nearest : Double.POSITIVE_INFINITY;
    }

    double dyn4j(robosim.geometry.model.Ray ray) {
        Point from = ray.start();
        Point way = ray.direction();
        Ray cast = new Ray(new Vector2(from.x(), from.z()), new Vector2(way.x(), way.z()));
        @Nullable
        RaycastResult<Body, BodyFixture> hit =
                world.raycastClosest(cast, FlatScene.RANGE, new DetectFilter<>(true, true, null));
        return hit == null ? Double.POSITIVE_INFINITY : hit.getRaycast().getDistance();
    }

    boolean jts(GeometryObject probe) {
        LeafColumn leaf = LocalLeaves.placed(probe);
        found = false;
        ItemVisitor visitor =
                item -> found = found || Overlap.test(Dimension.PLANAR, leaf, 0, leaves, (Integer) item, scratch);
        tree.query(envelope(leaf, 0), visitor);
        return found;
    }

    boolean dyn4j(GeometryObject probe) {
        CylinderObject disc = (CylinderObject) probe;
        Transform place = new Transform();
        place.translate(disc.center().x(), disc.center().z());
        return world.detectIterator(Geometry.createCircle(disc.radius()), place, new DetectFilter<>(true, true, null))
                .hasNext();
    }
}
