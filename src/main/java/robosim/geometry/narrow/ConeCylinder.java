package robosim.geometry.narrow;

import static robosim.geometry.narrow.RayMath.U;

/**
 * The least distance from a cone's apex to a solid cylinder inside the cone: a lower bound that is certain, within
 * 2^-40 of the truth (seen so down to grazes of 10^-13 of the radius, where the direction that proves the most is found
 * and weighed in pairs of doubles). Apart only where a plane proves it by more than 24u of the coordinates.
 *
 * <p>The distance is the largest {@code k(n) / s(n)} over directions n, where {@code k(n)} is the least n.x of the
 * cylinder and {@code s(n)} the support of the cone's part inside the unit sphere. Where the nearest point of the whole
 * cylinder is outside the cone only {@code n = v + t w} counts, t at least 0: v runs along the cone's border at some
 * angle about its axis, w is the border's outward normal there, and {@code s(n) = 1}. For one angle the best t is in
 * closed form; so is the point x of the cylinder, not beyond the border's tangent plane, that minimises v.x, and the
 * side of the border on which x lies tells on which side the best angle is. That is bisected; every step's
 * {@code k(n)}, less its rounding, is a certain lower bound whatever the step was worth.
 */
final class ConeCylinder {
    /** Halvings of the angle: then it is as good as doubles tell. */
    private static final int STEPS = 60;

    /** The share of the distance that a further halving must be able to add. */
    private static final double ENOUGH = 0x1p-44;

    /** k(v + t w) is a sum of few products of numbers below the extent times 1 + t, each off by a few u. */
    private static final double BOUND_ERROR = 24 * U;

    /** The same in pairs of doubles, of which every step is good to 2^-100 of what goes in. */
    private static final double PAIRS_ERROR = 0x1p-94;

    /** Tried where rounding hides how large the best t is, as the cone all but misses. */
    private static final double GRAZING = 0x1p26;

    /** The share of a golden section, and how many of them; and the largest cotangent for which they are fine enough. */
    private static final double GOLDEN = 0.6180339887498949;

    private static final int SECTIONS = 40;
    private static final double LEAST_LEAN = 1024;

    /** From this t on the best is looked for once more. */
    private static final double STEEP = 256;

    private static final int NORMAL = Cone.FREE;
    private static final int CENTER = NORMAL + 3;
    private static final int BODY = CENTER + 3;
    private static final int CROSS = BODY + 3;
    private static final int SUPPORT = CROSS + 3;
    private static final int LEAST = SUPPORT + 1;
    private static final int PART = LEAST + 1;
    private static final int TEMPORARY = PART + 1;

    private Cone cone = new Cone();
    private double extent;
    private double radius;
    private double half;

    // The centre seen from the apex, and the unit axis, in the frame of the cone: its axis first.
    private double cx;
    private double cy;
    private double cz;
    private double ax;
    private double ay;
    private double az;

    // The other two axes of that frame in the world.
    private double ex;
    private double ey;
    private double ez;
    private double fx;
    private double fy;
    private double fz;

    // What the last angle told: the best certain bound, whether the cylinder is proved apart, where x lies aside of the
    // border, and how fast that changes the bound.
    private double best;
    private boolean isApart;
    private double aside;
    private double rate;

    // Its best t and what k(n) is there, rounding and all.
    private double value;
    private double share;
    private double lastY;
    private double lastZ;

    // The direction with the greatest k(n) of all that were looked at, without regard to rounding.
    private double bestValue;
    private double bestShare;
    private double bestY;
    private double bestZ;

    /** The distance; the apex is outside the cylinder. */
    double distance(Cone cone, double[] b, int j, double axisX, double axisY, double axisZ) {
        this.cone = cone;
        double mx = b[j] - cone.ox;
        double my = b[j + 1] - cone.oy;
        double mz = b[j + 2] - cone.oz;
        double length = RayMath.length(axisX, axisY, axisZ);
        double px = axisX / length;
        double py = axisY / length;
        double pz = axisZ / length;
        radius = b[j + 3];
        half = b[j + 4] * length;
        // The differences are off by half an ulp of their own, however far from the origin the two are.
        extent = RayMath.largest(mx, my, mz) + radius + half;
        // The nearest point of the whole cylinder.
        double middle = mx * px + my * py + mz * pz;
        double along = Math.max(-half, Math.min(half, -middle));
        double wx = middle * px - mx;
        double wy = middle * py - my;
        double wz = middle * pz - mz;
        double away = RayMath.length(wx, wy, wz);
        double inward = away > radius ? radius / away : 1;
        double nx = mx + along * px + inward * wx;
        double ny = my + along * py + inward * wy;
        double nz = mz + along * pz + inward * wz;
        best = Math.max(0, RayMath.length(nx, ny, nz) - BOUND_ERROR * extent);
        if (cone.depth(nx, ny, nz) >= 0) {
            return best;
        }
        frame(mx, my, mz, px, py, pz);
        if (search() && best > 0) {
            polish(b, j, axisX, axisY, axisZ, bestShare, bestY, bestZ);
            polish(b, j, axisX, axisY, axisZ, share, lastY, lastZ);
        }
        return isApart ? Double.POSITIVE_INFINITY : best;
    }

    // A frame with the cone's axis first and the centre in the half plane of the second.
    private void frame(double mx, double my, double mz, double px, double py, double pz) {
        cx = mx * cone.ux + my * cone.uy + mz * cone.uz;
        ex = mx - cx * cone.ux;
        ey = my - cx * cone.uy;
        ez = mz - cx * cone.uz;
        double size = RayMath.length(ex, ey, ez);
        if (!(size > 0x1p-40 * extent)) {
            // On the axis to speak of: any direction across it.
            boolean isX = Math.abs(cone.ux) < 0.7;
            ex = (isX ? 1 : 0) - (isX ? cone.ux : cone.uy) * cone.ux;
            ey = (isX ? 0 : 1) - (isX ? cone.ux : cone.uy) * cone.uy;
            ez = -(isX ? cone.ux : cone.uy) * cone.uz;
            size = RayMath.length(ex, ey, ez);
        }
        ex /= size;
        ey /= size;
        ez /= size;
        // Once more: what cancelled above has left it a little askew.
        double askew = ex * cone.ux + ey * cone.uy + ez * cone.uz;
        ex -= askew * cone.ux;
        ey -= askew * cone.uy;
        ez -= askew * cone.uz;
        size = RayMath.length(ex, ey, ez);
        ex /= size;
        ey /= size;
        ez /= size;
        fx = cone.uy * ez - cone.uz * ey;
        fy = cone.uz * ex - cone.ux * ez;
        fz = cone.ux * ey - cone.uy * ex;
        cy = mx * ex + my * ey + mz * ez;
        cz = mx * fx + my * fy + mz * fz;
        ax = px * cone.ux + py * cone.uy + pz * cone.uz;
        ay = px * ex + py * ey + pz * ez;
        az = px * fx + py * fy + pz * fz;
    }

    // Whether the bounds are worth another look: they are not where the cylinder is apart.
    private boolean search() {
        bestValue = Double.NEGATIVE_INFINITY;
        double alongAxis = radius * Math.sqrt(Math.max(0, (1 - ax) * (1 + ax))) + half * Math.abs(ax);
        isApart = cx + alongAxis < -BOUND_ERROR * extent;
        if (isApart) {
            return false;
        }
        look(1, 0);
        if (isApart) {
            return false;
        }
        double fromY = 1;
        double fromZ = 0;
        double toY = 1;
        double toZ = 0;
        // From the first angle once around to itself; the halves of that, and of them, are no sums of their ends.
        double turn = aside >= 0 ? 1 : -1;
        double midY = -1;
        double midZ = 0;
        double width = 2 * Math.PI;
        double fromValue = value;
        for (int i = 0; i < STEPS; i++) {
            look(midY, midZ);
            if (isApart) {
                return false;
            }
            width /= 2;
            if (Math.abs(aside) * rate * width <= ENOUGH * best && i > 2) {
                break;
            }
            // What is at least as good as the beginning is all ahead of it without a gap: a worse place is beyond.
            boolean isAhead = aside * turn >= 0 && value >= fromValue;
            if (isAhead) {
                fromValue = value;
                fromY = midY;
                fromZ = midZ;
            } else {
                toY = midY;
                toZ = midZ;
            }
            if (i == 0) {
                midY = 0;
                midZ = isAhead ? -turn : turn;
            } else {
                double y = fromY + toY;
                double z = fromZ + toZ;
                double size = Math.sqrt(y * y + z * z);
                midY = y / size;
                midZ = z / size;
            }
        }
        isApart = cx - alongAxis < 0 && isApartAcross();
        return !isApart;
    }

    /**
     * What lies partly behind the apex may be apart by no plane along the border, but by one that leans away from it:
     * with the normal n = (-1, y, z) in the frame of the cone, y and z in a disc with the cotangent of the half angle for
     * its radius. There k(n) is concave: its top is looked for by golden sections, and any place above 0 is proof.
     */
    private boolean isApartAcross() {
        double reach = Math.min(cone.cos / cone.sin, LEAST_LEAN);
        double low = -reach;
        double high = reach;
        double left = high - GOLDEN * (high - low);
        double right = low + GOLDEN * (high - low);
        double atLeft = topAlong(left, reach);
        double atRight = topAlong(right, reach);
        for (int i = 0; i < SECTIONS && !isApart; i++) {
            if (atLeft >= atRight) {
                high = right;
                right = left;
                atRight = atLeft;
                left = high - GOLDEN * (high - low);
                atLeft = topAlong(left, reach);
            } else {
                low = left;
                left = right;
                atLeft = atRight;
                right = low + GOLDEN * (high - low);
                atRight = topAlong(right, reach);
            }
        }
        return isApart;
    }

    /** The greatest k(-1, y, z) over the z of the disc; apart where it is certainly above 0. */
    private double topAlong(double y, double reach) {
        double high = Math.sqrt(Math.max(0, (reach - y) * (reach + y)));
        double low = -high;
        double left = high - GOLDEN * (high - low);
        double right = low + GOLDEN * (high - low);
        double atLeft = behind(y, left);
        double atRight = behind(y, right);
        for (int i = 0; i < SECTIONS && !isApart; i++) {
            if (atLeft >= atRight) {
                high = right;
                right = left;
                atRight = atLeft;
                left = high - GOLDEN * (high - low);
                atLeft = behind(y, left);
            } else {
                low = left;
                left = right;
                atLeft = atRight;
                right = low + GOLDEN * (high - low);
                atRight = behind(y, right);
            }
        }
        return Math.max(atLeft, atRight);
    }

    private double behind(double y, double z) {
        double along = y * ay + z * az - ax;
        double across = RayMath.length(y * az - z * ay, z * ax + az, -ay - y * ax);
        double least = y * cy + z * cz - cx - radius * across - half * Math.abs(along);
        isApart |= least > BOUND_ERROR * extent * (1 + Math.abs(y) + Math.abs(z));
        return least;
    }

    // A large t comes out of a difference in which most cancels: it is looked for by parabolas, closer and closer.
    private void polish(double[] b, int j, double axisX, double axisY, double axisZ, double t, double y, double z) {
        double value = inPairs(b, j, axisX, axisY, axisZ, t, y, z);
        double center = t;
        double width = t > STEEP ? 0.5 : 0;
        while (width > 0x1p-12) {
            double less = inPairs(b, j, axisX, axisY, axisZ, center * (1 - width), y, z);
            double more = inPairs(b, j, axisX, axisY, axisZ, center * (1 + width), y, z);
            double bend = (value - less) + (value - more);
            double step = bend > 0 ? (more - less) / (2 * bend) : more > less ? 1 : -1;
            double next = center * (1 + width * Math.max(-1, Math.min(1, step)));
            double there = inPairs(b, j, axisX, axisY, axisZ, next, y, z);
            if (there > value) {
                value = there;
                center = next;
            }
            width *= Math.abs(step) < 1 ? 0.25 : 0.75;
        }
    }

    /**
     * The bound {@code k(n) / s(n)} once more in pairs of doubles, for the direction v + t w at an angle as rounded: where
     * the cone grazes the cylinder t is large, and of k(n) little is left.
     */
    private double inPairs(double[] b, int j, double axisX, double axisY, double axisZ, double t, double y, double z) {
        double across = cone.sin + t * cone.cos;
        double ahead = cone.cos - t * cone.sin;
        Pairs p = cone.pairs;
        p.set(NORMAL, ahead * cone.ux + across * (y * ex + z * fx));
        p.set(NORMAL + 1, ahead * cone.uy + across * (y * ey + z * fy));
        p.set(NORMAL + 2, ahead * cone.uz + across * (y * ez + z * fz));
        p.difference(CENTER, b[j], cone.ox);
        p.difference(CENTER + 1, b[j + 1], cone.oy);
        p.difference(CENTER + 2, b[j + 2], cone.oz);
        p.set(BODY, axisX);
        p.set(BODY + 1, axisY);
        p.set(BODY + 2, axisZ);
        double value = ratio(p, b[j + 4], t);
        // Where the best n is square to the axis rounding must not make it reach along the axis.
        p.dot(PART, NORMAL, BODY, TEMPORARY);
        p.dot(LEAST, BODY, BODY, TEMPORARY);
        p.divide(PART, PART, LEAST);
        p.negate(PART);
        p.advance(NORMAL, NORMAL, PART, BODY, TEMPORARY);
        return Math.max(value, ratio(p, b[j + 4], t));
    }

    private double ratio(Pairs p, double halfHeight, double t) {
        // s(n): along the border's direction that is nearest to n; n itself is never inside the cone.
        p.dot(SUPPORT, NORMAL, Cone.AXIS, TEMPORARY);
        p.multiply(SUPPORT, SUPPORT, Cone.COS);
        p.cross(CROSS, NORMAL, Cone.AXIS, TEMPORARY);
        p.dot(LEAST, CROSS, CROSS, TEMPORARY);
        p.root(LEAST, LEAST);
        p.multiply(LEAST, LEAST, Cone.SIN);
        p.add(SUPPORT, SUPPORT, LEAST);
        // k(n) = n.m - r |n x a| / |a| - h |n.a|
        p.cross(CROSS, NORMAL, BODY, TEMPORARY);
        p.dot(PART, CROSS, CROSS, TEMPORARY);
        p.dot(LEAST, BODY, BODY, TEMPORARY);
        p.divide(PART, PART, LEAST);
        p.root(PART, PART);
        p.multiply(PART, PART, radius);
        p.dot(LEAST, NORMAL, CENTER, TEMPORARY);
        p.subtract(LEAST, LEAST, PART);
        p.dot(PART, NORMAL, BODY, TEMPORARY);
        p.multiply(PART, PART, p.get(PART) < 0 ? -halfHeight : halfHeight);
        p.subtract(LEAST, LEAST, PART);
        p.divide(LEAST, LEAST, SUPPORT);
        double support = p.get(SUPPORT);
        if (support > 0) {
            double error = PAIRS_ERROR * extent * (1 + t) / support;
            best = Math.max(best, Math.nextDown(p.get(LEAST) - error));
        }
        return p.get(LEAST);
    }

    /** What the border at the angle with this cosine and sine tells. */
    private void look(double y, double z) {
        lastY = y;
        lastZ = z;
        double c = cone.cos;
        double s = cone.sin;
        // Along the border, outward, and around: centre and axis in that frame.
        double outwardC = cy * y + cz * z;
        double outwardA = ay * y + az * z;
        double mv = c * cx + s * outwardC;
        double mw = c * outwardC - s * cx;
        double mb = cz * y - cy * z;
        double av = c * ax + s * outwardA;
        double aw = c * outwardA - s * ax;
        double ab = az * y - ay * z;
        double kappa = Math.sqrt(av * av + ab * ab);
        if (mw - radius * kappa - half * Math.abs(aw) > BOUND_ERROR * extent) {
            isApart = true;
            return;
        }
        double fv = kappa > 0 ? av / kappa : 1;
        double gv = kappa > 0 ? -ab / kappa : 0;
        double t = bound(0, mv, mw, av, aw, ab, 0);
        t = bound(-av / aw, mv, mw, av, aw, ab, t);
        t = bound(stationary(mw - half * aw, kappa, av * aw, gv), mv, mw, av, aw, ab, t);
        t = bound(stationary(mw + half * aw, kappa, av * aw, gv), mv, mw, av, aw, ab, t);
        rate = s + t * c;
        value = least(t, mv, mw, av, aw, ab);
        share = t;
        if (value > bestValue) {
            bestValue = value;
            bestShare = t;
            bestY = y;
            bestZ = z;
        }
        aside = t == 0 ? freePoint(mb, av, aw, ab) : section(mv, mw, mb, aw, kappa, fv, gv);
    }

    // Where k(v + t w) is stationary beside its kink: the radius's part has the slope that the rest has.
    private double stationary(double slope, double kappa, double product, double gv) {
        double square = (radius * kappa - slope) * (radius * kappa + slope);
        if (slope > 0 && !(square > 0)) {
            return GRAZING;
        }
        return slope * Math.abs(gv) / (kappa * Math.sqrt(square)) + product / (kappa * kappa);
    }

    // Takes the bound at t into account where t is a number; answers the t of the better of it and another.
    private double bound(double t, double mv, double mw, double av, double aw, double ab, double other) {
        if (!(t > 0 && t < 0x1p50) && t != 0) {
            return other;
        }
        double value = least(t, mv, mw, av, aw, ab);
        best = Math.max(best, value - BOUND_ERROR * extent * (1 + t));
        return t == 0 || value > least(other, mv, mw, av, aw, ab) ? t : other;
    }

    private double least(double t, double mv, double mw, double av, double aw, double ab) {
        double along = av + t * aw;
        double turn = aw - t * av;
        double across = Math.sqrt((1 + t * t) * ab * ab + turn * turn);
        return mv + t * mw - radius * across - half * Math.abs(along);
    }

    // The point of the cylinder with the least v.x is not beyond the tangent plane: where it lies around the border.
    private double freePoint(double mb, double av, double aw, double ab) {
        // v less its part along the axis, in the frame (v, w, around).
        double qv = aw * aw + ab * ab;
        double qw = -av * aw;
        double qb = -av * ab;
        double size = RayMath.length(qv, qw, qb);
        double inward = size > 0 ? radius / size : 0;
        return mb - (av > 0 ? half : -half) * ab - inward * qb;
    }

    /**
     * Where around the border the point of the tangent plane's section with the least v.x lies. In the plane f runs along
     * the axis's image and g across it; the section is {@code |kappa f - m.a| <= half},
     * {@code (g - m.g)^2 + (aw f - m.k)^2 <= r^2} with {@code k = aw f - kappa w}.
     */
    private double section(double mv, double mw, double mb, double aw, double kappa, double fv, double gv) {
        // f = (fv, -gv) and g = (gv, fv) in (v, around).
        double mf = mv * fv - mb * gv;
        double mg = mv * gv + mb * fv;
        double ma = mf * kappa + mw * aw;
        double mk = aw * mf - kappa * mw;
        double low = Double.NEGATIVE_INFINITY;
        double high = Double.POSITIVE_INFINITY;
        if (kappa > 0) {
            low = (ma - half) / kappa;
            high = (ma + half) / kappa;
        }
        double steep = Math.abs(aw);
        if (steep > 0) {
            double center = mk / aw;
            low = Math.max(low, center - radius / steep);
            high = Math.min(high, center + radius / steep);
        }
        double norm = Math.sqrt(fv * fv + gv * gv * aw * aw);
        double f = fv > 0 ? low : high;
        if (steep > 0 && norm > 0) {
            double free = (mk - Math.copySign(radius, aw) * fv / norm) / aw;
            f = Math.max(low, Math.min(high, free));
        }
        double off = aw * f - mk;
        double chord = Math.sqrt(Math.max(0, (radius - off) * (radius + off)));
        if (gv == 0) {
            // All of the chord is as near: the border passes through it or on one side.
            double g = Math.max(mg - chord, Math.min(mg + chord, 0));
            return g * fv;
        }
        double g = mg - Math.copySign(chord, gv);
        return g * fv - f * gv;
    }
}
