package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.IntFunction;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Allocated;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.Snapshot;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;

/** What a robot asks in each step of a simulation leaves nothing for the garbage collector, on any JDK. */
@Tag("slow")
class AllocationTest {
    private static final int CALLS = Effort.cases(4000);
    private static final double SIDE = 200;

    private final SplittableRandom random = new SplittableRandom(41);

    @ParameterizedTest
    @EnumSource
    void stepsAllocateNothing(Dimension dimension) {
        Geometry geometry = new Geometry(SIDE, 20, SIDE, dimension, Accuracy.EXACT);
        for (int k = 0; k < 300; k++) {
            geometry.addObject(object(k));
        }
        for (String robot : ROBOTS) {
            GeometryObject round = new CylinderObject(new Point(), 0.5, 1);
            GeometryObject square = new BoxObject(new Point(), 1, 1, 0.8);
            GeometryObject person = new CapsuleObject(new Point(), 0.3, 0.4);
            GeometryObject body = robot.equals("round c") ? person : robot.startsWith("round") ? round : square;
            while (!geometry.addObject(body.moveable(robot).movedTo(place(5)))) {
                // until it has found room
            }
        }
        Ray[] rays = new Ray[64];
        for (int k = 0; k < rays.length; k++) {
            rays[k] = new Ray(place(5), new Point(coordinate(), dimension == Dimension.PLANAR ? 0 : 1, coordinate()));
        }
        GeometryObject[] bodies = new GeometryObject[64];
        for (int k = 0; k < bodies.length; k++) {
            bodies[k] = object(k % 8 == 7 ? 9 : k % 4).movedTo(place(5));
        }
        Ray mount = new Ray(new Point(0.3, 0.2, 0.1), new Point(1, 0.1, 0.5));
        Point mast = new Point(0.1, 0.4, 0);
        double[] distances = new double[19];

        assertAllocatesNothing("simpleMove", k -> geometry.simpleMove(robot(k), step(k), 0, 0) ? 1 : 0);
        assertAllocatesNothing("simpleTurn", k -> geometry.simpleTurn(robot(k), k % 7 * 23.4 - 60) ? 1 : 0);
        assertAllocatesNothing("overlap", k -> geometry.testObject(bodies[k * 7 & 63]) ? 1 : 0);
        assertAllocatesNothing("ray", k -> bounded(geometry.getRayDistance(rays[k & 63], 0, 100, 0)));
        assertAllocatesNothing("cone", k -> bounded(geometry.getRayDistance(rays[k & 63], 0, 100, 1 + k % 40)));
        assertAllocatesNothing("coarse", k -> bounded(geometry.getRayDistance(rays[k & 63], 0, 99, 0, Accuracy.OBB)));
        assertAllocatesNothing("ignoring", k -> bounded(geometry.getRayDistance(rays[k & 63], 0, 99, 9, robot(k))));
        assertAllocatesNothing(
                "sonar", k -> bounded(geometry.getSonarDistance(robot(k), 1, k % 9 - 4, 0.1, 50, k % 3 * 15)));
        assertAllocatesNothing(
                "mounted sonar", k -> bounded(geometry.getSonarDistance(robot(k), mount, 0.1, 50, k % 3 * 15)));
        assertAllocatesNothing("proximity", k -> bounded(geometry.getProximity(robot(k), 20)));
        assertAllocatesNothing("scan", k -> {
            geometry.scan(robot(k), -90.3, 10.1, 0, 50, distances);
            return bounded(distances[k % 19]);
        });
        assertAllocatesNothing("mounted scan", k -> {
            geometry.scan(robot(k), mast, k, 10, 0, 50, distances);
            return bounded(distances[k % 19]);
        });
        RayPattern fan = RayPattern.fan(-90, 10, 19);
        Pose top = Pose.of(mast, 20);
        SenseOptions rays19 = SenseOptions.range(0, 50);
        SenseOptions cones19 = rays19.withWidth(9);
        SenseBuffer all = new SenseBuffer(SenseBuffer.Extra.OBJECTS, SenseBuffer.Extra.NORMALS);
        SenseBuffer some = new SenseBuffer();
        Snapshot snapshot = geometry.snapshot();
        assertAllocatesNothing("pattern", k -> {
            geometry.sense(robot(k), top, fan, rays19, all);
            return bounded(all.distance(k % 19));
        });
        assertAllocatesNothing("pattern of cones", k -> {
            geometry.sense(robot(k), top, fan, cones19, some);
            return bounded(some.distance(k % 19));
        });
        assertAllocatesNothing("pattern in a snapshot", k -> {
            snapshot.sense(robot(k), top, fan, rays19, all);
            return bounded(all.distance(k % 19));
        });
        RayPattern turn = RayPattern.layers(new double[] {0, 5}, -90, 10, 19).withDuration(0.1);
        SenseOptions moving = rays19.withMotion(Twist.drive(1, 40));
        SenseBuffer parts = new SenseBuffer(SenseBuffer.Extra.PARTS);
        assertAllocatesNothing("pattern from a moving sensor", k -> {
            geometry.sense(robot(k), top, turn, moving, parts);
            return bounded(parts.distance(k % 19));
        });
        double[][] places = new double[64][8 * 5];
        for (double[] few : places) {
            for (int at = 0; at < few.length; at += 8) {
                Point from = place(5);
                double[] edge = {from.x(), from.y(), from.z(), at, from.x() + 3, from.y(), from.z() - 2, at + 40};
                System.arraycopy(edge, 0, few, at, 8);
            }
        }
        long[] free = new long[1];
        assertAllocatesNothing("poses", k -> geometry.freePoses(robot(k), places[k & 63], free));
        assertAllocatesNothing("poses in a snapshot", k -> snapshot.freePoses(robot(k), places[k & 63], free));
        assertAllocatesNothing("edges", k -> geometry.freeEdges(robot(k), places[k & 63], free));
        // They stand elsewhere now, and the world is asked again.
        assertAllocatesNothing("moves and sonars", k -> {
            String robot = robot(k);
            boolean moved = geometry.simpleMove(robot, step(k), 0, 0);
            boolean turned = geometry.simpleTurn(robot, moved ? 3.7 : 61.3);
            return (turned ? 1 : 0) + bounded(geometry.getSonarDistance(robot, 1, 0, 0, 30, 20));
        });
    }

    /** Of many groups alike the members are laid out once. */
    @ParameterizedTest
    @EnumSource
    void objectsAlikeAreLaidOutOnce(Dimension dimension) {
        List<GeometryObject> parts = new ArrayList<>();
        for (int k = 0; k < 10; k++) {
            parts.add(new BoxObject(new Point(0.1 * k, 0, 0), 0.1, 0.2, 0.1));
        }
        ObjectGroup group = new ObjectGroup(parts);
        long alike = added(dimension, k -> group);
        long apart = added(dimension, k -> new ObjectGroup(parts));
        assertThat(alike).isLessThan(apart * 3 / 4);
    }

    private static final List<String> ROBOTS =
            List.of("round a", "square a", "round b", "square b", "round c", "square c", "round d", "square d");

    /** Bytes that the addition of moveable objects takes. */
    private static long added(Dimension dimension, IntFunction<GeometryObject> shape) {
        List<GeometryObject> values = new ArrayList<>();
        for (int k = 0; k < 200; k++) {
            Point place = new Point(4 * (k % 20) - 40, 0, 4 * (k / 20) - 20);
            values.add(shape.apply(k).moveable("object " + k).movedTo(place));
        }
        return Allocated.everyTime(() -> {
            Geometry world = new Geometry(SIDE, 20, SIDE, dimension, Accuracy.EXACT);
            values.forEach(world::addObjectUnchecked);
        });
    }

    private static String robot(int k) {
        return ROBOTS.get(k & 7);
    }

    /** There and back for each of them, then further than there is room. */
    private static double step(int k) {
        return (k % 32 < 16 ? 0.3 : 250) * (k % 16 < 8 ? 1 : -1);
    }

    private static double bounded(double distance) {
        return Math.min(distance, 1000);
    }

    /** Less than a byte a call, and the calls answer a mix. */
    private static void assertAllocatesNothing(String call, IntToDoubleFunction ask) {
        assertThat(run(ask)).as(call).isGreaterThan(CALLS / 20);
        long bytes = Allocated.everyTime(() -> run(ask));
        assertThat(bytes / (double) CALLS).as(call).isLessThan(1);
    }

    /** How often an answer differed from the one before. */
    private static int run(IntToDoubleFunction ask) {
        int changes = 0;
        double last = Double.NaN;
        for (int k = 0; k < CALLS; k++) {
            double answer = ask.applyAsDouble(k);
            changes += answer == last ? 0 : 1;
            last = answer;
        }
        return changes;
    }

    private double coordinate() {
        return random.nextDouble(-0.45 * SIDE, 0.45 * SIDE);
    }

    private Point place(double height) {
        return new Point(coordinate(), -height, coordinate());
    }

    private GeometryObject object(int k) {
        double size = random.nextDouble(1, 5);
        GeometryObject object = switch (k % 6) {
            case 0 -> new BoxObject(new Point(), size, 6, 2);
            case 1 -> new BoxObject(new Point(), size, 6, 3).turned(0, random.nextDouble(-180, 180));
            case 2 -> new CylinderObject(new Point(), 0.5 * size, 6);
            case 3 ->
                k % 12 < 6
                        ? new SphereObject(new Point(), 0.5 * size)
                        : new CapsuleObject(new Point(), 0.25 * size, size).turned(k % 24 < 12 ? 0 : 50, 10);
            case 4 -> new BoxObject(new Point(), size, 2, 3).turned(random.nextDouble(-180, 180), 33.3);
            default -> k % 12 < 6 ? pyramid(size) : pair(size);
        };
        return object.movedTo(place(random.nextDouble(4, 6)));
    }

    private static GeometryObject pyramid(double size) {
        List<Point> corners = List.of(
                new Point(size, -2, 0.1), new Point(-size, -2, size), new Point(-0.9, -2, -size), new Point(0, 3, 0.2));
        return new MeshObject(corners, new int[][] {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    }

    private static GeometryObject pair(double size) {
        return new ObjectGroup(List.of(
                new BoxObject(new Point(1, 0, 0), size, 3, 1).turned(0, 20),
                new CylinderObject(new Point(-1, 0.5, 1), 1, size).turned(40, 10)));
    }
}
