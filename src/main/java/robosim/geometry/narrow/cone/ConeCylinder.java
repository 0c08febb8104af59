package robosim.geometry.narrow.cone;

import static robosim.geometry.exact.VectorMath.U;

import robosim.geometry.exact.VectorMath;

/**
 * The least distance from a cone's apex to a solid cylinder inside the cone, between two ends that are proved.
 *
 * <p>The nearest point that cone and cylinder have in common is unique. It is the cylinder's own nearest point where the cone
 * holds that; else it lies on the cone's border with the nearer cap, in closed form, where the cap holds the nearest point
 * of its plane in the cone; else with the mantle ({@link ConeCylinderMantle}), where that is between the caps; else with the
 * rim of the cap beyond which the mantle's lies ({@link ConeCylinderCap}). All this is in doubles, and what it led to is
 * then proved in pairs of doubles from both sides ({@link ConeCylinderBracket}): the least distance is the largest
 * {@code k(n) / s(n)} over directions n. What rounding led astray is not as narrow as it should be, and all the rest is
 * tried.
 *
 * <p>Silent only where a direction proves it: where its bound is beyond the farthest point of the cylinder.
 */
final class ConeCylinder {
    /** What is this share of a vector's length outside of a cone or within is so whatever was rounded. */
    private static final double DOUBT = 32 * U;

    /** So little does the cone's border rise along a mantle that is better searched around. */
    private static final double LEVEL = 0x1p-12;

    private final ConeCylinderFrame frame = new ConeCylinderFrame();
    private final ConeCylinderMantle mantle = new ConeCylinderMantle();
    private final ConeCylinderCap cap = new ConeCylinderCap();
    private final ConeCylinderBracket bracket = new ConeCylinderBracket();

    /** The distance, not above the truth; infinite where nothing is heard. The apex is outside the cylinder. */
    double distance(Cone cone, double[] b, int j, double axisX, double axisY, double axisZ) {
        frame.set(cone, b, j, axisX, axisY, axisZ);
        bracket.start(frame);
        if (!isAlone() && !isTouched()) {
            tryAll();
        }
        return bracket.isSilent() ? Double.POSITIVE_INFINITY : bracket.low();
    }

    /** The other end of the bracket that {@link #distance} answered the lower end of. */
    double upper() {
        return bracket.isSilent() ? Double.POSITIVE_INFINITY : bracket.high();
    }

    /** Whether the cylinder's own nearest point tells all: in the cone, or so far behind that a plane is between. */
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

    /** Whether the cone's border with the one part of the cylinder that it should be tells all. */
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

    // The direction that points most against the cone of those between the cap's and the mantle's, and a little
    // between.
    private void corner() {
        double along = Math.max(0, -frame.ua);
        double away = Math.max(0, -frame.up);
        double size = VectorMath.legs(along, away);
        double slack = size - frame.cone.sin;
        if (slack > 0) {
            bracket.corner(along / size + slack / 4, away / size + slack / 4);
        }
    }

    /** Near where one part of the cylinder gives way to another the wrong one may have been taken. */
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
