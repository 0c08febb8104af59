package robosim.geometry;

import java.util.List;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;

/**
 * What a world and a snapshot of it both answer, to the same bits: batches of beams, rays, poses and edges, none of which changes
 * anything. A {@link Geometry} belongs to one thread at a time. A {@link Snapshot} answers many threads at once, each with arrays
 * and buffers of its own, and may use several threads for one call.
 */
public sealed interface WorldQueries permits Geometry, Snapshot {
    /** Extent along X in world units. */
    double width();

    /** Extent along Y in world units. */
    double height();

    /** Extent along Z in world units. */
    double length();

    /** Whether heights count. */
    Dimension dimension();

    /** What stands for an object in queries that name no accuracy. */
    Accuracy accuracy();

    /** All objects at their places, in the order in which they were added. */
    List<GeometryObject> objects();

    /**
     * All beams of a sensor that is mounted on a moveable object. Each distance is, to the bit, that of
     * {@link Geometry#getSonarDistance(String, Ray, double, double, double)} along {@code new Ray(mount.center(), d)}, where d is
     * the beam's direction turned by the rotation of the mount. A {@link Geometry#scan(String, double, double, int, double, double) scan} is a {@link RayPattern#fan}.
     *
     * <p>In a PLANAR world, sonars (beams with a width) and level lasers measure in the plane. A sensor that looks up or
     * down, as cameras and lidars with elevation do, sees the objects with their heights: its answers are those of a SPATIAL
     * world with the same objects. A laser is level if its {@linkplain RayPattern#isLevel pattern} is and if it stands
     * upright to 2<sup>-16</sup>.
     *
     * @param mount   where the sensor is and which way it faces, in the object's own frame
     * @param options a snapshot uses up to its number of threads; a world answers on the calling thread
     * @param out     takes the answers
     */
    void sense(String name, Pose mount, RayPattern pattern, SenseOptions options, SenseBuffer out);

    /**
     * All beams of a sensor that nothing carries. Each distance is, to the bit, that of {@link Geometry#getRayDistance(Ray, double, double, double)} from the
     * sensor's place, and each object and normal that of {@link Geometry#castRay}. In a PLANAR world, a sensor that looks up or down
     * sees heights: see above.
     *
     * @param sensor where it is and which way it faces
     */
    void sense(Pose sensor, RayPattern pattern, SenseOptions options, SenseBuffer out);

    /**
     * What many rays hit first that begin anywhere: mirrored rays, or the echoes of a sensor that moves while it measures.
     * Each answer is, to the bit, that of {@link Geometry#castRay} with a range of its own.
     *
     * @param rays  seven numbers each: X, Y and Z of its start, X, Y and Z of its direction, of any length but zero, and its
     *              range, which may be infinite
     * @param count how many rays there are, from the beginning of the array
     * @param out   takes the answers
     */
    void castRays(double[] rays, int count, SenseBuffer out);

    /**
     * Finds for many rays whether each is free: whether it hits nothing within its range. Each bit is set where {@link
     * Geometry#castRay} would return null; that takes less time than finding what is hit first. Two points see each other where the ray from
     * one to the other, with their distance as its range, is free.
     *
     * @param rays  as in {@link #castRays}
     * @param count how many rays there are, from the beginning of the array
     * @param free  takes the answers as in {@link #freePoses}
     * @return how many are free
     */
    int freeRays(double[] rays, int count, long[] free);

    /**
     * The same, ignoring the object of a given name.
     *
     * @throws IllegalArgumentException if there is no object of that name
     */
    int freeRays(double[] rays, int count, String ignored, long[] free);

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
    int freePoses(String name, double[] poses, long[] free);

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
    int freeEdges(String name, double[] edges, long[] free);

    /** The same as {@link #freePoses(String, double[], long[])} with a margin, and without the objects that do not count. */
    int freePoses(String name, double[] poses, Avoidance avoid, long[] free);

    /**
     * The same as {@link #freeEdges(String, double[], long[])} with a margin, which is kept all along an edge, and without the
     * objects that do not count. With a margin, nothing that the object stands on is spared: name it to be ignored.
     */
    int freeEdges(String name, double[] edges, Avoidance avoid, long[] free);

    /**
     * Finds for many edges how much of each is free. Nothing is moved.
     *
     * @param edges     as in {@link #freeEdges(String, double[], long[])}
     * @param fractions takes two numbers for each edge, as {@link MoveResult} has them: the fraction of its translation that
     *                  is free, and after the whole translation that of its turn. Both are 1 for a free edge, and 0 for one
     *                  whose first pose is not free
     * @return how many edges are free
     */
    int edgeFractions(String name, double[] edges, Avoidance avoid, double[] fractions);

    /**
     * Finds for many drives how much of each is free. A drive is a motion with a constant {@link robosim.geometry.model.Twist},
     * which turns while it translates: a straight line, the arc of a car or of a robot with two driven wheels, a turn in place,
     * or a helix. It is swept, not sampled: no point of the object touches anything or comes nearer than the margin at any time
     * of the fraction returned, and no part of it leaves the world. Nothing is moved.
     *
     * <p>A drive that begins in contact, or nearer than the margin, is not free, with one exception: in SPATIAL, what lies
     * wholly at or below the lowest point of an upright object does not count for a drive without a height, so that a robot may
     * drive on a floor. A fraction is smaller than it could be by up to 2<sup>-30</sup> of the sizes and coordinates, and along
     * something at such a distance it may end early. A fraction can be used: a drive for that part of the time is free.
     *
     * @param drives    nine numbers each: X, Y, Z and heading of the first pose, as in {@link #freePoses}, the four numbers of a
     *                  twist, and for how many seconds
     * @param fractions takes one number for each drive: the fraction of its time that is free, 1 if all of it is
     * @return how many drives are free
     */
    int driveFractions(String name, double[] drives, Avoidance avoid, double[] fractions);

    /**
     * Finds for many poses of a moveable object how far it would be from all others, or how deep in one of them. Nothing is
     * moved. A positive number is what {@link Geometry#getProximity} would return there. Where the object would touch
     * something, it is 0 or minus the depth in the one object in which it is deepest, as proven: the upper end of
     * {@link robosim.geometry.collision.SignedDistance}. The margin of {@code avoid} does not matter.
     *
     * @param poses as in {@link #freePoses}; what the object stands on counts here unless it is ignored
     * @param max   range, world units; may be infinite
     * @param out   takes one number for each pose, {@code +Infinity} if nothing is within {@code max}; or, if it has exactly ten
     *              for each, also the nearest or deepest point on the object, that on the other one, and the unit direction
     *              from there, three numbers each: the gradient of the first number. They are zeros if nothing is within {@code max}
     * @return how many numbers are positive
     */
    int clearances(String name, double[] poses, double max, Avoidance avoid, double[] out);
}
