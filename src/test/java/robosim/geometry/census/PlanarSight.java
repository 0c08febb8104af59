package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.ray.PlanarRay;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.Truth;
import robosim.geometry.reference.Truth.Form;
import robosim.geometry.reference.Twofold;

/** Where a ray meets a projection. */
final class PlanarSight implements Kernel {
    private static final double CLOSE = 0x1p-40;

    private final String name;
    private final Form[] forms;
    private final Scratch scratch = new Scratch();

    PlanarSight(String name, Form... forms) {
        this.name = "distance along a ray to " + name + ", PLANAR";
        this.forms = forms;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public double effort() {
        return forms[0] == Form.CYLINDER ? 0.5 : 1;
    }

    @Override
    public List<String> regimes() {
        List<String> all = new ArrayList<>(List.of("from within", "missed beside", "missed behind", "met"));
        if (hasNoCorners()) {
            all.add("grazed");
        } else {
            all.add("met at a corner");
            all.add("met along a side");
        }
        return all;
    }

    private boolean hasNoCorners() {
        return PlanarCases.isOval(forms[0]) || forms[0] == Form.SPHERE;
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        Form form = forms[random.nextInt(forms.length)];
        double[] row = PlanarCases.row(form, random, adversarial);
        PlanarTwin twin = PlanarTwin.of(form, row);
        double far = random.nextInt(adversarial ? 3 : 12) == 0 ? StrictMath.pow(10, random.nextDouble(6)) : 3;
        double[] start = {random.nextDouble(-far, far), random.nextDouble(-far, far)};
        double[] n = PlanarCases.direction(twin, random, adversarial);
        double[] p = twin.foremost(n[0], n[1]);
        double share = adversarial ? 1 : random.nextDouble(1.6);
        double off = adversarial && random.nextInt(3) != 0 ? StrictMath.pow(10, -random.nextDouble(17)) : 0;
        double aimX = row[0] + share * (p[0] - row[0]) + (random.nextBoolean() ? off : -off) * n[0];
        double aimZ = row[2] + share * (p[1] - row[2]) + (random.nextBoolean() ? off : -off) * n[1];
        double[] way = {aimX - start[0], aimZ - start[1]};
        switch (random.nextInt(adversarial ? 6 : 8)) {
            case 0 -> { // from within, or nearly
                start[0] = row[0] + random.nextDouble(1.2) * (p[0] - row[0]);
                start[1] = row[2] + random.nextDouble(1.2) * (p[1] - row[2]);
            }
            case 1, 3, 4 -> { // along a tangent or a side, and a little off it
                way = new double[] {-n[1], n[0]};
                double back = random.nextInt(8) == 0 ? random.nextDouble(-1, far) : random.nextDouble(1, 1 + far);
                start = new double[] {aimX - back * way[0], aimZ - back * way[1]};
            }
            case 2 -> way = new double[] {-way[0], -way[1]};
            default -> {}
        }
        if (way[0] == 0 && way[1] == 0) {
            way[0] = 1;
        }
        return compare(form, row, twin, start, way);
    }

    private Visit compare(Form form, double[] row, PlanarTwin twin, double[] start, double[] way) {
        double distance = PlanarRay.distance(
                new BeamAxis().line(start[0], 0, start[1], way[0], 0, way[1]),
                PlanarCases.kind(form),
                row,
                0,
                scratch.ray);
        String text =
                PlanarCases.paste(form, row) + " from " + PlanarCases.paste(start) + " along " + PlanarCases.paste(way);
        Twofold ux = Twofold.of(way[0]);
        Twofold uz = Twofold.of(way[1]);
        Twofold speed = PlanarTwin.dot(ux, uz, ux, uz).root();
        double size = twin.size() + Math.abs(start[0]) + Math.abs(start[1]);
        if (form == Form.CYLINDER) {
            return oval(twin, start, ux, uz, speed, distance, size, text);
        }
        double[] point = new double[16];
        point[0] = start[0];
        point[2] = start[1];
        if (PlanarTwin.exactly(number -> Truth.planar(number, Form.SPHERE, point, form, row))) {
            return distance == 0
                    ? Visit.right("from within")
                    : Visit.wrong("from within", text + ": 0 (got: " + distance + ")");
        }
        double[] ray = {start[0], 0, start[1], way[0], 0, way[1]};
        boolean hit = PlanarTwin.exactly(number -> Truth.planarRay(number, ray, form, row));
        String regime = regime(twin, start, ux, uz, speed, hit, size);
        if (hit != distance < Double.POSITIVE_INFINITY) {
            return Visit.wrong(regime, text + ": " + hit + " (got: " + distance + ")");
        }
        Twofold entry = hit ? twin.entry(start[0], start[1], ux, uz) : null;
        if (entry == null) {
            return Visit.right(regime); // missed, or a tangent that even these numbers do not see
        }
        double truth = entry.times(speed).head();
        double bound = 4 * Math.ulp(Math.max(truth, size));
        return Visit.number(
                regime,
                Math.max(0, truth - distance) / bound,
                Math.max(0, distance - truth) / bound,
                0,
                () -> text + ": " + truth + " (got: " + distance + ")");
    }

    private String regime(
            PlanarTwin twin, double[] start, Twofold ux, Twofold uz, Twofold speed, boolean hit, double size) {
        double left = Double.NEGATIVE_INFINITY;
        double right = Double.POSITIVE_INFINITY;
        double ahead = Double.NEGATIVE_INFINITY;
        boolean isCorner = false;
        boolean isAlong = false;
        for (int k = 0; k < twin.x.length; k++) {
            Twofold wx = twin.x[k].minus(Twofold.of(start[0]));
            Twofold wz = twin.z[k].minus(Twofold.of(start[1]));
            double aside = PlanarTwin.cross(ux, uz, wx, wz).head() / speed.head();
            double wide = twin.radius.head() + half(PlanarTwin.cross(ux, uz, twin.axisX, twin.axisZ), twin, speed);
            double deep = twin.radius.head() + half(PlanarTwin.dot(ux, uz, twin.axisX, twin.axisZ), twin, speed);
            left = Math.max(left, aside + wide);
            right = Math.min(right, aside - wide);
            ahead = Math.max(ahead, PlanarTwin.dot(ux, uz, wx, wz).head() / speed.head() + deep);
            boolean isOn = Math.abs(aside) < CLOSE * size && twin.radius.signum() == 0;
            int n = (k + 1) % twin.x.length;
            Twofold ex = twin.x[n].minus(twin.x[k]);
            Twofold ez = twin.z[n].minus(twin.z[k]);
            double turn = PlanarTwin.cross(ux, uz, ex, ez).head() / speed.head();
            isAlong |= isOn && Math.abs(turn) < CLOSE * size;
            isCorner |= isOn;
        }
        if (!hit) {
            return ahead < 0 ? "missed behind" : "missed beside";
        }
        if (isAlong && !hasNoCorners()) {
            return "met along a side";
        }
        boolean isGrazed = Math.min(left, -right) < CLOSE * size;
        if (hasNoCorners()) {
            return isGrazed ? "grazed" : "met";
        }
        return isGrazed || isCorner ? "met at a corner" : "met";
    }

    /** Half of an oval's straight part, along a way or across. */
    private static double half(Twofold share, PlanarTwin twin, Twofold speed) {
        return twin.reach.head() * Math.abs(share.head()) / speed.head();
    }

    private Visit oval(
            PlanarTwin twin,
            double[] start,
            Twofold ux,
            Twofold uz,
            Twofold speed,
            double distance,
            double size,
            String text) {
        double[] place = new double[16];
        place[0] = start[0];
        place[2] = start[1];
        double gap = PlanarTwin.of(Form.SPHERE, place).parted(twin).head();
        double bound = 0x1p-48 * size;
        if (gap <= bound) {
            boolean isWrong =
                    gap <= 0 ? distance != 0 : distance > gap + 4 * bound && distance != Double.POSITIVE_INFINITY;
            return isWrong
                    ? Visit.wrong("from within", text + ": 0 (got: " + distance + ")")
                    : Visit.right("from within");
        }
        PlanarTwin larger = twin.grown(bound);
        double truth = along(twin.entry(start[0], start[1], ux, uz), speed);
        double least = along(larger.entry(start[0], start[1], ux, uz), speed);
        boolean isGrazed = truth - least > CLOSE * size || (truth == Double.POSITIVE_INFINITY && least < truth);
        String regime = isGrazed
                ? "grazed"
                : truth < Double.POSITIVE_INFINITY
                        ? "met"
                        : PlanarTwin.dot(
                                                        twin.x[0].minus(Twofold.of(start[0])),
                                                        twin.z[0].minus(Twofold.of(start[1])),
                                                        ux,
                                                        uz)
                                                .signum()
                                        < 0
                                ? "missed behind"
                                : "missed beside";
        boolean isLate = distance > truth + bound / 4;
        boolean isEarly = distance < least - bound;
        return isLate || isEarly
                ? Visit.wrong(regime, text + ": from " + least + " to " + truth + " (got: " + distance + ")")
                : Visit.right(regime);
    }

    private static double along(@Nullable Twofold entry, Twofold speed) {
        return entry == null ? Double.POSITIVE_INFINITY : entry.times(speed).head();
    }
}
