package robosim.geometry.census;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.exact.Rotations;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** How far a cone in space hears a cylinder. */
final class CylinderCone implements Kernel {
    /** What is documented: the answer is not above the truth, and below by this share of it at most. */
    private static final double SHARE = 0x1p-40;

    /**
     * Nearer than this share of the offsets and sizes the answer may be below by as much; and what is silent may be heard
     * where the cylinder passes the cone by less.
     */
    private static final double NEAREST = 0x1p-44;

    /** A cone hears no later than the ray along its axis, whose distance is so good. */
    private static final double RAY_ULPS = 4;

    private final ConeQuestion q = new ConeQuestion(LeafKind.CYLINDER);

    @Override
    public String name() {
        return "cone, cylinder, spatial";
    }

    @Override
    public List<String> regimes() {
        return List.of(
                "apex inside",
                "foot in the cone, on a cap",
                "foot in the cone, on the mantle",
                "foot in the cone, on a rim",
                "border and cap, apex over the cap",
                "border and cap, apex beside",
                "border and mantle, apex between the planes",
                "border and mantle, apex beyond one",
                "border and rim, apex between the planes",
                "border and rim, apex over the cap",
                "border and rim, apex beside and beyond",
                "silent",
                "grazing");
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        make(random, adversarial);
        double answer = q.ask();
        double upper = q.upper();
        CylinderConeTwin twin = new CylinderConeTwin(q);
        String regime = regime(twin);
        String truth = twin.low + " to " + twin.high;
        if (twin.high == 0) {
            return answer == 0 ? Visit.right(regime) : Visit.wrong(regime, q.paste(answer, truth));
        }
        if (twin.low == Double.POSITIVE_INFINITY || answer == Double.POSITIVE_INFINITY) {
            boolean isRight =
                    answer == Double.POSITIVE_INFINITY ? twin.high == Double.POSITIVE_INFINITY : passesClosely();
            return isRight ? Visit.right(regime) : Visit.wrong(regime, q.paste(answer, truth));
        }
        double nearest = NEAREST * q.extent();
        double bound = answer > nearest ? SHARE * answer : nearest;
        if (answer == q.ray()) {
            bound = Math.max(bound, RAY_ULPS * Math.ulp(q.extent()));
        }
        return Visit.number(
                regime,
                Math.max(0, twin.low - answer) / bound,
                answer > twin.high ? 2 : 0,
                regime.equals("grazing") ? 0 : (Math.max(answer, upper) - answer) / bound,
                () -> q.paste(answer, truth));
    }

    // Whether a cylinder that is a little larger is not silent.
    private boolean passesClosely() {
        double more = NEAREST * q.extent();
        q.row[3] += more;
        q.row[4] += more;
        boolean isSilent = new CylinderConeTwin(q).low == Double.POSITIVE_INFINITY;
        q.row[3] -= more;
        q.row[4] -= more;
        return !isSilent;
    }

    private static String regime(CylinderConeTwin t) {
        if (t.high == 0) {
            return "apex inside";
        }
        if (t.isFoot) {
            return "foot in the cone, on " + (t.isBetween ? "the mantle" : t.isWithin ? "a cap" : "a rim");
        }
        if (t.low == Double.POSITIVE_INFINITY) {
            return "silent";
        }
        if (t.high == Double.POSITIVE_INFINITY || t.high - t.low > 0x1p-36 * t.high) {
            return "grazing";
        }
        if (t.isCap) {
            return "border and cap, apex " + (t.isWithin ? "over the cap" : "beside");
        }
        if (t.isMantle) {
            return "border and mantle, apex " + (t.isBetween ? "between the planes" : "beyond one");
        }
        return "border and rim, apex "
                + (t.isBetween ? "between the planes" : t.isWithin ? "over the cap" : "beside and beyond");
    }

    private void make(SplittableRandom random, boolean adversarial) {
        Arrays.fill(q.row, 0);
        Rotations.identity(q.row, Leaf.ROTATION);
        q.kind = LeafKind.UPRIGHT_CYLINDER;
        double radius = random.nextDouble(0.05, 2);
        double half = random.nextDouble(0.05, 2);
        int shape = random.nextInt(6);
        if (shape == 0) {
            radius = 10; // a round floor
        } else if (shape == 1) {
            radius = adversarial && random.nextInt(4) == 0 ? 0 : StrictMath.pow(10, -random.nextDouble(1, 4));
        } else if (shape == 2) {
            half = adversarial && random.nextInt(4) == 0 ? 0 : StrictMath.pow(10, -random.nextDouble(1, 4));
        }
        q.row[3] = radius;
        q.row[4] = half;
        do {
            stand(random, radius, half, adversarial);
        } while (isInside() && random.nextInt(4) == 0);
        double degrees = random.nextDouble(0.5, 89.99);
        if (adversarial) {
            degrees =
                    StrictMath.pow(10, random.nextInt(8) == 0 ? -random.nextDouble(0, 6) : random.nextDouble(0, 1.954));
        }
        q.widen(StrictMath.toRadians(degrees));
        if (random.nextInt(20) < 10) {
            build(random, radius, half, adversarial);
        } else {
            aim(random, radius, half, adversarial);
        }
        if (random.nextInt(3) > 0) {
            q.turn(random);
            q.kind = LeafKind.CYLINDER;
        }
    }

    private boolean isInside() {
        return Math.abs(q.apex[1]) <= q.row[4] && Math.hypot(q.apex[0], q.apex[2]) <= q.row[3];
    }

    // Over a cap, beside the mantle, beyond a rim, or anywhere.
    private void stand(SplittableRandom random, double radius, double half, boolean adversarial) {
        double off = adversarial ? StrictMath.pow(10, -random.nextDouble(0, 7)) : random.nextDouble();
        double angle = random.nextDouble(-Math.PI, Math.PI);
        double away = random.nextDouble() * radius;
        double height = half * random.nextDouble(-1, 1);
        switch (random.nextInt(13)) {
            case 0, 1, 12 -> height = half + off;
            case 2, 3, 4 -> away = radius + off;
            case 5, 6, 7 -> {
                height = half + off;
                away = radius + random.nextDouble(0, 4);
            }
            case 8, 9 -> {
                height = random.nextDouble(-4, 4) * (random.nextBoolean() ? 1 : half / 4);
                away = random.nextDouble(0, 4) * (random.nextBoolean() ? 1 : radius / 4);
            }
            default -> {
                height = random.nextInt(3) == 0 ? height : half + random.nextDouble(0, 3);
                away = random.nextInt(8) == 0 ? away : radius + random.nextDouble(0, 3);
            }
        }
        q.apex[0] = away * StrictMath.cos(angle);
        q.apex[1] = random.nextBoolean() ? height : -height;
        q.apex[2] = away * StrictMath.sin(angle);
    }

    // From the answer: a point of the cylinder that is nearest along a direction n, and the cone whose border touches
    // there.
    private void build(SplittableRandom random, double radius, double half, boolean adversarial) {
        int any = random.nextInt(7);
        int part = any > 5 ? 0 : any;
        for (int attempt = 0; attempt < 30; attempt++) {
            double angle = StrictMath.atan2(q.apex[2], q.apex[0])
                    + (random.nextBoolean() ? 1.5 : 3) * random.nextDouble(-1, 1);
            double out = part == 0 ? 0 : 1;
            double up = part == 1 ? 0 : random.nextDouble(0, 4);
            if (adversarial && part > 1 && random.nextInt(3) == 0) {
                up = StrictMath.pow(10, random.nextDouble(-9, 9));
            }
            double side = Math.abs(q.apex[1]) > half == random.nextInt(8) > 0 ? 1 : -1;
            side *= q.apex[1] < 0 ? -1 : 1;
            double away = part == 0 ? radius * Math.sqrt(random.nextDouble()) : radius;
            double height = part == 1 ? half * random.nextDouble(-1, 1) : half * side;
            double c = StrictMath.cos(angle);
            double s = StrictMath.sin(angle);
            double[] v = {away * c - q.apex[0], height - q.apex[1], away * s - q.apex[2]};
            v = ConeQuestion.unit(v[0], v[1], v[2]);
            double[] n = ConeQuestion.unit(-out * c, (part == 0 ? -1 : -up) * side, -out * s);
            double along = n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
            if (along > (adversarial ? 1e-6 : 0.01)) {
                double[] w = ConeQuestion.unit(n[0] - along * v[0], n[1] - along * v[1], n[2] - along * v[2]);
                for (int k = 0; k < 3; k++) {
                    q.way[k] = q.cos * v[k] - StrictMath.sin(q.half) * w[k];
                }
                return;
            }
        }
        aim(random, radius, half, adversarial);
    }

    // The border near the foot, or a point of a cap, of the mantle, of a rim; or all but touching the rim or the
    // mantle.
    private void aim(SplittableRandom random, double radius, double half, boolean adversarial) {
        double angle = random.nextDouble(-Math.PI, Math.PI);
        double away = radius;
        double height = half * random.nextDouble(-1, 1);
        double facing = StrictMath.atan2(q.apex[2], q.apex[0]);
        int part = random.nextInt(7);
        switch (part) {
            case 0, 5, 6 -> {
                height = Math.max(-half, Math.min(half, q.apex[1]));
                away = Math.min(radius, Math.hypot(q.apex[0], q.apex[2]));
                angle = facing;
            }
            case 1 -> {
                away = radius * Math.sqrt(random.nextDouble());
                height = Math.copySign(half, q.apex[1]);
            }
            case 2 -> height = Math.copySign(half, random.nextInt(3) == 0 ? -q.apex[1] : q.apex[1]);
            default -> angle = facing + random.nextDouble(-1.4, 1.4);
        }
        double[] point = {away * StrictMath.cos(angle), height, away * StrictMath.sin(angle)};
        double off = random.nextDouble(-0.8, 0.8);
        if (adversarial && random.nextBoolean()) {
            off = StrictMath.pow(10, -random.nextDouble(1, 16)) * (random.nextBoolean() ? 1 : -1);
        }
        q.aim(point, off, random);
        if (adversarial && random.nextInt(6) == 0) {
            graze(point, random);
        }
    }

    // Turns the way within the plane of the point and the mantle's tangent, so that the border all but touches there.
    private void graze(double[] point, SplittableRandom random) {
        double[] to = ConeQuestion.unit(point[0] - q.apex[0], point[1] - q.apex[1], point[2] - q.apex[2]);
        double[] out = ConeQuestion.unit(point[0], 0, point[2]);
        double along = to[0] * out[0] + to[1] * out[1] + to[2] * out[2];
        double[] side = ConeQuestion.unit(out[0] - along * to[0], out[1] - along * to[1], out[2] - along * to[2]);
        double angle = q.half + StrictMath.pow(10, -random.nextDouble(3, 16)) * (random.nextBoolean() ? 1 : -1);
        for (int k = 0; k < 3; k++) {
            q.way[k] = StrictMath.cos(angle) * to[k] + StrictMath.sin(angle) * side[k];
        }
    }
}
