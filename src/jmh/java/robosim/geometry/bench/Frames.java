package robosim.geometry.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.LongSupplier;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.Snapshot;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;

/**
 * What it saves to ask the beams of a sensor together: nanoseconds a beam in one call and one by one, and their ratio. Depth
 * images, turns of a lidar of 16 layers, a laser's scan and a ring of 16 cones in the worlds of the folder {@code worlds}; with
 * {@code -Dpeers=FOLDER} also workload W6, whose frames {@link Peers} asks ray by ray. And a frame on one thread and on two.
 *
 * <p>{@code -Dworlds=warehouse,meshes}, {@code -Dsizes=100,1000}, {@code -Drounds=15} and {@code -Dclock=cpu} choose; the two
 * threads are always measured by the time that passes.
 */
public final class Frames {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 240;
    private static final int POSES = 6;
    private static final double RANGE = 100;
    private static final int ROUNDS = Integer.getInteger("rounds", 15);

    private Frames() {}

    /** Measures all. */
    public static void main(String[] args) throws IOException {
        for (String name : System.getProperty("worlds", "warehouse,meshes").split(",", -1)) {
            if (!name.isEmpty()) {
                world(name);
            }
        }
        String peers = System.getProperty("peers");
        if (peers != null) {
            for (String size :
                    System.getProperty("sizes", "100,1000,10000,100000").split(",", -1)) {
                frames(new PeerInputs(Path.of(peers)).space(Integer.parseInt(size)), size);
            }
        }
    }

    private static void world(String name) throws IOException {
        World world = WorldReader.read(Path.of("worlds", name + ".xml"));
        for (Dimension dimension : Dimension.values()) {
            Geometry geometry = new Geometry(world.width(), world.height(), world.length(), dimension, Accuracy.EXACT);
            for (WorldObject object : world.objects()) {
                if (!object.object().isMoveable()) {
                    geometry.addObjectUnchecked(object.object());
                }
            }
            List<Pose> poses = poses(world, geometry);
            String place = name + " " + dimension;
            SenseOptions rays = SenseOptions.range(0, RANGE);
            if (dimension == Dimension.SPATIAL) {
                double[] elevations = new double[16];
                for (int k = 0; k < elevations.length; k++) {
                    elevations[k] = 2 * k - 15;
                }
                RayPattern camera = RayPattern.pinhole(WIDTH, HEIGHT, 87);
                compare(place + " camera", geometry, poses, camera, rays, 1);
                compare(place + " lidar", geometry, poses, RayPattern.layers(elevations, 180, -0.2, 1800), rays, 1);
                threads(place + " camera", geometry.snapshot(), poses, camera, rays);
            }
            compare(place + " laser", geometry, poses, RayPattern.fan(-135, 0.25, 1081), rays, 20);
            SenseOptions sonars = SenseOptions.range(0, 20).withWidth(15);
            compare(place + " ring of cones", geometry, poses, RayPattern.fan(0, 22.5, 16), sonars, 300);
        }
    }

    /** Where a sensor is at the height of a person's hip, and free. */
    private static List<Pose> poses(World world, Geometry geometry) {
        SplittableRandom random = new SplittableRandom(5);
        List<Pose> poses = new ArrayList<>();
        while (poses.size() < POSES) {
            Point at = new Point(
                    random.nextDouble(-0.45, 0.45) * world.width(),
                    1.2 - world.height() / 2,
                    random.nextDouble(-0.45, 0.45) * world.length());
            if (!geometry.testObject(new SphereObject(at, 0.3))) {
                poses.add(Pose.of(at, random.nextDouble(-180, 180)));
            }
        }
        return poses;
    }

    private static void frames(PeerInputs.Space space, String size) {
        double side = 2 * space.side() + 40;
        Geometry geometry = new Geometry(side, side, side, Dimension.SPATIAL, Accuracy.EXACT);
        space.objects().forEach(geometry::addObjectUnchecked);
        List<Pose> poses = new ArrayList<>();
        for (int first = 0; first < space.frames().length; first += WIDTH * HEIGHT) {
            poses.add(pose(space.frames(), first));
        }
        RayPattern camera = RayPattern.pinhole(WIDTH, HEIGHT, 90);
        compare("W6 " + size, geometry, poses, camera, SenseOptions.range(0, RANGE), 1);
    }

    /** The pose of a camera whose rays come one by one, as its middle and its rows tell. */
    private static Pose pose(Ray[] rays, int first) {
        int row = first + (HEIGHT / 2 - 1) * WIDTH;
        int middle = row + WIDTH / 2 - 1;
        double[] ahead = unit(sum(rays[middle].direction(), rays[middle + WIDTH + 1].direction(), 1));
        double[] right = unit(sum(rays[row + WIDTH - 1].direction(), rays[row].direction(), -1));
        double[] r = new double[9];
        for (int k = 0; k < 3; k++) {
            int l = (k + 1) % 3;
            int m = (k + 2) % 3;
            r[3 * k] = ahead[k];
            r[3 * k + 1] = right[l] * ahead[m] - right[m] * ahead[l];
            r[3 * k + 2] = right[k];
        }
        return Pose.of(rays[first].start(), 0).oriented(r);
    }

    private static double[] sum(Point a, Point b, double sign) {
        return new double[] {a.x() + sign * b.x(), a.y() + sign * b.y(), a.z() + sign * b.z()};
    }

    private static double[] unit(double[] v) {
        double length = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        return new double[] {v[0] / length, v[1] / length, v[2] / length};
    }

    private static Ray beam(Pose pose, RayPattern pattern, int k) {
        Point d = pattern.direction(k);
        double[] r = pose.rotation();
        return new Ray(
                pose.center(),
                new Point(
                        r[0] * d.x() + r[1] * d.y() + r[2] * d.z(),
                        r[3] * d.x() + r[4] * d.y() + r[5] * d.z(),
                        r[6] * d.x() + r[7] * d.y() + r[8] * d.z()));
    }

    private static void compare(
            String what, Geometry geometry, List<Pose> poses, RayPattern pattern, SenseOptions options, int times) {
        int beams = pattern.size();
        Ray[][] rays = new Ray[poses.size()][beams];
        for (int p = 0; p < rays.length; p++) {
            for (int k = 0; k < beams; k++) {
                rays[p][k] = beam(poses.get(p), pattern, k);
            }
        }
        SenseBuffer out = new SenseBuffer();
        double[][] answers = new double[poses.size()][beams];
        long[] hits = new long[1];
        double[] sum = new double[1];
        LongSupplier together = () -> {
            hits[0] = 0;
            sum[0] = 0;
            for (int time = 0; time < times; time++) {
                for (int p = 0; p < rays.length; p++) {
                    geometry.sense(poses.get(p), pattern, options, out);
                    for (int k = 0; k < beams; k++) {
                        double distance = out.distances()[k];
                        if (distance < Double.POSITIVE_INFINITY) {
                            hits[0]++;
                            sum[0] += distance;
                        }
                    }
                }
            }
            return hits[0];
        };
        LongSupplier single = () -> {
            for (int time = 0; time < times; time++) {
                for (int p = 0; p < rays.length; p++) {
                    for (int k = 0; k < beams; k++) {
                        answers[p][k] =
                                geometry.getRayDistance(rays[p][k], options.min(), options.max(), options.width());
                    }
                }
            }
            return beams;
        };
        double[][] nanos = Timing.inTurn(ROUNDS, ROUNDS, together, single);
        for (int p = 0; p < rays.length; p++) {
            geometry.sense(poses.get(p), pattern, options, out);
            for (int k = 0; k < beams; k++) {
                if (out.distances()[k] != answers[p][k]) {
                    throw new IllegalStateException("must be the same: " + rays[p][k]);
                }
            }
        }
        double asked = (double) times * poses.size() * beams;
        Timing.print(
                "%-40s %8.1f ns a beam together, %8.1f one by one, ratio %.3f (%d hits, sum %.6f)",
                what,
                Timing.median(nanos[0]) / asked,
                Timing.median(nanos[1]) / asked,
                1 / Timing.ratio(nanos[1], nanos[0]),
                hits[0] / times,
                sum[0] / times);
    }

    private static void threads(
            String what, Snapshot snapshot, List<Pose> poses, RayPattern pattern, SenseOptions options) {
        SenseBuffer out = new SenseBuffer();
        double[][] nanos = new double[2][ROUNDS];
        for (int round = -ROUNDS; round < ROUNDS; round++) {
            for (int task = 0; task < 2; task++) {
                SenseOptions on = options.withThreads(1 + task);
                long start = System.nanoTime();
                for (Pose pose : poses) {
                    snapshot.sense(pose, pattern, on, out);
                }
                if (round >= 0) {
                    nanos[task][round] = System.nanoTime() - start;
                }
            }
        }
        Timing.print("%-40s %.2f times as fast on two threads as on one", what, Timing.ratio(nanos[0], nanos[1]));
    }
}
