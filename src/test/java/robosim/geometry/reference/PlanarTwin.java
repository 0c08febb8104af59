package robosim.geometry.reference;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.reference.Quantity.Arithmetic;
import robosim.geometry.reference.Quantity.Doubt;
import robosim.geometry.reference.Truth.Form;

/**
 * The projection of a form, from its stored numbers to some 100 bits, and what is true of it: the slow twin of the kernels in
 * the plane. Verdicts are those of exact arithmetic; distances go over all corners and sides, those of an oval over the
 * directions of lines between. An oval is a turned cylinder's projection, or a turned capsule's, whose ends are half discs.
 */
public final class PlanarTwin {
    /** Corners in the order from x to z; of what is round its centre alone. */
    public final Twofold[] x;

    public final Twofold[] z;
    public final boolean isOval;
    public final Twofold radius;

    /** Of an oval: its unit axis, half the straight part, half the thickness of its ends along the axis. */
    public Twofold axisX = Twofold.ONE;

    public Twofold axisZ = Twofold.ZERO;
    public Twofold reach = Twofold.ZERO;
    public Twofold minor = Twofold.ZERO;

    /** What it is drawn along, so that all places on a way are one shape. */
    private Twofold wayX = Twofold.ZERO;

    private Twofold wayZ = Twofold.ZERO;

    private PlanarTwin(int corners, double radius, boolean isOval) {
        x = new Twofold[corners];
        z = new Twofold[corners];
        this.radius = Twofold.of(radius);
        this.isOval = isOval;
    }

    public static PlanarTwin of(Form form, double[] row) {
        return switch (form) {
            case SPHERE, UPRIGHT_CYLINDER, UPRIGHT_CAPSULE -> at(row, row[3], false);
            case CYLINDER, CAPSULE -> oval(form, row);
            case TRIANGLE -> triangle(row);
            case BOX, UPRIGHT_BOX -> box(row);
        };
    }

    private static PlanarTwin at(double[] row, double radius, boolean isOval) {
        PlanarTwin twin = new PlanarTwin(1, radius, isOval);
        twin.x[0] = Twofold.of(row[0]);
        twin.z[0] = Twofold.of(row[2]);
        return twin;
    }

    private static PlanarTwin oval(Form form, double[] row) {
        PlanarTwin twin = at(row, row[3], true);
        Twofold ax = Twofold.of(row[7]);
        Twofold ay = Twofold.of(row[10]);
        Twofold az = Twofold.of(row[13]);
        Twofold flat = ax.times(ax).plus(az.times(az));
        Twofold level = flat.root();
        if (level.signum() > 0) {
            twin.axisX = ax.over(level);
            twin.axisZ = az.over(level);
        }
        twin.reach = level.times(row[4]);
        twin.minor = form == Form.CAPSULE
                ? twin.radius
                : ay.abs().times(row[3]).over(flat.plus(ay.times(ay)).root());
        return twin;
    }

    /** The same, larger by a length to all sides. */
    public PlanarTwin grown(double by) {
        PlanarTwin twin = new PlanarTwin(x.length, radius.head() + by, isOval);
        System.arraycopy(x, 0, twin.x, 0, x.length);
        System.arraycopy(z, 0, twin.z, 0, z.length);
        twin.axisX = axisX;
        twin.axisZ = axisZ;
        twin.reach = reach.plus(Twofold.of(by));
        twin.minor = minor.plus(Twofold.of(by));
        twin.wayX = wayX;
        twin.wayZ = wayZ;
        return twin;
    }

    /** The same, moved by a share of a way. */
    public PlanarTwin moved(double dx, double dz, double share) {
        return seenFrom(Twofold.of(dx).times(-share), Twofold.of(dz).times(-share));
    }

    /** The same, turned about a point by an angle of these, from x towards z. */
    public PlanarTwin turned(double px, double pz, double cos, double sin) {
        PlanarTwin twin = grown(0);
        for (int k = 0; k < x.length; k++) {
            Twofold wx = x[k].minus(Twofold.of(px));
            Twofold wz = z[k].minus(Twofold.of(pz));
            twin.x[k] = wx.times(cos).minus(wz.times(sin)).plus(Twofold.of(px));
            twin.z[k] = wx.times(sin).plus(wz.times(cos)).plus(Twofold.of(pz));
        }
        twin.axisX = axisX.times(cos).minus(axisZ.times(sin));
        twin.axisZ = axisX.times(sin).plus(axisZ.times(cos));
        return twin;
    }

    /** All places on a share of a way. */
    public PlanarTwin swept(double dx, double dz, double share) {
        PlanarTwin twin = grown(0);
        twin.wayX = Twofold.of(dx).times(share);
        twin.wayZ = Twofold.of(dz).times(share);
        return twin;
    }

    /** The octagon between bounds of x, z, x + z and x - z, each of which some point of it reaches. */
    public static PlanarTwin octagon(double[] row) {
        // Sides by the angle of their normals, from that along x on: each corner is where one meets the next.
        double[][] sides = {
            {1, 0, row[1]}, {1, 1, row[5]}, {0, 1, row[3]}, {-1, 1, -row[6]},
            {-1, 0, -row[0]}, {-1, -1, -row[4]}, {0, -1, -row[2]}, {1, -1, row[7]}
        };
        PlanarTwin twin = new PlanarTwin(8, 0, false);
        for (int k = 0; k < 8; k++) {
            double[] p = sides[k];
            double[] q = sides[(k + 1) % 8]; // their determinant is 1
            twin.x[k] = Twofold.of(p[2]).times(q[1]).minus(Twofold.of(q[2]).times(p[1]));
            twin.z[k] = Twofold.of(q[2]).times(p[0]).minus(Twofold.of(p[2]).times(q[0]));
        }
        return twin;
    }

    private static PlanarTwin triangle(double[] row) {
        PlanarTwin twin = new PlanarTwin(3, 0, false);
        Twofold[] first = {Twofold.difference(row[3], row[0]), Twofold.difference(row[5], row[2])};
        Twofold[] second = {Twofold.difference(row[6], row[0]), Twofold.difference(row[8], row[2])};
        boolean isLeft = cross(first[0], first[1], second[0], second[1]).signum() >= 0;
        int[] order = isLeft ? new int[] {0, 3, 6} : new int[] {0, 6, 3};
        for (int k = 0; k < 3; k++) {
            twin.x[k] = Twofold.of(row[order[k]]);
            twin.z[k] = Twofold.of(row[order[k] + 2]);
        }
        return twin;
    }

    private static PlanarTwin box(double[] row) {
        Twofold[][] spans = new Twofold[3][];
        int count = 0;
        for (int k = 0; k < 3; k++) {
            Twofold gx = Twofold.of(row[3 + k]).times(row[6 + k]);
            Twofold gz = Twofold.of(row[3 + k]).times(row[12 + k]);
            if (gx.signum() == 0 && gz.signum() == 0) {
                continue;
            }
            boolean isBack = gz.signum() < 0 || (gz.signum() == 0 && gx.signum() < 0);
            spans[count++] = isBack ? new Twofold[] {gx.negated(), gz.negated()} : new Twofold[] {gx, gz};
        }
        Twofold[][] sorted = Arrays.copyOf(spans, count);
        Arrays.sort(sorted, (p, q) -> -cross(p[0], p[1], q[0], q[1]).signum());
        PlanarTwin twin = new PlanarTwin(Math.max(1, 2 * count), 0, false);
        Twofold px = Twofold.of(row[0]);
        Twofold pz = Twofold.of(row[2]);
        for (Twofold[] span : sorted) {
            px = px.minus(span[0]);
            pz = pz.minus(span[1]);
        }
        twin.x[0] = px;
        twin.z[0] = pz;
        for (int k = 0; k + 1 < 2 * count; k++) {
            Twofold[] span = sorted[k % count];
            double twice = k < count ? 2 : -2;
            px = px.plus(span[0].times(twice));
            pz = pz.plus(span[1].times(twice));
            twin.x[k + 1] = px;
            twin.z[k + 1] = pz;
        }
        return twin;
    }

    public static Twofold cross(Twofold ax, Twofold az, Twofold bx, Twofold bz) {
        return ax.times(bz).minus(az.times(bx));
    }

    public static Twofold dot(Twofold ax, Twofold az, Twofold bx, Twofold bz) {
        return ax.times(bx).plus(az.times(bz));
    }

    /** The least number that no coordinate's magnitude is above, roughly. */
    public double size() {
        double size = 0;
        for (int k = 0; k < x.length; k++) {
            size = Math.max(size, Math.abs(x[k].head()) + Math.abs(z[k].head()));
        }
        return size + radius.head() + reach.head();
    }

    /** Whether two projections touch, by exact arithmetic. */
    public static boolean touch(Form formA, double[] a, Form formB, double[] b) {
        return exactly(number -> Truth.planar(number, formA, a, formB, b));
    }

    /** A question to exact arithmetic, coarse first. */
    public static boolean exactly(java.util.function.Predicate<Arithmetic> question) {
        try {
            return question.test(Truth.COARSE);
        } catch (Doubt doubt) {
            return question.test(Truth.EXACT);
        }
    }

    /** A distance, and whether a side's inside is nearest to a corner or to what is round. */
    public record Gap(Twofold distance, boolean isSide) {}

    /** Of two that are apart, neither an oval. */
    public Gap gap(PlanarTwin other) {
        Gap here = cornersTo(other);
        Gap there = other.cornersTo(this);
        Gap least = there.distance.isBelow(here.distance) ? there : here;
        return new Gap(least.distance.minus(radius).minus(other.radius), least.isSide);
    }

    private Gap cornersTo(PlanarTwin other) {
        Twofold best = null;
        boolean isSide = false;
        for (int k = 0; k < x.length; k++) {
            for (int m = 0; m < other.x.length; m++) {
                int n = (m + 1) % other.x.length;
                Twofold ex = other.x[n].minus(other.x[m]);
                Twofold ez = other.z[n].minus(other.z[m]);
                Twofold wx = x[k].minus(other.x[m]);
                Twofold wz = z[k].minus(other.z[m]);
                Twofold square = dot(ex, ez, ex, ez);
                Twofold along = dot(ex, ez, wx, wz);
                boolean isWithin = along.signum() > 0 && along.isBelow(square);
                Twofold here;
                if (isWithin) {
                    Twofold across = cross(ex, ez, wx, wz);
                    here = across.times(across).over(square);
                } else {
                    here = dot(wx, wz, wx, wz); // the other end is the next side's
                }
                if (best == null || here.isBelow(best)) {
                    best = here;
                    isSide = isWithin;
                }
            }
        }
        if (best == null) {
            throw new IllegalStateException("no corners");
        }
        return new Gap(best.root(), isSide);
    }

    /**
     * The greatest distance between two parallel lines that part the two, negative where none does; the twin of ovals. It is at
     * a side's normal or where its slope is zero, and there an error in the direction counts by its square.
     */
    public Twofold parted(PlanarTwin other) {
        return seenFrom(x[0], z[0]).near(other.seenFrom(x[0], z[0]));
    }

    /** The same in plain doubles. */
    public double partedRoughly(PlanarTwin other) {
        double[] best = {Double.NEGATIVE_INFINITY, 0};
        for (int k = 0; k < 32; k++) {
            offer(other, 2 * Math.PI * k / 32, best);
        }
        for (PlanarTwin of : new PlanarTwin[] {this, other}) {
            for (int m = 0; m < of.x.length; m++) {
                int n = (m + 1) % of.x.length;
                double ex = of.isOval ? of.axisX.head() : of.x[n].head() - of.x[m].head();
                double ez = of.isOval ? of.axisZ.head() : of.z[n].head() - of.z[m].head();
                double angle = Math.atan2(-ex, ez);
                offer(other, angle, best);
                offer(other, angle + Math.PI, best);
            }
        }
        climb(other, best[1], 0.2, best);
        climb(other, best[1], 0x1p-12, best);
        return best[0];
    }

    // From nearby, so that doubles lead to the right direction.
    private PlanarTwin seenFrom(Twofold px, Twofold pz) {
        PlanarTwin twin = grown(0);
        for (int k = 0; k < x.length; k++) {
            twin.x[k] = x[k].minus(px);
            twin.z[k] = z[k].minus(pz);
        }
        return twin;
    }

    private Twofold near(PlanarTwin other) {
        int count = 64;
        double[] best = {Double.NEGATIVE_INFINITY, 0};
        for (int k = 0; k < count; k++) {
            offer(other, 2 * Math.PI * k / count, best);
        }
        Twofold most = null;
        for (PlanarTwin of : new PlanarTwin[] {this, other}) {
            for (int m = 0; m < of.x.length; m++) {
                int n = (m + 1) % of.x.length;
                Twofold ex = of.isOval ? of.axisX : of.x[n].minus(of.x[m]);
                Twofold ez = of.isOval ? of.axisZ : of.z[n].minus(of.z[m]);
                for (int side = -1; side <= 1 && !(ex.signum() == 0 && ez.signum() == 0); side += 2) {
                    Twofold here = exactLines(other, ez.times(side), ex.times(-side));
                    most = most == null ? here : larger(most, here);
                    offer(other, Math.atan2(-side * ex.head(), side * ez.head()), best);
                }
            }
        }
        for (PlanarTwin of : new PlanarTwin[] {this, other}) {
            for (int side = -1; side <= 1; side += 2) {
                if (of.wayX.signum() != 0 || of.wayZ.signum() != 0) {
                    Twofold here = exactLines(other, of.wayZ.times(side), of.wayX.times(-side));
                    most = most == null ? here : larger(most, here);
                }
                if (of.isOval) { // an end that is all but flat
                    Twofold here = exactLines(other, of.axisX.times(side), of.axisZ.times(side));
                    most = most == null ? here : larger(most, here);
                }
            }
        }
        double from = best[1];
        for (double step = 0.1; step > 1e-15; step *= 1e-4) {
            climb(other, from, step, best);
        }
        Twofold slope = exactLines(other, Twofold.of(Math.cos(best[1])), Twofold.of(Math.sin(best[1])));
        return most == null ? slope : larger(most, slope);
    }

    private void offer(PlanarTwin other, double angle, double[] best) {
        double here = lines(other, Math.cos(angle), Math.sin(angle));
        if (here > best[0]) {
            best[0] = here;
            best[1] = angle;
        }
    }

    // Halves an interval about an angle by the sign of the slope: of the offset of the two foremost points across.
    private void climb(PlanarTwin other, double angle, double step, double[] best) {
        double low = angle - step;
        double high = angle + step;
        for (int k = 0; k < 30; k++) {
            double middle = (low + high) / 2;
            double nx = Math.cos(middle);
            double nz = Math.sin(middle);
            double[] p = foremost(nx, nz);
            double[] q = other.foremost(-nx, -nz);
            if (nx * (q[1] - p[1]) - nz * (q[0] - p[0]) > 0) {
                low = middle;
            } else {
                high = middle;
            }
        }
        offer(other, (low + high) / 2, best);
    }

    private static Twofold larger(Twofold a, Twofold b) {
        return a.isBelow(b) ? b : a;
    }

    /** How far two lines square to a direction part the other, which is ahead, from this one; below 0 where they do not. */
    public double lines(PlanarTwin other, double nx, double nz) {
        return -other.support(-nx, -nz) - support(nx, nz);
    }

    private double support(double nx, double nz) {
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < x.length; k++) {
            most = Math.max(most, nx * x[k].head() + nz * z[k].head());
        }
        most += Math.max(0, nx * wayX.head() + nz * wayZ.head());
        if (!isOval) {
            return most + radius.head();
        }
        double along = nx * axisX.head() + nz * axisZ.head();
        double across = nz * axisX.head() - nx * axisZ.head();
        return most + reach.head() * Math.abs(along) + Math.hypot(minor.head() * along, radius.head() * across);
    }

    private Twofold exactLines(PlanarTwin other, Twofold nx, Twofold nz) {
        Twofold length = dot(nx, nz, nx, nz).root();
        Twofold ux = nx.over(length);
        Twofold uz = nz.over(length);
        return other.exactSupport(ux.negated(), uz.negated())
                .plus(exactSupport(ux, uz))
                .negated();
    }

    private Twofold exactSupport(Twofold nx, Twofold nz) {
        Twofold most = dot(nx, nz, x[0], z[0]);
        for (int k = 1; k < x.length; k++) {
            most = larger(most, dot(nx, nz, x[k], z[k]));
        }
        most = most.plus(larger(Twofold.ZERO, dot(nx, nz, wayX, wayZ)));
        if (!isOval) {
            return most.plus(radius);
        }
        Twofold along = dot(nx, nz, axisX, axisZ);
        Twofold p = minor.times(along);
        Twofold q = radius.times(cross(axisX, axisZ, nx, nz));
        return most.plus(reach.times(along.abs()))
                .plus(p.times(p).plus(q.times(q)).root());
    }

    /** Where a ray enters, in lengths of its direction; null where doubles twice as long see no hit. The start is outside. */
    @Nullable
    public Twofold entry(double ox, double oz, Twofold ux, Twofold uz) {
        Twofold wx = x[0].minus(Twofold.of(ox));
        Twofold wz = z[0].minus(Twofold.of(oz));
        if (!isOval) {
            return x.length == 1 && radius.signum() > 0
                    ? ends(wx, wz, ux, uz, radius, radius)[0]
                    : polygonEntry(ox, oz, ux, uz);
        }
        Twofold along = dot(wx, wz, axisX, axisZ);
        Twofold across = cross(axisX, axisZ, wx, wz);
        Twofold wayAlong = dot(ux, uz, axisX, axisZ);
        Twofold wayAcross = cross(axisX, axisZ, ux, uz);
        Twofold best = null;
        for (int side = -1; side <= 1; side += 2) {
            Twofold end = along.plus(reach.times(side));
            best = sooner(best, ends(end, across, wayAlong, wayAcross, minor, radius)[0]);
            if (wayAcross.signum() != 0) {
                Twofold t = across.plus(radius.times(side)).over(wayAcross);
                Twofold place = wayAlong.times(t).minus(along);
                if (t.signum() >= 0 && !reach.isBelow(place.abs())) {
                    best = sooner(best, t);
                }
            }
        }
        return best;
    }

    private static @Nullable Twofold sooner(@Nullable Twofold a, @Nullable Twofold b) {
        return a == null ? b : b == null || a.isBelow(b) ? a : b;
    }

    // The ellipse about (cx, cz) with these half axes, which the ray from the origin enters at the first of the two.
    private static @Nullable Twofold[] ends(
            Twofold cx, Twofold cz, Twofold ux, Twofold uz, Twofold halfX, Twofold halfZ) {
        Twofold px = cx.times(halfZ);
        Twofold pz = cz.times(halfX);
        Twofold vx = ux.times(halfZ);
        Twofold vz = uz.times(halfX);
        Twofold square = dot(vx, vz, vx, vz);
        Twofold aside = cross(vx, vz, px, pz);
        Twofold most = halfX.times(halfZ);
        Twofold rest = most.times(most).times(square).minus(aside.times(aside));
        Twofold ahead = dot(px, pz, vx, vz);
        if (rest.signum() < 0 || ahead.signum() < 0 || square.signum() == 0) {
            return new Twofold[] {null};
        }
        return new Twofold[] {ahead.minus(rest.root()).over(square)};
    }

    // The first of its sides that the ray crosses between their ends; of what is flat, or met end on, the nearest
    // corner.
    private @Nullable Twofold polygonEntry(double ox, double oz, Twofold ux, Twofold uz) {
        Twofold best = null;
        for (int k = 0; k < x.length; k++) {
            int n = (k + 1) % x.length;
            Twofold ex = x[n].minus(x[k]);
            Twofold ez = z[n].minus(z[k]);
            Twofold wx = x[k].minus(Twofold.of(ox));
            Twofold wz = z[k].minus(Twofold.of(oz));
            Twofold turn = cross(ux, uz, ex, ez);
            if (turn.signum() == 0) {
                if (cross(ux, uz, wx, wz).signum() == 0 && dot(ux, uz, wx, wz).signum() >= 0) {
                    best = sooner(best, dot(ux, uz, wx, wz).over(dot(ux, uz, ux, uz)));
                }
                continue;
            }
            Twofold place = cross(wx, wz, ux, uz).over(turn);
            Twofold t = cross(wx, wz, ex, ez).over(turn);
            if (place.head() >= -0x1p-80 && place.minus(Twofold.ONE).head() <= 0x1p-80 && t.signum() >= 0) {
                best = sooner(best, t);
            }
        }
        return best;
    }

    /** The foremost point of its outline along a direction in doubles, for making up cases. */
    public double[] foremost(double nx, double nz) {
        int best = 0;
        for (int k = 1; k < x.length; k++) {
            if (nx * x[k].head() + nz * z[k].head() > nx * x[best].head() + nz * z[best].head()) {
                best = k;
            }
        }
        boolean isOn = nx * wayX.head() + nz * wayZ.head() > 0;
        double px = x[best].head() + (isOn ? wayX.head() : 0);
        double pz = z[best].head() + (isOn ? wayZ.head() : 0);
        double length = Math.hypot(nx, nz);
        if (!isOval) {
            return new double[] {px + radius.head() * nx / length, pz + radius.head() * nz / length};
        }
        double along = nx * axisX.head() + nz * axisZ.head();
        double across = nz * axisX.head() - nx * axisZ.head();
        double bulge = Math.max(Double.MIN_NORMAL, Math.hypot(minor.head() * along, radius.head() * across));
        double u = Math.signum(along) * reach.head() + minor.head() * minor.head() * along / bulge;
        double v = radius.head() * radius.head() * across / bulge;
        return new double[] {px + u * axisX.head() - v * axisZ.head(), pz + u * axisZ.head() + v * axisX.head()};
    }
}
