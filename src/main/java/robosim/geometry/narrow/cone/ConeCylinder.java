package robosim.geometry.narrow.cone;

import static robosim.geometry.exact.VectorMath.U;

import robosim.geometry.exact.VectorMath;

/**
 * A bracket, proved at both ends, of the distance from a cone's apex to the part of a solid cylinder inside the cone.
 *
 * <p>The nearest common point of cone and cylinder is unique. It is the cylinder's own nearest point if the cone
 * contains that. Otherwise it lies on the cone's border, and there on the nearer cap, in closed form, if the cap
 * contains the nearest point of its plane in the cone; else on the mantle ({@link ConeCylinderMantle}), if between the
 * caps; else on the rim of the cap beyond which the mantle's point lies ({@link ConeCylinderCap}). All this is in
 * doubles. The result is then proved in pairs of doubles from both sides ({@link ConeCylinderBracket}): the distance is
 * the maximum of {@code k(n) / s(n)} over directions n. If rounding has left the bracket too wide, all other cases are
 * tried.
 *
 * <p>Reports no hit only if a direction proves it: if its bound is beyond the farthest point of the cylinder.
 */
final class ConeCylinder {
    /** A point outside or inside a cone by more than this share of its length is so despite all rounding. */
    private static final double DOUBT = 32 * U;

    /** Where the cone's border rises along a mantle by less than this, it is searched around the mantle instead. */
    private static final double LEVEL = 0x1p-12;

    private final ConeCylinderFrame frame = new ConeCylinderFrame();
    private final ConeCylinderMantle mantle = new ConeCylinderMantle();
    private final ConeCylinderCap cap = new ConeCylinderCap();
    private final ConeCylinderBracket bracket = new ConeCylinderBracket();

    /** A lower bound of the distance; infinite on a miss. The apex must be outside the cylinder. */
    double distance(Cone cone, double[] b, int j, double axisX, double axisY, double axisZ) {
        frame.set(cone, b, j, axisX, axisY, axisZ);
        bracket.start(frame);
        if (!isAlone() && !isTouched()) {
            tryAll();
        }
        return bracket.isSilent() ? Double.POSITIVE_INFINITY : bracket.low();
    }

    /** The upper end of the bracket whose lower end {@link #distance} returned. */
    double upper() {
        return bracket.isSilent() ? Double.POSITIVE_INFINITY : bracket.high();
    }

    /** Whether the cylinder's own nearest point decides: in the cone, or so far behind that a plane separates them. */
    private boolean isAlone() {
        double y = Math.max(0, frame.near);
        double x = Math.max(0, frame.gap);
        double size = VectorMath.legs(y, x);
        double outside = frame.outside(y, x, 0);
        double ahead = y * frame.ua + x * frame.up;
        double doubt = DOUBT * size;
        bracket.take(size * (1 - 8 * U), Double.POSITIVE_INFINITY);
        if (outside < -doubt) {
            bracket.take(0, size * (1 + 8 * U));
            return true;
        }
        if (ahead < 0 && ahead + frame.cone.sin * size < -doubt) {
            bracket.take(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
            return true;
        }
        if (outside <= doubt || ahead < 0) {
            bracket.nearest();
        }
        return bracket.isDone();
    }

    /** Whether the cone's border with the expected part of the cylinder decides. */
    private boolean isTouched() {
        if (frame.near > 0) {
            if (cap.isBehind(frame, frame.near)) {
                bracket.axis();
                return bracket.isDone();
            }
            if (cap.holdsFoot(frame, frame.near)) {
                bracket.cap(frame.near, cap.p, cap.q);
                return bracket.isDone();
            }
        }
        boolean isFar = false;
        if (frame.gap > 0) {
            mantle.solve(frame);
            if (mantle.isMissed || (frame.near <= mantle.height && mantle.height <= frame.far)) {
                side(LEVEL);
                return bracket.isDone();
            }
            isFar = mantle.height > frame.far;
        }
        rim(isFar);
        return bracket.isDone();
    }

    private void side(double level) {
        if (mantle.isMissed) {
            bracket.edge(mantle.edgeA, mantle.edgeP, mantle.edgeQ);
            if (!bracket.isDone()) {
                bracket.across(mantle.betweenP, mantle.betweenQ);
            }
            if (!bracket.isDone()) {
                bracket.away();
            }
        } else {
            bracket.mantle(mantle.height, -mantle.cos, mantle.sin, level);
        }
    }

    private void rim(boolean isFar) {
        double height = isFar ? frame.far : frame.near;
        if (cap.isBehind(frame, height)) {
            bracket.edge(height < 0 ? -1 : 1, 0, 0);
            if (bracket.isDone()) {
                return;
            }
        }
        cap.solve(frame, height);
        if (cap.isMissed) {
            bracket.edge(cap.height, cap.p, cap.q);
            if (!bracket.isDone()) {
                bracket.edge(cap.height, cap.betweenP, cap.betweenQ);
            }
            if (bracket.isDone()) {
                return;
            }
        }
        bracket.rim(isFar, cap.p - frame.away, cap.q);
        if (!bracket.isDone()) {
            bracket.grazedRim(isFar, cap.p - frame.away, cap.q);
        }
    }

    // Among the directions between the cap's and the mantle's, the one most opposed to the cone, moved slightly inward.
    private void corner() {
        double along = Math.max(0, -frame.ua);
        double away = Math.max(0, -frame.up);
        double size = VectorMath.legs(along, away);
        double slack = size - frame.cone.sin;
        if (slack > 0) {
            bracket.corner(along / size + slack / 4, away / size + slack / 4);
        }
    }

    /** Near the boundary of two parts of the cylinder, the wrong one may have been chosen. */
    private void tryAll() {
        bracket.nearest();
        if (frame.near > 0 && !bracket.isDone()) {
            bracket.axis();
        }
        if (frame.near >= 0 && frame.gap > 0 && !bracket.isDone()) {
            corner();
        }
        if (frame.gap > 0 && !bracket.isDone()) {
            bracket.away();
            mantle.solve(frame);
            side(LEVEL);
            if (!bracket.isDone()) {
                side(Double.POSITIVE_INFINITY);
            }
        }
        if (!bracket.isDone()) {
            rim(false);
            bracket.edge(cap.height, cap.p, cap.q);
        }
        if (!bracket.isDone()) {
            rim(true);
            bracket.edge(cap.height, cap.p, cap.q);
        }
        if (frame.near > 0 && !bracket.isDone() && !cap.isBehind(frame, frame.near)) {
            cap.holdsFoot(frame, frame.near);
            bracket.cap(frame.near, cap.p, cap.q);
        }
    }
}
