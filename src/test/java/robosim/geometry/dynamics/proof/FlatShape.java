package robosim.geometry.dynamics.proof;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.SphereObject;

/**
 * What upright boxes, cylinders and spheres, and groups of these, are as seen from above: convex outlines with a radius
 * around each. Plain doubles and no code of the product, but the question that decides what these leave in doubt.
 */
public final class FlatShape {
    /** Farther apart than so much is certain: coordinates here are below 100, so their rounding errors are below 1e-13. */
    private static final double CERTAIN = 1e-12;

    private final GeometryObject object;
    private final List<double[]> outlines = new ArrayList<>();
    private final List<Double> radii = new ArrayList<>();
    private final List<double[]> circles = new ArrayList<>();
    private final boolean isKnown;

    private FlatShape(GeometryObject object) {
        this.object = object;
        isKnown = add(object);
    }

    /** The shape of an object. */
    public static FlatShape of(GeometryObject object) {
        return new FlatShape(object);
    }

    private boolean add(GeometryObject part) {
        double x = part.center().x();
        double z = part.center().z();
        if (part instanceof ObjectGroup group) {
            return group.parts().stream().allMatch(this::add);
        }
        double[] r = part.rotation();
        if (r[4] != 1) {
            return false;
        }
        if (part instanceof BoxObject box) {
            double w = box.width() / 2;
            double l = box.length() / 2;
            double[] corners = new double[8];
            for (int k = 0; k < 4; k++) {
                double u = k == 0 || k == 3 ? w : -w;
                double v = k < 2 ? l : -l;
                corners[2 * k] = x + r[0] * u + r[2] * v;
                corners[2 * k + 1] = z + r[6] * u + r[8] * v;
            }
            return add(corners, 0, x, z, Math.sqrt(w * w + l * l));
        }
        if (part instanceof CylinderObject disc) {
            return add(new double[] {x, z}, disc.radius(), x, z, disc.radius());
        }
        return part instanceof SphereObject ball && add(new double[] {x, z}, ball.radius(), x, z, ball.radius());
    }

    private boolean add(double[] corners, double radius, double x, double z, double reach) {
        outlines.add(corners);
        radii.add(radius);
        circles.add(new double[] {x, z, reach});
        return true;
    }

    /** Whether two touch or overlap: by a line that parts them, found with doubles, or by the exact question. */
    public static boolean overlap(FlatShape a, FlatShape b) {
        return depth(a, b) > -CERTAIN && CollisionDetection.intersects(a.object, b.object);
    }

    /** How deep two are in each other at least along some direction looked at; below 0 if they are certainly apart. */
    public static double depth(FlatShape a, FlatShape b) {
        if (!a.isKnown || !b.isKnown) {
            return Double.POSITIVE_INFINITY;
        }
        double deepest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < a.outlines.size(); i++) {
            for (int j = 0; j < b.outlines.size(); j++) {
                deepest = Math.max(deepest, depth(a, i, b, j));
            }
        }
        return deepest;
    }

    private static double depth(FlatShape a, int i, FlatShape b, int j) {
        double[] p = a.circles.get(i);
        double[] q = b.circles.get(j);
        double dx = p[0] - q[0];
        double dz = p[1] - q[1];
        double round = p[2] + q[2] - Math.sqrt(dx * dx + dz * dz);
        double[] outlineA = a.outlines.get(i);
        double[] outlineB = b.outlines.get(j);
        if (round < -1e-9 || (outlineA.length == 2 && outlineB.length == 2)) {
            return round;
        }
        double radius = a.radii.get(i) + b.radii.get(j);
        double least = Math.min(sides(outlineA, outlineB), sides(outlineB, outlineA));
        if (outlineA.length == 2 || outlineB.length == 2) {
            double[] point = outlineA.length == 2 ? outlineA : outlineB;
            double[] corners = outlineA.length == 2 ? outlineB : outlineA;
            for (int k = 0; k < corners.length; k += 2) {
                double ux = corners[k] - point[0];
                double uz = corners[k + 1] - point[1];
                double length = Math.sqrt(ux * ux + uz * uz);
                least = length == 0 ? least : Math.min(least, along(outlineA, outlineB, ux / length, uz / length));
            }
        }
        return least + radius;
    }

    /** The least overlap of two outlines across the sides of the first. */
    private static double sides(double[] of, double[] other) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < of.length && of.length > 2; k += 2) {
            double ux = of[(k + 2) % of.length] - of[k];
            double uz = of[(k + 3) % of.length] - of[k + 1];
            double length = Math.sqrt(ux * ux + uz * uz);
            least = Math.min(least, along(of, other, uz / length, -ux / length));
        }
        return least;
    }

    private static double along(double[] a, double[] b, double nx, double nz) {
        double aLow = Double.POSITIVE_INFINITY;
        double aHigh = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < a.length; k += 2) {
            double s = a[k] * nx + a[k + 1] * nz;
            aLow = Math.min(aLow, s);
            aHigh = Math.max(aHigh, s);
        }
        double bLow = Double.POSITIVE_INFINITY;
        double bHigh = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < b.length; k += 2) {
            double s = b[k] * nx + b[k + 1] * nz;
            bLow = Math.min(bLow, s);
            bHigh = Math.max(bHigh, s);
        }
        return Math.min(aHigh - bLow, bHigh - aLow);
    }
}
