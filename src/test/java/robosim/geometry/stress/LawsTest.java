package robosim.geometry.stress;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.PlanarOverlap;
import robosim.geometry.narrow.overlap.SpatialOverlap;
import robosim.geometry.reference.Truth.Form;

/** What must hold between the answers to two questions, whatever the truth is: laws for every family of leaves. */
class LawsTest {
    private static final int CASES = 250;

    private final Scratch scratch = new Scratch();

    private static List<Family> leaves() {
        return Families.all().stream()
                .filter(f -> f instanceof OverlapFamily || f instanceof RayFamily || f instanceof SweepFamily)
                .toList();
    }

    /** Asks random and adversarial questions of families; the answers are a mix. */
    private void ask(Predicate<Family> which, Law law) {
        Case question = new Case();
        int families = 0;
        for (Family family : leaves()) {
            if (!which.test(family)) {
                continue;
            }
            families++;
            Family.Source source =
                    family.source(new SplittableRandom(family.name().hashCode()));
            int yes = 0;
            for (int k = 0; k < CASES; k++) {
                if (k % 2 == 0) {
                    source.random(question);
                } else {
                    source.adversarial(question);
                }
                int answer = family.product(question, scratch);
                yes += answer > 0 ? 1 : 0;
                law.check(family, question, answer);
            }
            assertThat(yes).as(family.name()).isBetween(CASES / 6, CASES * 9 / 10);
        }
        assertThat(families).isPositive();
    }

    private interface Law {
        void check(Family family, Case question, int answer);
    }

    private void unchanged(Predicate<Family> which, Consumer<Case> change) {
        Case changed = new Case();
        ask(which, (family, question, answer) -> {
            changed.copyFrom(question);
            change.accept(changed);
            assertThat(family.product(changed, scratch))
                    .as(() -> family.call() + "\n" + question.paste() + "changed\n" + changed.paste())
                    .isEqualTo(answer);
        });
    }

    @Test
    void theOrderOfTwoMakesNoDifference() {
        unchanged(f -> f instanceof OverlapFamily, Mutations::swap);
    }

    @Test
    void theOneMovingOrTheOtherBackMakesNoDifference() {
        unchanged(f -> f instanceof SweepFamily, c -> {
            Mutations.swap(c);
            for (int k = 3; k < 6; k++) {
                c.ray[k] = -c.ray[k];
            }
        });
    }

    @Test
    void aQuarterTurnOfAllMakesNoDifference() {
        unchanged(f -> true, Changes::quarterTurn);
    }

    @Test
    void aMirrorMakesNoDifference() {
        unchanged(f -> true, Changes::mirror);
    }

    @Test
    void theOrderOfCornersMakesNoDifference() {
        unchanged(f -> f.name().contains("triangle"), Changes::permute);
    }

    @Test
    void aPowerOfTwoMakesNoDifference() {
        unchanged(f -> true, c -> Changes.scale(c, 7));
    }

    @Test
    void theLengthOfARaysDirectionMakesNoDifference() {
        unchanged(f -> f instanceof RayFamily, c -> {
            for (int k = 3; k < 6; k++) {
                c.ray[k] = Math.scalb(c.ray[k], 5);
            }
        });
    }

    @Test
    void toGrowByAnUlpPartsNothing() {
        Case grown = new Case();
        ask(f -> true, (family, question, answer) -> {
            grown.copyFrom(question);
            if (Changes.grow(grown) && answer > 0) {
                assertThat(family.product(grown, scratch))
                        .as(() -> family.call() + "\n" + question.paste())
                        .isPositive();
            }
        });
    }

    /** A point further, nothing rounded. */
    @Test
    void aDyadicTranslationMakesNoDifference() {
        Case moved = new Case();
        int[] asked = new int[1];
        ask(f -> true, (family, question, answer) -> {
            moved.copyFrom(question);
            if (isMovedExactly(moved, 512)) {
                asked[0]++;
                assertThat(family.product(moved, scratch))
                        .as(() -> family.call() + "\n" + question.paste())
                        .isEqualTo(answer);
            }
        });
        assertThat(asked[0]).isGreaterThan(500);
    }

    private static boolean isMovedExactly(Case c, double by) {
        Case was = new Case();
        was.copyFrom(c);
        Forms.move(c.formA, c.a, by, -by, by);
        Forms.move(c.formB, c.b, by, -by, by);
        c.ray[0] += by;
        c.ray[1] -= by;
        c.ray[2] += by;
        boolean exact = true;
        for (int k = 0; k < 9; k++) {
            double step = k % 3 == 1 ? -by : by;
            exact &= k >= points(c.formA) || isSum(c.a[k], was.a[k], step);
            exact &= k >= points(c.formB) || isSum(c.b[k], was.b[k], step);
            exact &= k >= 3 || isSum(c.ray[k], was.ray[k], step);
        }
        return exact;
    }

    private static int points(Form form) {
        return form == Form.TRIANGLE ? 9 : 3;
    }

    private static boolean isSum(double sum, double a, double b) {
        return sum - a == b && sum - b == a;
    }

    /** The halves of a triangle cut at a dyadic middle meet what it meets, and no more. */
    @Test
    void aTriangleIsItsHalves() {
        Case half = new Case();
        int[] asked = new int[2];
        ask(f -> f.name().contains("triangle"), (family, question, answer) -> {
            boolean swapped = question.formB != Form.TRIANGLE && family instanceof OverlapFamily;
            int either = 0;
            for (int k = 0; k < 2; k++) {
                half.copyFrom(question);
                if (swapped) {
                    Mutations.swap(half);
                }
                if (half.formB != Form.TRIANGLE || !Changes.halve(half, k == 1)) {
                    return;
                }
                either = Math.max(either, family.product(half, scratch));
            }
            asked[answer > 0 ? 1 : 0]++;
            assertThat(either > 0)
                    .as(() -> family.call() + "\n" + question.paste())
                    .isEqualTo(answer > 0);
        });
        assertThat(asked[0]).as("misses cut").isGreaterThan(50);
        assertThat(asked[1]).as("hits cut").isGreaterThan(50);
    }

    /** What stands upright at one height meets in space where its plan does. */
    @Test
    void uprightThingsMeetAsTheirPlansDo() {
        Case level = new Case();
        ask(f -> f.name().startsWith("upright") && f instanceof OverlapFamily, (family, question, answer) -> {
            level.copyFrom(question);
            level.b[1] = level.a[1];
            LeafKind kindA = OverlapFamily.kind(level.formA);
            LeafKind kindB = OverlapFamily.kind(level.formB);
            if (!kindA.isVerticalPrism() || !kindB.isVerticalPrism()) {
                return;
            }
            assertThat(SpatialOverlap.test(new Leaf(kindA, level.a, 0), new Leaf(kindB, level.b, 0), scratch.overlap))
                    .as(() -> family.call() + "\n" + level.paste())
                    .isEqualTo(PlanarOverlap.test(
                            new Leaf(kindA, level.a, 0), new Leaf(kindB, level.b, 0), scratch.overlap));
        });
    }
}
