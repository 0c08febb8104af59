package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/** From which gap on verdicts can be relied on. */
final class Resolution {
    /** More wrong than this, and a gap is not told apart. */
    static final double MOST_WRONG = 0.05;

    static final String METRIC = "resolution";

    private static final String STUDY = "verdicts";

    private Resolution() {}

    /** One decade of gaps: its lower end in size with the sign of the gap, and what came of it. */
    record Bin(double gap, double asked, double wrong) {
        double share() {
            return wrong / asked;
        }
    }

    /** All decades of some pairs together, from the deepest overlap to the widest gap. */
    static List<Bin> bins(Results results, Subject subject, List<String> pairs) {
        List<String> names = new ArrayList<>();
        for (int exponent = Verdicts.HIGH; exponent >= Verdicts.LOW - 1; exponent--) {
            names.add("-1e" + exponent);
        }
        names.add(Verdicts.TOUCH);
        for (int exponent = Verdicts.LOW - 1; exponent <= Verdicts.HIGH; exponent++) {
            names.add("1e" + exponent);
        }
        List<Bin> bins = new ArrayList<>();
        for (String name : names) {
            double asked = 0;
            double wrong = 0;
            for (String pair : pairs) {
                asked += results.value(STUDY, subject, pair, "overlap", "asked " + name)
                        .orElse(0);
                wrong += results.value(STUDY, subject, pair, "overlap", "wrong " + name)
                        .orElse(0);
            }
            if (asked > 0) {
                bins.add(new Bin(Double.parseDouble(name), asked, wrong));
            }
        }
        return bins;
    }

    /**
     * The widest gap or depth about which more than 5 % are wrong, 0 where there is none; a touch to the last bit does not
     * count, as others mean something else by it. Empty where nothing was asked.
     */
    static OptionalDouble of(Results results, Subject subject, String pair) {
        return results.value(STUDY, subject, pair, "overlap", METRIC);
    }

    /** The worst over pairs, each for itself. */
    static OptionalDouble worst(Results results, Subject subject) {
        List<String> pairs = pairs(results, subject.dimension());
        OptionalDouble worst = OptionalDouble.empty();
        for (String pair : pairs) {
            OptionalDouble one = of(results, subject, pair);
            if (one.isPresent()) {
                worst = OptionalDouble.of(Math.max(worst.orElse(0), one.getAsDouble()));
            }
        }
        return worst;
    }

    static List<String> pairs(Results results, String dimension) {
        return results
                .where(measure -> measure.study().equals(STUDY)
                        && measure.subject().dimension().equals(dimension))
                .stream()
                .map(Measure::scene)
                .distinct()
                .toList();
    }

    /** Wrong answers of all that were asked: apart and said to collide, or colliding and said to be free; or exact touch. */
    static double wrong(List<Bin> bins, int sign) {
        return bins.stream()
                .filter(bin -> Math.signum(bin.gap) == sign)
                .mapToDouble(Bin::wrong)
                .sum();
    }

    static double asked(List<Bin> bins) {
        return bins.stream().mapToDouble(Bin::asked).sum();
    }
}
