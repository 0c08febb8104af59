package robosim.geometry.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Each block of Java in a page or in javadoc compiles, runs, and gives the values that its comments state. */
@Tag("slow")
class SnippetsTest {
    @TempDir
    static Path folder;

    private static int seen;
    private static int run;

    @TestFactory
    List<DynamicTest> ofThePages() throws IOException {
        List<DynamicTest> tests = new ArrayList<>();
        for (Path page : Pages.markdown()) {
            tests.addAll(tests(Pages.blocks(page).stream()
                    .filter(block -> block.language().equals("java"))
                    .toList()));
        }
        assertThat(tests).hasSizeGreaterThan(12);
        return tests;
    }

    @TestFactory
    List<DynamicTest> ofTheJavadoc() throws IOException {
        List<DynamicTest> tests = new ArrayList<>();
        for (Path source : Pages.exported()) {
            tests.addAll(tests(Pages.javadoc(source).stream()
                    .filter(block -> !block.code().stripLeading().startsWith("<"))
                    .toList()));
        }
        assertThat(tests).hasSizeGreaterThan(4);
        return tests;
    }

    /** In their order, so that one which continues has what came before it. */
    private static List<DynamicTest> tests(List<Block> blocks) {
        List<DynamicTest> tests = new ArrayList<>();
        StringBuilder before = new StringBuilder();
        for (Block block : blocks) {
            if (!block.continues()) {
                before.setLength(0);
            }
            String earlier = before.toString();
            tests.add(DynamicTest.dynamicTest(block.place(), () -> {
                seen++;
                run += block.isOnlyCompiled() ? 0 : 1;
                SnippetRunner.check(block, earlier, Files.createTempDirectory(folder, "snippet"));
            }));
            before.append(block.code());
        }
        return tests;
    }

    /** Nothing is shown by blocks that are never run, or that state nothing. */
    @AfterAll
    static void mostAreRun() {
        if (seen > 20) {
            assertThat(run).as("of %d blocks are run", seen).isGreaterThan(seen / 2);
            assertThat(Stated.checks()).as("values compared").isGreaterThan(15);
        }
    }

    private static Block block(String code) {
        return new Block("page.md", 1, "java", "", code);
    }

    private static void check(Block block) throws Throwable {
        SnippetRunner.check(block, "", Files.createTempDirectory(folder, "snippet"));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "int a = ;",
                "Geometry geometry = new Geometry(1, 2);",
                "new Geometry().simpleMove(\"robot\", 1, 0);",
                "class Robot { void run() { geometry.move(); } }",
                "@Test void fails() { fail(); }",
                "@Test @World(\"worlds/rooms.xml\") void drives(RobotWorld world) { world.robot(\"drum 1\").drives(1e3); }",
                "new Geometry().simpleMove(\"robot\", 1, 0, 0);",
                "double a = 0.1 + 0.2; // 0.31",
                "Math.max(1, 2); // 3: the larger one",
                "boolean a = 1 > 2; // true",
                "String a = \"wall\"; // \"walls\"",
                "List.of(1, 2).size(); // 3",
                "new Geometry().accuracy(); // DOP",
                "double a = Math.sqrt(\n        2); // 1.5",
                "for (int k = 0; k < 3; k++) {\n    int a = 2 * k; // 0\n}",
            })
    void whatIsBrokenIsSeen(String code) {
        assertThatThrownBy(() -> check(block(code + "\n")))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("page.md:1: ");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "double a = 0.1 + 0.2; // 0.3, about",
                "Math.max(1, 2); // 2: the larger one",
                "double a = Double.POSITIVE_INFINITY; // +Infinity",
                "double a = 1 / 0.0; // Infinity",
                "String a = null; // null",
                "String a = \"wall\"; // \"wall\"",
                "long a = 1000; // 1,000 of them",
                "new Geometry().accuracy(); // EXACT",
                "int a = 1; // 2nd is no value",
                "import java.util.concurrent.TimeUnit;\nTimeUnit unit = TimeUnit.DAYS; // DAYS",
                "record Pair(int a, int b) {}",
                "@Test\nvoid holds() { assertTrue(true); }",
            })
    void whatHoldsPasses(String code) throws Throwable {
        check(block(code + "\n"));
    }

    @Test
    void markersSayWhatIsTakenForGranted() throws Throwable {
        Block given = new Block("page.md", 1, "java", "given Geometry world, String name", "world.hasObject(name);\n");
        check(given);
        assertThatThrownBy(() -> check(block(given.code()))).hasMessageContaining("cannot find symbol");
        Block continues = new Block("page.md", 1, "java", "continues; compiled", "a = Integer.parseInt(\"x\");\n");
        SnippetRunner.check(continues, "int a = 1;\n", Files.createTempDirectory(folder, "snippet"));
        assertThat(continues.continues()).isTrue();
        SnippetRunner.check(
                block("new Robot().wheels(); // 4\n"),
                "public final class Robot {\n    int wheels() {\n        return 4;\n    }\n}\n",
                Files.createTempDirectory(folder, "snippet"));
    }

    @Test
    void blocksOfAPageAreFound(@TempDir Path place) throws IOException {
        Path page = place.resolve("page.md");
        Files.writeString(
                page, "text\n<!-- java: compiled -->\n```java\nint a;\n```\n\n```\nnot java\n```\n    ```java\nb();\n");
        assertThat(Pages.blocks(page))
                .extracting(Block::line, Block::language, Block::marker, Block::code)
                .containsExactly(
                        org.assertj.core.groups.Tuple.tuple(4, "java", "compiled", "int a;\n"),
                        org.assertj.core.groups.Tuple.tuple(8, "", "", "not java\n"),
                        org.assertj.core.groups.Tuple.tuple(11, "java", "", "b();\n"));
        Path source = place.resolve("A.java");
        Files.writeString(
                source,
                "/**\n * Text.\n *\n * <!-- java: given Geometry g -->\n * <pre>{@code\n * g.width();\n *\n *     g.height();\n"
                        + " * }</pre>\n */\nclass A {}\n");
        assertThat(Pages.javadoc(source))
                .extracting(Block::line, Block::marker, Block::code)
                .containsExactly(
                        org.assertj.core.groups.Tuple.tuple(6, "given Geometry g", "g.width();\n\n    g.height();\n"));
    }
}
