package robosim.geometry;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.collision.SignedDistance;
import robosim.geometry.engine.World;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.broadphase.TouchQuery;
import robosim.geometry.engine.motion.ClearanceQuery;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.engine.sensing.NearestQuery;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/**
 * Questions about which objects of a world are where: what is in the way of an addition or a placement, what meets a box,
 * what is nearest. It follows its world and belongs to its thread; {@link Geometry#search} returns it.
 *
 * <pre>{@code
 * Geometry geometry = new Geometry(20, 5, 20);
 * geometry.addObject(new BoxObject(new Point(4, 0, 0), 0.2, 2, 6).named("wall"));
 * geometry.addObject(new CylinderObject(new Point(0, 0, 0), 0.3, 1).moveable("robot"));
 * ObjectSearch search = geometry.search();
 * GeometryObject crate = new BoxObject(new Point(4, 0, 0), 1, 1, 1);
 * search.firstTouching(crate).get().name();                       // "wall"
 * search.inTheWay("robot", new Point(3.8, 0, 0), 90).size();      // 1: the wall
 * search.inTheWay("robot", new Point(6, 0, 0), 90).size();        // 0: at that place, not on the way there
 * search.inBox(new Point(0, 0, 0), 10, 5, 10).size();             // 2
 * search.nearest("robot", 1, 10).get(0).distance();               // 3.6
 * }</pre>
 *
 * <p>Touching is colliding, as everywhere; objects are seen at the accuracy of the world, and in PLANAR by their floor
 * plans. The world's bounds are no object: {@link #fits} asks about them. Lists are in the order in which the objects were
 * added, or the nearest first, and new ones each time.
 */
public final class ObjectSearch {
    private final ObjectRegistry registry;
    private final ObjectTable objects;
    private final TouchQuery touching;
    private final NearestQuery nearest;
    private final ClearanceQuery clearance;

    ObjectSearch(World world) {
        registry = world.registry;
        objects = world.objects;
        touching = world.touching();
        nearest = world.nearest();
        clearance = world.clearance();
    }

    /**
     * All objects that an object would touch or overlap where it stands: what is in the way of adding it. Empty where
     * {@link Geometry#testObject(GeometryObject)} returns false.
     */
    public List<GeometryObject> touching(GeometryObject object) {
        registry.begin("touching");
        return found(touching.find(registry.view, object, -1));
    }

    /** Of those the one that was added first. */
    public Optional<GeometryObject> firstTouching(GeometryObject object) {
        registry.begin("firstTouching");
        return first(touching.find(registry.view, object, -1));
    }

    /**
     * All objects that a moveable object would touch or overlap, itself left out, if it stood upright at a point: at that
     * place, not on a way to it. It is what is in the way of {@link Geometry#placeObject}; what blocks a way is the obstacle
     * of a {@link Geometry#move}.
     *
     * @param heading degrees about the vertical
     */
    public List<GeometryObject> inTheWay(String name, Point center, double heading) {
        registry.begin("inTheWay");
        int id = registry.mover(name);
        return found(touching.find(registry.view, placed(id, center, heading), id));
    }

    /** Of those the one that was added first. */
    public Optional<GeometryObject> firstInTheWay(String name, Point center, double heading) {
        registry.begin("firstInTheWay");
        int id = registry.mover(name);
        return first(touching.find(registry.view, placed(id, center, heading), id));
    }

    /**
     * All objects that touch or overlap an upright box, given like a {@link BoxObject}.
     *
     * @param width world units along X
     */
    public List<GeometryObject> inBox(Point center, double width, double height, double length) {
        return touching(new BoxObject(center, width, height, length));
    }

    /**
     * The objects nearest to a point, nearest first; of two equally near the one added first. Their distances are those of
     * {@link Geometry#getProximity} from a sphere of radius 0.
     *
     * @param count how many at most
     * @param max   range, world units; may be infinite
     */
    public List<NearObject> nearest(Point point, int count, double max) {
        registry.begin("nearest");
        Checks.range(0, max);
        int found = nearest.around(registry.view, Checks.present("point", point), Checks.count(count), max);
        clearance.point(registry.view, point);
        return near(found);
    }

    /**
     * The objects nearest to an object, which is left out. The distance of the first is {@link Geometry#getProximity}.
     *
     * @param count how many at most
     * @param max   range, world units; may be infinite
     */
    public List<NearObject> nearest(String name, int count, double max) {
        registry.begin("nearest");
        int id = registry.known(name);
        Checks.range(0, max);
        int found = nearest.around(registry.view, id, Checks.count(count), max);
        clearance.present(registry.view, id);
        return near(found);
    }

    /** Whether an object lies within the world's bounds where it stands. */
    public boolean fits(GeometryObject object) {
        return registry.fits(Checks.present("object", object));
    }

    /** Whether a moveable object would lie within the world's bounds if it stood upright at a point. */
    public boolean fits(String name, Point center, double heading) {
        return registry.fits(placed(registry.mover(name), center, heading));
    }

    private GeometryObject placed(int id, Point center, double heading) {
        return objects.value(id).at(Pose.of(Checks.present("center", center), Checks.angle("heading", heading)));
    }

    private Optional<GeometryObject> first(int count) {
        @Nullable GeometryObject one = count == 0 ? null : objects.present(touching.touched(0));
        return Optional.ofNullable(one);
    }

    private List<GeometryObject> found(int count) {
        List<GeometryObject> list = new ArrayList<>(count);
        for (int k = 0; k < count; k++) {
            list.add(objects.present(touching.touched(k)));
        }
        return list;
    }

    private List<NearObject> near(int count) {
        List<NearObject> list = new ArrayList<>(count);
        for (int k = 0; k < count; k++) {
            clearance.measure(nearest.found(k), nearest.distance(k));
            list.add(near(objects, nearest.found(k), nearest.distance(k), clearance));
        }
        return list;
    }

    static NearObject near(ObjectTable objects, int id, double distance, ClearanceQuery measured) {
        return new NearObject(objects.present(id), distance, signed(measured));
    }

    static SignedDistance signed(ClearanceQuery measured) {
        double[] w = measured.witness();
        return new SignedDistance(
                measured.low(),
                measured.high(),
                new Point(w[0], w[1], w[2]),
                new Point(w[3], w[4], w[5]),
                new Point(w[6], w[7], w[8]),
                measured.steps());
    }
}
