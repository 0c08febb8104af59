package robosim.geometry.sensor;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import robosim.geometry.check.Checks;

/**
 * A list of points with fields, which frames fill and files take. It grows as points are added and keeps its memory when it
 * is cleared.
 *
 * <pre>{@code
 * Geometry world = new Geometry(20, 4, 20);
 * world.addObject(new BoxObject(new Point(5, 0, 0), 2, 2, 2));
 * LidarFrame turn = new LidarFrame(LidarFrame.Extra.INTENSITIES);
 * Lidar.velodyneVlp16(10).read(world, turn);
 * PointCloud cloud = new PointCloud(PointCloud.Field.INTENSITY, PointCloud.Field.RING);
 * turn.addTo(cloud);
 * cloud.size() > 1000;      // true: rays without an echo are left out
 * cloud.x(0) >= 4;          // true
 * }</pre>
 */
public final class PointCloud {
    /** The axes in which the points of a file are given. */
    public enum Axes {
        /** This module's own: X forward, Y up, Z to the right. */
        MODULE,
        /** Those of robots and maps in ROS (REP 103): X forward, Y to the left, Z up. */
        ROS,
        /** Those of cameras in ROS and OpenCV (REP 103, "optical"): X to the right, Y down, Z forward. */
        OPTICAL;

        /** Writes a vector along these axes, given along the module's. */
        public void of(double x, double y, double z, double[] out) {
            switch (this) {
                case MODULE -> set(x, y, z, out);
                case ROS -> set(x, 0.0 - z, y, out);
                case OPTICAL -> set(z, 0.0 - y, x, out);
            }
        }

        private static void set(double x, double y, double z, double[] out) {
            out[0] = x;
            out[1] = y;
            out[2] = z;
        }
    }

    /** What a point may have beside its place. */
    public enum Field {
        /** From 0 to 1; of lidars. */
        INTENSITY,
        /** The layer of a lidar, or the row of an image. */
        RING,
        /** Seconds from the start of the frame; of lidars. */
        TIME,
        /** The label of the surface's material; of lidars with objects and of segmentation cameras. */
        LABEL,
        /** The number of an object; of segmentation cameras. */
        INSTANCE,
        /** The surface normal's X; of normal cameras. All three or none. */
        NORMAL_X,
        /** Its Y. */
        NORMAL_Y,
        /** Its Z. */
        NORMAL_Z;

        /** 0 to 2 for a normal's, else -1. */
        int axis() {
            return switch (this) {
                case NORMAL_X -> 0;
                case NORMAL_Y -> 1;
                case NORMAL_Z -> 2;
                case INTENSITY, RING, TIME, LABEL, INSTANCE -> -1;
            };
        }
    }

    private static final int NORMALS = 3;

    private final List<Field> fields;
    private int size;
    private double[] places = new double[0];
    private double[] values = new double[0];
    private final double[] vector = new double[3];

    /** An empty cloud whose points have the given fields. */
    public PointCloud(Field... fields) {
        EnumSet<Field> set = EnumSet.noneOf(Field.class);
        for (Field field : Checks.present("fields", fields)) {
            set.add(Checks.present("field", field));
        }
        long axes = set.stream().filter(field -> field.axis() >= 0).count();
        if (axes != 0 && axes != NORMALS) {
            throw new IllegalArgumentException(
                    "fields must have all three components of the normal or none (got: " + set + ")");
        }
        this.fields = List.copyOf(set);
    }

    void add(RayFrame frame, boolean inWorld) {
        int rays = frame.size();
        for (int k = 0; k < rays; k++) {
            if (frame.hasPoint(k)) {
                reserve();
                for (int f = 0; f < fields.size(); f++) {
                    values[size * fields.size() + f] = frame.field(fields.get(f), k);
                }
                if (inWorld) {
                    frame.worldPoint(k, places, 3 * size);
                    turnNormal(frame);
                } else {
                    frame.point(k, places, 3 * size);
                }
                size++;
            }
        }
    }

    /** Turns the normal of the point at the end from the frame's axes to the world's. */
    private void turnNormal(RayFrame frame) {
        int first = fields.indexOf(Field.NORMAL_X);
        if (first >= 0) {
            int at = size * fields.size() + first;
            frame.turn(values[at], values[at + 1], values[at + 2], vector, 0);
            System.arraycopy(vector, 0, values, at, NORMALS);
        }
    }

    /**
     * Adds a point.
     *
     * @param itsValues one number for each of {@link #fields}, in their order
     */
    public void add(double x, double y, double z, double... itsValues) {
        if (Checks.present("values", itsValues).length != fields.size()) {
            throw new IllegalArgumentException(
                    "values must be one for each of " + fields + " (got: " + itsValues.length + ")");
        }
        reserve();
        places[3 * size] = x;
        places[3 * size + 1] = y;
        places[3 * size + 2] = z;
        System.arraycopy(itsValues, 0, values, size * fields.size(), fields.size());
        size++;
    }

    private void reserve() {
        if (3 * (size + 1) > places.length) {
            int most = Math.max(1024, 2 * size);
            places = Arrays.copyOf(places, Math.multiplyExact(3, most));
            values = Arrays.copyOf(values, Math.multiplyExact(fields.size(), most));
        }
    }

    /** Removes all points. */
    public void clear() {
        size = 0;
    }

    /** The number of points. */
    public int size() {
        return size;
    }

    /** The fields of each point, in the order of {@link Field}. */
    public List<Field> fields() {
        return fields;
    }

    /** A point's X. */
    public double x(int point) {
        return places[3 * checked(point)];
    }

    /** A point's Y. */
    public double y(int point) {
        return places[3 * checked(point) + 1];
    }

    /** A point's Z. */
    public double z(int point) {
        return places[3 * checked(point) + 2];
    }

    /** A field of a point. */
    public double value(Field field, int point) {
        int at = fields.indexOf(Checks.present("field", field));
        if (at < 0) {
            throw new IllegalArgumentException("field must be one of " + fields + " (got: " + field + ")");
        }
        return values[checked(point) * fields.size() + at];
    }

    private int checked(int point) {
        if (point < 0 || point >= size) {
            throw new IllegalArgumentException(
                    "point must be from 0 to size - 1, " + (size - 1) + " (got: " + point + ")");
        }
        return point;
    }

    /**
     * Writes the points as PLY (Polygon File Format), version 1.0, binary and little-endian, which CloudCompare, MeshLab,
     * Open3D and Blender read. Places and normals are floats of 32 bits. An existing file stays as it was until the new one is
     * complete.
     *
     * @param axes along which the file has its points
     * @throws IOException if it cannot be written, naming the file
     */
    public void writePly(Axes axes, Path file) throws IOException {
        SensorFiles.writePly(this, axes, file);
    }

    /**
     * Writes the points as PCD, version 0.7, binary: the format of the Point Cloud Library (PCL), which Open3D and ROS's
     * pcl_ros read too. Places and normals are floats of 32 bits. An existing file stays as it was until the new one is
     * complete.
     *
     * @param axes along which the file has its points
     * @throws IOException if it cannot be written, naming the file
     */
    public void writePcd(Axes axes, Path file) throws IOException {
        SensorFiles.writePcd(this, axes, file);
    }
}
