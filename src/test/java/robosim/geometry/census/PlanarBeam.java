package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.cone.PlanarCone;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.SectorTwin;
import robosim.geometry.reference.Truth;
import robosim.geometry.reference.Truth.Form;

/** The nearest point of a projection within a sector. */
final class PlanarBeam implements Kernel {
    private static final double CLOSE = 0x1p-14;

    private final String name;
    private final Form[] forms;
    private final Scratch scratch = new Scratch();

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
        double truth = SectorTwin.nearest(twin, apex, way, halfCos, 0);
        double wider = SectorTwin.nearest(isOval ? twin.grown(0x1p-46 * size) : twin, apex, way, halfCos, CLOSE);
        double narrower = SectorTwin.nearest(twin, apex, way, halfCos, -CLOSE);
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
                    : SectorTwin.nearest(twin.grown(0x1p-44 * size), apex, way, halfCos, 0x1p-44);
            return oval(regime, distance, truth, least, size, text);
        }
        double surely = SectorTwin.nearest(twin, apex, way, halfCos, 0x1p-85);
        double hardly = SectorTwin.nearest(twin, apex, way, halfCos, -0x1p-85);
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
}
