package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.ChildJvm;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.scenario.Step;

/** {@code serve} and {@code connect}: who is let in, what is printed, how they end. */
@Tag("clock")
class ServeCommandTest {
    private static final String WORD = "correct horse battery staple";

    @TempDir
    Path folder;

    private static Process start(String... arguments) throws IOException {
        return new ProcessBuilder(ChildJvm.running(Main.class, arguments))
                .redirectErrorStream(true)
                .start();
    }

    private static BufferedReader reader(java.io.InputStream in) {
        return new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
    }

    /** The first line that has this part; all before it are skipped. */
    private static String lineWith(BufferedReader output, String part) throws IOException {
        String line = output.readLine();
        while (line != null && !line.contains(part)) {
            line = output.readLine();
        }
        return line == null ? "the end" : line;
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    serve 0 --host 0.0.0.0             | give it TLS
                    serve 0 --key-store a.p12          | Missing required
                    serve 0 --key-store a.p12 --trust-store b.p12 --password-env NO_SUCH_VARIABLE | (got: NO_SUCH_VARIABLE)
                    serve 0 --secret-env NO_SUCH_VARIABLE | --secret-env must name a variable that is set
                    serve 0 --secret-file pom.xml --secret-env HOME | mutually exclusive
                    serve 0 --secret-file no.such      | --secret-file must be a text file (got: no.such)
                    serve 0 --stall 0                  | stall must be from a millisecond to a day (got: PT0S)
                    serve 0 --connections 0            | connections must be at least 1 (got: 0)
                    serve 0 --max-objects 0            | objects must be at least 1 (got: 0)
                    serve 0 --world no.such.xml        | --world must be a file that exists
                    serve 0 --world pom.xml            | pom.xml
                    serve 0 --models no.such           | --models must be a folder
                    serve 0 --figures -1               | --figures must be at least 0 (got: -1)
                    connect localhost 1 --once         | cannot reach an environment at localhost:1
                    """)
    void whatCannotBeIsRefusedWithItsReason(String line, String reason) {
        StringWriter err = new StringWriter();
        assertThat(Commands.run(new PrintWriter(new StringWriter(), true), new PrintWriter(err, true), line.split(" ")))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains(reason).doesNotContain("\tat ");
    }

    @Test
    void aServerForEverybodyWhoKnowsTheSecretPrintsItsFiguresAndNotTheSecret() throws Exception {
        Path file = Files.writeString(folder.resolve("secret"), WORD + "\n");
        Process process = start(
                "serve", "0", "--host", "0.0.0.0", "--secret-file", file.toString(), "--figures", "1", "--idle", "100");
        try (BufferedReader output = reader(process.getInputStream())) {
            String listening = lineWith(output, "Listening on");
            int port = Integer.parseInt(listening.substring(listening.lastIndexOf(':') + 1));
            try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
                socket.setSoTimeout(20_000);
                socket.getOutputStream()
                        .write(("{\"type\":\"hello\",\"version\":1,\"secret\":\"" + WORD + "\"}\n")
                                .getBytes(StandardCharsets.UTF_8));
                assertThat(reader(socket.getInputStream()).readLine()).contains("\"hello\"");
                assertThat(lineWith(output, "connections 1 open")).contains("1 in all, 0 refused");
            }
            assertThat(lineWith(output, "connections 0 open")).contains("1 in all", "0 errors");
            process.toHandle().destroy();
            List<String> rest = output.lines().toList();
            assertThat(rest).isNotEmpty();
            assertThat(rest.get(rest.size() - 1)).startsWith("connections 0 open, 1 in all");
            assertThat(rest).noneMatch(line -> line.contains("horse"));
            assertThat(process.waitFor(20, TimeUnit.SECONDS)).isTrue();
        } finally {
            process.destroyForcibly();
        }
    }

    /** A world from a file, with the bodies of its robots: in each connection it begins anew, and so does its recording. */
    @Test
    void connectionsBeginWithTheWorldOfAFile() throws Exception {
        Process process = start("serve", "0", "--world", "worlds/pushing.xml", "--record", folder.toString());
        try (BufferedReader output = reader(process.getInputStream())) {
            assertThat(lineWith(output, "worlds/pushing.xml")).endsWith("pushing.xml, 11 objects");
            String listening = lineWith(output, "Listening on");
            int port = Integer.parseInt(listening.substring(listening.lastIndexOf(':') + 1));
            for (int k = 0; k < 2; k++) {
                try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
                    socket.setSoTimeout(20_000);
                    socket.getOutputStream().write("""
                                    {"type":"hello","version":1}
                                    {"type":"batch","requests":[{"kind":"world"},{"kind":"pose","objectName":"cart"}]}
                                    {"type":"step","seconds":0,"commands":[{"objectName":"cart","forward":1}]}
                                    {"type":"step","seconds":1}
                                    """.getBytes(StandardCharsets.UTF_8));
                    BufferedReader in = reader(socket.getInputStream());
                    assertThat(in.readLine()).contains("\"hello\"");
                    assertThat(in.readLine()).contains("{\"added\":11,\"leftOut\":[]", "{\"center\":[-4.0,-1.0,0.0]");
                    assertThat(in.readLine()).contains("\"objectName\":\"drum\"", "\"refused\":[]");
                    assertThat(in.readLine()).contains("\"velocity\":{\"x\":1.0");
                }
            }
            try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
                socket.setSoTimeout(20_000);
                MessageWriter writer = new MessageWriter(socket.getOutputStream());
                writer.write(new InitBundle.Answered(new InitBundle(List.of())));
                BatchAnswerBundle told = (BatchAnswerBundle) new MessageReader(socket.getInputStream()).read();
                assertThat(((WorldAnswer.Described) told.answers().get(0)).added())
                        .as("who sends a world has that one")
                        .isZero();
            }
        } finally {
            process.toHandle().destroy();
            process.waitFor(20, TimeUnit.SECONDS);
            process.destroyForcibly();
        }
        List<Integer> objects = new ArrayList<>();
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                try (ScenarioReader reader = ScenarioReader.open(file)) {
                    Step first = Objects.requireNonNull(reader.next());
                    objects.add(((InitBundle) first.request()).objects().size());
                    boolean isOfFile = objects.get(objects.size() - 1) > 0;
                    assertThat(Objects.requireNonNull(reader.next()).request())
                            .isInstanceOf(isOfFile ? StepBundle.class : BatchRequestBundle.class);
                }
            }
        }
        assertThat(objects).containsExactlyInAnyOrder(11, 11, 0);
    }

    @Test
    void connectDialsAgainUntilItIsEnded() throws Exception {
        try (ServerSocket environment = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
            environment.setSoTimeout(20_000);
            Process process = start("connect", "localhost", "" + environment.getLocalPort());
            try (BufferedReader output = reader(process.getInputStream())) {
                for (int k = 0; k < 2; k++) {
                    try (Socket socket = environment.accept()) {
                        socket.setSoTimeout(20_000);
                        MessageWriter writer = new MessageWriter(socket.getOutputStream());
                        writer.write(new InitBundle(List.of()));
                        writer.write(new MoveBundle(List.of()));
                        assertThat(new MessageReader(socket.getInputStream()).read())
                                .isEqualTo(new MoveBundle(List.of()));
                    }
                }
                process.toHandle().destroy();
                assertThat(lineWith(output, "connections ")).contains("2 in all", "4 bundles");
                assertThat(process.waitFor(20, TimeUnit.SECONDS)).isTrue();
            } finally {
                process.destroyForcibly();
            }
        }
    }
}
