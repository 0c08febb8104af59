package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import robosim.geometry.cli.terminal.Progress;

@Tag("clock")
class ProgressTest {
    private final StringWriter err = new StringWriter();

    @Test
    void drawsABarOverItselfAndTakesItAwayAtTheEnd() {
        try (Progress progress = Progress.shown(new PrintWriter(err, true), "rays", 200)) {
            progress.at(50, () -> "rooms.xml");
            assertThat(err.toString()).isEqualTo("\r\033[Krays [######..................]  25 %  rooms.xml");
            progress.at(100); // too soon to be drawn
            assertThat(err.toString()).endsWith("rooms.xml");
            progress.clear();
            progress.clear();
        }
        assertThat(err.toString()).endsWith("rooms.xml\r\033[K");
    }

    @Test
    void drawsAgainAfterAWhileAndNeverLeavesItsFrame() throws InterruptedException {
        try (Progress progress = Progress.shown(new PrintWriter(err, true), "rays", 10)) {
            progress.at(-3);
            Thread.sleep(250);
            progress.at(12);
        }
        assertThat(err.toString())
                .isEqualTo("\r\033[Krays [........................]   0 %"
                        + "\r\033[Krays [########################] 100 %\r\033[K");
    }

    @Test
    void countsWhereTheSizeIsNotKnown() {
        try (Progress progress = Progress.shown(new PrintWriter(err, true), "places", 0)) {
            progress.at(12345);
        }
        assertThat(err.toString()).isEqualTo("\r\033[Kplaces: 12,345\r\033[K");
    }

    @Test
    void keepsQuietWhereNobodyWatchesAndAsksForNoNote() throws InterruptedException {
        CommandLine line = Commands.line(false);
        line.setErr(new PrintWriter(err, true));
        try (Progress progress = Progress.of(line, "rays", 10)) {
            Thread.sleep(550);
            progress.at(5, () -> {
                throw new AssertionError("asked for a note");
            });
        }
        assertThat(err.toString()).isEmpty();
    }
}
