package robosim.geometry.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.bench.Answers;
import robosim.geometry.bench.Questions;
import robosim.geometry.bench.Questions.Family;
import robosim.geometry.bench.Questions.Subject;

/** Every verdict with its filter on, off and in doubt, in JVMs of their own. */
class FilterTest {
    private static final long SEED = 20261121;

    @ParameterizedTest
    @ValueSource(strings = {"doubt", "off"})
    void whatTheFilterDecidesIsWhatTheExactPathsDecide(String mode) throws IOException {
        Subject[] subjects = {
            Subject.OVERLAP,
            Subject.RAY,
            Subject.CONE,
            Subject.TRANSLATION,
            Subject.SIDE,
            Subject.VOLUME,
            Subject.PRODUCTS
        };
        int count = 150;
        List<Family> families = Questions.families(subjects);
        double[] here = Answers.here(families, SEED, count);
        double[] there = Answers.forked(filter(mode), subjects, SEED, count);
        int touching = 0;
        for (int k = 0; k < here.length; k++) {
            Family family = families.get(k / count);
            if (!isSame(family, k % count, here[k], there[k])) {
                Questions question = new Questions();
                question.make(family, SEED, k % count);
                assertThat(here[k])
                        .as("question %d, %s: %s", k % count, mode, question)
                        .isEqualTo(there[k]);
            }
            touching += family.subject() == Subject.OVERLAP && here[k] == 1 ? 1 : 0;
        }
        int overlaps = (int) families.stream()
                        .filter(f -> f.subject() == Subject.OVERLAP)
                        .count()
                * count;
        assertThat(touching).isBetween(overlaps / 8, overlaps / 2);
    }

    // A distance or a time may be any within its bound; what is decided must be the same.
    private static boolean isSame(Family family, int number, double here, double there) {
        if (here == there || (Double.isNaN(here) && Double.isNaN(there))) {
            return true;
        }
        boolean isFinite =
                here >= 0 && there >= 0 && here < Double.POSITIVE_INFINITY && there < Double.POSITIVE_INFINITY;
        return switch (family.subject()) {
            case RAY, CONE -> {
                Questions question = new Questions();
                question.make(family, SEED, number);
                // In space a start inside is told from one outside; in the plane a start at the border may be either.
                boolean isDecided = family.planar() || (here > 0 && there > 0);
                double ulp = Math.ulp(Math.max(here, question.size()));
                yield isFinite && isDecided && Math.abs(here - there) <= 8 * ulp;
            }
            case TRANSLATION -> isFinite && here > 0 && there > 0 && Math.abs(here - there) <= 4 * Math.ulp(there);
            default -> false;
        };
    }

    @Test
    void aTenthOfTheBoundsIsTooLittleForEachOfTheDeterminants() throws IOException {
        assertThat(wrong("tenth", Subject.SIDE, 20_000)).isPositive();
        assertThat(wrong("tenth", Subject.VOLUME, 20_000)).isPositive();
    }

    private static int wrong(String mode, Subject subject, int count) throws IOException {
        double[] right = Answers.here(Questions.families(subject), SEED, count);
        double[] mutant = Answers.forked(filter(mode), new Subject[] {subject}, SEED, count);
        int wrong = 0;
        for (int k = 0; k < right.length; k++) {
            wrong += right[k] != mutant[k] ? 1 : 0;
        }
        return wrong;
    }

    @Test
    void anythingButTheDefaultIsLoggedAndWhatIsNoModeIsRefused() throws IOException {
        String warned = Answers.run(filter("alone"), Answers.class, List.of("", "1", "1", "SIDE"));
        assertThat(warned).contains("WARNING").contains(Filter.PROPERTY + " is alone");
        String refused = Answers.run(filter("perhaps"), Answers.class, List.of("", "1", "1", "SIDE"));
        assertThat(refused).contains(Filter.PROPERTY + " must be").contains("(got: perhaps)");
        assertThat(Filter.bound(3)).isEqualTo(3);
    }

    private static List<String> filter(String mode) {
        return List.of("-D" + Filter.PROPERTY + "=" + mode);
    }
}
