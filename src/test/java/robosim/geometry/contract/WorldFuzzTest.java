package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/**
 * Worlds of all layouts, in both dimensions and at all accuracies, against lists of their objects: some thousand operations in
 * an ordinary build, ten million under {@code -Pstress}.
 *
 * <p>The system properties {@code stress.worlds} and {@code stress.seed} are how many operations there are and where they
 * start, {@code stress.layouts} a regular expression as in {@code "TILES SPATIAL .*"}.
 */
@Tag("slow")
class WorldFuzzTest {
    private static final long OPERATIONS = Long.getLong("stress.worlds", Effort.cases(20_000));
    private static final long SEED = Long.getLong("stress.seed", 20_261_122);
    private static final String NAMES = System.getProperty("stress.layouts", ".*");

    /** With no more operations than this, half of the 170 shapes of world are asked. */
    private static final long FEW = 20_000;

    @Test
    void aWorldAnswersAsAListOfItsObjects() {
        List<WorldFuzz> shapes = new ArrayList<>();
        for (WorldLayout layout : WorldLayout.values()) {
            for (Dimension dimension : Dimension.values()) {
                for (Accuracy accuracy : Accuracy.values()) {
                    int shape = 3 * layout.ordinal() + 5 * dimension.ordinal() + accuracy.ordinal();
                    boolean isOneOfSome = OPERATIONS > FEW || shape % 2 == 0;
                    if (isOneOfSome
                            && "%s %s %s".formatted(layout, dimension, accuracy).matches(NAMES)) {
                        shapes.add(new WorldFuzz(layout, dimension, accuracy));
                    }
                }
            }
        }
        assertThat(shapes).as("layouts named " + NAMES).isNotEmpty();
        long each = OPERATIONS / shapes.size();
        long operations = 0;
        long moves = 0;
        long refusals = 0;
        long takenBack = 0;
        long standing = 0;
        List<String> divergences = new ArrayList<>();
        shapes.parallelStream().forEach(shape -> {
            for (long life = 0; shape.operations < each; life++) {
                shape.live(SEED + life, (int) Math.min(WorldFuzz.LIFE, each));
            }
            shape.forget();
        });
        for (WorldFuzz shape : shapes) {
            operations += shape.operations;
            moves += shape.moves;
            refusals += shape.refusals;
            takenBack += shape.takenBack;
            standing += shape.standing;
            divergences.addAll(shape.divergences);
        }
        if (each > WorldFuzz.LIFE) {
            System.out.printf(
                    "%,d operations in worlds of %d shapes, of seed %d: %,d moves, %,d of them refused; %,d shares taken"
                            + " back for the place as it is stored, %,d moves over what lies behind a contact's plane;"
                            + " %d divergences%n",
                    operations, shapes.size(), SEED, moves, refusals, takenBack, standing, divergences.size());
        }
        assertThat(divergences).as("of %d operations", operations).isEmpty();
        assertThat(moves).isBetween(operations / 5, operations * 3 / 5);
        assertThat(refusals).isBetween(moves / 20, moves * 4 / 5);
        assertThat(takenBack).isLessThan(moves / 1000 + 5);
    }
}
