package robosim.geometry.sensor;

import java.util.EnumSet;
import org.jspecify.annotations.Nullable;
import robosim.geometry.SenseBuffer;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.Twist;
import robosim.geometry.sensor.effects.NoisyFrame;

/**
 * A reading of a sensor with rays: a distance for each ray and what the sensor makes of it. Its arrays are used again by
 * the next reading and grow only for more rays. Before the first reading, and after one that threw an exception, it is
 * empty. A frame is used by one reading at a time.
 *
 * <p>The rays are in the order of the sensor's {@link RayPattern}: element {@code row * columns() + column}.
 */
public abstract class RayFrame {
    private static final double[] NONE = new double[0];

    private SenseBuffer buffer = new SenseBuffer();
    private boolean hasObjects;
    private boolean hasNormals;
    private boolean hasParts;
    private final SenseBuffer cones = new SenseBuffer();
    private final NoisyFrame measured = new NoisyFrame();

    private @Nullable RayPattern pattern;
    private int size;
    private long number;

    /** How the sensor moved; null where it did not. */
    private @Nullable ScanMotion motion;

    /** Of what the motion was made. */
    private @Nullable Setup moved;

    /** The distances: the buffer's own, or with noise the frame's. */
    private double[] ranges = NONE;

    private double[] noisy = NONE;

    /** Which echoes are nearer than the blind range; empty where none can be. */
    private boolean[] near = new boolean[0];

    private boolean hasNear;
    private double[] incidence = NONE;
    private boolean hasIncidence;
    private final double[] vector = new double[3];

    RayFrame() {}

    // What the sensor does while it reads.

    /**
     * Makes a buffer with what is needed.
     *
     * @param parts   objects, and the parts of groups
     * @param normals whether normals are needed
     * @param cones   whether the beams have a width: then there are no parts and no normals
     */
    void prepare(boolean objects, boolean parts, boolean normals, boolean cones) {
        size = 0;
        pattern = null;
        hasIncidence = false;
        hasNear = false;
        // What another sensor needed stays, except that a buffer with parts or normals takes no cones.
        boolean hasEnough = (hasObjects || !objects)
                && (hasParts || !parts)
                && (hasNormals || !normals)
                && !((hasParts || hasNormals) && cones);
        if (!hasEnough) {
            hasObjects |= objects;
            hasParts = parts || (hasParts && !cones);
            hasNormals = normals || (hasNormals && !cones);
            buffer = new SenseBuffer(extras());
        }
    }

    private SenseBuffer.Extra[] extras() {
        EnumSet<SenseBuffer.Extra> extras = EnumSet.noneOf(SenseBuffer.Extra.class);
        if (hasObjects) {
            extras.add(SenseBuffer.Extra.OBJECTS);
        }
        if (hasParts) {
            extras.add(SenseBuffer.Extra.PARTS);
        }
        if (hasNormals) {
            extras.add(SenseBuffer.Extra.NORMALS);
        }
        return extras.toArray(new SenseBuffer.Extra[0]);
    }

    SenseBuffer buffer() {
        return buffer;
    }

    SenseBuffer cones() {
        return cones;
    }

    @SuppressWarnings(
            "ReferenceEquality") // an equal setup makes an equal motion; to compare its rays would take longer
    void filled(Setup setup, long frame) {
        pattern = setup.pattern();
        number = frame;
        ranges = buffer.distances();
        Twist twist = setup.options().motion();
        if (twist == null || !setup.pattern().hasTimes()) {
            motion = null;
            moved = null;
        } else if (moved != setup) {
            motion = new ScanMotion(twist, setup.mounting());
            moved = setup;
        }
    }

    /** Makes what the sensor reports of the true distances, in a copy: with noise, and within its range. */
    void measure(Setup setup) {
        double min = setup.options().min();
        if (min == 0 && setup.noise().isNone()) {
            return;
        }
        int count = setup.pattern().size();
        if (noisy.length < count) {
            noisy = new double[count];
            near = new boolean[count];
        }
        hasNear = true;
        double[] truth = buffer.distances();
        for (int k = 0; k < count; k++) {
            near[k] = truth[k] < min;
            noisy[k] = near[k] ? min : truth[k];
        }
        ranges = noisy;
        if (!setup.noise().isNone()) {
            disturb(setup, count);
        }
        double max = setup.options().max();
        for (int k = 0; k < count; k++) {
            double distance = noisy[k];
            near[k] |= distance < min;
            if (distance > max) {
                noisy[k] = Double.POSITIVE_INFINITY;
            }
            if (near[k] && distance <= max) { // not lost
                noisy[k] = setup.outOfRange().near(distance, min);
            }
        }
    }

    private void disturb(Setup setup, int count) {
        measured.distances = noisy;
        measured.count = count;
        measured.min = setup.options().min();
        measured.max = setup.options().max();
        measured.lost = setup.outOfRange().lost();
        measured.incidence = setup.noise().needsIncidence() ? incidence() : NONE;
        measured.cones = setup.asked().cones() == null ? NONE : cones.distances();
        setup.noise().apply(setup.errors().seed(), setup.errors().sensor(), number, measured);
    }

    /** Computes the cosine of each angle of incidence, -1 where no surface was met. */
    double[] incidence() {
        if (hasIncidence) {
            return incidence;
        }
        RayPattern rays = rays();
        int count = rays.size();
        if (incidence.length < count) {
            incidence = new double[count];
        }
        double[] normals = buffer.normals();
        for (int k = 0; k < count; k++) {
            double nx = normals[3 * k];
            double ny = normals[3 * k + 1];
            double nz = normals[3 * k + 2];
            if (nx == 0 && ny == 0 && nz == 0) {
                incidence[k] = -1;
                continue;
            }
            direction(rays, k);
            double cosine = Math.abs(nx * vector[0] + ny * vector[1] + nz * vector[2]);
            incidence[k] = cosine > 1 ? 1 : cosine;
        }
        hasIncidence = true;
        return incidence;
    }

    /** Sets the vector to a ray's unit direction in the world, level if it was measured in the plane. */
    private void direction(RayPattern rays, int ray) {
        vector[0] = rays.x(ray);
        vector[1] = rays.y(ray);
        vector[2] = rays.z(ray);
        ScanMotion moving = motion;
        if (moving != null) {
            moving.to(rays.time(ray));
            moving.turn(vector);
        }
        turn(vector[0], vector[1], vector[2], vector, 0);
        if (buffer.dimension() == Dimension.PLANAR) {
            vector[1] = 0;
        }
        double length = Math.sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
        vector[0] /= length;
        vector[1] /= length;
        vector[2] /= length;
    }

    /** Turns a vector from the sensor's axes to the world's. */
    void turn(double x, double y, double z, double[] out, int at) {
        double[] r = buffer.place();
        out[at] = r[3] * x + r[4] * y + r[5] * z;
        out[at + 1] = r[6] * x + r[7] * y + r[8] * z;
        out[at + 2] = r[9] * x + r[10] * y + r[11] * z;
    }

    /** Turns a vector from the world's axes to the sensor's. */
    void turnBack(double x, double y, double z, double[] out, int at) {
        double[] r = buffer.place();
        out[at] = r[3] * x + r[6] * y + r[9] * z;
        out[at + 1] = r[4] * x + r[7] * y + r[10] * z;
        out[at + 2] = r[5] * x + r[8] * y + r[11] * z;
    }

    void finished() {
        size = rays().size();
    }

    RayPattern rays() {
        return Checks.present("pattern", pattern);
    }

    // What users ask.

    /** The number of rays; 0 before the first reading. */
    public int size() {
        return size;
    }

    /** The number of rows: of a lidar's layers, or of an image; 0 before the first reading. */
    public int rows() {
        return size == 0 ? 0 : rays().rows();
    }

    /** The number of rays in a row; 0 before the first reading. */
    public int columns() {
        return size == 0 ? 0 : rays().columns();
    }

    /** The number of the reading, as it was given to the sensor. */
    public long number() {
        return number;
    }

    /**
     * The distance that a ray measured, along the ray from the sensor; {@code +Infinity} where nothing echoes. Without noise
     * it is, to the bit, what {@link robosim.geometry.Geometry#getRayDistance} returns, unless the sensor reports what is
     * {@linkplain RaySensor#withRep117 out of range} in another way.
     */
    public double range(int ray) {
        return ranges[checked(ray)];
    }

    /**
     * Whether a ray's echo was nearer than the blind range, or its noise made it so. Nothing is known of it but that it is
     * there: it has no point, no intensity, and is in no cloud.
     */
    public boolean isNear(int ray) {
        return hasNear && near[checked(ray)];
    }

    /** Whether a ray measured a distance within the sensor's range. */
    public boolean hasPoint(int ray) {
        return isMeasured(checked(ray));
    }

    /** The same while the frame is being read. */
    boolean isMeasured(int ray) {
        return Math.abs(ranges[ray]) < Double.POSITIVE_INFINITY && !(hasNear && near[ray]); // NaN is no distance
    }

    /**
     * All distances: the frame's own array, no copy. Elements from {@link #size} on mean nothing, and the next reading may
     * use another array.
     */
    public double[] ranges() {
        return ranges;
    }

    /** Where the sensor was in the world, and which way it faced, when it was read; at time 0 if it moved meanwhile. */
    public Pose pose() {
        double[] place = buffer.place();
        double[] rotation = new double[9];
        System.arraycopy(place, 3, rotation, 0, 9);
        return Pose.of(new Point(place[0], place[1], place[2]), 0).oriented(rotation);
    }

    /**
     * Writes the point that a ray measured, in the sensor's own frame: its range along its direction, as a sensor computes it
     * that knows nothing of its motion. A level laser in a PLANAR world measures in the plane, where the point then is.
     *
     * @param out takes X, Y and Z; they are NaN where the ray has {@linkplain #hasPoint no point}
     * @param at  where in the array they begin
     */
    public void point(int ray, double[] out, int at) {
        double range = rangeOrNaN(ray);
        RayPattern rays = rays();
        vector[0] = rays.x(ray);
        vector[1] = rays.y(ray);
        vector[2] = rays.z(ray);
        if (buffer.dimension() == Dimension.PLANAR) {
            turn(vector[0], vector[1], vector[2], vector, 0);
            turnBack(vector[0], 0, vector[2], vector, 0);
        }
        double length = Math.sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
        for (int axis = 0; axis < 3; axis++) {
            out[at + axis] = range * (vector[axis] / length);
        }
    }

    /**
     * Writes the point that a ray measured, in the world. If the sensor moves during the reading, it is the point as seen
     * from where the sensor was when the ray was sent.
     */
    public void worldPoint(int ray, double[] out, int at) {
        double range = rangeOrNaN(ray);
        double[] place = buffer.place();
        ScanMotion moving = motion;
        direction(rays(), ray); // which goes to the ray's time
        double x = range * vector[0];
        double y = range * vector[1];
        double z = range * vector[2];
        vector[0] = 0;
        vector[1] = 0;
        vector[2] = 0;
        if (moving != null) {
            moving.origin(vector);
            turn(vector[0], vector[1], vector[2], vector, 0);
        }
        out[at] = place[0] + vector[0] + x;
        out[at + 1] = place[1] + vector[1] + y;
        out[at + 2] = place[2] + vector[2] + z;
    }

    private double rangeOrNaN(int ray) {
        return hasPoint(ray) ? ranges[ray] : Double.NaN;
    }

    /** Adds each {@linkplain #hasPoint point} to a cloud, in the sensor's own frame: see {@link #point}. */
    public void addTo(PointCloud cloud) {
        cloud.add(this, false);
    }

    /** Adds each {@linkplain #hasPoint point} to a cloud, in the world: see {@link #worldPoint}. */
    public void addInWorldTo(PointCloud cloud) {
        cloud.add(this, true);
    }

    /** One of the fields of a cloud, for one ray. */
    double field(PointCloud.Field field, int ray) {
        if (field == PointCloud.Field.RING) {
            int row = ray / rays().columns();
            return row;
        }
        throw new IllegalArgumentException("a cloud must have fields that the frame has (got: " + field + " for a "
                + getClass().getSimpleName() + ")");
    }

    @Nullable
    GeometryObject metBy(int ray) {
        return buffer.object(checked(ray));
    }

    int checked(int ray) {
        if (ray < 0 || ray >= size) {
            String need = size == 0 ? "one of a frame that was read, and none was" : "from 0 to " + (size - 1);
            throw new IllegalArgumentException("ray must be " + need + " (got: " + ray + ")");
        }
        return ray;
    }
}
