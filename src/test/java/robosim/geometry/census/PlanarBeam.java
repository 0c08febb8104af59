package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.cone.PlanarCone;
import robosim.geometry.reference.Truth;
import robosim.geometry.reference.Truth.Form;

/** The nearest point of a projection within a sector. */
final class PlanarBeam implements Kernel {
    private static final double CLOSE = 0x1p-14;

    private final String name;
    private final Form[] forms;
    private final Scratch scratch = new Scratch();

    // One case: the sector as it is stored, and its edges.
    private Twofold dx = Twofold.ZERO;
    private Twofold dz = Twofold.ZERO;
    private Twofold cos = Twofold.ZERO;
    private Twofold sin = Twofold.ZERO;

    PlanarBeam(String name, Form... forms) {
        this.name = "sector and " + name + ", PLANAR";
        this.forms = forms;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public double effort() {
        return PlanarCases.isOval(forms[0]) ? 0.45 : 0.7; // the twin is slow, the regimes are few
    }

    @Override
    public List<String> regimes() {
        List<String> all = new ArrayList<>(List.of(
                "from within", "the nearest point within", "cut by an edge", "nothing within", "an edge grazes it"));
        if (!PlanarCases.isOval(forms[0])) {
            all.add("the nearest point near an edge");
        }
        return all;
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        Form form = forms[random.nextInt(forms.length)];
        double[] row = PlanarCases.row(form, random, adversarial);
        PlanarTwin twin = PlanarTwin.of(form, row);
        double far = random.nextInt(6) == 0 ? StrictMath.pow(10, random.nextDouble(5)) : 2.5;
        double[] apex = {random.nextDouble(-far, far), random.nextDouble(-far, far)};
        if (random.nextInt(12) == 0) {
            apex = new double[] {row[0], row[2]};
        }
        double half =
                random.nextInt(6) == 0 ? StrictMath.pow(10, -random.nextDouble(1, 9)) : random.nextDouble(0.02, 1.55);
        double[] n = PlanarCases.direction(twin, random, adversarial);
        double[] p = twin.foremost(n[0], n[1]);
        double angle = Math.atan2(p[1] - apex[1], p[0] - apex[0]);
        if (adversarial) { // an edge past the foremost point, or past the nearest
            boolean isOff = apex[0] != row[0] || apex[1] != row[2];
            double[] at = isOff && random.nextBoolean() ? twin.foremost(apex[0] - row[0], apex[1] - row[2]) : p;
            double off = StrictMath.pow(10, -random.nextDouble(3, 17));
            angle = Math.atan2(at[1] - apex[1], at[0] - apex[0])
                    + (random.nextBoolean() ? half : -half)
                    + (random.nextBoolean() ? off : -off);
        } else {
            angle += random.nextDouble(-1.5, 1.5) * half + random.nextDouble(-0.5, 0.5);
        }
        double length = random.nextBoolean() ? 1 : random.nextDouble(0.1, 30);
        return compare(
                form,
                row,
                twin,
                apex,
                new double[] {length * StrictMath.cos(angle), length * StrictMath.sin(angle)},
                StrictMath.cos(half),
                StrictMath.sin(half));
    }

    private Visit compare(
            Form form, double[] row, PlanarTwin twin, double[] apex, double[] way, double halfCos, double halfSin) {
        double distance = PlanarCone.distance(
                new BeamAxis().line(apex[0], 0, apex[1], way[0], 0, way[1]).widen(halfCos, halfSin),
                PlanarCases.kind(form),
                row,
                0,
                Double.POSITIVE_INFINITY,
                scratch.cone);
        String text = PlanarCases.paste(form, row) + " from " + PlanarCases.paste(apex) + " along "
                + PlanarCases.paste(way) + ", half " + PlanarCases.paste(halfCos, halfSin);
        double size = twin.size() + Math.abs(apex[0]) + Math.abs(apex[1]);
        double[] point = new double[16];
        point[0] = apex[0];
        point[2] = apex[1];
        boolean isOval = PlanarCases.isOval(form);
        boolean isWithin = isOval
                ? PlanarTwin.of(Form.SPHERE, point).parted(twin).head() <= 0x1p-46 * size
                : PlanarTwin.exactly(number -> Truth.planar(number, Form.SPHERE, point, form, row));
        if (isWithin) {
            return distance <= 0x1p-44 * size * (isOval ? 1 : 0)
                    ? Visit.right("from within")
                    : Visit.wrong("from within", text + ": 0 (got: " + distance + ")");
        }
        double truth = within(twin, apex, way, halfCos, 0);
        double wider = within(isOval ? twin.grown(0x1p-46 * size) : twin, apex, way, halfCos, CLOSE);
        double narrower = within(twin, apex, way, halfCos, -CLOSE);
        double all = twin.isOval || twin.radius.signum() > 0 || twin.x.length == 1
                ? PlanarTwin.of(Form.SPHERE, point).parted(twin).head()
                : PlanarTwin.of(Form.SPHERE, point).gap(twin).distance().head();
        boolean isBorder = narrower == Double.POSITIVE_INFINITY && wider < Double.POSITIVE_INFINITY;
        boolean isAll = truth <= all + 0x1p-44 * size;
        String regime = isBorder
                ? "an edge grazes it"
                : truth == Double.POSITIVE_INFINITY
                        ? "nothing within"
                        : !isAll
                                ? "cut by an edge"
                                : narrower > truth && !isOval
                                        ? "the nearest point near an edge"
                                        : "the nearest point within";
        if (isOval) {
            // The search goes past what is very thin: of that no more is asked than that it is nearest where it is.
            double least = twin.radius.head() < 0x1p-12
                    ? all
                    : within(twin.grown(0x1p-44 * size), apex, way, halfCos, 0x1p-44);
            return oval(regime, distance, truth, least, size, text);
        }
        double surely = within(twin, apex, way, halfCos, 0x1p-85);
        double hardly = within(twin, apex, way, halfCos, -0x1p-85);
        double bound = 8 * Math.ulp(Math.max(size, hardly < Double.POSITIVE_INFINITY ? hardly : 0));
        double early = distance < surely ? (surely - distance) / bound : 0;
        double late = distance > hardly ? (distance - hardly) / bound : 0;
        return Visit.number(
                regime, early, late, 0, () -> text + ": " + surely + " to " + hardly + " (got: " + distance + ")");
    }

    private static Visit oval(String regime, double distance, double truth, double least, double size, String text) {
        double bound = 0x1p-44 * size;
        boolean isLate = distance > truth + 4 * Math.ulp(truth);
        boolean isEarly = distance < least - bound;
        return isLate || isEarly
                ? Visit.wrong(regime, text + ": " + least + " to " + truth + " (got: " + distance + ")")
                : Visit.right(regime);
    }

    /** The least distance within the sector, wider by an angle to both sides; the corners, the feet, and where edges cut. */
    private double within(PlanarTwin twin, double[] apex, double[] way, double halfCos, double by) {
        dx = Twofold.of(way[0]);
        dz = Twofold.of(way[1]);
        Twofold c = Twofold.of(halfCos);
        Twofold s = Twofold.ONE.minus(c.times(c)).root();
        cos = c.minus(s.times(by));
        sin = s.plus(c.times(by));
        if (sin.signum() < 0) {
            return Double.POSITIVE_INFINITY;
        }
        Twofold length = PlanarTwin.dot(dx, dz, dx, dz).root();
        dx = dx.over(length);
        dz = dz.over(length);
        double best = Double.POSITIVE_INFINITY;
        double[] angles = new double[3];
        int count = 0;
        for (int side = -1; side <= 1; side++) {
            Twofold ux = side == 0 ? dx : dx.times(cos).minus(dz.times(sin).times(side));
            Twofold uz = side == 0 ? dz : dz.times(cos).plus(dx.times(sin).times(side));
            Twofold entry = twin.entry(apex[0], apex[1], ux, uz);
            if (entry != null) {
                best = Math.min(best, entry.head());
                angles[count++] = Math.atan2(uz.head(), ux.head());
            }
        }
        return Math.min(best, twin.isOval ? round(twin, apex, angles, count) : places(twin, apex));
    }

    // The corners and the feet of the apex that are within.
    private double places(PlanarTwin twin, double[] apex) {
        double best = Double.POSITIVE_INFINITY;
        for (int k = 0; k < twin.x.length; k++) {
            int n = (k + 1) % twin.x.length;
            Twofold px = twin.x[k].minus(Twofold.of(apex[0]));
            Twofold pz = twin.z[k].minus(Twofold.of(apex[1]));
            best = Math.min(best, place(px, pz, twin.radius));
            Twofold ex = twin.x[n].minus(twin.x[k]);
            Twofold ez = twin.z[n].minus(twin.z[k]);
            Twofold square = PlanarTwin.dot(ex, ez, ex, ez);
            Twofold along = PlanarTwin.dot(px, pz, ex, ez).negated();
            if (along.signum() > 0 && along.isBelow(square)) {
                Twofold t = along.over(square);
                best = Math.min(best, place(px.plus(ex.times(t)), pz.plus(ez.times(t)), twin.radius));
            }
        }
        return best;
    }

    private double place(Twofold px, Twofold pz, Twofold radius) {
        return holds(px, pz)
                ? PlanarTwin.dot(px, pz, px, pz).root().minus(radius).head()
                : Double.POSITIVE_INFINITY;
    }

    private boolean holds(Twofold px, Twofold pz) {
        Twofold ahead = PlanarTwin.dot(px, pz, dx, dz);
        Twofold aside = PlanarTwin.cross(dx, dz, px, pz).abs();
        return ahead.signum() >= 0 && aside.times(cos).minus(ahead.times(sin)).head() <= 0;
    }

    // Along the ray that is the nearest by a search that goes down, from each that hits.
    private double round(PlanarTwin twin, double[] apex, double[] angles, int count) {
        double[] starts = new double[count + 1];
        System.arraycopy(angles, 0, starts, 0, count);
        starts[count] = Math.atan2(twin.z[0].head() - apex[1], twin.x[0].head() - apex[0]);
        double best = Double.POSITIVE_INFINITY;
        double middle = Math.atan2(dz.head(), dx.head());
        for (double start : starts) {
            double angle = start
                    + 1e-13 * Math.IEEEremainder(middle - start, 2 * Math.PI); // an edge itself may be rounded outward

            double here = along(twin, apex, angle);
            for (double step = 0.1; step > 1e-14 && here < Double.POSITIVE_INFINITY; ) {
                double left = along(twin, apex, angle - step);
                double right = along(twin, apex, angle + step);
                if (Math.min(left, right) < here) {
                    here = Math.min(left, right);
                    angle += left < right ? -step : step;
                } else {
                    step *= 0.2;
                }
            }
            best = Math.min(best, here);
        }
        return best;
    }

    private double along(PlanarTwin twin, double[] apex, double angle) {
        Twofold ux = Twofold.of(Math.cos(angle));
        Twofold uz = Twofold.of(Math.sin(angle));
        @Nullable Twofold entry = holds(ux, uz) ? twin.entry(apex[0], apex[1], ux, uz) : null;
        return entry == null
                ? Double.POSITIVE_INFINITY
                : entry.times(PlanarTwin.dot(ux, uz, ux, uz).root()).head();
    }
}
