package robosim.geometry.engine.sensing;

import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** Beams as callers ask for them: one at a time, from a place or from a sensor on an object, between two ranges. */
public final class Beams {
    private final Dimension dimension;
    private final ObjectTable objects;
    private final BeamQuery ranging;
    private final double[] vector = new double[3];

    // Where a beam begins that stands on an object.
    private double ox;
    private double oy;
    private double oz;

    public Beams(Dimension dimension, ObjectTable objects, BeamQuery ranging) {
        this.dimension = dimension;
        this.objects = objects;
        this.ranging = ranging;
    }

    /**
     * Distance to the nearest echo.
     *
     * @param ignored an object that does not echo; -1 for none
     */
    public double distance(AccuracyView seen, Ray ray, double min, double max, double width, int ignored) {
        Point from = Checks.present("ray", ray).start();
        Point to = ray.direction();
        return distance(seen, from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), min, max, width, ignored);
    }

    private double distance(
            AccuracyView seen,
            double x,
            double y,
            double z,
            double dx,
            double dy,
            double dz,
            double min,
            double max,
            double width,
            int ignored) {
        Checks.range(min, max);
        Checks.width(width);
        checkLevel(dimension, dx, dy, dz);
        ranging.beam(dimension, x, y, z, dx, dy, dz, width);
        double nearest = ranging.nearest(seen, max, ignored);
        return nearest < min ? min : nearest;
    }

    static void checkLevel(Dimension dimension, double dx, double dy, double dz) {
        if (dimension == Dimension.PLANAR && dx == 0 && dz == 0) {
            throw vertical("direction", dx, dy, dz);
        }
    }

    static IllegalArgumentException vertical(String direction, double dx, double dy, double dz) {
        return new IllegalArgumentException(
                direction + " must not be vertical in a PLANAR world, which has no heights (got: (" + dx + ", " + dy
                        + ", " + dz + "))");
    }

    /** What a sonar hears that stands at a point of an object's own frame and looks along one of its directions. */
    public double sonar(
            AccuracyView seen,
            int id,
            double x,
            double y,
            double z,
            double dx,
            double dy,
            double dz,
            double min,
            double max,
            double width) {
        mount(id, x, y, z);
        objects.toWorld(id, dx, dy, dz, vector);
        return distance(seen, ox, oy, oz, vector[0], vector[1], vector[2], min, max, width, id);
    }

    /** Takes a point of an object's own frame for where a beam begins. */
    private void mount(int id, double x, double y, double z) {
        double[] places = objects.places();
        int at = objects.place(id);
        objects.toWorld(id, x, y, z, vector);
        ox = places[at] + vector[0];
        oy = places[at + 1] + vector[1];
        oz = places[at + 2] + vector[2];
    }

    /**
     * How far a ray goes until it meets anything within a range, +Infinity where it meets nothing.
     *
     * @param normal three numbers, of the face that is met
     */
    public double cast(AccuracyView seen, Ray ray, double max, double[] normal) {
        Point from = Checks.present("ray", ray).start();
        Point to = ray.direction();
        Checks.range(0, max);
        checkLevel(dimension, to.x(), to.y(), to.z());
        ranging.beam(dimension, from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), 0);
        double distance = ranging.nearest(seen, max, -1);
        if (ranging.hit() < 0) {
            return Double.POSITIVE_INFINITY;
        }
        ranging.normal(seen, distance, normal);
        return distance;
    }

    /** What the last ray that was cast met. */
    public int hit() {
        return ranging.hit();
    }

    /** A coordinate of the last ray's point at a distance. */
    public double point(int axis, double distance) {
        return ranging.point(axis, distance);
    }
}
