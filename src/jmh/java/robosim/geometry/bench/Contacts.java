package robosim.geometry.bench;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.collision.Verdict;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;

/**
 * Time to find all contact triangles, the first, and the verdict alone, of two meshes of 4,000 triangles each that
 * overlap a little, touch deeply or are apart; then the bracket of the distance after 10, 100, 1,000 and 10,000 steps.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test -Dexec.mainClass=robosim.geometry.bench.Contacts}
 */
public final class Contacts {
    private static final int ROUND = 40;
    private static final int ALONG = 50;
    private static final long[] STEPS = {10, 100, 1_000, 10_000};

    private Contacts() {}

    /** Measures each pair. */
    public static void main(String[] args) {
        MeshObject ball = torus(0, 1);
        MeshObject ring = torus(1, 0.35);
        Timing.print("%-24s %8s %12s %12s %12s", "pair", "contacts", "all us", "first us", "verdict us");
        times("balls, overlap 0.02", ball, ball.turned(20, 30).movedTo(new Point(1.9, 0.3, 0.5)));
        times("balls, overlap 0.5", ball, ball.turned(20, 30).movedTo(new Point(1.45, 0.2, 0.3)));
        times("rings, overlap 0.02", ring, ring.turned(20, 30).movedTo(new Point(2.6, 0.05, 0.1)));
        times("rings, linked, touching", ring, ring.turned(90, 10).movedTo(new Point(1.3, 0.1, 0)));
        times("rings, linked, apart", ring, ring.turned(90, 10).movedTo(new Point(1, 0.05, 0)));
        times("balls, 0.02 apart", ball, ball.turned(20, 30).movedTo(new Point(1.93, 0.3, 0.5)));
        Timing.print("%n%-24s %8s %10s %12s %12s %12s %10s", "pair", "steps", "answer", "low", "high", "width", "us");
        brackets("rings, linked, apart", ring, ring.turned(90, 10).movedTo(new Point(1, 0.05, 0)));
        brackets("balls, 0.02 apart", ball, ball.turned(20, 30).movedTo(new Point(1.93, 0.3, 0.5)));
        brackets("balls, overlap 0.02", ball, ball.turned(20, 30).movedTo(new Point(1.9, 0.3, 0.5)));
    }

    private static void times(String name, GeometryObject a, GeometryObject b) {
        int contacts = ContactQuery.contacts(a, b).size();
        double[][] nanos = Timing.inTurn(
                60,
                60,
                () -> ContactQuery.contacts(a, b).size(),
                () -> ContactQuery.first(a, b) == null ? 0 : 1,
                () -> CollisionDetection.intersects(a, b) ? 1 : 0);
        Timing.print(
                "%-24s %8d %12.1f %12.1f %12.1f",
                name,
                contacts,
                Timing.median(nanos[0]) / 1e3,
                Timing.median(nanos[1]) / 1e3,
                Timing.median(nanos[2]) / 1e3);
    }

    private static void brackets(String name, GeometryObject a, GeometryObject b) {
        for (long steps : STEPS) {
            row(name, a, b, Budget.steps(steps));
        }
        row(name, a, b, Budget.UNLIMITED);
    }

    private static void row(String name, GeometryObject a, GeometryObject b, Budget budget) {
        Verdict verdict = ContactQuery.distance(a, b, budget);
        double[][] nanos =
                Timing.inTurn(30, 30, () -> ContactQuery.distance(a, b, budget).steps());
        Timing.print(
                "%-24s %8d %10s %12.6g %12.6g %12.3g %10.1f",
                name,
                verdict.steps(),
                verdict.answer(),
                verdict.low(),
                verdict.high(),
                verdict.high() - verdict.low(),
                Timing.median(nanos[0]) / 1e3);
    }

    /** A tube around a circle; around a circle without a radius it is a ball. */
    private static MeshObject torus(double radius, double tube) {
        List<Point> vertices = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        for (int i = 0; i < ALONG; i++) {
            for (int j = 0; j < ROUND; j++) {
                double around = 2 * Math.PI * i / ALONG;
                double across = radius > 0 ? 2 * Math.PI * j / ROUND : Math.PI * (j / (ROUND - 1.0) - 0.5);
                double out = radius + tube * StrictMath.cos(across);
                vertices.add(new Point(
                        out * StrictMath.cos(around), tube * StrictMath.sin(across), out * StrictMath.sin(around)));
                int right = (i + 1) % ALONG * ROUND;
                int up = (j + 1) % ROUND;
                if (radius > 0 || up > 0) {
                    faces.add(new int[] {i * ROUND + j, i * ROUND + up, right + up});
                    faces.add(new int[] {i * ROUND + j, right + up, right + j});
                }
            }
        }
        return new MeshObject(vertices, faces.toArray(new int[0][]));
    }
}
