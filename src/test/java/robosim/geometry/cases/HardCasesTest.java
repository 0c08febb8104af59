package robosim.geometry.cases;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicNode;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import robosim.geometry.cases.HardCase.Question;

/** Every hard case as a test of its own. */
@Tag("slow")
class HardCasesTest {
    private static final List<HardCase> CASES = CaseReader.all();

    @TestFactory
    Stream<DynamicNode> cases() {
        return CASES.stream()
                .map(hard -> DynamicTest.dynamicTest(hard.toString(), () -> isRight(hard, Trial.run(hard))));
    }

    private static void isRight(HardCase hard, List<Finding> findings) {
        for (int k = 0; k < hard.questions().size(); k++) {
            int number = k;
            Question question = hard.questions().get(k);
            List<Finding> about = findings.stream()
                    .filter(finding -> finding.question() == number)
                    .toList();
            // A case is only of use where its truth is known as given, and is the one that its file states.
            assertThat(about).as("%s, question %d: known truths", hard, k + 1).isNotEmpty();
            Finding given = about.get(0);
            assertThat(Statement.agrees(question, question.truth(), given.truth()))
                    .as("%s, question %d: the file says %s, truth is %s", hard, k + 1, question.truth(), given.truth())
                    .isTrue();
            assertThat(given.variant().name()).isEqualTo("as given");
            assertThat(question.how().startsWith(HardCase.RECOMPUTED))
                    .as("%s, question %d: how its truth is established", hard, k + 1)
                    .isEqualTo(!given.isStated());
        }
        assertThat(findings.stream().filter(finding -> !finding.right()).toList())
                .as("%s: wrong answers of %d", hard, findings.size())
                .isEmpty();
    }

    @Test
    void everyRowHasACase() {
        Map<Character, Integer> rows = new TreeMap<>(Map.ofEntries(
                Map.entry('P', 7),
                Map.entry('T', 9),
                Map.entry('D', 4),
                Map.entry('G', 8),
                Map.entry('R', 4),
                Map.entry('S', 11),
                Map.entry('M', 7),
                Map.entry('Z', 3),
                Map.entry('E', 7),
                Map.entry('I', 6),
                Map.entry('N', 6),
                Map.entry('B', 8),
                Map.entry('U', 4)));
        Map<Character, Integer> found = new TreeMap<>();
        CASES.forEach(hard -> found.merge(hard.id().charAt(0), 1, Integer::sum));
        assertThat(CASES.stream().map(HardCase::id)).doesNotHaveDuplicates();
        rows.forEach((family, count) -> assertThat(found.getOrDefault(family, 0))
                .as("cases of family %s", family)
                .isGreaterThanOrEqualTo(count));
    }
}
