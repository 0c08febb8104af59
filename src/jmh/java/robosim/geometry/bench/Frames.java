package robosim.geometry.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;

/** tmp. */
public final class Frames {
    private Frames() {}

    public static void main(String[] args) throws IOException {
        PeerInputs inputs = new PeerInputs(Path.of(System.getProperty("peers", "/work/peers")));
        for (String size : System.getProperty("sizes", "100,1000,10000,100000").split(",", -1)) {
            PeerInputs.Space space = inputs.space(Integer.parseInt(size));
            double world = 2 * space.side() + 40;
            Geometry geometry = new Geometry(world, world, world, Dimension.SPATIAL, Accuracy.EXACT);
            space.objects().forEach(geometry::addObjectUnchecked);
            Ray[] rays = space.frames();
            int frame = 320 * 240;
            RayPattern camera = RayPattern.pinhole(320, 240, 90);
            List<Pose> poses = new ArrayList<>();
            for (int f = 0; f < rays.length / frame; f++) {
                poses.add(pose(rays, f * frame));
            }
            SenseOptions options = SenseOptions.range(0, 100);
            SenseBuffer out = new SenseBuffer();
            long[] hits = new long[2];
            double[] sums = new double[2];
            LongSupplier together = () -> {
                hits[0] = 0;
                sums[0] = 0;
                for (Pose pose : poses) {
                    geometry.sense(pose, camera, options, out);
                    for (int k = 0; k < frame; k++) {
                        if (out.distances()[k] < Double.POSITIVE_INFINITY) {
                            hits[0]++;
                            sums[0] += out.distances()[k];
                        }
                    }
                }
                return hits[0];
            };
            LongSupplier single = () -> {
                hits[1] = 0;
                sums[1] = 0;
                for (Ray ray : rays) {
                    double d = geometry.getRayDistance(ray, 0, 100, 0);
                    if (d < Double.POSITIVE_INFINITY) {
                        hits[1]++;
                        sums[1] += d;
                    }
                }
                return hits[1];
            };
            boolean only = Boolean.getBoolean("only");
            double[][] nanos = only ? Timing.inTurn(10, Integer.getInteger("rounds", 10), together) : Timing.inTurn(3, 5, together, single);
            Timing.print("%s sense %.1f single %.1f  %d %.6f  %d %.6f  unsure %s",
                    size, least(nanos[0]) / rays.length, only ? 0 : least(nanos[1]) / rays.length,
                    hits[0], sums[0], hits[1], sums[1], robosim.geometry.exact.StageCounters.counts().get("PacketSearch"));
        }
    }

    private static double least(double[] v) {
        return java.util.Arrays.stream(v).min().getAsDouble();
    }

    private static Pose pose(Ray[] rays, int first) {
        // The middle of four pixels is ahead; X is right, Y is up.
        int at = first + 119 * 320 + 159;
        Point a = rays[at].direction();
        Point b = rays[at + 1].direction();
        Point c = rays[at + 320].direction();
        Point d = rays[at + 321].direction();
        double[] ahead = unit(a.x() + b.x() + c.x() + d.x(), a.y() + b.y() + c.y() + d.y(), a.z() + b.z() + c.z() + d.z());
        Point l = rays[first + 119 * 320].direction();
        Point r = rays[first + 119 * 320 + 319].direction();
        double[] right = unit(r.x() - l.x(), r.y() - l.y(), r.z() - l.z());
        double[] up = {
            right[1] * ahead[2] - right[2] * ahead[1],
            right[2] * ahead[0] - right[0] * ahead[2],
            right[0] * ahead[1] - right[1] * ahead[0]
        };
        double[] rotation = {ahead[0], up[0], right[0], ahead[1], up[1], right[1], ahead[2], up[2], right[2]};
        return Pose.of(rays[first].start(), 0).oriented(rotation);
    }

    private static double[] unit(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / length, y / length, z / length};
    }
}
