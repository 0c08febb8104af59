package robosim.geometry.dynamics.proof;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/** A small world with bodies, and what must hold there after every step, decided from where the bodies' centres are. */
final class StepScene {
    /** What must hold between a step and the next; tells what is broken. */
    interface Law {
        @Nullable
        String broken();
    }

    final Geometry world;
    final Dynamics dynamics;
    final List<String> names = new ArrayList<>();
    final List<Body> bodies = new ArrayList<>();
    private final List<Law> laws = new ArrayList<>();
    private final List<GeometryObject> walls = new ArrayList<>();
    private @Nullable List<FlatShape> wallShapes;

    /** A world without anything; its border is a wall. */
    StepScene(double width, double length, Surface ground) {
        world = new Geometry(width, 4, length, Dimension.PLANAR, Accuracy.EXACT);
        dynamics = new Dynamics(world, ground);
        laws.add(() -> {
            for (String name : names) {
                Point c = center(name);
                if (!(Math.abs(c.x()) < width / 2 && Math.abs(c.z()) < length / 2)) {
                    return name + " is outside";
                }
            }
            return null;
        });
    }

    Point center(String name) {
        return world.getObject(name).center();
    }

    /** Adds what stands still. */
    void wall(GeometryObject wall) {
        if (!world.addObjectUnchecked(wall)) {
            throw new IllegalArgumentException("wall must be taken (got: " + wall + ")");
        }
        walls.add(wall);
    }

    /** Adds a body if its place is free; answers its name. */
    @Nullable
    String body(GeometryObject shape, Body body) {
        String name = "b" + names.size();
        if (!world.addObject(shape.moveable(name))) {
            return null;
        }
        names.add(name);
        bodies.add(body);
        dynamics.add(name, body);
        return name;
    }

    void law(Law law) {
        laws.add(law);
    }

    /** From now on each body stays on its side of the line through a point along a direction: no wall there has a gap. */
    void keepsSides(double x, double z, double dx, double dz) {
        double[] sides = new double[names.size()];
        for (int k = 0; k < sides.length; k++) {
            sides[k] = side(center(names.get(k)), x, z, dx, dz);
        }
        laws.add(() -> {
            for (int k = 0; k < sides.length; k++) {
                if (side(center(names.get(k)), x, z, dx, dz) != sides[k]) {
                    return names.get(k) + " has passed the wall";
                }
            }
            return null;
        });
    }

    private static double side(Point c, double x, double z, double dx, double dz) {
        return Math.signum((c.x() - x) * dz - (c.z() - z) * dx);
    }

    /** Gives every body a velocity of up to a speed along each axis, and of turning, degrees a second. */
    void stir(SplittableRandom random, double speed, double turn) {
        for (String name : names) {
            velocity(
                    name,
                    random.nextDouble(-speed, speed),
                    random.nextDouble(-speed, speed),
                    turn * random.nextDouble(-1, 1));
        }
    }

    /** Gives a body a velocity in the world's axes. */
    void velocity(String name, double vx, double vz, double turn) {
        double[] r = world.getObject(name).rotation();
        dynamics.setVelocity(name, new Twist(r[0] * vx + r[6] * vz, 0, r[2] * vx + r[8] * vz, turn));
    }

    /** The greatest speed of a body. */
    double fastest() {
        double most = 0;
        for (String name : names) {
            Twist v = dynamics.velocity(name);
            most = Math.max(most, Math.sqrt(v.x() * v.x() + v.z() * v.z()));
        }
        return most;
    }

    double energy() {
        double sum = 0;
        for (int k = 0; k < names.size(); k++) {
            Twist v = dynamics.velocity(names.get(k));
            double w = StrictMath.toRadians(v.ry());
            sum += 0.5 * bodies.get(k).mass() * (v.x() * v.x() + v.z() * v.z())
                    + 0.5 * bodies.get(k).inertia() * w * w;
        }
        return sum;
    }

    /** What is broken: an overlap, or another law; null if nothing is. */
    @Nullable
    String broken() {
        List<FlatShape> still = wallShapes;
        if (still == null) {
            still = walls.stream().map(FlatShape::of).toList();
            wallShapes = still;
        }
        FlatShape[] all = new FlatShape[names.size()];
        for (int i = 0; i < all.length; i++) {
            all[i] = FlatShape.of(world.getObject(names.get(i)));
            for (int j = 0; j < i; j++) {
                if (FlatShape.overlap(all[i], all[j])) {
                    return names.get(i) + " overlaps " + names.get(j);
                }
            }
            for (int j = 0; j < still.size(); j++) {
                if (FlatShape.overlap(all[i], still.get(j))) {
                    return names.get(i) + " overlaps wall " + j;
                }
            }
        }
        for (Law law : laws) {
            String broken = law.broken();
            if (broken != null) {
                return broken;
            }
        }
        return null;
    }

    /** Mixes the bits of all places and velocities into a number. */
    long digest(long before) {
        long hash = before;
        for (String name : names) {
            GeometryObject object = world.getObject(name);
            Twist v = dynamics.velocity(name);
            double[] all = {object.center().x(), object.center().z(), object.heading(), v.x(), v.z(), v.ry()};
            for (double each : all) {
                hash = (hash ^ Double.doubleToLongBits(each)) * 0x9E3779B97F4A7C15L;
                hash ^= hash >>> 29;
            }
        }
        return hash;
    }
}
