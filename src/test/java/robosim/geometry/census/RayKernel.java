package robosim.geometry.census;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.RayOracle;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.ray.SpatialRay;
import robosim.geometry.proof.Witnesses;

/** A ray against each convex shape in space, beside the decimals of {@link RayOracle}: the verdict, and four ulp of the distance. */
final class RayKernel implements Kernel {
    private static final String INSIDE = "starts inside";
    private static final String MISSES = "misses";

    /** Nearer than this share of the size to an edge, a rim or a tangent is at it. */
    private static final double AT = 1e-7;

    private final Scratch scratch = new Scratch();
    private Body body = Body.sphere(new double[3], 0);
    private double[] start = {};
    private double[] way = {};
    private double answer;

    @Override
    public String name() {
        return "ray in space, every shape";
    }

    @Override
    public double effort() {
        return 1.6;
    }

    @Override
    public List<String> regimes() {
        return List.of(
                "box, face",
                "box, edge or corner",
                "cylinder, cap",
                "cylinder, mantle",
                "cylinder, rim or tangent",
                "triangle, face",
                "triangle, edge or corner",
                "sphere, side",
                "sphere, tangent",
                "capsule, end",
                "capsule, side",
                "capsule, tangent",
                "box, misses by little",
                "cylinder, misses by little",
                "triangle, misses by little",
                "sphere, misses by little",
                "capsule, misses by little",
                INSIDE,
                MISSES);
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        SpacePairs pairs = new SpacePairs(random, adversarial);
        // A cylinder has more regimes than the others.
        Body.Type type = random.nextInt(12) == 0 ? Body.Type.CYLINDER : Body.Type.values()[random.nextInt(5)];
        double[] n = Vec.direction(random);
        int state = random.nextInt(32);
        // Faces, then edges and corners, then what passes by; a sphere has no edges. Of a cylinder mantles are the
        // second.
        int faces = type == Body.Type.TRIANGLE ? 4 : 7;
        int aimed = type == Body.Type.SPHERE ? 8 : type == Body.Type.CYLINDER ? 17 : 14;
        int feature = state >= faces ? random.nextInt(3) : type == Body.Type.CYLINDER ? 1 + random.nextInt(2) : 2;
        if (type == Body.Type.CAPSULE) {
            feature = random.nextInt(2); // its side is met where that is in front only
            aimed = 10;
        }
        Body body = pairs.showing(type, feature, n);
        double[] place = Vec.plus(
                new double[3], adversarial ? 1000 * random.nextDouble() : random.nextDouble(), Vec.direction(random));
        body = body.movedBy(place);
        double[] target = body.furthest(n, random);
        double[] back = Vec.direction(random);
        if (Vec.dot(back, n) < 0) {
            back = Vec.plus(new double[3], -1, back);
        }
        if (state < aimed) {
            target = body.project(
                    Vec.plus(target, StrictMath.pow(10, random.nextDouble(-17, -8)), Vec.minus(middle(body), target)));
        } else if (state < 27) {
            back = Vec.unit(Vec.squareTo(n, back));
            double off = StrictMath.pow(10, random.nextDouble(adversarial ? -16 : -9, -7)) * body.size();
            target = Vec.plus(target, random.nextInt(5) < 2 ? -off : off, n);
        } else if (state > 29) {
            target = Vec.plus(target, random.nextDouble(0.1, 3), Vec.direction(random));
        }
        double away = adversarial ? StrictMath.pow(10, random.nextDouble(-3, 3)) : random.nextDouble(1, 10);
        double[] start = Vec.plus(target, away, back);
        if (state >= 27 && state < 30) {
            start = body.project(Vec.plus(body.c, 0.5 * random.nextDouble() * body.size(), Vec.direction(random)));
        }
        double[] way = Vec.plus(new double[3], -Math.scalb(random.nextDouble(1, 2), random.nextInt(-3, 4)), back);
        return compare(body, start, way);
    }

    private static double[] middle(Body body) {
        return body.type == Body.Type.TRIANGLE
                ? Vec.plus(
                        Vec.plus(new double[3], 0.5, body.corners[0]),
                        0.25,
                        Vec.plus(body.corners[1], 1, body.corners[2]))
                : body.c;
    }

    @Override
    public @Nullable String proof(Witnesses witnesses) {
        return witnesses.ray(start, way, Witnesses.object(body.kind, body.row), Dimension.SPATIAL, answer);
    }

    private Visit compare(Body body, double[] start, double[] way) {
        this.body = body;
        this.start = start;
        this.way = way;
        answer = SpatialRay.distance(
                new BeamAxis().line(start[0], start[1], start[2], way[0], way[1], way[2]),
                body.kind,
                body.row,
                0,
                scratch.ray);
        BigDecimal truth = RayOracle.distance(start, way, body.kind, body.row);
        String regime = regime(body, start, way, truth);
        if ((truth == null) != (answer == Double.POSITIVE_INFINITY)) {
            return Visit.wrong(regime, "%s, not %s: %s".formatted(answer, truth, paste(body, start, way)));
        }
        if (truth == null) {
            return Visit.right(regime);
        }
        double largest = Math.max(answer, largest(start));
        for (int k = 0; k < (body.type == Body.Type.TRIANGLE ? 9 : 6); k++) {
            largest = Math.max(largest, Math.abs(body.row[k]));
        }
        double late = new BigDecimal(answer).subtract(truth).doubleValue() / (4 * Math.ulp(largest));
        return Visit.number(
                regime,
                Math.max(0, -late),
                Math.max(0, late),
                0,
                () -> "%s, not %s: %s".formatted(answer, truth, paste(body, start, way)));
    }

    private static double largest(double[] p) {
        return Math.max(Math.abs(p[0]), Math.max(Math.abs(p[1]), Math.abs(p[2])));
    }

    private static String paste(Body body, double[] start, double[] way) {
        return body + " from " + Arrays.toString(start) + " along " + Arrays.toString(way);
    }

    private static String regime(Body body, double[] start, double[] way, BigDecimal truth) {
        String shape = body.type.name().toLowerCase(Locale.ROOT);
        if (truth == null) {
            return nearest(body, start, way) < 10 * AT * body.size() ? shape + ", misses by little" : MISSES;
        }
        if (truth.signum() == 0) {
            return INSIDE;
        }
        double[] ahead = Vec.unit(way);
        double[] p = Vec.plus(start, truth.doubleValue(), ahead);
        double[] w = Vec.minus(p, body.c);
        double at = AT * body.size();
        return shape
                + switch (body.type) {
                    case BOX -> sides(body, w, at) > 1 ? ", edge or corner" : ", face";
                    case CYLINDER -> ", " + part(body, w, ahead, at);
                    case TRIANGLE -> isAtEdge(body, p, at) ? ", edge or corner" : ", face";
                    case CAPSULE -> ", " + round(body, w, ahead, at);
                    case SPHERE -> Vec.length(Vec.cross(w, ahead)) > body.row[3] - at ? ", tangent" : ", side";
                };
    }

    private static int sides(Body box, double[] w, double at) {
        int sides = 0;
        for (int k = 0; k < 3; k++) {
            sides += Math.abs(Vec.dot(w, box.axes[k])) > box.row[3 + k] - at ? 1 : 0;
        }
        return sides;
    }

    private static String part(Body cylinder, double[] w, double[] ahead, double at) {
        double[] axis = cylinder.axes[1];
        double along = Vec.dot(w, axis);
        double[] aside = Vec.plus(w, -along, axis);
        boolean round = Vec.length(aside) > cylinder.row[3] - at;
        if (Math.abs(along) > cylinder.row[4] - at) {
            return round ? "rim or tangent" : "cap";
        }
        double[] level = Vec.plus(ahead, -Vec.dot(ahead, axis), axis);
        double slope = Math.abs(Vec.dot(level, aside)) / (Vec.length(level) * Vec.length(aside));
        return slope < 1e-3 ? "rim or tangent" : "mantle";
    }

    private static String round(Body capsule, double[] w, double[] ahead, double at) {
        double[] axis = capsule.axes[1];
        double along = Vec.dot(w, axis);
        boolean isEnd = Math.abs(along) > capsule.row[4];
        double[] out = Vec.plus(w, -(isEnd ? Math.copySign(capsule.row[4], along) : along), axis);
        double level = Vec.length(Vec.cross(out, ahead));
        return level > capsule.row[3] - at ? "tangent" : isEnd ? "end" : "side";
    }

    private static boolean isAtEdge(Body triangle, double[] p, double at) {
        for (double[] edge : triangle.edges) {
            double[] along = {edge[3], edge[4], edge[5]};
            double[] w = Vec.minus(p, new double[] {edge[0], edge[1], edge[2]});
            if (Vec.length(Vec.cross(w, along)) < at * Vec.length(along)) {
                return true;
            }
        }
        return false;
    }

    /** How near the ray comes, by halving where the distance falls. */
    private static double nearest(Body body, double[] start, double[] way) {
        double from = 0;
        double to = 2 * (Vec.length(Vec.minus(body.c, start)) + 2 * body.size()) / Vec.length(way);
        for (int k = 0; k < 60; k++) {
            double middle = 0.5 * (from + to);
            if (Vec.dot(body.outward(Vec.plus(start, middle, way)), way) < 0) {
                from = middle;
            } else {
                to = middle;
            }
        }
        double[] p = Vec.plus(start, from, way);
        return Vec.length(Vec.minus(p, body.project(p)));
    }
}
