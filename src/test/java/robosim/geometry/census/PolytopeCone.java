package robosim.geometry.census;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.Rotations;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.Twofold;
import robosim.geometry.reference.Twofold.Vector;

/** How far a cone in space hears a box, a triangle or a mesh. */
final class PolytopeCone implements Kernel {
    /** What is asked about. */
    enum Shape {
        BOX,
        TRIANGLE,
        MESH
    }

    /** In ulp of the largest coordinate or of the distance. */
    private static final double ULPS = 8;

    /** So near to its verdict's change, as a share of the half angle, a cone grazes. */
    private static final double GRAZING = 1e-7;

    private static final int[][] BOX_FACES = {
        {0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}
    };
    private static final int[][] MESH_FACES = {
        {0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}
    };

    private final Shape shape;
    private ConeQuestion q = new ConeQuestion(LeafKind.BOX);
    private double[][] mesh = new double[6][3];
    private double degrees;
    private boolean isAimed;

    PolytopeCone(Shape shape) {
        this.shape = shape;
    }

    @Override
    public String name() {
        return "cone, " + shape.name().toLowerCase(Locale.ROOT) + ", spatial";
    }

    @Override
    public List<String> regimes() {
        List<String> regimes = new ArrayList<>(List.of(
                "corner",
                "foot on an edge",
                "border and edge",
                "foot on a face",
                "border and face",
                "silent",
                "grazing"));
        if (shape == Shape.BOX) {
            regimes.add("apex inside");
        }
        return regimes;
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        make(random, adversarial);
        double answer = answer();
        if (shape == Shape.BOX && isInside()) {
            return answer == 0 ? Visit.right("apex inside") : Visit.wrong("apex inside", paste(answer, 0));
        }
        PolytopeConeTwin twin = twin(0);
        double truth = twin.distance();
        boolean isHeard = truth < Double.POSITIVE_INFINITY;
        boolean isGrazing = isAimed && isHeard(GRAZING) != isHeard(-GRAZING);
        String regime = isGrazing ? "grazing" : regime(twin.feature);
        if (answer < Double.POSITIVE_INFINITY != isHeard) {
            return Visit.wrong(regime, paste(answer, truth));
        }
        if (!isHeard) {
            return Visit.right(regime);
        }
        double off = twin.least.minus(Twofold.of(answer)).head();
        double unit = ULPS * Math.ulp(Math.max(truth, extent()));
        return Visit.number(regime, Math.max(0, off) / unit, Math.max(0, -off) / unit, 0, () -> paste(answer, truth));
    }

    private static String regime(PolytopeConeTwin.Feature feature) {
        return switch (feature) {
            case CORNER -> "corner";
            case EDGE_FOOT -> "foot on an edge";
            case EDGE_BORDER -> "border and edge";
            case FACE_FOOT -> "foot on a face";
            case FACE_BORDER -> "border and face";
            case NONE -> "silent";
        };
    }

    private double answer() {
        if (shape != Shape.MESH) {
            return q.ask();
        }
        List<Point> vertices = new ArrayList<>();
        for (double[] v : mesh) {
            vertices.add(new Point(v[0], v[1], v[2]));
        }
        Geometry geometry = new Geometry(1e6, 1e6, 1e6);
        geometry.addObjectUnchecked(new MeshObject(vertices, MESH_FACES));
        Ray ray = new Ray(new Point(q.apex[0], q.apex[1], q.apex[2]), new Point(q.way[0], q.way[1], q.way[2]));
        return geometry.getRayDistance(ray, 0, Double.POSITIVE_INFINITY, degrees);
    }

    private boolean isHeard(double share) {
        return twin(share).feature != PolytopeConeTwin.Feature.NONE;
    }

    /** The twin for a cone that is wider by a share of its half angle. */
    private PolytopeConeTwin twin(double share) {
        Twofold cos = Twofold.of(q.cos);
        if (share != 0) {
            cos = cos.minus(Twofold.of(Math.sin(q.half) * q.half * share));
        }
        PolytopeConeTwin twin = new PolytopeConeTwin(q.way, cos);
        Vector[] corners = corners();
        int[][] faces = shape == Shape.BOX ? BOX_FACES : shape == Shape.MESH ? MESH_FACES : new int[][] {{0, 1, 2}};
        for (int[] face : faces) {
            Vector[] polygon = new Vector[face.length];
            for (int k = 0; k < face.length; k++) {
                polygon[k] = corners[face[k]];
            }
            twin.add(polygon);
        }
        return twin;
    }

    private Vector[] corners() {
        if (shape == Shape.BOX) {
            Vector[] corners = new Vector[8];
            for (int c = 0; c < 8; c++) {
                Twofold[] x = new Twofold[3];
                for (int k = 0; k < 3; k++) {
                    x[k] = Twofold.difference(q.row[k], q.apex[k]);
                    for (int i = 0; i < 3; i++) {
                        double half = (c >> i & 1) == 0 ? -q.row[3 + i] : q.row[3 + i];
                        x[k] = x[k].plus(Twofold.of(half).times(q.row[Leaf.ROTATION + 3 * k + i]));
                    }
                }
                corners[c] = new Vector(x[0], x[1], x[2]);
            }
            return corners;
        }
        Vector[] corners = new Vector[shape == Shape.MESH ? mesh.length : 3];
        for (int c = 0; c < corners.length; c++) {
            double[] v = shape == Shape.MESH ? mesh[c] : Arrays.copyOfRange(q.row, 3 * c, 3 * c + 3);
            corners[c] = new Vector(
                    Twofold.difference(v[0], q.apex[0]),
                    Twofold.difference(v[1], q.apex[1]),
                    Twofold.difference(v[2], q.apex[2]));
        }
        return corners;
    }

    private boolean isInside() {
        for (int i = 0; i < 3; i++) {
            // along the own axes, orthonormal but for rounding: near a face either is right
            Twofold along = Twofold.ZERO;
            for (int k = 0; k < 3; k++) {
                along = along.plus(Twofold.difference(q.row[k], q.apex[k]).times(q.row[Leaf.ROTATION + 3 * k + i]));
            }
            if (Math.abs(along.head()) > q.row[3 + i]) {
                return false;
            }
        }
        return true;
    }

    private double extent() {
        double largest = q.extent();
        for (double[] v : mesh) {
            for (double x : v) {
                largest = Math.max(largest, shape == Shape.MESH ? Math.abs(x) : 0);
            }
        }
        return largest;
    }

    private String paste(double answer, double truth) {
        return q.paste(answer, "" + truth) + (shape == Shape.MESH ? Arrays.deepToString(mesh) + degrees : "");
    }

    private void make(SplittableRandom random, boolean adversarial) {
        q = new ConeQuestion(shape == Shape.BOX ? LeafKind.BOX : LeafKind.TRIANGLE);
        degrees = 2 * (adversarial ? StrictMath.pow(10, random.nextDouble(-1, 1.95)) : random.nextDouble(1, 89));
        q.widen(StrictMath.toRadians(degrees / 2));
        if (shape == Shape.MESH) {
            q.cos = Degrees.cos(degrees / 2);
        }
        shape(random, adversarial);
        double near = random.nextInt(3) > 0 ? 0.5 : 3;
        double[] at = place(random, random.nextInt(3));
        double[] away = ConeQuestion.direction(random);
        if (shape == Shape.TRIANGLE && random.nextInt(4) == 0) {
            at = place(random, 2);
            away = normal();
        }
        double far = near * random.nextDouble(0.01, 2);
        if (adversarial && random.nextInt(12) == 0) {
            far = StrictMath.pow(10, random.nextDouble(1, shape == Shape.MESH ? 5 : 6));
        }
        for (int k = 0; k < 3; k++) {
            q.apex[k] = at[k] + far * away[k];
        }
        // At what the apex is near, where the foot is, or at another place.
        double[] target = random.nextInt(3) > 0 ? at : place(random, random.nextInt(3));
        double off = random.nextDouble(-1, 0.6);
        isAimed = adversarial && random.nextInt(shape == Shape.BOX ? 8 : 2) > 0;
        if (isAimed) {
            double[] side = ConeQuestion.direction(random);
            off = StrictMath.pow(10, -random.nextDouble(7, 16)) * (random.nextBoolean() ? 1 : -1);
            q.aim(outermost(side), off, side, random);
        } else {
            q.aim(target, off, random);
        }
        if (shape == Shape.BOX && random.nextInt(3) == 0) {
            q.kind = LeafKind.UPRIGHT_BOX;
        } else if (shape == Shape.BOX) {
            q.turn(random);
        }
    }

    private void shape(SplittableRandom random, boolean adversarial) {
        Arrays.fill(q.row, 0);
        switch (shape) {
            case BOX -> {
                for (int k = 0; k < 3; k++) {
                    q.row[k] = random.nextDouble(-1, 1);
                    q.row[3 + k] = random.nextDouble(0.05, 1);
                }
                if (adversarial && random.nextInt(4) == 0) {
                    q.row[3 + random.nextInt(3)] = StrictMath.pow(10, -random.nextDouble(2, 9));
                }
                Rotations.yaw(random.nextDouble(-180, 180), 0, q.row, Leaf.ROTATION);
            }
            case TRIANGLE -> {
                for (int k = 0; k < 9; k++) {
                    q.row[k] = random.nextDouble(-1, 1);
                }
                if (adversarial && random.nextInt(4) == 0) {
                    double thin = StrictMath.pow(10, -random.nextDouble(2, 6));
                    for (int k = 0; k < 3; k++) {
                        q.row[6 + k] = (q.row[k] + q.row[3 + k]) / 2 + thin * q.row[6 + k];
                    }
                }
            }
            case MESH -> {
                for (int c = 0; c < 6; c++) {
                    for (int k = 0; k < 3; k++) {
                        mesh[c][k] = random.nextDouble(-0.4, 0.4) + (c / 2 == k ? (c % 2 == 0 ? 1 : -1) : 0);
                    }
                }
            }
        }
    }

    private double[] normal() {
        Vector[] v = corners();
        Vector n = v[1].minus(v[0]).cross(v[2].minus(v[0])).unit();
        return new double[] {n.x().head(), n.y().head(), n.z().head()};
    }

    /** The corner that is farthest along a direction. */
    private double[] outermost(double[] side) {
        double[] out = new double[3];
        double most = Double.NEGATIVE_INFINITY;
        for (Vector v : corners()) {
            double[] x = {v.x().head(), v.y().head(), v.z().head()};
            double along = x[0] * side[0] + x[1] * side[1] + x[2] * side[2];
            if (along > most) {
                most = along;
                out = x;
            }
        }
        for (int k = 0; k < 3; k++) {
            out[k] += q.apex[k];
        }
        return out;
    }

    /** A corner (0), or a place of an edge (1) or of a face (2), of the leaf before it is turned. */
    private double[] place(SplittableRandom random, int dimension) {
        double[] weights = {1, 0, 0};
        if (dimension > 0) {
            weights[1] = random.nextDouble();
            weights[2] = dimension > 1 ? random.nextDouble() * (1 - weights[1]) : 0;
            weights[0] = 1 - weights[1] - weights[2];
        }
        Vector[] corners = corners();
        int[][] faces = shape == Shape.BOX ? BOX_FACES : shape == Shape.MESH ? MESH_FACES : new int[][] {{0, 1, 2}};
        int[] face = faces[random.nextInt(faces.length)];
        int first = random.nextInt(face.length);
        double[] out = new double[3];
        for (int i = 0; i < 3; i++) {
            Vector v = corners[face[(first + i) % face.length]];
            out[0] += weights[i] * v.x().head();
            out[1] += weights[i] * v.y().head();
            out[2] += weights[i] * v.z().head();
        }
        for (int k = 0; k < 3; k++) {
            out[k] += q.apex[k];
        }
        return out;
    }
}
