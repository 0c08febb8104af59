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
}
