package robosim.geometry.bench.dynamics;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;

/**
 * 100 robots that drive about in {@code worlds/rooms.xml} and push 40 crates, which the floor slows; each is told anew where to
 * go every two seconds. Prints steps of 50 ms a second. {@code -Dsteps=1000 -Drounds=5}.
 */
public final class Rooms {
    /** Seconds a step. */
    public static final double STEP = 0.05;

    private static final int ROBOTS = 100;
    private static final int CRATES = 40;
    private static final int COMMANDED = 40;

    public final Geometry world;
    public final Dynamics dynamics;
    private final List<String> robots = new ArrayList<>();
    private final SplittableRandom random = new SplittableRandom(7);
    private int steps;

    /** The scene at its beginning, half of whose robots are round. */
    public Rooms() throws Exception {
        this(false);
    }

    /** The same, or all robots are boxes and there are no crates. */
    Rooms(boolean areBoxes) throws Exception {
        world = new Geometry(40, 3.2, 30, Dimension.PLANAR, Accuracy.EXACT);
        for (WorldObject each : WorldReader.read(Path.of("worlds", "rooms.xml")).objects()) {
            if (!each.object().isMoveable()) {
                world.addObjectUnchecked(each.object());
            }
        }
        dynamics = new Dynamics(world, new Surface(0.2, 0.3, 0.2));
        Surface surface = new Surface(0.2, 0.3, 0.2);
        while (robots.size() < ROBOTS) {
            GeometryObject robot = add("robot" + robots.size(), !areBoxes && robots.size() % 2 == 0);
            if (robot != null) {
                robots.add(robot.name());
                dynamics.add(robot.name(), Body.ofMass(robot, 30).withSurface(surface));
            }
        }
        for (int crate = 0; !areBoxes && crate < CRATES; ) {
            GeometryObject box = add("crate" + crate, false);
            if (box != null) {
                dynamics.add(
                        box.name(), Body.ofMass(box, 10).withSurface(surface).withFloorFriction(0.3));
                crate++;
            }
        }
    }

    private GeometryObject add(String name, boolean isRound) {
        Point c = new Point(random.nextDouble(-19, 19), -1.3, random.nextDouble(-14, 14));
        GeometryObject object = isRound
                ? new CylinderObject(c, 0.2, 0.4).moveable(name)
                : new BoxObject(c, 0.45, 0.4, 0.35)
                        .turned(0, random.nextDouble(360))
                        .moveable(name);
        return world.addObject(object) ? object : null;
    }

    /** Makes a step. */
    public void step() {
        if (steps++ % COMMANDED == 0) {
            for (String robot : robots) {
                dynamics.drive(
                        robot,
                        new DifferentialDrive(0.3, 1.5, 3)
                                .driving(random.nextDouble(0.2, 1), random.nextDouble(-60, 60)));
            }
        }
        dynamics.advance(STEP);
    }

    /** Prints a line for each round. */
    public static void main(String[] args) throws Exception {
        int steps = Integer.getInteger("steps", 1000);
        for (int round = 0; round < Integer.getInteger("rounds", 5); round++) {
            Rooms rooms = new Rooms();
            int stopped = 0;
            long nanos = 0;
            for (int step = 0; step < steps; step++) {
                long start = System.nanoTime();
                rooms.step();
                nanos += System.nanoTime() - start;
                stopped += rooms.dynamics.last().stopped().size();
            }
            System.out.printf(
                    Locale.ROOT, "%d robots: %.0f steps/s; stopped %d%n", ROBOTS, steps / (nanos * 1e-9), stopped);
        }
    }
}
