package robosim.geometry.bench;

import java.util.List;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/**
 * Time a ray and an overlap test take as static objects grow from 100 to 1,000,000 at constant density, with the time to
 * add them: what grows is the depth of the tree and what no longer fits the caches.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test -Dexec.mainClass=robosim.geometry.bench.Scaling}
 */
public final class Scaling {
    private static final int QUERIES = 20_000;
    private static final double RANGE = 100;

    private Scaling() {}

    /** Measures every size, PLANAR and EXACT. */
    public static void main(String[] args) {
        Timing.print("%9s %12s %12s %12s %14s %12s", "objects", "add ns", "ray ns", "hits", "overlap ns", "overlaps");
        for (int n = 100; n <= 1_000_000; n *= 10) {
            row(n);
        }
    }

    private static void row(int n) {
        Scene scene = new Scene(n, 2);
        List<GeometryObject> objects = scene.objects(n);
        double world = scene.side() + 20;
        Geometry geometry = new Geometry(world, 10, world, Dimension.PLANAR, Accuracy.EXACT);
        long start = System.nanoTime();
        objects.forEach(geometry::addObjectUnchecked);
        double added = (System.nanoTime() - start) / (double) n;
        Ray[] rays = new Ray[QUERIES];
        GeometryObject[] probes = new GeometryObject[QUERIES];
        for (int k = 0; k < QUERIES; k++) {
            double angle = scene.random().nextDouble(2 * Math.PI);
            rays[k] = new Ray(
                    new Point(scene.coordinate(), 0, scene.coordinate()),
                    new Point(StrictMath.cos(angle), 0, StrictMath.sin(angle)));
            probes[k] = new CylinderObject(new Point(scene.coordinate(), 0, scene.coordinate()), 0.5, 1);
        }
        double[][] nanos = Timing.inTurn(6, 15, () -> castAll(geometry, rays), () -> testAll(geometry, probes));
        Timing.print(
                "%9d %12.0f %12.0f %12d %14.0f %12d",
                n,
                added,
                Timing.median(nanos[0]) / QUERIES,
                castAll(geometry, rays),
                Timing.median(nanos[1]) / QUERIES,
                testAll(geometry, probes));
    }

    private static long castAll(Geometry geometry, Ray[] rays) {
        long hits = 0;
        for (Ray ray : rays) {
            hits += geometry.getRayDistance(ray, 0, RANGE, 0) <= RANGE ? 1 : 0;
        }
        return hits;
    }

    private static long testAll(Geometry geometry, GeometryObject[] probes) {
        long hits = 0;
        for (GeometryObject probe : probes) {
            hits += geometry.testObject(probe) ? 1 : 0;
        }
        return hits;
    }
}
