package robosim.geometry.narrow.sat;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactMath;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** The exact counterpart of {@link MovingAxes}: the same axes, any number of them, without rounding. */
public final class ExactAxes {
    private static final StageCounters.Counter EXACT = StageCounters.counter("MovingAxes");

    private final ExactBody first;
    private final ExactBody second;
    private final ExactVector move;
    private final List<Direction> directions = new ArrayList<>();

    // How far the mover lies beyond the other in a direction (negative: how deep), how fast that grows, and the
    // direction's squared length.
    private record Direction(Dyadic gap, Dyadic speed, Dyadic square) {}

    private ExactAxes(ExactBody first, ExactBody second, ExactVector move) {
        this.first = first;
        this.second = second;
        this.move = move;
    }

    /** As {@code PlanarSweep.translation}, for polytopes. */
    public static double time(AxisBody.Mode mode, Leaf a, double dx, double dy, double dz, Leaf b) {
        EXACT.count();
        ExactVector move = ExactVector.of(dx, mode == AxisBody.Mode.PLANAR ? 0 : dy, dz);
        ExactAxes axes = new ExactAxes(ExactBody.of(mode, a), ExactBody.of(mode, b), move);
        axes.collect(mode == AxisBody.Mode.SPATIAL && a.kind == LeafKind.TRIANGLE && b.kind == LeafKind.TRIANGLE);
        return axes.decide();
    }

    private void collect(boolean triangles) {
        first.normals.forEach(this::add);
        second.normals.forEach(this::add);
        for (ExactVector p : first.edges) {
            for (ExactVector q : second.edges) {
                add(p.cross(q));
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
        ExactVector normal = body.normals.get(0);
        boolean flat = first.normals.get(0).isZero() || second.normals.get(0).isZero();
        for (ExactVector edge : body.edges) {
            add(edge.cross(normal));
            if (flat) {
                add(edge.cross(ExactVector.of(1, 0, 0)));
                add(edge.cross(ExactVector.of(0, 1, 0)));
                add(edge.cross(ExactVector.of(0, 0, 1)));
            }
        }
        if (flat) {
            add(ExactVector.of(1, 0, 0));
            add(ExactVector.of(0, 1, 0));
            add(ExactVector.of(0, 0, 1));
        }
    }

    private void add(ExactVector axis) {
        if (axis.isZero()) {
            return;
        }
        ExactBody.Extent p = first.project(axis);
        ExactBody.Extent q = second.project(axis);
        Dyadic speed = axis.dot(move);
        Dyadic square = axis.square();
        directions.add(new Direction(p.lo().subtract(q.hi()), speed, square));
        directions.add(new Direction(q.lo().subtract(p.hi()), speed.negate(), square));
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
