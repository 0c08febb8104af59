package robosim.geometry.narrow;

import static robosim.geometry.reference.Decimals.cross;
import static robosim.geometry.reference.Decimals.dot;
import static robosim.geometry.reference.Decimals.minus;
import static robosim.geometry.reference.Decimals.vector;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.HullMotion;

/**
 * The slow twin of a sphere that moves straight on at corners' hull, in decimals without rounding: they meet where the
 * centre's way goes into the hull, or all that the hull sweeps, seen from the centre, comes as near as the radius to it.
 */
public final class BallTwin {
    private final List<BigDecimal[]> corners = new ArrayList<>();
    private final BigDecimal[] move;
    private final BigDecimal square;
    private final @Nullable HullMotion core;

    public BallTwin(double[] sphere, double[] d, LeafKind kindB, double[] b) {
        BigDecimal[] centre = vector(sphere[0], sphere[1], sphere[2]);
        List<BigDecimal[]> rest = kindB == LeafKind.SPHERE
                ? List.<BigDecimal[]>of(vector(b[0], b[1], b[2]))
                : FlatTwin.cornersInSpace(kindB, b);
        for (BigDecimal[] corner : rest) {
            corners.add(minus(corner, centre));
        }
        move = vector(d[0], d[1], d[2]);
        BigDecimal radius = new BigDecimal(sphere[3]).add(new BigDecimal(kindB == LeafKind.SPHERE ? b[3] : 0));
        square = radius.pow(2);
        core = HullMotion.of(List.<BigDecimal[]>of(centre), rest, d);
    }

    /** Whether the two touch anywhere from time 0 to {@code time}. */
    public boolean meetsBy(BigDecimal time) {
        if (core != null && core.compareTo(time) <= 0) {
            return true;
        }
        List<BigDecimal[]> swept = new ArrayList<>(corners);
        for (BigDecimal[] corner : corners) {
            BigDecimal[] moved = corner.clone();
            for (int k = 0; k < 3; k++) {
                moved[k] = moved[k].subtract(move[k].multiply(time));
            }
            swept.add(moved);
        }
        for (int i = 0; i < swept.size(); i++) {
            for (int j = 0; j <= i; j++) {
                if (isNearSegment(swept.get(i), swept.get(j))) {
                    return true;
                }
                for (int k = 0; k < j; k++) {
                    if (isNearInside(swept.get(i), swept.get(j), swept.get(k))) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private boolean isNearSegment(BigDecimal[] p, BigDecimal[] q) {
        BigDecimal[] edge = minus(q, p);
        BigDecimal length = dot(edge, edge);
        BigDecimal share = dot(p, edge).negate();
        if (share.signum() <= 0 || share.compareTo(length) >= 0) {
            return dot(p, p).min(dot(q, q)).compareTo(square) <= 0;
        }
        BigDecimal[] aside = cross(p, edge);
        return dot(aside, aside).compareTo(square.multiply(length)) <= 0;
    }

    /** Whether a triangle is near the origin, with the foot inside it. */
    private boolean isNearInside(BigDecimal[] p, BigDecimal[] q, BigDecimal[] r) {
        BigDecimal[] normal = cross(minus(q, p), minus(r, p));
        BigDecimal length = dot(normal, normal);
        return length.signum() > 0
                && dot(normal, p).pow(2).compareTo(square.multiply(length)) <= 0
                && dot(cross(p, q), normal).signum() >= 0
                && dot(cross(q, r), normal).signum() >= 0
                && dot(cross(r, p), normal).signum() >= 0;
    }
}
