package robosim.geometry.bench.dynamics;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.dyn4j.collision.AxisAlignedBounds;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.World;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.OmnidirectionalDrive;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/**
 * CPU time of single ticks in the planar scenes of robot simulators: mean, 99th percentile and worst, and those of dyn4j at its
 * defaults where it has the same scene, in turns in one JVM. {@code -Dscene=field -Dticks=500 -Drounds=3 -Dalone}.
 */
public final class Ticks {
    private static final Surface BALL = new Surface(0.3, 0.3, 0.2);

    /** A scene that goes on by a tick. */
    private interface Ticking {
        void tick();

        default int stopped() {
            return 0;
        }
    }

    private Ticks() {}

    /** Runs the scenes and prints a line for each round. */
    public static void main(String[] args) throws Exception {
        String only = System.getProperty("scene", "");
        int rounds = Integer.getInteger("rounds", 3);
        int ticks = Integer.getInteger("ticks", 500);
        for (int round = 0; round < rounds; round++) {
            run(only, "field", ticks, () -> new Pushed(true));
            run(only, "field dyn4j", ticks, () -> new PushedThere(new Pushed(true)));
            run(only, "hook", ticks, () -> new Pushed(false));
            run(only, "hook dyn4j", ticks, () -> new PushedThere(new Pushed(false)));
            run(only, "rooms", ticks, Ticks::rooms);
            run(only, "discs", ticks, Ticks::discs);
            run(only, "fast 445", 20, () -> fast(11, 445, 0.05));
            run(only, "fast 1062", 20, () -> fast(13, 1062, 1e-3));
        }
    }

    private static void run(String only, String name, int ticks, Supplier<Ticking> scene) {
        if (!name.startsWith(only) || (Boolean.getBoolean("alone") && name.endsWith("dyn4j"))) {
            return;
        }
        Ticking ticking = scene.get();
        ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        double[] took = new double[ticks];
        int stopped = 0;
        for (int k = 0; k < ticks; k++) {
            long start = thread.getCurrentThreadCpuTime();
            ticking.tick();
            took[k] = (thread.getCurrentThreadCpuTime() - start) * 1e-6;
            stopped += ticking.stopped();
        }
        double mean = Arrays.stream(took).sum() / ticks;
        Arrays.sort(took);
        System.out.printf(
                Locale.ROOT,
                "%-12s mean %8.3f ms, median %8.3f, p99 %8.3f, worst %8.3f, stopped %d%n",
                name,
                mean,
                took[ticks / 2],
                took[ticks * 99 / 100],
                took[ticks - 1],
                stopped);
    }

    /** A robot on a field of 16.5 by 8 m that drives into 400 balls, or one shaped like a U that turns over six. */
    private static final class Pushed implements Ticking {
        /** Where the robot on the field drives to in turns: through the balls, into corners and along walls. */
        private static final double[][] TARGETS = {
            {0, 0}, {7.7, 3.4}, {7.7, -3.4}, {0, -3.4}, {-2, 2}, {3, 3.5}, {-7.7, 3.5}
        };

        final boolean isField;
        final List<GeometryObject> balls = new ArrayList<>();
        final GeometryObject robot;
        final Geometry world;
        final Dynamics dynamics;
        final double[] size;
        private int ticks;
        private int stopped;

        Pushed(boolean isField) {
            this.isField = isField;
            size = isField ? new double[] {16.5, 8} : new double[] {1.4, 1.4};
            world = new Geometry(size[0], 3, size[1], Dimension.PLANAR, Accuracy.EXACT);
            dynamics = new Dynamics(world, BALL);
            robot = (isField ? new BoxObject(new Point(-5, 0, 0), 0.9, 0.5, 0.9) : hook()).moveable("robot");
            world.addObject(robot);
            dynamics.add("robot", Body.of(50, 6.75).withSurface(new Surface(0.1, 0.3, 0.3)));
            SplittableRandom random = new SplittableRandom(5);
            for (int k = 0; k < 400 && isField; k++) {
                ball(0.16 * (k % 20 - 9.5) + random.nextDouble(0.005), 0.16 * (k / 20 - 9.5));
            }
            while (!isField && balls.size() < 6) {
                ball(random.nextDouble(-0.6, 0.6), random.nextDouble(-0.6, 0.6));
            }
        }

        private static GeometryObject hook() {
            return new ObjectGroup(List.of(
                    new BoxObject(new Point(-0.4, 0, 0), 0.1, 0.5, 0.9),
                    new BoxObject(new Point(0.05, 0, -0.4), 0.8, 0.5, 0.1),
                    new BoxObject(new Point(0.05, 0, 0.4), 0.8, 0.5, 0.1)));
        }

        private void ball(double x, double z) {
            GeometryObject ball = new CylinderObject(new Point(x, 0, z), 0.075, 0.15).moveable("ball" + balls.size());
            if (world.addObject(ball)) {
                balls.add(ball);
                dynamics.add(
                        ball.name(), Body.ofMass(ball, 0.2).withSurface(BALL).withDamping(0.5, 0.5));
            }
        }

        /** The velocity along the world's axes and of turning, degrees a second, that the robot at a place is to have. */
        double[] command(int tick, double x, double z) {
            if (!isField) {
                return new double[] {0, 0, tick / 100 % 2 == 0 ? 180 : -180};
            }
            double[] target = TARGETS[tick / 60 % TARGETS.length];
            double dx = target[0] - x;
            double dz = target[1] - z;
            double by = 4 / Math.max(0.2, Math.sqrt(dx * dx + dz * dz));
            return new double[] {by * dx, by * dz, tick / 50 % 2 == 0 ? 90 : -90};
        }

        @Override
        public void tick() {
            stopped = 0;
            for (int part = 0; part < (isField ? 5 : 1); part++) {
                Point at = world.getObject("robot").center();
                double[] v = command(ticks, at.x(), at.z());
                double[] r = world.getObject("robot").rotation();
                dynamics.drive(
                        "robot",
                        new OmnidirectionalDrive(5, 8, 360, 1500)
                                .driving(r[0] * v[0] + r[6] * v[1], r[2] * v[0] + r[8] * v[1], v[2]));
                dynamics.advance(isField ? 0.004 : 0.02);
                stopped += dynamics.last().stopped().size();
            }
            ticks++;
        }

        @Override
        public int stopped() {
            return stopped;
        }
    }

    /** The same by dyn4j, whose y is minus z. */
    private static final class PushedThere implements Ticking {
        private final Pushed scene;
        private final World<org.dyn4j.dynamics.Body> there = new World<>();
        private final org.dyn4j.dynamics.Body robot = new org.dyn4j.dynamics.Body();
        private int ticks;

        PushedThere(Pushed scene) {
            this.scene = scene;
            there.setGravity(World.ZERO_GRAVITY);
            there.setBounds(new AxisAlignedBounds(40, 40));
            for (GeometryObject each : scene.balls) {
                org.dyn4j.dynamics.Body ball = new org.dyn4j.dynamics.Body();
                surface(ball, each, BALL);
                ball.translate(each.center().x(), -each.center().z());
                ball.setLinearDamping(0.5);
                ball.setAngularDamping(0.5);
                there.addBody(ball);
            }
            if (scene.robot instanceof ObjectGroup group) {
                group.parts().forEach(part -> surface(robot, part, new Surface(0.1, 0.3, 0.3)));
            } else {
                surface(robot, scene.robot.movedTo(new Point()), new Surface(0.1, 0.3, 0.3));
                robot.translate(-5, 0);
            }
            robot.setAtRestDetectionEnabled(false);
            there.addBody(robot);
            for (int side = -1; side <= 1; side += 2) {
                there.addBody(wall(new Point(side * 0.5 * (scene.size[0] + 1), 0, 0), 1, scene.size[1] + 2));
                there.addBody(wall(new Point(0, 0, side * 0.5 * (scene.size[1] + 1)), scene.size[0] + 2, 1));
            }
        }

        private static org.dyn4j.dynamics.Body wall(Point at, double width, double length) {
            org.dyn4j.dynamics.Body wall = Crowd.body(new BoxObject(at, width, 1, length));
            wall.setMass(MassType.INFINITE);
            return wall;
        }

        private static void surface(org.dyn4j.dynamics.Body body, GeometryObject shape, Surface surface) {
            var fixture = body.addFixture(
                    shape instanceof CylinderObject disc
                            ? org.dyn4j.geometry.Geometry.createCircle(disc.radius())
                            : org.dyn4j.geometry.Geometry.createRectangle(
                                    ((BoxObject) shape).width(), ((BoxObject) shape).length()));
            if (shape instanceof BoxObject box) {
                fixture.getShape().translate(box.center().x(), -box.center().z());
                fixture.setDensity(50 / 0.81);
            } else {
                fixture.setDensity(0.2 / (Math.PI * 0.075 * 0.075));
            }
            fixture.setFriction(surface.slidingFriction());
            fixture.setRestitution(surface.restitution());
            body.setMass(MassType.NORMAL);
        }

        @Override
        public void tick() {
            for (int part = 0; part < (scene.isField ? 5 : 1); part++) {
                Vector2 at = robot.getWorldCenter();
                double[] v = scene.command(ticks, at.x, -at.y);
                Vector2 now = robot.getLinearVelocity();
                Vector2 by = new Vector2(v[0] - now.x, -v[1] - now.y);
                double most = 8 * (scene.isField ? 0.004 : 0.02);
                if (by.getMagnitude() > most) {
                    by.setMagnitude(most);
                }
                robot.setLinearVelocity(now.x + by.x, now.y + by.y);
                robot.setAngularVelocity(Math.toRadians(v[2]));
                there.step(1, scene.isField ? 0.004 : 0.02);
            }
            ticks++;
        }
    }

    private static Ticking rooms() {
        try {
            Rooms rooms = new Rooms(true);
            return new Ticking() {
                @Override
                public void tick() {
                    rooms.step();
                }

                @Override
                public int stopped() {
                    return rooms.dynamics.last().stopped().size();
                }
            };
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    /** 1,000 elastic discs that cover a fifth of a room. */
    private static Ticking discs() {
        double side = Math.sqrt(1000 * Math.PI * 0.0625 / 0.2);
        Surface elastic = new Surface(1, 0, 0);
        return new Free(1000, side, 5, 1 / 60.0, elastic, 0.25, true);
    }

    /** Bodies of all shapes in a small room. */
    private static Ticking fast(int count, double speed, double seconds) {
        return new Free(count, 4, speed, seconds, new Surface(0.5, 0.5, 0.4), 0.6, false);
    }

    private static final class Free implements Ticking {
        private final Geometry world;
        private final Dynamics dynamics;
        private final List<String> names = new ArrayList<>();
        private final SplittableRandom random = new SplittableRandom(3);
        private final double seconds;
        private final double speed;
        private final boolean areElastic;
        private int ticks;

        Free(int count, double side, double speed, double seconds, Surface surface, double size, boolean areElastic) {
            this.seconds = seconds;
            this.speed = speed;
            this.areElastic = areElastic;
            world = new Geometry(side, 3, side, Dimension.PLANAR, Accuracy.EXACT);
            dynamics = new Dynamics(world, surface);
            while (names.size() < count) {
                String name = "b" + names.size();
                Point c = new Point(random.nextDouble(-side / 2, side / 2), 0, random.nextDouble(-side / 2, side / 2));
                GeometryObject body = areElastic || names.size() % 3 == 0
                        ? new CylinderObject(c, areElastic ? size : size / 2, 1).moveable(name)
                        : new BoxObject(c, size * random.nextDouble(0.5, 2), 1, size * random.nextDouble(0.1, 1))
                                .turned(0, random.nextDouble(360))
                                .moveable(name);
                if (world.addObject(body)) {
                    names.add(name);
                    dynamics.add(name, Body.ofMass(body, 1).withSurface(surface));
                }
            }
        }

        @Override
        public void tick() {
            if (ticks == 0 || !areElastic && ticks % 5 == 0) {
                for (String name : names) {
                    double turn = areElastic ? 0 : random.nextDouble(-3600, 3600);
                    dynamics.setVelocity(
                            name,
                            new Twist(random.nextDouble(-speed, speed), 0, random.nextDouble(-speed, speed), turn));
                }
            }
            ticks++;
            dynamics.advance(seconds);
        }

        @Override
        public int stopped() {
            return dynamics.last().stopped().size();
        }
    }
}
