package robosim.geometry.narrow.sat;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactMath;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.leaf.LeafKind;

/** The exact counterpart of {@link MovingAxes}: the same axes, any number of them, without rounding. */
public final class ExactAxes {
    private static final StageCounters.Counter EXACT = StageCounters.counter("MovingAxes");

    private final ExactBody first;
    private final ExactBody second;
    private final Dyadic[] move;
    private final List<Direction> directions = new ArrayList<>();

    // How far the mover lies beyond the other in a direction (negative: how deep), how fast that grows, and the
    // direction's squared length.
    private record Direction(Dyadic gap, Dyadic speed, Dyadic square) {}

    private ExactAxes(ExactBody first, ExactBody second, Dyadic[] move) {
        this.first = first;
        this.second = second;
        this.move = move;
    }

    /** As {@code PlanarSweep.translation}, for polytopes. */
    public static double time(
            int mode,
            LeafKind kindA,
            double[] a,
            int i,
            double dx,
            double dy,
            double dz,
            LeafKind kindB,
            double[] b,
            int j) {
        EXACT.count();
        return of(mode, kindA, a, i, dx, dy, dz, kindB, b, j).decide();
    }

    private static ExactAxes of(
            int mode,
            LeafKind kindA,
            double[] a,
            int i,
            double dx,
            double dy,
            double dz,
            LeafKind kindB,
            double[] b,
            int j) {
        Dyadic[] move = ExactBody.vector(dx, mode == AxisBody.PLANAR ? 0 : dy, dz);
        ExactAxes axes = new ExactAxes(ExactBody.of(mode, kindA, a, i), ExactBody.of(mode, kindB, b, j), move);
        axes.collect(mode == AxisBody.SPATIAL && kindA == LeafKind.TRIANGLE && kindB == LeafKind.TRIANGLE);
        return axes;
    }

    private void collect(boolean triangles) {
        first.normals.forEach(this::add);
        second.normals.forEach(this::add);
        for (Dyadic[] p : first.edges) {
            for (Dyadic[] q : second.edges) {
                add(ExactBody.cross(p, q));
            }
        }
        if (triangles) {
            inPlane(first);
            inPlane(second);
        }
    }

    // Triangles in one plane need the normals of their edges in it; degenerate ones need those of a triangle thickened
    // by a cube.
    private void inPlane(ExactBody body) {
        Dyadic[] normal = body.normals.get(0);
        boolean flat = ExactBody.isZero(first.normals.get(0)) || ExactBody.isZero(second.normals.get(0));
        for (Dyadic[] edge : body.edges) {
            add(ExactBody.cross(edge, normal));
            if (flat) {
                add(ExactBody.cross(edge, ExactBody.vector(1, 0, 0)));
                add(ExactBody.cross(edge, ExactBody.vector(0, 1, 0)));
                add(ExactBody.cross(edge, ExactBody.vector(0, 0, 1)));
            }
        }
        if (flat) {
            add(ExactBody.vector(1, 0, 0));
            add(ExactBody.vector(0, 1, 0));
            add(ExactBody.vector(0, 0, 1));
        }
    }

    private void add(Dyadic[] axis) {
        if (ExactBody.isZero(axis)) {
            return;
        }
        Dyadic[] p = first.project(axis);
        Dyadic[] q = second.project(axis);
        Dyadic speed = ExactBody.dot(axis, move);
        Dyadic square = ExactBody.dot(axis, axis);
        directions.add(new Direction(p[0].subtract(q[1]), speed, square));
        directions.add(new Direction(q[0].subtract(p[1]), speed.negate(), square));
    }

    private double decide() {
        Direction enter = null;
        Direction leave = null;
        for (Direction d : directions) {
            if (d.gap.signum() > 0) {
                if (d.speed.signum() >= 0) {
                    return Double.POSITIVE_INFINITY;
                }
                enter = enter == null || isLater(d, enter) ? d : enter;
            } else if (d.speed.signum() > 0) {
                leave = leave == null || isLater(leave, d) ? d : leave;
            }
        }
        if (enter == null) {
            return fromContact() ? 0 : Double.POSITIVE_INFINITY;
        }
        boolean late = enter.gap.add(enter.speed).signum() > 0 || (leave != null && isLater(enter, leave));
        return late ? Double.POSITIVE_INFINITY : ExactMath.floorQuotient(enter.gap, enter.speed.negate());
    }

    // Whether p's plane is crossed strictly after q's: |gap p| / |speed p| > |gap q| / |speed q|.
    private static boolean isLater(Direction p, Direction q) {
        return p.gap.abs().multiply(q.speed.abs()).compareTo(q.gap.abs().multiply(p.speed.abs())) > 0;
    }

    private boolean fromContact() {
        Direction least = null;
        boolean blocked = true;
        for (Direction d : directions) {
            int order = compareDepth(d, least);
            if (order < 0) {
                least = d;
                blocked = d.speed.signum() < 0;
            } else if (order == 0) {
                blocked &= d.speed.signum() < 0;
            }
        }
        return blocked;
    }

    private static int compareDepth(Direction p, @Nullable Direction q) {
        if (q == null) {
            return -1;
        }
        return p.gap.square().multiply(q.square).compareTo(q.gap.square().multiply(p.square));
    }
}
