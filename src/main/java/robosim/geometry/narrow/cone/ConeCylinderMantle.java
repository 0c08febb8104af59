package robosim.geometry.narrow.cone;

import robosim.geometry.exact.VectorMath;

/**
 * The nearest common point of a cone and the infinite mantle of the cylinder; the apex is outside the mantle.
 *
 * <p>The distance to the part of a line along the mantle that is inside the cone is a convex function of the line's
 * position in the plane across the axis. So its slope at one line decides on which side around the mantle the best line
 * is, which is bracketed by false position and bisection. For the lines visible from the apex the sign of the slope
 * alone decides, as it has a positive product with the direction from the apex. The line's own nearest point is in
 * closed form.
 */
final class ConeCylinderMantle {
    private static final int STEPS = 160;

    /** Replaces a slope of which only the sign is needed. */
    private static final double FLAT = 0x1p-40;

    private ConeCylinderFrame f = new ConeCylinderFrame();

    /** Whether no line meets the cone, according to doubles. */
    boolean isMissed;

    /** The line's position around the mantle: p minus the radius times the cosine, and q. */
    double cos;

    double sin;

    /** The height above the apex of its nearest point in the cone. */
    double height;

    /** On a miss, a direction along the cone's border there: along the axis, away and across; 0 where there is none. */
    double edgeA;

    double edgeP;
    double edgeQ;

    /** On a miss, the normal, away and across, of a plane along the axis halfway between the cone and the mantle. */
    double betweenP;

    double betweenQ;

    // The last line evaluated.
    private double slope;
    private double noise;
    private double rise;

    // The line with the least slope among those that met the cone.
    private double flattest;
    private double bestCos;
    private double bestSin;

    void solve(ConeCylinderFrame frame) {
        f = frame;
        isMissed = false;
        double firstCos = 1;
        double firstSin = 0;
        if (f.uq > f.cone.sin || (f.up < 0 && f.across > f.cone.sin)) {
            // Seen along the axis the cone is a sector; this is the cosine and sine of the angle where it begins.
            double reach = Math.sqrt((f.across - f.cone.sin) * (f.across + f.cone.sin));
            double square = f.across * f.across;
            double c = (f.up * reach + f.uq * f.cone.sin) / square;
            double s = (f.uq * reach - f.up * f.cone.sin) / square;
            double past = f.away * s - f.radius;
            if (!(c > 0) || past > 0) {
                miss(c, s);
                return;
            }
            double sine = f.away * s / f.radius;
            double cosine = Math.sqrt(Math.max(0, -past * (f.radius + f.away * s))) / f.radius;
            firstSin = Math.max(0, sine * c - cosine * s);
            firstCos = Math.max(0, cosine * c + sine * s);
        }
        double lastCos = f.radius / f.away;
        double lastSin = Math.sqrt(f.gap * (f.away + f.radius)) / f.away;
        search(firstCos, firstSin, lastCos, lastSin);
    }

    private void miss(double c, double s) {
        isMissed = true;
        // w = (0, s, -c) is normal to the cone's border along v = (u + sin w) / cos.
        double cosine = f.cone.cos;
        double sine = f.cone.sin;
        edgeA = c > 0 ? f.ua / cosine : 0;
        edgeP = c > 0 ? (f.up + sine * s) / cosine : 0;
        edgeQ = c > 0 ? (f.uq - sine * c) / cosine : 0;
        // Seen along the axis, the mantle ends at this angle, and the cone begins at that of c and s.
        double grazing = Math.sqrt(f.gap * (f.away + f.radius)) / f.away;
        betweenP = f.radius / f.away + s;
        betweenQ = -(grazing + c);
    }

    private void search(double firstCos, double firstSin, double lastCos, double lastSin) {
        flattest = Double.POSITIVE_INFINITY;
        double low = 0;
        double high = 1;
        look(firstCos, firstSin);
        double atLow = slope;
        if (atLow >= 0) {
            take(firstCos, firstSin);
            return;
        }
        look(lastCos, lastSin);
        double atHigh = slope;
        if (atHigh < 0) {
            take(lastCos, lastSin);
            return;
        }
        int side = 0;
        for (int i = 0; i < STEPS && Math.abs(slope) > noise; i++) {
            double share = low + (high - low) * (atLow / (atLow - atHigh));
            if (i % 4 == 3 || !(share > low && share < high)) {
                share = low + (high - low) / 2;
            }
            if (!(share > low && share < high)) {
                break;
            }
            double c = firstCos + share * (lastCos - firstCos);
            double s = firstSin + share * (lastSin - firstSin);
            double size = Math.sqrt(c * c + s * s);
            look(c / size, s / size);
            // An end that stays twice counts half; otherwise false position would never leave it (Illinois algorithm).
            if (slope < 0) {
                low = share;
                atLow = slope;
                atHigh = side < 0 ? 0.5 * atHigh : atHigh;
                side = -1;
            } else {
                high = share;
                atHigh = slope;
                atLow = side > 0 ? 0.5 * atLow : atLow;
                side = 1;
            }
        }
        take(flattest < Double.POSITIVE_INFINITY ? bestCos : cos, flattest < Double.POSITIVE_INFINITY ? bestSin : sin);
    }

    private void take(double c, double s) {
        look(c, s);
        height = f.ua < 0 ? -rise : rise;
    }

    /** A line's nearest height in the cone, and the slope of its distance around the mantle up to a positive factor. */
    private void look(double c, double s) {
        cos = c;
        sin = s;
        double p = f.gap + f.radius * (s * s / (1 + c));
        double q = f.radius * s;
        double base = VectorMath.length(0, p, q);
        double b = (p * f.up + q * f.uq) / base;
        double radial = p * s + q * c;
        double turned = f.up * s + f.uq * c;
        double askew = (p * f.uq - q * f.up) / base;
        double steep = Math.abs(f.ua);
        noise = 0;
        if (b >= f.cone.cos) {
            rise = 0;
            slope = Math.max(steep, FLAT) * radial;
            if (slope < flattest) {
                flattest = slope;
                bestCos = c;
                bestSin = s;
            }
            return;
        }
        // The plane of the apex and the line cuts the cone in a sector; the line crosses its border at this tangent.
        double square = (f.cone.sin - Math.abs(askew)) * (f.cone.sin + Math.abs(askew));
        double reach = Math.sqrt(Math.max(0, square));
        double run = b * f.cone.cos + steep * reach;
        if (square < 0 || !(run > 0)) {
            // a miss: the cone is on the side of its axis
            rise = 0;
            slope = askew > 0 ? -base : base;
            return;
        }
        rise = base * Math.max(0, steep * f.cone.cos - b * reach) / run;
        slope = steep * radial - rise * turned;
        if (Math.abs(slope) < flattest) {
            flattest = Math.abs(slope);
            bestCos = c;
            bestSin = s;
        }
        noise = 2 * VectorMath.U * (steep * radial + rise * Math.abs(turned));
    }
}
