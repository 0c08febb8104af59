package robosim.geometry.census;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** How far a cone in space hears a capsule. */
final class CapsuleCone implements Kernel {
    /** What is documented: the answer is not above the truth, and below by this share of it at most. */
    private static final double SHARE = 0x1p-40;

    /** Nearer than this share of offsets and sizes, below by as much; and what is missed by less may be heard. */
    private static final double NEAREST = 0x1p-44;

    /** A cone hears no later than the ray along its axis, whose distance is so good. */
    private static final double RAY_ULPS = 4;

    /** Nearer to silence than this share of the extent, the distance changes by more than places do. */
    private static final double GRAZING = 1e-7;

    private final ConeQuestion q = new ConeQuestion(LeafKind.CAPSULE);

    @Override
    public String name() {
        return "cone, capsule, spatial";
    }

    @Override
    public List<String> regimes() {
        return List.of(
                "apex inside",
                "side, in the cone",
                "end, in the cone",
                "side, at the border",
                "end, at the border",
                "silent",
                "grazing");
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        make(random, adversarial);
        double answer = q.ask();
        double upper = q.upper();
        double extent = q.extent();
        CapsuleConeTwin twin = new CapsuleConeTwin(q);
        String regime = regime(twin, extent);
        String truth = twin.distance + " by " + twin.clearance;
        double nearest = NEAREST * extent;
        if (twin.clearance < -2 * nearest || twin.clearance > nearest) {
            if (answer < Double.POSITIVE_INFINITY != twin.clearance > 0) {
                return Visit.wrong(regime, q.paste(answer, truth));
            }
        }
        if (regime.equals("apex inside")) {
            return answer <= nearest ? Visit.right(regime) : Visit.wrong(regime, q.paste(answer, truth));
        }
        if (answer == Double.POSITIVE_INFINITY || twin.distance == Double.POSITIVE_INFINITY) {
            return Visit.right(regime);
        }
        double bound = Math.max(SHARE * answer, nearest);
        if (answer == q.ray()) {
            bound = Math.max(bound, RAY_ULPS * Math.ulp(extent));
        }
        boolean isGrazing = regime.equals("grazing");
        return Visit.number(
                regime,
                isGrazing ? 0 : Math.max(0, twin.distance - answer) / bound,
                answer > twin.distance + Math.ulp(twin.distance) + 0x1p-90 * extent ? 2 : 0,
                isGrazing ? 0 : (Math.max(answer, upper) - answer) / bound,
                () -> q.paste(answer, truth));
    }

    private static String regime(CapsuleConeTwin twin, double extent) {
        if (twin.distance == 0) {
            return "apex inside";
        }
        if (Math.abs(twin.clearance) < GRAZING * extent) {
            return "grazing";
        }
        if (twin.clearance < 0) {
            return "silent";
        }
        return (twin.isEnd ? "end, " : "side, ") + (twin.isInside ? "in the cone" : "at the border");
    }

    private void make(SplittableRandom random, boolean adversarial) {
        Arrays.fill(q.row, 0);
        q.kind = random.nextInt(4) == 0 ? LeafKind.UPRIGHT_CAPSULE : LeafKind.CAPSULE;
        double[] r = Vec.rotation(Vec.direction(random), Vec.direction(random));
        System.arraycopy(r, 0, q.row, Leaf.ROTATION, 9);
        for (int k = 0; k < 3; k++) {
            q.row[k] = random.nextDouble(-2, 2);
        }
        q.row[3] = size(random, adversarial);
        q.row[4] = 2 * size(random, adversarial);
        double[] axis = CapsuleConeTwin.axis(q);
        double place = random.nextInt(3) > 0
                ? q.row[4] * random.nextDouble(-1, 1)
                : random.nextBoolean() ? q.row[4] : -q.row[4];
        double[] centre = Arrays.copyOf(q.row, 3);
        double[] on = Vec.plus(centre, place, axis);
        double[] aside = Vec.unit(Vec.squareTo(axis, Vec.direction(random)));
        double[] out = random.nextInt(3) > 0 ? aside : Vec.direction(random);
        double close = adversarial ? StrictMath.pow(10, -random.nextDouble(0, 7)) : random.nextDouble();
        double away = random.nextInt(10) == 0
                ? q.row[3] * random.nextDouble()
                : q.row[3] + (random.nextInt(3) > 0 ? random.nextDouble(0.1, 4) : close);
        System.arraycopy(Vec.plus(on, away, out), 0, q.apex, 0, 3);
        q.widen(StrictMath.toRadians(
                adversarial ? StrictMath.pow(10, random.nextDouble(-4, 1.95)) : random.nextDouble(0.5, 89.5)));
        // The border past a point of the surface, or past the nearest one to silence.
        double[] target =
                Vec.plus(Vec.plus(centre, q.row[4] * random.nextDouble(-1, 1), axis), q.row[3], Vec.direction(random));
        double off = random.nextDouble(-0.9, 0.9);
        if (adversarial && random.nextBoolean()) {
            off = StrictMath.pow(10, -random.nextDouble(1, 14)) * (random.nextBoolean() ? 1 : -1);
        }
        q.aim(target, off, random);
        if (random.nextInt(3) == 0) {
            graze(random, adversarial);
        } else if (random.nextInt(12) == 0) {
            System.arraycopy(out, 0, q.way, 0, 3); // away from it: all of it is behind the apex
        }
    }

    /** Turns the way so that some place of the segment is as far from the cone as the radius, or nearly. */
    private void graze(SplittableRandom random, boolean adversarial) {
        double[] axis = CapsuleConeTwin.axis(q);
        double[] on = Vec.plus(Arrays.copyOf(q.row, 3), q.row[4] * random.nextDouble(-1, 1), axis);
        double[] w = Vec.minus(on, q.apex);
        double distance = Vec.length(w);
        double seen = StrictMath.asin(Math.min(1, q.row[3] / distance));
        double off = StrictMath.pow(10, -random.nextDouble(adversarial ? 9 : 1, adversarial ? 16 : 9));
        double[] side = Vec.cross(w, axis);
        if (!(Vec.length(side) > 1e-9 * distance) || !(q.half + seen < 1.57)) {
            return;
        }
        q.aim(on, seen / q.half + (random.nextBoolean() ? off : -off), side, random);
    }

    private static double size(SplittableRandom random, boolean adversarial) {
        return switch (random.nextInt(adversarial ? 6 : 12)) {
            case 0 -> StrictMath.pow(10, -random.nextDouble(0, adversarial ? 8 : 3));
            case 1 -> adversarial ? 0 : 1;
            default -> random.nextDouble(0.05, 1.5);
        };
    }
}
