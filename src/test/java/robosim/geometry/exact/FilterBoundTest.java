package robosim.geometry.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.ChildJvm;
import robosim.geometry.Effort;
import robosim.geometry.bench.Answers;
import robosim.geometry.bench.Questions;
import robosim.geometry.bench.Questions.Family;
import robosim.geometry.bench.Questions.Subject;
import robosim.geometry.narrow.AimedBounds;
import robosim.geometry.narrow.leaf.LeafKind;

/** Every verdict with its filter on, off and in doubt, in JVMs of their own. */
@Tag("slow")
class FilterBoundTest {
    private static final long SEED = 20261121;

    private static final Set<LeafKind> CERTIFIED = Set.of(LeafKind.UPRIGHT_CYLINDER, LeafKind.SPHERE);

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
            Subject.PRODUCTS,
            Subject.BORDER
        };
        int count = Effort.cases(150, 40);
        List<Family> families = Questions.families(subjects);
        double[] here = Answers.here(families, SEED, count);
        double[] there = Answers.forked(filter(mode), families, SEED, count);
        int touching = 0;
        for (int k = 0; k < here.length; k++) {
            Family family = families.get(k / count);
            if (!isSame(family, SEED, k % count, here[k], there[k])) {
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

    // On the rim of an upright cylinder the time of a sphere is certified, and may be that of another bracket.
    private static boolean isCertified(Family family) {
        return family.subject() == Subject.TRANSLATION
                && !family.planar()
                && family.kindA() != family.kindB()
                && CERTIFIED.contains(family.kindA())
                && CERTIFIED.contains(family.kindB());
    }

    // A distance or a time may be any within its bound; what is decided must be the same.
    private static boolean isSame(Family family, long seed, int number, double here, double there) {
        if (here == there || (Double.isNaN(here) && Double.isNaN(there))) {
            return true;
        }
        boolean isFinite =
                here >= 0 && there >= 0 && here < Double.POSITIVE_INFINITY && there < Double.POSITIVE_INFINITY;
        Questions question = new Questions();
        question.make(family, seed, number);
        if (isCertified(family)) {
            // Neither is late, and at the earlier the gap is within the bound of TranslationAdvancement.
            double earlier = Math.min(here, there);
            return earlier > 0 && question.gap(earlier) <= 0x1p-42 * question.sum();
        }
        return switch (family.subject()) {
            case RAY, CONE -> {
                // In space a start inside is told from one outside; in the plane a start at the border may be either.
                boolean isDecided = family.planar() || (here > 0 && there > 0);
                double ulp = Math.ulp(Math.max(here, question.size()));
                yield isFinite && isDecided && Math.abs(here - there) <= 8 * ulp;
            }
            case TRANSLATION -> isFinite && here > 0 && there > 0 && Math.abs(here - there) <= 4 * Math.ulp(there);
            default -> false;
        };
    }

    /** Each bound is no more than ten times what rounding does at worst: a tenth of it lets a wrong answer through. */
    @Test
    void aTenthOfABoundIsTooLittle() throws IOException {
        Map<String, Family> families = new LinkedHashMap<>();
        families.put("RectangleRectangle", overlap(true, LeafKind.UPRIGHT_BOX, LeafKind.UPRIGHT_BOX));
        families.put("ZonogonZonogon", overlap(true, LeafKind.BOX, LeafKind.BOX));
        families.put("PolygonPolygon", overlap(true, LeafKind.TRIANGLE, LeafKind.TRIANGLE));
        families.put("DiscDisc", overlap(true, LeafKind.SPHERE, LeafKind.SPHERE));
        families.put("DiscRectangle", overlap(true, LeafKind.UPRIGHT_BOX, LeafKind.SPHERE));
        families.put("PolytopePolytope", overlap(false, LeafKind.BOX, LeafKind.BOX));
        families.put("SpatialOverlap.spheres", overlap(false, LeafKind.SPHERE, LeafKind.SPHERE));
        families.put("RayDisc", ray(true, LeafKind.SPHERE));
        families.put("RayRectangle", ray(true, LeafKind.UPRIGHT_BOX));
        families.put("RayPolygon", ray(true, LeafKind.TRIANGLE));
        families.put("RaySphere", ray(false, LeafKind.SPHERE));
        families.put("RayBox", ray(false, LeafKind.BOX));
        families.put("RayTriangle", ray(false, LeafKind.TRIANGLE));
        families.put("RayCylinder", ray(false, LeafKind.CYLINDER));
        families.put("RayPrism", ray(false, LeafKind.PRISM));
        families.put("Orientation.side", new Family(Subject.SIDE, true, LeafKind.UPRIGHT_BOX, LeafKind.UPRIGHT_BOX));
        families.put(
                "Orientation.volume", new Family(Subject.VOLUME, false, LeafKind.UPRIGHT_BOX, LeafKind.UPRIGHT_BOX));
        families.put("Border", new Family(Subject.BORDER, false, LeafKind.CYLINDER, LeafKind.CYLINDER));
        List<Family> asked = List.copyOf(families.values());
        int count = 15_000;
        double[] right = Answers.here(asked, 9, count);
        double[] mutant = Answers.forked(filter("tenth"), asked, 9, count);
        int at = 0;
        for (String bound : families.keySet()) {
            int wrong = 0;
            for (int k = at; k < at + count; k++) {
                wrong += isSame(asked.get(k / count), 9, k % count, right[k], mutant[k]) ? 0 : 1;
            }
            assertThat(wrong)
                    .as("wrong answers with a tenth of the bound of " + bound)
                    .isPositive();
            at += count;
        }
    }

    /** The same of bounds that random questions do not reach: all right as derived, none without wrong answers at a tenth. */
    @Test
    void aTenthOfABoundThatIsAimedAtIsTooLittle() throws IOException {
        List<String> derived =
                Answers.run(filter("on"), AimedBounds.class, List.of()).lines().toList();
        assertThat(derived).hasSize(3).allSatisfy(line -> assertThat(line).endsWith(" 0"));
        List<String> mutant = Answers.run(filter("tenth"), AimedBounds.class, List.of())
                .lines()
                .filter(line -> line.matches("[A-Z]\\w+\\.\\w+ \\d+"))
                .toList();
        assertThat(mutant).hasSize(3).allSatisfy(line -> assertThat(line).doesNotEndWith(" 0"));
    }

    private static Family overlap(boolean planar, LeafKind kindA, LeafKind kindB) {
        return new Family(Subject.OVERLAP, planar, kindA, kindB);
    }

    private static Family ray(boolean planar, LeafKind kind) {
        return new Family(Subject.RAY, planar, kind, kind);
    }

    @Test
    void anythingButTheDefaultIsLoggedAndWhatIsNoModeIsRefused() throws IOException {
        String warned =
                Answers.run(filter("alone"), Answers.class, List.of("", "1", "1", "SIDE:true:UPRIGHT_BOX:UPRIGHT_BOX"));
        assertThat(warned).contains("WARNING").contains(FilterBound.PROPERTY + " is alone");
        String refused = Answers.run(
                filter("perhaps"), Answers.class, List.of("", "1", "1", "SIDE:true:UPRIGHT_BOX:UPRIGHT_BOX"));
        assertThat(refused).contains(FilterBound.PROPERTY + " must be").contains("(got: perhaps)");
        assertThat(FilterBound.bound(3)).isEqualTo(3);
    }

    private static List<String> filter(String mode) {
        List<String> options = new ArrayList<>(ChildJvm.FLAGS);
        options.add("-D" + FilterBound.PROPERTY + "=" + mode);
        return options;
    }
}
