package robosim.geometry.census;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.Twofold;
import robosim.geometry.reference.Twofold.Vector;

/** How far a cone in space hears a sphere. */
final class SphereCone implements Kernel {
    /** Of the coordinates, before the last rounding. */
    private static final double ERROR = 0x1p-90;

    private final ConeQuestion q = new ConeQuestion(LeafKind.SPHERE);

    @Override
    public String name() {
        return "cone, sphere, spatial";
    }

    @Override
    public List<String> regimes() {
        return List.of("apex inside", "centre in the cone", "border", "silent, ahead", "silent, behind", "grazing");
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        make(random, adversarial);
        double answer = q.ask();
        Vector m = new Vector(
                Twofold.difference(q.row[0], q.apex[0]),
                Twofold.difference(q.row[1], q.apex[1]),
                Twofold.difference(q.row[2], q.apex[2]));
        Vector u = Vector.of(q.way[0], q.way[1], q.way[2]).unit();
        Twofold cos = Twofold.of(q.cos);
        Twofold sin = Twofold.ONE.minus(cos).times(Twofold.ONE.plus(cos)).root();
        Twofold r = Twofold.of(q.row[3]);
        Twofold distance = m.length();
        if (!r.isBelow(distance)) {
            return answer == 0 ? Visit.right("apex inside") : Visit.wrong("apex inside", q.paste(answer, "0"));
        }
        Twofold ahead = m.dot(u);
        Twofold aside = m.cross(u).length();
        Twofold past = aside.times(cos).minus(ahead.times(sin));
        Twofold along = ahead.times(cos).plus(aside.times(sin));
        Twofold truth = distance.minus(r);
        String regime = "centre in the cone";
        boolean isHeard = true;
        if (past.signum() > 0) {
            Twofold clearance = r.minus(past);
            isHeard = clearance.signum() >= 0 && along.signum() >= 0;
            boolean isGrazing = along.signum() >= 0 && Math.abs(clearance.head()) < 1e-7 * distance.head();
            regime = isGrazing
                    ? "grazing"
                    : isHeard ? "border" : along.signum() >= 0 ? "silent, ahead" : "silent, behind";
            truth = along.minus(clearance.times(r.plus(past)).root());
        }
        String right = isHeard ? truth.head() + "" : "silent";
        if (answer < Double.POSITIVE_INFINITY != isHeard) {
            return Visit.wrong(regime, q.paste(answer, right));
        }
        if (!isHeard) {
            return Visit.right(regime);
        }
        double off = truth.minus(Twofold.of(answer)).head();
        // Under the root what is off by so much is more where the border but grazes.
        double slack = regime.equals("grazing") ? Math.sqrt(ERROR) : ERROR;
        double unit = Math.ulp(answer) / 2 * (1 + 0x1p-40) + slack * q.extent();
        return Visit.number(regime, Math.max(0, off) / unit, Math.max(0, -off) / unit, 0, () -> q.paste(answer, right));
    }

    private void make(SplittableRandom random, boolean adversarial) {
        Arrays.fill(q.row, 0);
        for (int k = 0; k < 3; k++) {
            q.row[k] = random.nextDouble(-2, 2);
            q.apex[k] = random.nextDouble(-2, 2);
        }
        double x = q.row[0] - q.apex[0];
        double y = q.row[1] - q.apex[1];
        double z = q.row[2] - q.apex[2];
        double distance = Math.sqrt(x * x + y * y + z * z);
        double close = adversarial ? StrictMath.pow(10, -random.nextDouble(0, 12)) : random.nextDouble();
        q.row[3] = distance * (random.nextInt(8) == 0 ? 1 + close : random.nextBoolean() ? 1 - close : 0.5 * close);
        q.widen(StrictMath.toRadians(
                adversarial ? StrictMath.pow(10, random.nextDouble(-6, 1.95)) : random.nextDouble(0.5, 89.5)));
        // The sphere is seen as wide as this.
        double seen = Math.asin(Math.min(1, q.row[3] / distance));
        double angle = random.nextDouble(0, 1.5) * (q.half + seen);
        if (adversarial && random.nextBoolean()) {
            angle = (q.half + seen)
                    * (1 + StrictMath.pow(10, -random.nextDouble(3, 16)) * (random.nextBoolean() ? 1 : -1));
        } else if (random.nextInt(8) == 0) {
            angle = random.nextDouble(q.half, Math.PI);
        }
        q.aim(Arrays.copyOf(q.row, 3), angle / q.half - 1, random);
    }
}
