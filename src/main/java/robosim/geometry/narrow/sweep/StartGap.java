package robosim.geometry.narrow.sweep;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.Radians;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.gjk.Support;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.sat.AxisBody;
import robosim.geometry.narrow.sat.ExactExtent;
import robosim.geometry.narrow.sat.ExactFeatures;

/**
 * Finds planes that certainly separate two leaves which start nearer to each other than a sweep can resolve, and asks which of
 * them a motion does not cross. Such a start counts as a contact.
 *
 * <p>A translation of a convex leaf is free if and only if there is such a plane. Candidates for its normal come in three
 * sorts. A flat side fixes a normal, and so do two edges; these are exact. One edge leaves a circle of normals: on it the widest
 * slab is where the slope of the width is 0. That slope is the difference of two support points, which doubles know to a
 * rounding, whereas the width is flat at its maximum and would lead only to half the digits. The direction found is then made
 * perpendicular to the edge without rounding. Where only curves meet, the same is done around two directions in turns. The
 * displacement counts as an edge: perpendicular to it are the normals of planes that a translation runs along. So does the axis of a
 * turn, which is a normal too.
 *
 * <p>Doubles only choose what is worth verifying.
 */
public final class StartGap {
    /** What a motion has to do with the planes. */
    public interface Motion {
        /**
         * Whether a plane settles the question; {@link #isApart} tells if it separates the two at the start.
         *
         * @param n the plane's normal, from the other leaf to the mover
         * @param u the same at length 1, to rounding
         */
        boolean isSettledBy(ExactVector n, double[] u);
    }

    /** A gap along a plane's normal that closes by more than this share of sizes and way is no gap of these starts any more. */
    private static final double EARLY = 0x1p-40;

    /** Beyond this turn from the direction given no maximum is looked for. */
    private static final double WIDEST = 1;

    private static final double NARROWEST = 0x1p-30;

    /** Halvings of an angle, until it is known as well as doubles allow. */
    private static final int HALVINGS = 64;

    /** Turns around one direction and the other until both are at a maximum, where only curves meet. */
    private static final int ROUNDS = 24;

    /** A direction this close to an edge is not made perpendicular to it. */
    private static final double ALONG = 0x1p-6;

    private static final ExactVector UP = ExactVector.of(0, 1, 0);

    private final Support mover = new Support();
    private final Support rest = new Support();
    private final Motion straight = this::isKept;

    private boolean planar;
    private Leaf a = new Leaf();
    private Leaf b = new Leaf();

    private Motion motion = straight;
    /** The displacement, or a turn's axis. */
    private ExactVector way = UP;

    private double dx;
    private double dy;
    private double dz;

    /** A slab along a unit direction that is narrower than minus this is none. */
    private double doubt;

    // The unit direction that was found last.
    private double nx;
    private double ny;
    private double nz;

    /** Sets the leaves of the next question. */
    public void between(boolean inPlane, Leaf moving, Leaf resting) {
        planar = inPlane;
        a = moving;
        b = resting;
        double ox = Support.originX(a.kind, a.row, a.at);
        double oz = Support.originZ(a.kind, a.row, a.at);
        if (planar) {
            mover.planar(a.kind, a.row, a.at, ox, oz, 1);
            rest.planar(b.kind, b.row, b.at, ox, oz, 1);
        } else {
            double oy = Support.originY(a.kind, a.row, a.at);
            mover.spatial(a.kind, a.row, a.at, ox, oy, oz, 1);
            rest.spatial(b.kind, b.row, b.at, ox, oy, oz, 1);
        }
        doubt = 4 * (Gjk.ROUNDOFF * (mover.extent + rest.extent) + AxisBody.TINY);
    }

    /**
     * Whether a translation is proven free.
     *
     * @param towards a direction from the other leaf to the mover from which to search, of length 1: three numbers
     */
    boolean isFree(double x, double y, double z, double[] towards) {
        dx = x;
        dy = y;
        dz = z;
        way = ExactVector.of(x, y, z);
        motion = straight;
        return isSettled(towards);
    }

    /**
     * Whether a plane settles a question about a turn.
     *
     * @param axis the direction of its axis: three numbers
     */
    public boolean isSettled(double[] towards, double[] axis, Motion turn) {
        way = ExactVector.of(axis[0], axis[1], axis[2]);
        motion = turn;
        return (!planar && (isWorth(way) || isWorth(way.negate()))) || isSettled(towards);
    }

    private boolean isSettled(double[] towards) {
        if (isWorth(ExactVector.of(towards[0], towards[1], towards[2]))) {
            return true;
        }
        ExactFeatures mine = new ExactFeatures(planar, a);
        ExactFeatures other = new ExactFeatures(planar, b);
        List<ExactVector> edges = new ArrayList<>(mine.edges());
        edges.addAll(other.edges());
        edges.add(way);
        if (planar) {
            edges.clear();
            edges.add(UP);
        }
        return bySides(mine, other, edges)
                || around(edges, towards)
                || betweenCorners(mine, other)
                || betweenCorners(other, mine)
                || (!planar && (a.kind.isCylinder() || b.kind.isCylinder()) && betweenCurves(towards));
    }

    private boolean bySides(ExactFeatures mine, ExactFeatures other, List<ExactVector> edges) {
        List<ExactVector> normals = new ArrayList<>(mine.faces());
        normals.addAll(other.faces());
        if (planar) {
            normals.add(way.cross(UP));
        }
        for (int k = 0; k < edges.size(); k++) {
            for (int m = k + 1; m < edges.size(); m++) {
                normals.add(edges.get(k).cross(edges.get(m)));
            }
        }
        return normals.stream().anyMatch(n -> isWorth(n) || isWorth(n.negate()));
    }

    /** Perpendicular to one edge, the widest slab. */
    private boolean around(List<ExactVector> edges, double[] towards) {
        for (ExactVector edge : edges) {
            double[] e = unit(edge);
            nx = towards[0];
            ny = towards[1];
            nz = towards[2];
            if (e.length > 0 && widen(e[0], e[1], e[2])) {
                ExactVector n = ExactVector.of(nx, ny, nz);
                if (isWorth(n.times(edge.square()).minus(edge.times(n.dot(edge))))) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Between corners, or a corner and an edge: for round ends, whose normals these are. */
    private boolean betweenCorners(ExactFeatures one, ExactFeatures two) {
        if (!one.isRound) {
            return false;
        }
        for (ExactVector p : one.corners) {
            for (ExactVector q : two.corners) {
                ExactVector offset = p.minus(q);
                if (isWorth(offset) || isWorth(offset.negate())) {
                    return true;
                }
            }
            for (ExactVector edge : two.edges()) {
                for (ExactVector q : two.corners) {
                    ExactVector offset = p.minus(q);
                    ExactVector across = offset.times(edge.square()).minus(edge.times(offset.dot(edge)));
                    if (isWorth(across) || isWorth(across.negate())) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private boolean betweenCurves(double[] towards) {
        nx = towards[0];
        ny = towards[1];
        nz = towards[2];
        for (int round = 0; round < ROUNDS; round++) {
            // Around two directions that are perpendicular to the one found and to each other.
            boolean isSteep = Math.abs(ny) > 0.5;
            double length = isSteep ? Math.sqrt(ny * ny + nz * nz) : Math.sqrt(nx * nx + nz * nz);
            double ex = isSteep ? 0 : -nz / length;
            double ey = isSteep ? nz / length : 0;
            double ez = isSteep ? -ny / length : nx / length;
            double fx = ny * ez - nz * ey;
            double fy = nz * ex - nx * ez;
            double fz = nx * ey - ny * ex;
            if (!(widen(ex, ey, ez) && widen(fx, fy, fz))) {
                return false;
            }
            if (isWorth(ExactVector.of(nx, ny, nz))) {
                return true;
            }
        }
        return false;
    }

    /**
     * Turns the direction around an edge to where the slab is widest; false where that is not found.
     *
     * <p>Where the slab of the leaves without their margins is not negative, its slope decreases with the angle.
     */
    private boolean widen(double ex, double ey, double ez) {
        double along = nx * ex + ny * ey + nz * ez;
        double fx = nx - along * ex;
        double fy = ny - along * ey;
        double fz = nz - along * ez;
        double length = Math.sqrt(fx * fx + fy * fy + fz * fz);
        if (!(length > ALONG)) {
            return false;
        }
        fx /= length;
        fy /= length;
        fz /= length;
        double gx = ey * fz - ez * fy;
        double gy = ez * fx - ex * fz;
        double gz = ex * fy - ey * fx;
        double side = slope(fx, fy, fz, gx, gy, gz, 0) < 0 ? -1 : 1;
        double low = 0;
        double high = NARROWEST;
        while (side * slope(fx, fy, fz, gx, gy, gz, side * high) > 0) {
            low = high;
            high *= 4;
            if (high > WIDEST) {
                return false;
            }
        }
        for (int k = 0; k < HALVINGS; k++) {
            double middle = 0.5 * (low + high);
            if (side * slope(fx, fy, fz, gx, gy, gz, side * middle) > 0) {
                low = middle;
            } else {
                high = middle;
            }
        }
        double cos = Radians.cos(low);
        double sin = side * Radians.sin(low);
        nx = cos * fx + sin * gx;
        ny = cos * fy + sin * gy;
        nz = cos * fz + sin * gz;
        return true;
    }

    /** The slope of the width of the slab along the direction at an angle from f to g. */
    private double slope(double fx, double fy, double fz, double gx, double gy, double gz, double angle) {
        double cos = Radians.cos(angle);
        double sin = Radians.sin(angle);
        double x = cos * fx + sin * gx;
        double y = cos * fy + sin * gy;
        double z = cos * fz + sin * gz;
        mover.find(-x, -y, -z);
        rest.find(x, y, z);
        return (cos * gx - sin * fx) * (mover.x - rest.x)
                + (cos * gy - sin * fy) * (mover.y - rest.y)
                + (cos * gz - sin * fz) * (mover.z - rest.z);
    }

    /** Whether a direction, along which the two may be apart at the start, settles the question. */
    private boolean isWorth(ExactVector n) {
        double[] u = unit(n);
        if (u.length == 0) {
            return false;
        }
        mover.find(-u[0], -u[1], -u[2]);
        rest.find(u[0], u[1], u[2]);
        double width = u[0] * (mover.x - rest.x) + u[1] * (mover.y - rest.y) + u[2] * (mover.z - rest.z);
        return width - mover.margin - rest.margin > -doubt && motion.isSettledBy(n, u);
    }

    /** Whether the two are strictly apart along a direction at the start. */
    public boolean isApart(ExactVector n) {
        return ExactExtent.of(n, b).gapTo(ExactExtent.of(n, a)) > 0;
    }

    /** Whether the two are strictly apart along a direction at the start, and at the end too, or the gap does not close. */
    private boolean isKept(ExactVector n, double[] u) {
        double gain = u[0] * dx + u[1] * dy + u[2] * dz;
        double closing = EARLY * (mover.extent + rest.extent + Math.abs(dx) + Math.abs(dy) + Math.abs(dz));
        if (gain < -closing || !isApart(n)) {
            return false;
        }
        Dyadic rise = n.dot(way);
        ExactExtent ends = ExactExtent.of(n, a).movedBy(rise);
        return rise.signum() >= 0 || ExactExtent.of(n, b).gapTo(ends) > 0;
    }

    /** A direction at length 1, to rounding; empty for none. */
    private static double[] unit(ExactVector n) {
        if (n.isZero()) {
            return new double[0];
        }
        int power = Integer.MIN_VALUE;
        for (Dyadic component : new Dyadic[] {n.x(), n.y(), n.z()}) {
            power = component.signum() == 0 ? power : Math.max(power, component.magnitude());
        }
        ExactVector scaled = n.scale(-power);
        double x = scaled.x().doubleValue();
        double y = scaled.y().doubleValue();
        double z = scaled.z().doubleValue();
        double length = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / length, y / length, z / length};
    }
}
