package robosim.geometry.cases;

import java.math.BigDecimal;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.cases.Trial.UnknownTruthException;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.reference.Gaps;

/** One variant of the question how far an object may go. */
final class DriveTrial {
    /** How early a contact may be answered: 4 ulp of the largest number that it was computed from. */
    private static final double EARLY = 0x1p-50;

    /** How many times that a fraction may be early so that it can be used. */
    private static final double USABLE = 64;

    private final HardCase.Drive question;
    private final Variant variant;
    private final GeometryObject mover;
    private final List<GeometryObject> others;
    private final Point way;
    private final Map<String, double[]> turns;

    /** Whether the way that is stored is the way that was asked for, up to a rounding. */
    private final boolean isWhole;

    /** Where a finding goes. */
    interface Sink {
        void find(String truth, boolean isStated, String ours, boolean right);
    }

    DriveTrial(HardCase hard, HardCase.Drive question, Variant variant, Map<String, double[]> turns) {
        this.turns = turns;
        this.question = question;
        this.variant = variant;
        mover = variant.place(hard.object(question.mover())).moveable("mover");
        others = hard.objects(question.of()).stream().map(variant::place).toList();
        double[] w = question.way();
        double s = variant.scale();
        Point c = mover.center();
        way = new Point(stored(c.x(), w[0] * s), stored(c.y(), w[1] * s), stored(c.z(), w[2] * s));
        isWhole = isAlike(way.x(), w[0] * s) && isAlike(way.y(), w[1] * s) && isAlike(way.z(), w[2] * s);
    }

    private static boolean isAlike(double stored, double asked) {
        return Math.abs(stored - asked) <= 1e-6 * Math.abs(asked);
    }

    /** From the stored start to the stored end. */
    private static double stored(double start, double by) {
        return (start + by) - start;
    }

    void run(Sink sink) {
        boolean touching =
                Trial.known(() -> others.stream().anyMatch(other -> Gaps.overlap(mover, other, variant.dimension())));
        Geometry world = Trial.world(variant.dimension(), all(), Truth.size(mover) + Truth.size(Trial.point(way)));
        boolean fits = world.addObjectUnchecked(mover);
        List<GeometryObject> order = variant.swapped() ? reversed() : others;
        fits &= order.stream().allMatch(world::addObjectUnchecked);
        MoveResult result = world.moveGlobal("mover", new Move(way.x(), way.y(), way.z(), 0, question.turn()));
        String ours = !fits
                ? "does not fit into its world"
                : result.allowed()
                        ? "free"
                        : result.fraction() < 1 || question.turn() == 0
                                ? Double.toString(result.fraction())
                                : "turn " + result.turnFraction();
        if (touching) {
            sink.find(fromFile(), true, ours, ours.equals(fromFile()));
            return;
        }
        // Rounded down, and so far from contact that a caller can use it, however that rounds: some roundings of the
        // place.
        double allowed = USABLE * EARLY * size() / length() + 4 * Math.ulp(1.0);
        if (!variant.name().endsWith("as given")) {
            boolean never = Trial.known(() -> !touchesBy(1));
            if (!never) {
                double late = Math.min(1, result.fraction() + allowed);
                boolean right = fits && !result.allowed() && !touchesBy(result.fraction()) && touchesBy(late);
                sink.find("within " + allowed + " before contact", false, ours, right);
                return;
            }
        } else {
            BigDecimal share = Trial.known(this::share);
            if (share != null) {
                boolean right = fits
                        && !result.allowed()
                        && share.subtract(new BigDecimal(result.fraction())).signum() > 0
                        && Trial.far(share, result.fraction()) <= allowed;
                sink.find(Double.toString(share.doubleValue()), false, ours, right);
                return;
            }
        }
        double[] turn = question.turn() == 0 ? null : Trial.known(this::turn);
        if (turn == null) {
            sink.find("free", false, ours, fits && result.allowed());
        } else {
            boolean right = fits
                    && result.fraction() == 1
                    && result.turnFraction() <= turn[1]
                    && result.turnFraction() >= turn[0] - question.within();
            sink.find("turn " + turn[0], false, ours, right);
        }
    }

    private List<GeometryObject> all() {
        return java.util.stream.Stream.concat(java.util.stream.Stream.of(mover), others.stream())
                .toList();
    }

    private List<GeometryObject> reversed() {
        List<GeometryObject> reversed = new java.util.ArrayList<>(others);
        java.util.Collections.reverse(reversed);
        return reversed;
    }

    /** What starts in contact is judged as the file says: in projection it may be another question. */
    private String fromFile() {
        String planar = question.planar();
        boolean inPlane = variant.dimension() == Dimension.PLANAR;
        if (question.turn() == 0 && way.equals(new Point())) {
            return "free";
        }
        if (!variant.exact() || !isWhole || (inPlane && planar == null)) {
            throw new UnknownTruthException(new IllegalArgumentException("a start in contact"));
        }
        String truth = inPlane && planar != null ? planar : question.truth();
        return truth.equals("refused") ? "0.0" : truth;
    }

    private @Nullable BigDecimal share() {
        BigDecimal first = null;
        for (GeometryObject other : others) {
            BigDecimal share = Gaps.touch(mover, way, other, variant.dimension());
            if (share != null && (first == null || share.compareTo(first) < 0)) {
                first = share;
            }
        }
        return first;
    }

    private boolean touchesBy(double share) {
        return others.stream().anyMatch(other -> Gaps.touchesBy(share, mover, way, other, variant.dimension()));
    }

    private double @Nullable [] turn() {
        // Scaling leaves the share of a turn as it is.
        String key = variant.dimension() + " " + question;
        if (variant.isScaled() && turns.containsKey(key)) {
            return turns.get(key);
        }
        Point c = mover.center();
        GeometryObject there = mover.movedTo(new Point(c.x() + way.x(), c.y() + way.y(), c.z() + way.z()));
        double[] bracket = Truth.turn(there, question.turn(), others, variant.dimension());
        if (bracket != null && variant.name().endsWith("as given")) {
            turns.put(key, bracket);
        }
        return bracket;
    }

    private double size() {
        return all().stream().mapToDouble(Truth::size).max().orElse(0) + Truth.size(Trial.point(way));
    }

    private double length() {
        double vertical = variant.dimension() == Dimension.PLANAR ? 0 : way.y();
        return Math.sqrt(way.x() * way.x() + vertical * vertical + way.z() * way.z());
    }
}
