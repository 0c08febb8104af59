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
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.scenario.Mismatch;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.ScenarioException;
import robosim.geometry.scenario.ScenarioReader;

/**
 * Makes tests of a folder of scenario files: each is replayed, and fails if an answer differs from the expected one.
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
     * A test for each file whose name ends in {@link ScenarioReader#ENDING} in a folder and its subfolders, in order,
     * named by its path within the folder and its title. A file that is not a valid scenario gives a test that fails.
     *
     * <p>Worlds that they name are looked up relative to each file's folder, and must be within the parent of the given
     * folder.
     *
     * @throws IllegalArgumentException if there are none
     * @throws UncheckedIOException if the folder cannot be read
     */
    public static Stream<DynamicTest> in(Path folder) {
        Checks.present("folder", folder);
        Path above = folder.toAbsolutePath().normalize().getParent();
        return in(folder, above == null ? folder : above);
    }

    /**
     * A test for each file, as in {@link #in(Path)}.
     *
     * @param root worlds that the files name are read from within this folder only
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
            return ""; // reported by the test itself
        }
    }

    private static void replay(Path file, Path root) throws IOException {
        List<Mismatch> found = new ArrayList<>();
        try (ScenarioReader reader = ScenarioReader.open(file, root)) {
            Replay replay = Replay.of(reader, found::add);
            if (reader.torn() > 0) {
                throw new AssertionFailedError(file + ":" + reader.torn() + ": the last line is incomplete");
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
                                    + " answered differently",
                            found.size() > MOST_TOLD ? "\n  and " + (found.size() - MOST_TOLD) + " more" : "")));
        }
    }
}
