package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.IntSupplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Version;

@Tag("clock")
class CommandsTest {
    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        return Commands.run(new PrintWriter(out, true), new PrintWriter(err, true), arguments);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', textBlock = """
                    fly                                  | Unmatched argument at index 0: 'fly'
                    demo --steps 0                       | --steps must be at least 1 (got: 0)
                    demo --steps many                    | must be a whole number of at most 2147483647 (got: many)
                    render w.xml -o w.svg --slice 1,5    | must be a number, such as 12, -0.5 or 1.5e-3 (got: 1,5)
                    demo --seed -1                       | --seed must be at least 0 (got: -1)
                    demo --speed NaN                     | --speed must be above 0 (got: NaN)
                    demo --world nowhere.xml             | --world must be a file that exists; check the path (got: nowhere.xml)
                    demo --examples nowhere              | (got: nowhere/ReferenceEnvironment.java)
                    serve                                | Missing required parameter: 'PORT'
                    serve 70000                          | PORT must be 0 to 65535 (got: 70000)
                    connect localhost                    | Missing required parameter: 'PORT'
                    connect localhost 0                  | PORT must be 1 to 65535 (got: 0)
                    render worlds/rooms.xml              | Missing required option: '--output=FILE'
                    render worlds/rooms.xml -o a.bmp     | (got: a.bmp)
                    render worlds/rooms.xml -o no/a.png  | FILE must be in a folder that exists; create the folder first (got: no/a.png)
                    render worlds/rooms.xml --plan --size 9x9 -o a.png | --size is for a picture by a camera; leave it out for a plan, which has a size of its own (got: --size with --plan)
                    render worlds/rooms.xml --camera top -o a.svg | --camera is for a picture by a camera; leave it out for a plan, which has a size of its own (got: --camera with a.svg)
                    render worlds/rooms.xml --camera robot:drm -o a.png | (got: drm)
                    scan worlds/rooms.xml -o no/a.ply    | FILE must be in a folder that exists
                    scan worlds/rooms.xml -o worlds      | FILE must end in .ply, .pcd or .npy (got: worlds)
                    convert worlds/rooms.xml no/a.xml    | OUT must be in a folder that exists
                    export worlds/rooms.xml no/a.html    | PAGE must be in a folder that exists
                    add worlds/rooms.xml no/a.xml disc:1@0,0 | OUT must be in a folder that exists
                    drive worlds/pushing.xml --record no/a.scenario.jsonl | --record must be in a folder that exists
                    drive worlds/pushing.xml --robot crat | ["cart",
                    connect localhost 5 --record no/a.scenario.jsonl | --record must be in a folder that exists
                    sweep nowhere.Scenario w.xml -o no/a.jsonl | --out must be in a folder that exists
                    sweep nowhere.Scenario w.xml --table a.txt | --table must end in .md (got: a.txt)
                    sweep nowhere.Scenario w.xml --plot no/a.svg | --plot must be in a folder that exists
                    rendr worlds/rooms.xml               | Did you mean: robosim-geometry render
                    render worlds/rooms.xml --sensors -o a.png | --sensors is for a plan of the whole height; write an .svg or add --plan, without --slice (got: --sensors for a.png)
                    render worlds/rooms.xml --plna -o a.svg | Possible solutions: --plan
                    render nowhere.xml -o a.png          | WORLD must be a file that exists; check the path (got: nowhere.xml)
                    render worlds -o a.png               | WORLD must be a file, not a folder; name a file in it (got: worlds)
                    render pom.xml -o a.png              | pom.xml
                    """)
    void badArgumentsAreRefusedWithTheirReason(String line, String reason) {
        assertThat(run(line.split(" "))).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains(reason).doesNotContain("\tat ");
        assertThat(out.toString()).isEmpty();
    }

    @Test
    void nothingAtAllShowsTheCommands() {
        assertThat(run()).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("demo", "serve", "connect", "render");
    }

    @Test
    void aWorldIsDrawn(@TempDir Path folder) throws Exception {
        Path svg = folder.resolve("rooms.svg");
        assertThat(run("render", "worlds/rooms.xml", "-o", svg.toString())).isZero();
        assertThat(Files.readString(svg)).contains(">rooms<", "drum 1", "scale-bar");
        Path png = folder.resolve("rooms.png");
        assertThat(run("render", "worlds/rooms.xml", "--dark", "-o", png.toString()))
                .isZero();
        assertThat(png).isNotEmptyFile();
    }

    @Test
    void theVersionIsThatOfThePom() throws Exception {
        assertThat(run("--version")).isZero();
        assertThat(out.toString()).startsWith("robosim-geometry " + Version.NUMBER);
        assertThat(Files.readString(Path.of("pom.xml")))
                .contains("<artifactId>robosim-geometry</artifactId>\n  <version>" + Version.NUMBER + "</version>");
    }

    @Test
    void everyCommandHasAVersionExamplesAndItsExitCodes() {
        Map<String, CommandLine> commands = Commands.line(false).getSubcommands();
        assertThat(commands).hasSizeGreaterThan(5);
        for (String name : commands.keySet()) {
            out.getBuffer().setLength(0);
            assertThat(run(name, "--help")).isZero();
            assertThat(out.toString())
                    .as(name)
                    .contains("\nExamples:\n")
                    // a server has no end of its own
                    .containsPattern(
                            name.equals("serve")
                                    ? "\nExit codes:\n  2   [\\s\\S]*\n  128\\+N "
                                    : "\nExit codes:\n  0   [\\s\\S]*\n  2   ")
                    .doesNotContain("null");
            out.getBuffer().setLength(0);
            assertThat(run(name, "--version")).isZero();
            assertThat(out.toString()).contains(Version.NUMBER);
        }
    }

    @Test
    void helpIsAWordToo() {
        assertThat(run("--help")).isZero();
        String all = out.toString();
        for (String[] line : new String[][] {{"help"}, {"help", "sweep"}, {"help", "sweep", "merge"}}) {
            out.getBuffer().setLength(0);
            assertThat(run(line)).as(Arrays.toString(line)).isZero();
            assertThat(out.toString())
                    .startsWith("Usage: robosim-geometry "
                            + String.join(" ", line).substring(4).strip());
            assertThat(out.toString().equals(all)).isEqualTo(line.length == 1);
        }
        assertThat(err.toString()).isEmpty();
        assertThat(run("help", "fly")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("Unmatched argument at index 0: 'fly'");
    }

    /** As in the footers of the help, with a line that ends in a backslash going on. */
    static List<String> examples() {
        List<String> examples = new ArrayList<>();
        Commands.line(false).getSubcommands().values().forEach(command -> {
            for (String line : command.getCommandSpec().usageMessage().footer()) {
                if (line.startsWith("  robosim-geometry ")) {
                    examples.add(line.strip());
                }
            }
        });
        return examples;
    }

    @ParameterizedTest
    @MethodSource("examples")
    void theExamplesOfTheHelpAreParsed(String example) {
        String[] words = example.split(" +");
        Commands.line(false).parseArgs(Arrays.copyOfRange(words, 1, words.length));
    }

    @Test
    void completionIsAScriptThatBashAccepts(@TempDir Path folder) throws Exception {
        assertThat(run("completion")).isZero();
        String script = out.toString();
        assertThat(script).contains("complete -F _complete_robosim-geometry", "--steps", "--record-bytes");
        Path file = Files.writeString(folder.resolve("completion.bash"), script);
        assumeThat(Path.of("/bin/bash")).exists();
        // Asks the script itself what it offers behind "robosim-geometry re".
        String ask = "source " + file + "; COMP_WORDS=(robosim-geometry re); COMP_CWORD=1;"
                + " _complete_robosim-geometry; echo \"${COMPREPLY[@]}\"";
        Process bash = new ProcessBuilder("/bin/bash", "-c", ask)
                .redirectErrorStream(true)
                .start();
        assertThat(new String(bash.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip())
                .isEqualTo("render replay");
        assertThat(bash.waitFor()).isZero();
        // compopt is for a shell that completes; there is none here.
        ask = "compopt() { :; }; "
                + ask.replace(
                        "(robosim-geometry re); COMP_CWORD=1", "(robosim-geometry convert --up ''); COMP_CWORD=3");
        bash = new ProcessBuilder("/bin/bash", "-c", ask)
                .redirectErrorStream(true)
                .start();
        assertThat(new String(bash.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip())
                .isEqualTo("y z");
    }

    /** An exit code of 1 would say that something was found. */
    @Test
    void anErrorOfJavaIsNoFinding() {
        for (Error error :
                List.of(new OutOfMemoryError("Java heap space"), new StackOverflowError(), new AssertionError("x"))) {
            ByteArrayOutputStream told = new ByteArrayOutputStream();
            IntSupplier command = () -> {
                throw error;
            };
            assertThat(Main.code(command, new PrintStream(told, true, StandardCharsets.UTF_8)))
                    .isEqualTo(ExitCodes.UNUSABLE);
            assertThat(told.toString(StandardCharsets.UTF_8).lines()).hasSize(1);
            if (error instanceof OutOfMemoryError) {
                assertThat(told.toString(StandardCharsets.UTF_8)).contains("-Xmx", "(got: Java heap space)");
            }
        }
        assertThat(Main.code(() -> 1, System.err)).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource({
        "picocli/CommandLine, -app.jar",
        "com/fasterxml/jackson/core/JsonFactory, com.fasterxml.jackson.core:jackson-core",
        "org/snakeyaml/engine/v2/api/Load, org.snakeyaml:snakeyaml-engine",
        "java/awt/Color, java.desktop",
        "a/b/C, as it was built"
    })
    void aMissingLibraryIsToldWithItsRemedy(String missing, String remedy) {
        assertThat(Main.sentence(new NoClassDefFoundError(missing))).contains(remedy, "(missing: " + missing + ")");
    }

    /** What is advised is more than what there is. */
    @Test
    void moreMemoryIsAdvisedAndNotLess() {
        for (long gigabytes : new long[] {0, 1, 2, 4, 8, 31}) {
            for (long most : new long[] {gigabytes << 30, (gigabytes << 30) + (1 << 29)}) {
                assertThat(Main.moreGigabytes(most) << 30).isGreaterThan(most + (most >> 1));
                assertThat(Main.moreGigabytes(most)).isGreaterThanOrEqualTo(4);
            }
        }
    }
}
