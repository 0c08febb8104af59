package robosim.geometry.reference;

import static robosim.geometry.reference.Vectors.abs;
import static robosim.geometry.reference.Vectors.atMost;
import static robosim.geometry.reference.Vectors.cross;
import static robosim.geometry.reference.Vectors.dot;
import static robosim.geometry.reference.Vectors.minus;

import robosim.geometry.reference.Quantity.Arithmetic;

/**
 * Yes or no about forms that are given by their stored numbers, in the real-number geometry of these numbers. The
 * numbers of a form stand in a row: centre, three half sizes (or radius and half height, of a capsule half its segment), a
 * row-major rotation; or the nine coordinates of a triangle.
 */
public final class Truth {
    /** With doubles, or not at all. */
    public static final Arithmetic COARSE = Coarse::of;

    /** Always, and slowly. */
    public static final Arithmetic EXACT = Binary::of;

    /** What a row of numbers describes. */
    public enum Form {
        UPRIGHT_BOX,
        BOX,
        TRIANGLE,
        SPHERE,
        UPRIGHT_CYLINDER,
        CYLINDER,
        UPRIGHT_CAPSULE,
        CAPSULE;

        /** Whether it is a vertical prism. */
        boolean isUpright() {
            return this == UPRIGHT_BOX || this == UPRIGHT_CYLINDER;
        }

        boolean isCylinder() {
            return this == UPRIGHT_CYLINDER || this == CYLINDER;
        }

        /** Whether it is a capsule, upright or turned. */
        public boolean isCapsule() {
            return this == UPRIGHT_CAPSULE || this == CAPSULE;
        }

        boolean isRound() {
            return this == SPHERE || isCylinder() || isCapsule();
        }
    }

    private Truth() {}

    /** Whether the projections of two forms touch or overlap; knows no turned cylinders, and turned capsules by discs. */
    public static boolean planar(Arithmetic n, Form formA, double[] a, Form formB, double[] b) {
        if (formA == Form.CYLINDER || formB == Form.CYLINDER) {
            throw new IllegalArgumentException("no oracle for turned cylinders (got: " + formA + ", " + formB + ")");
        }
        if (formA == Form.CAPSULE || formB == Form.CAPSULE) {
            return CapsuleTruth.planar(n, formA, a, formB, b);
        }
        if (formA.isRound() && formB.isRound()) {
            Quantity[] offset = minus(flat(n, a), flat(n, b));
            Quantity both = n.of(a[3]).plus(n.of(b[3]));
            return atMost(dot(offset, offset), both.times(both));
        }
        if (formB.isRound()) {
            return planar(n, formB, b, formA, a);
        }
        return formA.isRound()
                ? outline(n, formB, b).isWithin(flat(n, a), n.of(a[3]))
                : outline(n, formA, a).meets(outline(n, formB, b));
    }

    /** Whether two forms touch or overlap; of turned cylinders, only those parallel to each other are known. */
    public static boolean spatial(Arithmetic n, Form formA, double[] a, Form formB, double[] b) {
        if (formA.isCapsule() || formB.isCapsule()) {
            return CapsuleTruth.spatial(n, formA, a, formB, b);
        }
        if (formA.isUpright() && formB.isUpright()) {
            Quantity apart = abs(n.of(a[1]).minus(n.of(b[1])));
            return atMost(apart, n.of(a[4]).plus(n.of(b[4]))) && planar(n, formA, a, formB, b);
        }
        if (formA.isRound() && !formB.isRound()) {
            return spatial(n, formB, b, formA, a);
        }
        if (!formB.isRound()) {
            return hull(n, formA, a).meets(hull(n, formB, b));
        }
        if (!formA.isRound()) {
            return formB == Form.SPHERE
                    ? hull(n, formA, a).isWithin(centre(n, b), n.of(b[3]))
                    : tube(n, formB, b).meets(hull(n, formA, a));
        }
        if (formA == Form.SPHERE && formB == Form.SPHERE) {
            Quantity[] offset = minus(centre(n, a), centre(n, b));
            Quantity both = n.of(a[3]).plus(n.of(b[3]));
            return atMost(dot(offset, offset), both.times(both));
        }
        if (formB == Form.SPHERE) {
            return tube(n, formA, a).meetsBall(centre(n, b), n.of(b[3]));
        }
        return formA == Form.SPHERE
                ? tube(n, formB, b).meetsBall(centre(n, a), n.of(a[3]))
                : tube(n, formA, a).meetsParallel(tube(n, formB, b));
    }

    /** Whether a ray, given by start and direction, meets the projection of a form, projected itself. */
    public static boolean planarRay(Arithmetic n, double[] ray, Form form, double[] row) {
        Quantity[] start = Vectors.of(n, ray[0], 0, ray[2]);
        Quantity[] direction = Vectors.of(n, ray[3], 0, ray[5]);
        if (form == Form.CAPSULE) {
            return CapsuleTruth.planarRay(n, start, direction, row);
        }
        return form.isRound()
                ? ballIsHit(start, direction, flat(n, row), n.of(row[3]))
                : Clip.rayMeets(start, direction, outline(n, form, row).slabs);
    }

    /** Whether a ray, given by start and direction, meets a form. */
    public static boolean spatialRay(Arithmetic n, double[] ray, Form form, double[] row) {
        Quantity[] start = Vectors.of(n, ray[0], ray[1], ray[2]);
        Quantity[] direction = Vectors.of(n, ray[3], ray[4], ray[5]);
        if (form == Form.SPHERE) {
            return ballIsHit(start, direction, centre(n, row), n.of(row[3]));
        }
        if (form.isCapsule()) {
            return CapsuleTruth.spatialRay(n, start, direction, form, row);
        }
        return form.isCylinder()
                ? tube(n, form, row).isHitBy(start, direction)
                : Clip.rayMeets(start, direction, hull(n, form, row).slabs);
    }

    /** Sign of (b - a) x (p - a) in the plane of six numbers. */
    public static int side(Arithmetic n, double[] p) {
        Quantity ux = n.of(p[2]).minus(n.of(p[0]));
        Quantity uz = n.of(p[3]).minus(n.of(p[1]));
        Quantity vx = n.of(p[4]).minus(n.of(p[0]));
        Quantity vz = n.of(p[5]).minus(n.of(p[1]));
        return ux.times(vz).minus(uz.times(vx)).signum();
    }

    /** Sign of the volume that four points span, of twelve numbers. */
    public static int volume(Arithmetic n, double[] p) {
        Quantity[] a = Vectors.of(n, p[0], p[1], p[2]);
        Quantity[] u = minus(Vectors.of(n, p[3], p[4], p[5]), a);
        Quantity[] v = minus(Vectors.of(n, p[6], p[7], p[8]), a);
        Quantity[] w = minus(Vectors.of(n, p[9], p[10], p[11]), a);
        return dot(u, cross(v, w)).signum();
    }

    static boolean ballIsHit(Quantity[] start, Quantity[] direction, Quantity[] centre, Quantity radius) {
        Quantity[] offset = minus(centre, start);
        Quantity most = radius.times(radius);
        if (atMost(dot(offset, offset), most)) {
            return true;
        }
        Quantity[] moment = cross(offset, direction);
        return dot(offset, direction).signum() > 0
                && atMost(dot(moment, moment), most.times(dot(direction, direction)));
    }

    static Hull outline(Arithmetic n, Form form, double[] row) {
        return form == Form.TRIANGLE ? Hull.flatTriangle(n, row) : Hull.shadow(n, row);
    }

    static Hull hull(Arithmetic n, Form form, double[] row) {
        return form == Form.TRIANGLE ? Hull.triangle(n, row) : Hull.box(n, row);
    }

    private static Tube tube(Arithmetic n, Form form, double[] row) {
        return form == Form.UPRIGHT_CYLINDER ? Tube.upright(n, row) : Tube.turned(n, row);
    }

    private static Quantity[] centre(Arithmetic n, double[] row) {
        return Vectors.of(n, row[0], row[1], row[2]);
    }

    static Quantity[] flat(Arithmetic n, double[] row) {
        return Vectors.of(n, row[0], 0, row[2]);
    }
}
