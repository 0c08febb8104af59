package robosim.geometry.engine.sensing;

import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.Twist;

/** Where a sensor is and which way it faces: on a moveable object or free, at rest or moving during its scan. */
public final class SensorFrame {
    /** A sensor tilted by less than this is upright: a pose given in radians of five digits is rounded by as much. */
    private static final double TILT = 0x1p-16;

    private final ObjectTable objects;
    private final double[] vector = new double[3];
    private final double[] mount = new double[9];

    /** Where the sensor is mounted, or is at time 0. */
    private Pose pose = Pose.ORIGIN;

    /** Whether it moves during the scan. */
    private boolean isMoving;

    private final SensorMotion path = new SensorMotion();
    private final double[] place = new double[Pose.PLACE];

    /** Where the beams begin. */
    private double ox;

    private double oy;
    private double oz;

    /** The object that carries the sensor; -1 for none. */
    private int carrier = -1;

    SensorFrame(ObjectTable objects) {
        this.objects = objects;
    }

    /** Takes a sensor that is mounted on a moveable object, in its own frame. */
    public void mounted(int id, Pose on) {
        carrier = id;
        pose = on;
        on.rotation(mount, 0);
        stand(id, on.center());
    }

    /** Takes a point of an object's own frame for where all beams begin. */
    void stand(int id, Point at) {
        double[] places = objects.places();
        int place = objects.place(id);
        objects.toWorld(id, at.x(), at.y(), at.z(), vector);
        ox = places[place] + vector[0];
        oy = places[place + 1] + vector[1];
        oz = places[place + 2] + vector[2];
    }

    /** Takes a sensor in the world that nothing carries. */
    public void at(Pose sensor) {
        carrier = -1;
        pose = sensor;
        sensor.rotation(mount, 0);
        Point at = sensor.center();
        ox = at.x();
        oy = at.y();
        oz = at.z();
    }

    /** Writes where the sensor is, at time 0 if it moves: its origin, and its axes as the columns of a rotation. */
    void tell(double[] place) {
        place[0] = ox;
        place[1] = oy;
        place[2] = oz;
        for (int axis = 0; axis < 3; axis++) {
            vector[0] = mount[axis];
            vector[1] = mount[3 + axis];
            vector[2] = mount[6 + axis];
            if (carrier >= 0) {
                objects.toWorld(carrier, vector[0], vector[1], vector[2], vector);
            }
            for (int row = 0; row < 3; row++) {
                place[3 + 3 * row + axis] = vector[row] + 0.0;
            }
        }
    }

    /** Whether the sensor's own Y is vertical, so that a level pattern stays level; upside down too. */
    boolean isUpright() {
        vector[0] = mount[1];
        vector[1] = mount[4];
        vector[2] = mount[7];
        if (carrier >= 0) {
            objects.toWorld(carrier, vector[0], vector[1], vector[2], vector);
        }
        return isVertical();
    }

    /** Whether an object's own Y is vertical. */
    boolean isUpright(int id) {
        objects.toWorld(id, 0, 1, 0, vector);
        return isVertical();
    }

    private boolean isVertical() {
        return Math.abs(vector[0]) <= TILT && Math.abs(vector[2]) <= TILT;
    }

    private void checkMotion(Twist velocity, RayPattern pattern, SenseOptions options) {
        if (carrier >= 0 && options.carrier() == SenseOptions.Carrier.SEEN) {
            throw new IllegalArgumentException(
                    "the object that carries a sensor must be IGNORED where it moves during the scan (got: SEEN)");
        }
        double time = pattern.farthestTime();
        if (carrier >= 0) {
            double[] places = objects.places();
            int at = objects.place(carrier);
            velocity.check(time, places[at], places[at + 1], places[at + 2]);
        } else {
            velocity.check(
                    time, pose.center().x(), pose.center().y(), pose.center().z());
        }
    }

    /** Whether the sensor moves while the beams of a pattern are fired. */
    static boolean moves(RayPattern pattern, SenseOptions options) {
        return options.motion() != null && pattern.hasTimes();
    }

    /**
     * Takes how the sensor moves, after it was put in its place.
     *
     * @throws IllegalArgumentException if it gets too far away, or is to see the object that carries it
     */
    void start(RayPattern pattern, SenseOptions options) {
        Twist velocity = options.motion();
        isMoving = velocity != null && pattern.hasTimes();
        if (velocity != null && isMoving) {
            checkMotion(velocity, pattern, options);
            if (carrier >= 0) {
                path.start(objects.places(), objects.place(carrier), velocity);
            } else {
                pose.place(place, 0);
                path.start(place, 0, velocity);
            }
        }
    }

    /** Goes to where the sensor is at a time. */
    void moveTo(double seconds) {
        int at = path.at(seconds);
        double[] poses = path.poses();
        ox = poses[at];
        oy = poses[at + 1];
        oz = poses[at + 2];
        if (carrier >= 0) {
            Point on = pose.center();
            path.turn(at, on.x(), on.y(), on.z(), vector);
            ox += vector[0];
            oy += vector[1];
            oz += vector[2];
        }
    }

    /** The object that carries the sensor; -1 for none. */
    int carrier() {
        return carrier;
    }

    boolean isMoving() {
        return isMoving;
    }

    double x() {
        return ox;
    }

    double y() {
        return oy;
    }

    double z() {
        return oz;
    }

    /**
     * Turns the directions of some beams to the world's axes.
     *
     * @param beams their numbers in the pattern
     * @param times takes when they are fired, if the sensor moves
     */
    void turn(RayPattern pattern, int count, double[] directions, int[] beams, double[] times) {
        if (isMoving) {
            turnMoving(pattern, count, directions, beams, times);
            return;
        }
        for (int at = 0; at < 3 * count; at += 3) {
            double x = directions[at];
            double y = directions[at + 1];
            double z = directions[at + 2];
            // As a point has them, which has no -0.0.
            double ownX = mount[0] * x + mount[1] * y + mount[2] * z + 0.0;
            double ownY = mount[3] * x + mount[4] * y + mount[5] * z + 0.0;
            double ownZ = mount[6] * x + mount[7] * y + mount[8] * z + 0.0;
            if (carrier >= 0) {
                objects.toWorld(carrier, ownX, ownY, ownZ, vector);
                directions[at] = vector[0];
                directions[at + 1] = vector[1];
                directions[at + 2] = vector[2];
            } else {
                directions[at] = ownX;
                directions[at + 1] = ownY;
                directions[at + 2] = ownZ;
            }
        }
    }

    private void turnMoving(RayPattern pattern, int count, double[] directions, int[] beams, double[] times) {
        for (int k = 0; k < count; k++) {
            int at = 3 * k;
            double x = directions[at];
            double y = directions[at + 1];
            double z = directions[at + 2];
            times[k] = pattern.time(beams[k]);
            int then = path.at(times[k]);
            if (carrier >= 0) {
                // As a point has them, which has no -0.0.
                double ownX = mount[0] * x + mount[1] * y + mount[2] * z + 0.0;
                double ownY = mount[3] * x + mount[4] * y + mount[5] * z + 0.0;
                double ownZ = mount[6] * x + mount[7] * y + mount[8] * z + 0.0;
                path.turn(then, ownX, ownY, ownZ, vector);
                System.arraycopy(vector, 0, directions, at, 3);
            } else {
                path.turn(then, x, y, z, vector);
                directions[at] = vector[0] + 0.0;
                directions[at + 1] = vector[1] + 0.0;
                directions[at + 2] = vector[2] + 0.0;
            }
        }
    }
}
