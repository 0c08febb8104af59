package robosim.geometry.narrow.cone;

import robosim.geometry.exact.VectorMath;

/**
 * Narrows the bounds of the distance to a cylinder in a cone: tries directions and points where the nearest point of the
 * cylinder may be.
 */
final class ConeCylinderBracket extends ConeCylinderBounds {
    /** Points are placed this deep inside the cone, as a share of the extent: deeper than {@link #ERROR}. */
    private static final double DEPTH = 0x1p-92;

    private static final int STEPS = 12;

    /**
     * The cylinder's own nearest point: a direction, a point if the cone contains it, and a plane touching the cone.
     */
    void nearest() {
        for (int k = 0; k < 3; k++) {
            p.set(POINT + k, 0);
        }
        if (f.near > 0) {
            p.advance(POINT, POINT, ConeCylinderFrame.NEAR, ConeCylinderFrame.BODY, TEMPORARY);
        }
        if (f.gap > 0) {
            p.set(PART, -f.radius);
            p.add(PART, ConeCylinderFrame.AWAY, PART);
            p.divide(PART, PART, ConeCylinderFrame.AWAY);
            p.advance(POINT, POINT, PART, ConeCylinderFrame.ACROSS, TEMPORARY);
        }
        locate();
        point();
        copy(NORMAL, POINT);
        direction();
        copy(NORMAL, OUTWARD);
        direction();
    }

    /** The direction of the axis. */
    void axis() {
        copy(NORMAL, ConeCylinderFrame.BODY);
        direction();
    }

    /** The direction away from the axis. */
    void away() {
        copy(NORMAL, ConeCylinderFrame.ACROSS);
        direction();
    }

    /** A direction perpendicular to the axis: if the apex is almost on the mantle, no other can prove a miss. */
    void across(double p0, double q0) {
        f.put(NORMAL, 0, p0, q0);
        p.dot(PART, NORMAL, ConeCylinderFrame.BODY, TEMPORARY);
        p.negate(PART);
        p.advance(NORMAL, NORMAL, PART, ConeCylinderFrame.BODY, TEMPORARY);
        direction();
    }

    /**
     * The combination of the directions along the axis and away from it with these weights. If both are positive and
     * the cone is behind, or almost behind, both the lower cap's plane and the mantle's nearest plane, it proves a
     * miss.
     */
    void corner(double along, double away) {
        p.set(PART, along);
        for (int k = 0; k < 3; k++) {
            p.multiply(NORMAL + k, ConeCylinderFrame.BODY + k, PART);
        }
        p.set(PART, away);
        p.divide(PART, PART, ConeCylinderFrame.AWAY);
        p.advance(NORMAL, NORMAL, PART, ConeCylinderFrame.ACROSS, TEMPORARY);
        direction();
    }

    /**
     * The plane that touches the cone along the line of its border nearest to a vector of the frame, moved around the
     * cone to where it is farthest from the cylinder.
     */
    void edge(double along, double p0, double q0) {
        f.put(POINT, along, p0, q0);
        locate();
        double last = Double.NaN;
        double way = 0;
        for (int i = 0; i < STEPS; i++) {
            copy(NORMAL, OUTWARD);
            direction();
            p.cross(AROUND, Cone.AXIS, SIDE, TEMPORARY);
            lowest();
            p.dot(PART, POINT, AROUND, TEMPORARY);
            double slope = p.get(PART);
            double next = i == 0 ? Math.copySign(0x1p-40, slope) : -slope * way / (slope - last);
            if (isSilent() || !(Math.abs(next) < 0.25) || next == 0) {
                return;
            }
            last = slope;
            way = next;
            p.set(PART, next);
            p.advance(SIDE, SIDE, PART, AROUND, TEMPORARY);
            p.dot(PART, SIDE, SIDE, TEMPORARY);
            p.root(PART, PART);
            for (int k = 0; k < 3; k++) {
                p.divide(SIDE + k, SIDE + k, PART);
            }
            outward();
        }
    }

    // POINT = the point of the cylinder with the minimum along NORMAL.
    private void lowest() {
        p.dot(PART, NORMAL, ConeCylinderFrame.BODY, TEMPORARY);
        boolean isUp = p.get(PART) > 0;
        p.negate(PART);
        p.advance(RADIAL, NORMAL, PART, ConeCylinderFrame.BODY, TEMPORARY);
        p.dot(REST, RADIAL, RADIAL, TEMPORARY);
        p.root(REST, REST);
        p.set(PART, -f.radius);
        if (p.get(REST) > 0) {
            p.divide(PART, PART, REST);
        }
        p.advance(POINT, ConeCylinderFrame.CENTER, PART, RADIAL, TEMPORARY);
        p.set(REST, isUp ? -1 : 1);
        p.multiply(PART, ConeCylinderFrame.HALF, REST);
        p.advance(POINT, POINT, PART, ConeCylinderFrame.BODY, TEMPORARY);
    }

    /** The lower cap's plane, if the cap contains the plane's nearest point in the cone. */
    void cap(double along, double p0, double q0) {
        axis();
        f.put(POINT, along, p0, q0);
        // Moved exactly into the plane: the component along the plane's normal is replaced by the cap's height.
        p.dot(PART, POINT, ConeCylinderFrame.BODY, TEMPORARY);
        p.subtract(PART, ConeCylinderFrame.NEAR, PART);
        p.advance(POINT, POINT, PART, ConeCylinderFrame.BODY, TEMPORARY);
        for (int i = 0; i < STEPS; i++) {
            locate();
            if (isInCap()) {
                point();
            }
            if (isDone()) {
                return;
            }
            // Into the cone within the plane, in the steepest direction.
            p.dot(PART, OUTWARD, ConeCylinderFrame.BODY, TEMPORARY);
            p.negate(PART);
            copy(RADIAL, OUTWARD);
            p.advance(RADIAL, RADIAL, PART, ConeCylinderFrame.BODY, TEMPORARY);
            p.dot(PART, RADIAL, RADIAL, TEMPORARY);
            if (!(p.get(PART) > 0)) {
                return;
            }
            p.set(REST, DEPTH * f.extent);
            p.add(REST, LATERAL, REST);
            p.divide(PART, REST, PART);
            p.negate(PART);
            p.advance(POINT, POINT, PART, RADIAL, TEMPORARY);
        }
    }

    private boolean isInCap() {
        for (int k = 0; k < 3; k++) {
            p.subtract(SIDE + k, POINT + k, ConeCylinderFrame.CENTER + k);
        }
        p.cross(AROUND, SIDE, ConeCylinderFrame.BODY, TEMPORARY);
        p.dot(PART, AROUND, AROUND, TEMPORARY);
        p.set(REST, f.radius);
        p.multiply(REST, REST, f.radius);
        p.subtract(PART, REST, PART);
        return p.get(PART) >= 0;
    }

    /** A point of a rim near a point around it, moved to the cone's border. */
    void rim(boolean isFar, double p0, double q0) {
        int height = isFar ? ConeCylinderFrame.FAR : ConeCylinderFrame.NEAR;
        p.set(HEIGHT, p.get(height), p.rest(height));
        radial(p0, q0);
        toBorder(STEPS);
    }

    /**
     * The same where the rim only grazes the cone, and doubles cannot distinguish where it enters from where it leaves.
     * The point is first moved to where it is deepest, then from outside to the border on the apex's side.
     */
    void grazedRim(boolean isFar, double p0, double q0) {
        int height = isFar ? ConeCylinderFrame.FAR : ConeCylinderFrame.NEAR;
        p.set(HEIGHT, p.get(height), p.rest(height));
        radial(p0, q0);
        double bend = 0;
        double last = Double.NaN;
        double way = 0x1p-30;
        for (int i = 0; i < STEPS; i++) {
            onMantle();
            p.dot(PART, OUTWARD, AROUND, TEMPORARY);
            p.multiply(PART, PART, f.radius);
            double rate = p.get(PART);
            if (i > 0) {
                double bent = (rate - last) / way;
                bend = bent > 0 ? bent : bend;
                way = -rate / bend;
                if (!(Math.abs(way) < 0.5) || Math.abs(way) < 0x1p-90) {
                    break;
                }
            }
            last = rate;
            p.set(PART, way);
            turn();
        }
        onMantle();
        p.dot(PART, POINT, AROUND, TEMPORARY);
        double depth = -p.get(LATERAL);
        double aside = 2 * Math.sqrt(2 * depth / bend);
        if (depth > 0 && aside < 0.5) {
            p.set(PART, Math.copySign(aside, -p.get(PART)));
            turn();
            toBorder(2 * STEPS);
        }
    }

    private void toBorder(int steps) {
        for (int i = 0; i < steps; i++) {
            onMantle();
            // n = v + t w, perpendicular to the rim
            lean(AROUND);
            direction();
            flatten();
            point();
            if (isDone()) {
                return;
            }
            p.dot(PART, OUTWARD, AROUND, TEMPORARY);
            p.multiply(PART, PART, f.radius);
            step(PART);
            if (!(Math.abs(p.get(PART)) < 0.5)) {
                return;
            }
            turn();
        }
    }

    /**
     * A point of the mantle near a given height and angle, moved to the cone's border and to where it is nearest. Of
     * the two coordinates, the one along which the border is steeper leads to the border; the other to where n is
     * perpendicular to both.
     *
     * @param level below this slope along the axis, for a cylinder as wide as it is away, the border is sought by angle
     */
    void mantle(double height, double p0, double q0, double level) {
        radial(p0, q0);
        p.set(HEIGHT, height);
        onMantle();
        p.dot(PART, OUTWARD, ConeCylinderFrame.BODY, TEMPORARY);
        p.dot(REST, OUTWARD, AROUND, TEMPORARY);
        boolean isUpwards = Math.abs(p.get(PART)) * f.extent >= level * f.radius * Math.abs(p.get(REST));
        double unit = isUpwards ? low() / f.extent : low();
        double last = Double.NaN;
        double way = 0;
        for (int i = 0; i < STEPS; i++) {
            enter(isUpwards);
            lean(isUpwards ? ConeCylinderFrame.BODY : AROUND);
            p.dot(PART, NORMAL, isUpwards ? AROUND : ConeCylinderFrame.BODY, TEMPORARY);
            double slope = p.get(PART) / VectorMath.length(p.get(NORMAL), p.get(NORMAL + 1), p.get(NORMAL + 2));
            p.dot(PART, NORMAL, ConeCylinderFrame.BODY, TEMPORARY);
            p.negate(PART);
            p.advance(NORMAL, NORMAL, PART, ConeCylinderFrame.BODY, TEMPORARY);
            direction();
            if (isBetween()) {
                point();
            }
            double next = i == 0 ? Math.copySign(0x1p-44 * unit, -slope) : -slope * way / (slope - last);
            if (isDone() || !(Math.abs(next) < unit) || next == 0) {
                return;
            }
            last = slope;
            way = next;
            p.set(PART, next);
            if (isUpwards) {
                turn();
            } else {
                p.add(HEIGHT, HEIGHT, PART);
            }
        }
    }

    // Into the cone by no more than the depth, along the axis or around the mantle.
    private void enter(boolean isUpwards) {
        for (int k = 0; k < 4; k++) {
            onMantle();
            p.dot(PART, OUTWARD, isUpwards ? ConeCylinderFrame.BODY : AROUND, TEMPORARY);
            if (!isUpwards) {
                p.multiply(PART, PART, f.radius);
            }
            step(PART);
            double outside = p.get(LATERAL) / (DEPTH * f.extent);
            double way = Math.abs(p.get(PART));
            if ((outside <= -0.5 && outside > -2) || k == 3 || !(way < (isUpwards ? f.extent : 0.5))) {
                return;
            }
            if (isUpwards) {
                p.add(HEIGHT, HEIGHT, PART);
            } else {
                turn();
            }
        }
    }

    private boolean isBetween() {
        p.subtract(PART, HEIGHT, ConeCylinderFrame.NEAR);
        boolean isAbove = p.get(PART) >= 0;
        p.subtract(PART, ConeCylinderFrame.FAR, HEIGHT);
        return isAbove && p.get(PART) >= 0;
    }

    // The unit vector perpendicular to the axis that is nearest to one of the frame.
    private void radial(double p0, double q0) {
        f.put(RADIAL, 0, p0, q0);
        unit(RADIAL);
    }

    // Rotates about the axis by the small angle in PART.
    private void turn() {
        p.advance(RADIAL, RADIAL, PART, AROUND, TEMPORARY);
        unit(RADIAL);
    }

    private void unit(int vector) {
        p.dot(REST, vector, ConeCylinderFrame.BODY, TEMPORARY);
        p.negate(REST);
        p.advance(vector, vector, REST, ConeCylinderFrame.BODY, TEMPORARY);
        p.dot(REST, vector, vector, TEMPORARY);
        p.root(REST, REST);
        for (int k = 0; k < 3; k++) {
            p.divide(vector + k, vector + k, REST);
        }
    }

    // PART = the step at this rate that brings the point inside the cone by the depth.
    private void step(int rate) {
        p.set(REST, DEPTH * f.extent);
        p.add(REST, LATERAL, REST);
        p.divide(PART, REST, rate);
        p.negate(PART);
    }

    private void onMantle() {
        p.set(REST, f.radius);
        copy(POINT, ConeCylinderFrame.ACROSS);
        p.advance(POINT, POINT, REST, RADIAL, TEMPORARY);
        p.advance(POINT, POINT, HEIGHT, ConeCylinderFrame.BODY, TEMPORARY);
        p.cross(AROUND, ConeCylinderFrame.BODY, RADIAL, TEMPORARY);
        locate();
    }

    // NORMAL = v + t w perpendicular to a vector, v along the border; just the border's normal w unless t is positive.
    private void lean(int vector) {
        for (int k = 0; k < 3; k++) {
            p.multiply(NORMAL + k, SIDE + k, Cone.SIN);
            p.multiply(REST, Cone.AXIS + k, Cone.COS);
            p.add(NORMAL + k, NORMAL + k, REST);
        }
        p.dot(PART, NORMAL, vector, TEMPORARY);
        p.dot(REST, OUTWARD, vector, TEMPORARY);
        p.divide(PART, PART, REST);
        p.negate(PART);
        double t = p.get(PART);
        if (t >= 0 && t < 0x1p60) {
            p.advance(NORMAL, NORMAL, PART, OUTWARD, TEMPORARY);
        } else {
            copy(NORMAL, OUTWARD);
        }
    }

    // Makes the direction exactly perpendicular to the axis, if it is so up to rounding.
    private void flatten() {
        p.dot(PART, NORMAL, ConeCylinderFrame.BODY, TEMPORARY);
        double size = VectorMath.largest(p.get(NORMAL), p.get(NORMAL + 1), p.get(NORMAL + 2));
        if (Math.abs(p.get(PART)) < 0x1p-40 * size) {
            p.negate(PART);
            p.advance(NORMAL, NORMAL, PART, ConeCylinderFrame.BODY, TEMPORARY);
            direction();
        }
    }
}
