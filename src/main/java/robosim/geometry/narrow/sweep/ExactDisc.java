package robosim.geometry.narrow.sweep;

import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactMath;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.planar.ExactPolygon;

/**
 * A disc, or an upright cylinder, translated against an upright disc or polygon at rest: decided without rounding, as a
 * segment's distance from the outline.
 *
 * <p>All coordinates are relative to the disc's centre at the start.
 */
public final class ExactDisc {
    private static final StageCounters.Counter EXACT = StageCounters.counter("MovingDisc");

    private final ExactPolygon outline;
    private final Dyadic radius;
    private final Dyadic[] move;

    /** Heights, where they count; else null. */
    private final @Nullable Heights heights;

    // How far the mover's bottom is above the other's top, and its top below the other's bottom; and how it moves.
    record Heights(Dyadic above, Dyadic below, Dyadic speed) {
        boolean touch() {
            return above.signum() <= 0 && below.signum() <= 0;
        }
    }

    private ExactDisc(ExactPolygon outline, Dyadic radius, Dyadic[] move, @Nullable Heights heights) {
        this.outline = outline;
        this.radius = radius;
        this.move = move;
        this.heights = heights;
    }

    /**
     * A disc that goes straight on by (dx, dz), and what it may meet.
     *
     * @param heights null where they do not count
     */
    public static ExactDisc of(Leaf a, double dx, double dz, Leaf b, @Nullable Heights heights) {
        EXACT.count();
        Dyadic radius = Dyadic.of(a.get(3));
        if (b.kind.isDisc()) {
            radius = radius.add(Dyadic.of(b.get(3)));
        }
        Dyadic[] centre = ExactPolygon.pair(Dyadic.of(a.get(0)), Dyadic.of(a.get(2)));
        ExactPolygon outline = ExactPolygon.of(b.kind, b.row, b.at).relative(centre, Dyadic.ONE);
        Dyadic[] move = ExactPolygon.pair(Dyadic.of(dx), Dyadic.of(dz));
        return new ExactDisc(outline, radius, move, heights);
    }

    /** The answer of {@code translation} for this pair. */
    double time() {
        Dyadic[] origin = ExactPolygon.pair(Dyadic.ZERO, Dyadic.ZERO);
        boolean contact = outline.isWithin(origin, radius);
        if (heights == null) {
            return contact
                    ? fromContact()
                    : outline.comesNear(origin, move, radius) ? entry() : Double.POSITIVE_INFINITY;
        }
        return contact && heights.touch() ? fromContact() : whileLevel(heights);
    }

    /** Whether the two touch or overlap at the start, in the plane. */
    public boolean touches() {
        return outline.isWithin(ExactPolygon.pair(Dyadic.ZERO, Dyadic.ZERO), radius);
    }

    // Only while the heights touch, from enter / rate to leave / rate.
    private double whileLevel(Heights h) {
        Dyadic rate = h.speed.abs();
        boolean down = h.speed.signum() < 0;
        Dyadic enter = (down ? h.above : h.below).max(Dyadic.ZERO);
        Dyadic leave = (down ? h.below : h.above).negate();
        if (rate.signum() == 0) {
            if (!h.touch()) {
                return Double.POSITIVE_INFINITY;
            }
            rate = Dyadic.ONE;
            leave = Dyadic.ONE;
        }
        leave = leave.min(rate);
        if (enter.compareTo(leave) > 0) {
            return Double.POSITIVE_INFINITY;
        }
        ExactPolygon scaled = outline.relative(ExactPolygon.pair(Dyadic.ZERO, Dyadic.ZERO), rate);
        Dyadic[] from = ExactPolygon.scale(move, enter);
        Dyadic[] to = ExactPolygon.scale(move, leave);
        Dyadic reach = radius.multiply(rate);
        if (scaled.isWithin(from, reach)) {
            return ExactMath.floorQuotient(enter, rate);
        }
        if (!scaled.comesNear(from, to, reach)) {
            return Double.POSITIVE_INFINITY;
        }
        return Math.max(entry(), ExactMath.floorQuotient(enter, rate));
    }

    /** Time of the first touch in the plane, which is known to be one, after the start; rounded down. */
    private double entry() {
        double first = 1;
        for (int k = 0; k < outline.size(); k++) {
            first = Math.min(first, cornerTime(outline.corner(k)));
        }
        for (int k = 0; k < outline.normals().size(); k++) {
            first = Math.min(first, edgeTime(k));
        }
        return first;
    }

    private double cornerTime(Dyadic[] corner) {
        Dyadic beyond = ExactPolygon.dot(corner, corner).subtract(radius.square());
        Dyadic ahead = ExactPolygon.dot(corner, move);
        Dyadic square = ExactPolygon.dot(move, move);
        Dyadic aside = ExactPolygon.cross(corner, move);
        Dyadic chord = radius.square().multiply(square).subtract(aside.square());
        if (ahead.signum() <= 0 || chord.signum() < 0) {
            return Double.POSITIVE_INFINITY;
        }
        // Not the difference of ahead and the root: that would cancel.
        Dyadic whole = ahead.add(ExactMath.sqrtUp(chord));
        if (whole.compareTo(beyond) < 0) {
            return Double.POSITIVE_INFINITY;
        }
        double time = ExactMath.floorQuotient(beyond, whole);
        // The root was rounded: still outside the circle, or on it, and not past it at the next double?
        Dyadic next = Dyadic.of(Math.nextUp(time));
        Dyadic left = beyond.subtract(ahead.multiply(next).scale(1)).add(square.multiply(next.square()));
        boolean later = left.signum() >= 0 && square.multiply(next).compareTo(ahead) <= 0;
        return later ? Math.nextUp(time) : time;
    }

    private double edgeTime(int k) {
        Dyadic[] n = outline.normals().get(k);
        Dyadic[] p = outline.corner(k);
        Dyadic[] edge = ExactPolygon.subtract(outline.corner(k + 1), p);
        Dyadic length = ExactPolygon.dot(edge, edge);
        Dyadic speed = ExactPolygon.dot(n, move).negate();
        Dyadic square = ExactPolygon.dot(n, n);
        Dyadic height = ExactPolygon.dot(n, p).negate();
        if (length.signum() == 0 || speed.signum() <= 0 || ExactMath.compareToRoot(height, radius, square) < 0) {
            return Double.POSITIVE_INFINITY;
        }
        // Times the speed, the foot is along the edge by a - b sqrt(square); past an end the corner's circle counts.
        Dyadic along = ExactPolygon.dot(move, edge);
        Dyadic a = height.multiply(along).subtract(ExactPolygon.dot(p, edge).multiply(speed));
        Dyadic b = radius.multiply(along);
        if (ExactMath.compareToRoot(a, b, square) < 0
                || ExactMath.compareToRoot(a.subtract(length.multiply(speed)), b, square) > 0) {
            return Double.POSITIVE_INFINITY;
        }
        // Not the difference of the height and the radius, which would cancel.
        Dyadic gap = height.square().subtract(radius.square().multiply(square));
        Dyadic closing = height.add(radius.multiply(ExactMath.sqrtUp(square))).multiply(speed);
        if (gap.compareTo(closing) > 0) {
            return Double.POSITIVE_INFINITY;
        }
        double time = ExactMath.floorQuotient(gap, closing);
        Dyadic left = height.subtract(speed.multiply(Dyadic.of(Math.nextUp(time))));
        return ExactMath.compareToRoot(left, radius, square) >= 0 ? Math.nextUp(time) : time;
    }

    /** In contact: 0 where the move goes against every least way out, else infinite. */
    private double fromContact() {
        LeastWay way = leastWay();
        boolean blocked = way.blocked;
        if (heights != null) {
            Dyadic depth = heights.above.max(heights.below).negate();
            int order = way.compare(radius.subtract(depth));
            boolean level = (heights.above.compareTo(heights.below) < 0 || heights.speed.signum() < 0)
                    && (heights.below.compareTo(heights.above) < 0 || heights.speed.signum() > 0);
            blocked = order < 0 ? blocked : order > 0 ? level : blocked && level;
        }
        return blocked ? 0 : Double.POSITIVE_INFINITY;
    }

    /**
     * The least way out in the plane: its depth is the radius less, or (from inside) plus, the root of num / den;
     * blocked where the move is strictly against all that tie.
     */
    private record LeastWay(boolean inside, Dyadic num, Dyadic den, boolean blocked) {
        /** Sign of (depth - radius + excess): compares the depth with {@code radius - excess}. */
        int compare(Dyadic excess) {
            int order = excess.square().multiply(den).compareTo(num);
            if (inside) {
                return excess.signum() >= 0 ? Integer.signum(excess.signum() + num.signum()) : -order;
            }
            return excess.signum() < 0 ? -1 : order;
        }
    }

    private LeastWay leastWay() {
        Dyadic[] origin = ExactPolygon.pair(Dyadic.ZERO, Dyadic.ZERO);
        return outline.contains(origin) ? wayFromInside() : wayFromOutside();
    }

    private LeastWay wayFromInside() {
        Dyadic num = Dyadic.ZERO;
        Dyadic den = Dyadic.ZERO;
        boolean blocked = true;
        for (int k = 0; k < outline.normals().size(); k++) {
            Dyadic[] n = outline.normals().get(k);
            Dyadic depth = ExactPolygon.dot(n, outline.corner(k)).square();
            Dyadic square = ExactPolygon.dot(n, n);
            boolean into = ExactPolygon.dot(n, move).signum() < 0;
            int order = den.signum() == 0 ? -1 : depth.multiply(den).compareTo(num.multiply(square));
            if (order < 0) {
                num = depth;
                den = square;
                blocked = into;
            } else if (order == 0) {
                blocked &= into;
            }
        }
        return new LeastWay(true, num, den, blocked);
    }

    private LeastWay wayFromOutside() {
        Dyadic num = Dyadic.ZERO;
        Dyadic den = Dyadic.ZERO;
        boolean blocked = true;
        for (int k = 0; k < outline.size(); k++) {
            Dyadic[] p = outline.corner(k);
            Dyadic[] edge = ExactPolygon.subtract(outline.corner(k + 1), p);
            Dyadic length = ExactPolygon.dot(edge, edge);
            Dyadic share = ExactPolygon.dot(p, edge).negate();
            // What is flat has an edge for either side, of which only the one that faces the centre counts.
            boolean face = share.signum() > 0
                    && share.compareTo(length) < 0
                    && ExactPolygon.dot(outline.normals().get(k), p).signum() <= 0;
            Dyadic distance = face ? ExactPolygon.cross(edge, p).square() : ExactPolygon.dot(p, p);
            Dyadic square = face ? length : Dyadic.ONE;
            if (den.signum() == 0 || distance.multiply(den).compareTo(num.multiply(square)) < 0) {
                num = distance;
                den = square;
                Dyadic[] inward = face ? ExactPolygon.scale(outline.normals().get(k), Dyadic.ONE.negate()) : p;
                blocked = ExactPolygon.dot(inward, move).signum() > 0;
            }
        }
        return new LeastWay(false, num, den, blocked);
    }
}
