package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.GraphicsEnvironment;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.cli.terminal.ExitCodes;

class ViewCommandTest {
    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        return Commands.run(new PrintWriter(out, true), new PrintWriter(err, true), arguments);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    view                                     | either FILE or --watch must be given (got: neither)
                    view a.xml --watch h:1                   | either FILE or --watch must be given (got: both)
                    view nowhere.xml                         | FILE must exist; check the path (got: nowhere.xml)
                    serve 0 --watch 70000                    | PORT must be 0 to 65535 (got: 70000)
                    """)
    void badArgumentsAreRefusedWithTheirReason(String line, String reason) {
        assertThat(run(line.split(" "))).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains(reason);
        assertThat(out.toString()).isEmpty();
    }

    @Test
    void withoutADisplayItSaysSoAndWhatHelps() {
        assumeTrue(GraphicsEnvironment.isHeadless(), "there is a display, and no window is to open on it");
        assertThat(run("view", "worlds/rooms.xml")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString())
                .startsWith("view needs a display for its window, and there is none here; ")
                .contains("`robosim-geometry render`")
                .hasLineCount(1);
    }

    @Test
    void aPortThatIsTakenIsNotWatchedOn() throws Exception {
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            String port = String.valueOf(taken.getLocalPort());
            assertThat(run("serve", "0", "--watch", port)).isEqualTo(ExitCodes.UNUSABLE);
            assertThat(err.toString()).contains("cannot listen on").contains(port);
        }
    }
}
