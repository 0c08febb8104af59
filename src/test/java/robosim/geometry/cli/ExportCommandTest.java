package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.cli.terminal.ExitCodes;

/** The command export; what is in its pages is tested in the room export. */
@Timeout(60)
class ExportCommandTest extends CommandRun {
    private static final Path TALK = Path.of("worlds/scenarios/wandering.scenario.jsonl");

    @Test
    void aWorldAndARecordingBecomePages() throws IOException {
        Path page = folder.resolve("page.html");
        assertThat(run("export", Path.of("worlds/rooms.xml"), page)).isEqualTo(ExitCodes.FINE);
        assertThat(out.toString()).startsWith("Wrote " + page + ": ").contains(" bytes");
        assertThat(page).content().contains("<title>rooms</title>");
        assertThat(run("export", TALK, "--world", Path.of("worlds/rooms.xml"), "--title", "a < b", page))
                .isZero();
        assertThat(out.toString()).contains("Wrote " + page + ": 9 steps, ");
        assertThat(page).content().contains("<title>a &lt; b</title>");
        assertThat(Files.list(folder)).containsExactly(page);
    }

    @Test
    void aPartOfARecordingIsSmaller() throws IOException {
        Path page = folder.resolve("page.html");
        assertThat(run("export", TALK, page)).isZero();
        long whole = Files.size(page);
        assertThat(run("export", TALK, "--steps", "3-4", page)).isZero();
        assertThat(out.toString()).contains(": 2 steps, ");
        assertThat(Files.size(page)).isLessThan(whole);
    }

    @Test
    void aRecordingBecomesMessagesOfRos() throws IOException {
        Path messages = folder.resolve("a.mcap");
        assertThat(run("export", TALK, messages)).isZero();
        assertThat(out.toString()).startsWith("Wrote " + messages + ": 17 requests, ");
        byte[] first = Files.readAllBytes(messages);
        assertThat(run("convert", TALK, messages)).isZero();
        assertThat(Files.readAllBytes(messages)).isEqualTo(first);
        assertThat(run("export", TALK, messages, "--tick", "2")).isZero();
        assertThat(Files.readAllBytes(messages)).isNotEqualTo(first);
        assertThat(run("export", TALK, messages, "--tick", "0")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("--tick must be above 0 and at most 3600 (got: 0.0)");
        assertThat(run("export", TALK, folder.resolve("a.html"), "--tick", "1")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("--tick is for .mcap and .wpilog");
        assertThat(run("export", Path.of("worlds/rooms.xml"), messages)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("an .mcap or .wpilog is written of a whole recording");
        assertThat(run("convert", TALK, folder.resolve("a.xml"))).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("OUT, of a recording, must end in .mcap");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "worlds/nowhere.xml | page.html | | FILE must exist",
                "worlds/rooms.xml | page.htm | | PAGE must end in .html",
                "worlds/rooms.xml | page.html | 1-2 | --steps is for a recording",
                "worlds/scenarios/wandering.scenario.jsonl | page.html | 4 | --steps must be FIRST-LAST",
                "worlds/scenarios/wandering.scenario.jsonl | page.html | 0-4 | --steps must be within 1-9",
                "worlds/scenarios/wandering.scenario.jsonl | page.html | 5-4 | --steps must be within 1-9",
                "worlds/scenarios/wandering.scenario.jsonl | page.html | 5-10 | --steps must be within 1-9",
            })
    void whatCannotBeIsRefused(String file, String page, String steps, String said) throws IOException {
        Path there = Files.writeString(folder.resolve(page), "old");
        int code = steps == null
                ? run("export", Path.of(file), there)
                : run("export", Path.of(file), there, "--steps", steps);
        assertThat(code).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith(said);
        assertThat(there).hasContent("old");
    }

    /** The formats that convert writes are those that it names. */
    @Test
    void convertWritesGltf() throws IOException {
        Path glb = folder.resolve("rooms.glb");
        assertThat(run("convert", Path.of("worlds/rooms.xml"), glb)).isZero();
        assertThat(Files.readAllBytes(glb)).startsWith('g', 'l', 'T', 'F');
        assertThat(run("convert", Path.of("worlds/rooms.xml"), folder.resolve("rooms.gltf")))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("OUT must end in .xml, .glb or .obj");
    }

    @Test
    void aWorldTakesNothingFromAnother() {
        Path page = folder.resolve("page.html");
        assertThat(run("export", "worlds/rooms.xml", page, "--world", "worlds/maze.xml"))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("--world is for a recording, and FILE is a world (got: worlds/maze.xml)");
        assertThat(page).doesNotExist();
    }
}
