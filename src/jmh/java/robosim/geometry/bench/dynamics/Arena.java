package robosim.geometry.bench.dynamics;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/**
 * A crowded arena seen from above: discs and boxes of about 0.5 m in a square of walls, some 40 % of it covered, all of one
 * surface, which are stirred every {@link #STIRRED} steps. The same numbers make the scene of another engine.
 */
public final class Arena {
    /** All velocities are set anew after so many steps. */
    public static final int STIRRED = 50;

    /** Seconds a step. */
    public static final double STEP = 0.01;

    public static final double RESTITUTION = 0.5;
    public static final double FRICTION = 0.3;
    public static final double DENSITY = 100;

    /** How fast bodies are stirred, m/s and radians a second, both ways along each axis. */
    public static final double SPEED = 2;

    public static final double TURN = 2;

    /** Half of the square's side, metres; its walls are outside. */
    public final double half;

    public final List<GeometryObject> bodies = new ArrayList<>();
    private final SplittableRandom random;

    /** A scene of so many bodies. */
    public Arena(int count, long seed) {
        random = new SplittableRandom(seed);
        half = 0.5 * Math.sqrt(count * 0.25 / 0.4);
        Geometry free = new Geometry(2 * half, 2, 2 * half, Dimension.PLANAR, Accuracy.EXACT);
        while (bodies.size() < count) {
            String name = "b" + bodies.size();
            Point c = new Point(random.nextDouble(-half, half), 0, random.nextDouble(-half, half));
            GeometryObject body = bodies.size() % 2 == 0
                    ? new CylinderObject(c, random.nextDouble(0.22, 0.32), 1).moveable(name)
                    : new BoxObject(c, random.nextDouble(0.35, 0.65), 1, random.nextDouble(0.35, 0.65))
                            .turned(0, random.nextDouble(360))
                            .moveable(name);
            if (free.addObject(body)) {
                bodies.add(body);
            }
        }
    }

    /** A velocity along X, along Z and of turning, radians a second, for each body. */
    public double[] stirring() {
        double[] all = new double[3 * bodies.size()];
        for (int k = 0; k < bodies.size(); k++) {
            all[3 * k] = random.nextDouble(-SPEED, SPEED);
            all[3 * k + 1] = random.nextDouble(-SPEED, SPEED);
            all[3 * k + 2] = random.nextDouble(-TURN, TURN);
        }
        return all;
    }

    /** The walls: four boxes. */
    public List<GeometryObject> walls() {
        List<GeometryObject> walls = new ArrayList<>();
        for (int side = -1; side <= 1; side += 2) {
            walls.add(new BoxObject(new Point(side * (half + 0.5), 0, 0), 1, 1, 2 * half + 2));
            walls.add(new BoxObject(new Point(0, 0, side * (half + 0.5)), 2 * half, 1, 1));
        }
        return walls;
    }

    /** The world of this scene. */
    public Geometry world() {
        Geometry world = new Geometry(2 * half + 4, 2, 2 * half + 4, Dimension.PLANAR, Accuracy.EXACT);
        walls().forEach(world::addObjectUnchecked);
        bodies.forEach(world::addObject);
        return world;
    }

    /** The bodies of this scene in its world. */
    public Dynamics dynamics(Geometry world) {
        Surface surface = new Surface(RESTITUTION, FRICTION, FRICTION);
        Dynamics dynamics = new Dynamics(world, surface);
        for (GeometryObject body : bodies) {
            dynamics.add(body.name(), Body.ofDensity(body, DENSITY).withSurface(surface));
        }
        return dynamics;
    }

    /** Gives all bodies velocities in the world's axes. */
    public void stir(Geometry world, Dynamics dynamics, double[] velocities) {
        for (int k = 0; k < bodies.size(); k++) {
            String name = bodies.get(k).name();
            double[] r = world.getObject(name).rotation();
            double vx = velocities[3 * k];
            double vz = velocities[3 * k + 1];
            dynamics.setVelocity(
                    name,
                    new Twist(r[0] * vx + r[6] * vz, 0, r[2] * vx + r[8] * vz, Math.toDegrees(velocities[3 * k + 2])));
        }
    }
}
