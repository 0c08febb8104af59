package robosim.geometry;

import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.broadphase.SharedIndex;
import robosim.geometry.engine.motion.FreePlaces;
import robosim.geometry.engine.motion.Motion;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.engine.sensing.BeamQuery;
import robosim.geometry.engine.sensing.Beams;
import robosim.geometry.engine.sensing.Echoes;
import robosim.geometry.engine.sensing.PatternSensor;
import robosim.geometry.engine.sensing.ProximityQuery;
import robosim.geometry.engine.sensing.RayBatch;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.narrow.Scratch;

/**
 * The questions to a world about what is seen and what is free, which change nothing. Users know them as methods of
 * {@link Geometry}, the only class of this kind.
 */
abstract class GeometryQueries {
    private static final Point CENTER = new Point();

    final ObjectRegistry registry;
    final ObjectTable objects;
    final AccuracyView view;
    final Motion motion;
    final Scratch scratch;
    private final Beams beams;
    private final PatternSensor sensor;
    private final RayBatch rays;
    private final ProximityQuery proximity;
    private @Nullable FreePlaces places;
    private final double[] normal = new double[3];

    GeometryQueries(
            double width,
            double height,
            double length,
            Dimension dimension,
            Accuracy accuracy,
            @Nullable SharedIndex shared,
            Scratch scratch) {
        this.scratch = scratch;
        registry = new ObjectRegistry(width, height, length, dimension, accuracy, shared, scratch);
        objects = registry.objects;
        view = registry.view;
        BeamQuery ranging = new BeamQuery(objects, scratch);
        beams = new Beams(dimension, objects, ranging);
        sensor = new PatternSensor(registry, ranging, scratch);
        rays = new RayBatch(dimension, objects, ranging);
        proximity = new ProximityQuery(objects, scratch);
        motion = new Motion(registry, scratch);
    }

    /**
     * Distance from the ray's start to the nearest surface within its beam. With an opening angle above 0 the beam is a
     * cone, and the result is the distance of the nearest point of any object within it.
     *
     * @param min   blind range, world units; a nearer echo is reported as {@code min} and still hides what is behind it
     * @param max   range, world units, {@code min <= max}; may be infinite
     * @param width full opening angle in degrees, from 0 (a line) up to, not including, 180
     * @return world units in {@code [min, max]}, or {@code +Infinity} if nothing echoes; {@code min} if the ray starts
     *     inside a solid
     * @throws IllegalArgumentException naming the argument that is NaN or out of range; in PLANAR also for a vertical ray
     */
    public double getRayDistance(Ray ray, double min, double max, double width) {
        registry.begin("getRayDistance");
        return beams.distance(view, ray, min, max, width, -1);
    }

    /** Distance along a ray at a given accuracy. */
    public double getRayDistance(Ray ray, double min, double max, double width, Accuracy accuracy) {
        registry.begin("getRayDistance");
        return beams.distance(registry.at(accuracy), ray, min, max, width, -1);
    }

    /** Distance along a ray to the nearest object, ignoring the one of a given name. */
    public double getRayDistance(Ray ray, double min, double max, double width, String ignored) {
        registry.begin("getRayDistance");
        return beams.distance(view, ray, min, max, width, registry.known(ignored));
    }

    /**
     * Distance that a sonar at the centre of a moveable object measures; the object itself does not echo.
     *
     * @param x forward component of the direction in the object's own frame
     * @param z component to the right
     */
    public double getSonarDistance(String name, double x, double z, double min, double max, double width) {
        registry.begin("getSonarDistance");
        int id = registry.mover(name);
        Checks.coordinate("x", x);
        Checks.coordinate("z", z);
        if (x == 0 && z == 0) {
            throw new IllegalArgumentException("direction must not be zero (got: x " + x + ", z " + z + ")");
        }
        return beams.sonar(view, id, 0, 0, 0, x, 0, z, min, max, width);
    }

    /**
     * Distance that a sonar measures along a ray given in a moveable object's own frame; the object itself does not
     * echo.
     */
    public double getSonarDistance(String name, Ray mount, double min, double max, double width) {
        registry.begin("getSonarDistance");
        int id = registry.mover(name);
        Point from = Checks.present("mount", mount).start();
        Point to = mount.direction();
        return beams.sonar(view, id, from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), min, max, width);
    }

    /**
     * The smallest distance between an object and any other. To the bit, it is the minimum of the distances to each
     * other object alone; its error is within 2<sup>-43</sup> of the distance and of the sizes of the two.
     *
     * @param max range, world units; may be infinite
     * @return 0 in contact, {@code +Infinity} if nothing is within {@code max}
     */
    public double getProximity(String name, double max) {
        registry.begin("getProximity");
        int id = registry.known(name);
        Checks.range(0, max);
        return proximity.of(view, id, max);
    }

    /**
     * What a ray hits first within a range; null if it hits nothing. A ray that starts inside a solid hits it at
     * distance 0. In PLANAR the hit point keeps the height of the ray's start.
     */
    public @Nullable RayHit castRay(Ray ray, double max) {
        registry.begin("castRay");
        double distance = beams.cast(view, ray, max, normal);
        return distance == Double.POSITIVE_INFINITY
                ? null
                : new RayHit(
                        distance,
                        new Point(beams.point(0, distance), beams.point(1, distance), beams.point(2, distance)),
                        new Point(normal[0], normal[1], normal[2]),
                        objects.present(beams.hit()));
    }

    /**
     * A scan: rays from the centre of a moveable object in its own horizontal plane. Ray k points {@code firstDegrees +
     * k * stepDegrees} counter-clockwise from forward. In a PLANAR world, that of a tipped object looks up or down and sees
     * heights, as {@link #sense} describes.
     *
     * @param count number of rays; at least 0
     * @return one distance per ray, as {@link #getRayDistance} returns it with a width of 0
     */
    public double[] scan(String name, double firstDegrees, double stepDegrees, int count, double min, double max) {
        double[] distances = new double[Checks.count(count)];
        scan(name, firstDegrees, stepDegrees, min, max, distances);
        return distances;
    }

    /** A scan into a given array, with as many rays as the array has elements. */
    public void scan(String name, double firstDegrees, double stepDegrees, double min, double max, double[] out) {
        scan(name, CENTER, firstDegrees, stepDegrees, min, max, out);
    }

    /**
     * A scan from a sensor that is not at the object's centre.
     *
     * @param mount the sensor's position in the object's own frame
     */
    public void scan(
            String name, Point mount, double firstDegrees, double stepDegrees, double min, double max, double[] out) {
        registry.begin("scan");
        Checks.present("mount", mount);
        sensor.scan(registry.mover(name), mount, firstDegrees, stepDegrees, min, max, out);
    }

    /**
     * All beams of a sensor that is mounted on a moveable object. Each distance is, to the bit, that of
     * {@link #getSonarDistance(String, Ray, double, double, double)} along {@code new Ray(mount.center(), d)}, where d is
     * the beam's direction turned by the rotation of the mount. A {@link #scan} is a {@link RayPattern#fan}.
     *
     * <p>In a PLANAR world, sonars (beams with a width) and level lasers measure in the plane. A sensor that looks up or
     * down, as cameras and lidars with elevation do, sees the objects with their heights: its answers are those of a SPATIAL
     * world with the same objects. A laser is level if its {@linkplain RayPattern#isLevel pattern} is and if it stands
     * upright to 2<sup>-16</sup>.
     *
     * @param mount   where the sensor is and which way it faces, in the object's own frame
     * @param options a world answers on the calling thread alone, whatever the number of threads: see
     *                {@link Snapshot#sense}
     * @param out     takes the answers
     */
    public void sense(String name, Pose mount, RayPattern pattern, SenseOptions options, SenseBuffer out) {
        registry.begin("sense");
        mountSensor(Checks.present("name", name), Checks.present("mount", mount));
        sense(pattern, options, out);
    }

    /**
     * All beams of a sensor that nothing carries. Each distance is, to the bit, that of {@link #getRayDistance} from the
     * sensor's place, and each object and normal that of {@link #castRay}. In a PLANAR world, a sensor that looks up or down
     * sees heights: see above.
     *
     * @param sensor where it is and which way it faces
     */
    public void sense(Pose sensor, RayPattern pattern, SenseOptions options, SenseBuffer out) {
        registry.begin("sense");
        mountSensor(null, Checks.present("sensor", sensor));
        sense(pattern, options, out);
    }

    private void sense(RayPattern pattern, SenseOptions options, SenseBuffer out) {
        Echoes echoes = prepareSensor(pattern, options, out);
        sensor.sense(pattern, options, echoes, 0, sensor.tiles(pattern, options));
        PatternSensor.finish(pattern, echoes);
    }

    /** Puts the sensor on an object, or into the world where none is named. */
    void mountSensor(@Nullable String name, Pose pose) {
        if (name == null) {
            sensor.frame().at(pose);
        } else {
            sensor.frame().mounted(registry.mover(name), pose);
        }
    }

    /** Checks what the sensor is asked, and makes room for its answers. */
    Echoes prepareSensor(RayPattern pattern, SenseOptions options, SenseBuffer out) {
        Checks.present("pattern", pattern);
        Checks.present("options", options);
        Echoes echoes = Checks.present("out", out).echoes();
        sensor.prepare(pattern, options, echoes);
        return echoes;
    }

    /** The number of tiles in a pattern of the sensor. */
    int sensorTiles(RayPattern pattern, SenseOptions options) {
        return sensor.tiles(pattern, options);
    }

    /** Answers some tiles of the sensor. */
    void senseSome(RayPattern pattern, SenseOptions options, Echoes out, int from, int to) {
        sensor.sense(pattern, options, out, from, to);
    }

    /**
     * What many rays meet first that begin anywhere: mirrored rays, or the echoes of a sensor that moves while it measures.
     * Each answer is, to the bit, that of {@link #castRay} with a range of its own.
     *
     * @param rays  seven numbers each: X, Y and Z of its start, X, Y and Z of its direction, of any length but zero, and its
     *              range, which may be infinite
     * @param count how many rays there are, from the beginning of the array
     * @param out   takes the answers
     */
    public void castRays(double[] rays, int count, SenseBuffer out) {
        registry.begin("castRays");
        this.rays.check(rays, count);
        this.rays.cast(view, rays, count, Checks.present("out", out).echoes());
    }

    /**
     * Tells for many rays whether each is free: whether it meets nothing within its range. Each bit is set where {@link
     * #castRay} would return null; it is found sooner than what is met first. Two points see each other where the ray from
     * one to the other, with their distance as its range, is free.
     *
     * @param rays  as in {@link #castRays}
     * @param count how many rays there are, from the beginning of the array
     * @param free  takes the answers as in {@link #freePoses}
     * @return how many are free
     */
    public int freeRays(double[] rays, int count, long[] free) {
        return freeRays(rays, count, -1, free);
    }

    /**
     * The same, ignoring the object of a given name.
     *
     * @throws IllegalArgumentException if there is no object of that name
     */
    public int freeRays(double[] rays, int count, String ignored, long[] free) {
        return freeRays(rays, count, registry.known(Checks.present("ignored", ignored)), free);
    }

    private int freeRays(double[] rays, int count, int ignored, long[] free) {
        registry.begin("freeRays");
        this.rays.check(rays, count);
        FreePlaces.checkRoom(count, free);
        return this.rays.free(view, rays, count, ignored, free);
    }

    /**
     * Finds for many poses of a moveable object whether it could be there. Nothing is moved. A pose keeps how the object is
     * tipped now: the object is turned about the vertical until its heading is that of the pose. Each bit is set if the object
     * would be within the world and touch nothing there, apart from itself and from what it stands on: where the object is now,
     * a plane may separate it from a piece that it touches, such as a floor. Pieces that lie wholly behind that plane do not
     * count at a pose that is on the other side of it, or on it, as for moves. So a robot on a floor may be anywhere on that
     * floor. Enclosures of coarser accuracies have no such planes.
     *
     * @param poses four numbers each: X, Y and Z of the centre, and the heading in degrees
     * @param free  bit {@code k % 64} of element {@code k / 64} is the answer for pose k, the layout of
     *              {@link java.util.BitSet#valueOf(long[])}; the other bits of the last element are cleared
     * @return how many poses are free
     */
    public int freePoses(String name, double[] poses, long[] free) {
        registry.begin("freePoses");
        int id = registry.mover(name);
        return places().poses(view, id, poses, 0, FreePlaces.check("poses", poses, FreePlaces.POSE, free), free);
    }

    /**
     * Finds for many edges, each a straight move from one pose to another, whether a moveable object could make them. Nothing
     * is moved. Each bit is set if the first pose is free as in {@link #freePoses} and {@link Geometry#moveGlobal} would move
     * the object from there by the differences of the coordinates, and in place turn it by that of the headings: a turn of 350
     * degrees is not one of -10. An edge that begins where the object is, with the numbers of its centre and heading, is free
     * exactly if that move is. The path is swept, not sampled.
     *
     * @param edges eight numbers each: X, Y, Z and heading at the first pose, then at the second
     * @param free  takes the answers as in {@link #freePoses}
     * @return how many edges are free
     */
    public int freeEdges(String name, double[] edges, long[] free) {
        registry.begin("freeEdges");
        int id = registry.mover(name);
        return places().edges(view, id, edges, 0, FreePlaces.check("edges", edges, FreePlaces.EDGE, free), free);
    }

    /** Answers some poses. */
    int somePoses(String name, double[] poses, int from, int to, long[] free) {
        return places().poses(view, registry.mover(name), poses, from, to, free);
    }

    /** Answers some edges. */
    int someEdges(String name, double[] edges, int from, int to, long[] free) {
        return places().edges(view, registry.mover(name), edges, from, to, free);
    }

    /** Made on first use: many worlds answer no such query. */
    final FreePlaces places() {
        FreePlaces made = places == null ? new FreePlaces(registry, motion, scratch) : places;
        places = made;
        return made;
    }
}
