package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;

/** The least distance of a mesh and anything in space, a mesh too: the least of its triangles', whatever limit is given. */
final class MeshDistanceKernel implements Kernel {
    private static final List<String> OTHERS = List.of("box", "cylinder", "triangle", "sphere", "capsule", "mesh");
    private static final int[][] FACES = {{0, 1, 2}, {1, 0, 3}};

    /** A gap below this share of the size is near contact. */
    private static final double NEAR = 1e-3;

    private final DistanceProbe probe = new DistanceProbe();
    private final NearestTwin twin = new NearestTwin();
    private final LeafColumn column = new LeafColumn(1);

    @Override
    public String name() {
        return "distance in space, mesh and anything";
    }

    @Override
    public double effort() {
        return 1.2;
    }

    @Override
    public List<String> regimes() {
        List<String> regimes = new ArrayList<>();
        for (String other : OTHERS) {
            regimes.add("far, " + other);
            regimes.add("near, " + other);
            regimes.add("touching or overlapping, " + other);
        }
        return regimes;
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        SpacePairs pairs = new SpacePairs(random, adversarial);
        int kind = random.nextInt(OTHERS.size());
        boolean isMesh = kind == OTHERS.size() - 1;
        Body.Type other = isMesh ? Body.Type.TRIANGLE : Body.Type.values()[kind];
        int state = random.nextInt(3) == 0 ? 0 : 65 + random.nextInt(35); // most of the others near contact
        double gap = DistanceKernel.gap(random, state, adversarial);
        pairs.facing(Body.Type.TRIANGLE, random.nextInt(3), other, random.nextInt(3), gap);
        List<Body> a = surface(pairs.a, random, -1, pairs.n);
        List<Body> b = isMesh ? surface(pairs.b, random, 1, pairs.n) : List.of(pairs.b);
        double low = Double.POSITIVE_INFINITY;
        double high = Double.POSITIVE_INFINITY;
        double size = 0;
        double rounding = 0;
        for (Body p : a) {
            for (Body q : b) {
                twin.find(p, q);
                low = Math.min(low, Math.max(0, twin.low));
                high = Math.min(high, twin.high);
                size = Math.max(size, p.size() + q.size() + Vec.length(Vec.minus(p.c, q.c)));
                rounding = Math.max(rounding, NearestTwin.rounding(p, q));
            }
        }
        String regime = low <= 2 * rounding ? "touching or overlapping, " : low < NEAR * size ? "near, " : "far, ";
        LeafColumn second = isMesh ? LocalLeaves.placed(mesh(b)) : column;
        if (!isMesh) {
            pairs.b.writeTo(column);
        }
        return probe.compare(
                regime + OTHERS.get(kind),
                LocalLeaves.placed(mesh(a)),
                second,
                low - rounding,
                high + rounding,
                size,
                rounding,
                () -> String.format(Locale.ROOT, "%s, %s", a, b));
    }

    /** Two triangles on three corners and a fourth one, which is farther back. */
    private static List<Body> surface(Body triangle, SplittableRandom random, int back, double[] n) {
        double[][] corners = new double[4][];
        System.arraycopy(triangle.corners, 0, corners, 0, 3);
        double[] way = Vec.direction(random);
        double sign = Math.signum(Vec.dot(way, n)) * back;
        corners[3] = Vec.plus(triangle.corners[random.nextInt(3)], sign * random.nextDouble(0.01, 1), way);
        List<Body> bodies = new ArrayList<>();
        for (int[] face : FACES) {
            double[] nine = new double[9];
            for (int k = 0; k < 3; k++) {
                System.arraycopy(corners[face[k]], 0, nine, 3 * k, 3);
            }
            bodies.add(Body.triangle(nine));
        }
        return bodies;
    }

    private static MeshObject mesh(List<Body> surface) {
        List<Point> corners = new ArrayList<>();
        int[][] faces = new int[surface.size()][];
        for (int k = 0; k < faces.length; k++) {
            for (double[] corner : surface.get(k).corners) {
                corners.add(new Point(corner[0], corner[1], corner[2]));
            }
            faces[k] = new int[] {3 * k, 3 * k + 1, 3 * k + 2};
        }
        return new MeshObject(corners, faces);
    }
}
