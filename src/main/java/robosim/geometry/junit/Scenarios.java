package robosim.geometry.junit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.opentest4j.AssertionFailedError;
import robosim.geometry.exact.Checks;
import robosim.geometry.protocol.Text;
import robosim.geometry.scenario.Mismatch;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.ScenarioException;
import robosim.geometry.scenario.ScenarioReader;

/**
 * A folder of scenario files as tests: each is replayed, and fails where an answer is another than the file expects.
 *
 * <!-- java: compiled -->
 * <pre>{@code
 * @TestFactory
 * Stream<DynamicTest> scenarios() {
 *     return Scenarios.in(Path.of("src/test/scenarios"));
 * }
 * }</pre>
 */
public final class Scenarios {
    private static final int MOST_TOLD = 10;

    private Scenarios() {}

    /**
     * A test for each file of a folder and the folders below whose name ends in {@link ScenarioReader#ENDING}, in their
     * order, named by its path there and its title. A file that is no scenario is a test that fails.
     *
     * <p>The worlds that they name are looked for beside them, and not above the folder that the folder is in.
     *
     * @throws IllegalArgumentException where there are none
     * @throws UncheckedIOException     where the folder cannot be read
     */
    public static Stream<DynamicTest> in(Path folder) {
        Checks.present("folder", folder);
        Path above = folder.toAbsolutePath().normalize().getParent();
        return in(folder, above == null ? folder : above);
    }

    /**
     * A test for each file, as {@link #in(Path)} has it.
     *
     * @param root the folder outside of which no world is read that a file names
     */
    public static Stream<DynamicTest> in(Path folder, Path root) {
        Checks.present("folder", folder);
        Checks.present("root", root);
        List<Path> files;
        try (Stream<Path> all = Files.walk(folder)) {
            files = all.filter(file -> file.toString().endsWith(ScenarioReader.ENDING))
                    .sorted()
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException("the folder " + folder + " could not be read: " + e, e);
        }
        if (files.isEmpty()) {
            throw new IllegalArgumentException(
                    "folder must hold scenarios, *" + ScenarioReader.ENDING + " (got none in: " + folder + ")");
        }
        return files.stream()
                .map(file -> DynamicTest.dynamicTest(
                        folder.relativize(file) + title(file, root), file.toUri(), () -> replay(file, root)));
    }

    private static String title(Path file, Path root) {
        try (ScenarioReader reader = ScenarioReader.open(file, root)) {
            return ": " + Text.line(reader.header().title());
        } catch (IOException e) {
            return ""; // told by the test itself
        }
    }

    private static void replay(Path file, Path root) throws IOException {
        List<Mismatch> found = new ArrayList<>();
        try (ScenarioReader reader = ScenarioReader.open(file, root)) {
            Replay replay = Replay.of(reader, found::add);
            if (reader.torn() > 0) {
                throw new AssertionFailedError(file + ":" + reader.torn() + ": the last line breaks off");
            }
            if (replay.steps() == 0) {
                throw new AssertionFailedError(file + ": a scenario must have a step (got: none)");
            }
        } catch (ScenarioException e) {
            throw new AssertionFailedError(e.getMessage(), e);
        }
        if (!found.isEmpty()) {
            throw new AssertionFailedError(found.stream()
                    .limit(MOST_TOLD)
                    .map(mismatch -> "\n  " + mismatch)
                    .collect(Collectors.joining(
                            "",
                            file + ": " + found.size() + (found.size() == 1 ? " step is" : " steps are")
                                    + " answered otherwise",
                            found.size() > MOST_TOLD ? "\n  and " + (found.size() - MOST_TOLD) + " more" : "")));
        }
    }
}
