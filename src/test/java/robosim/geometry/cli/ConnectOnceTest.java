package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.cli.terminal.ExitCodes;

/** What {@code connect --once} tells by its exit code. */
@Tag("clock")
@Timeout(60)
class ConnectOnceTest {
    private static final String HELLO = "{\"type\":\"hello\",\"version\":1}\n";

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    /** Dials an environment that says so much and hangs up. */
    private int connect(String said, String... more) throws Exception {
        try (ServerSocket listening = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            Thread environment = new Thread(() -> talk(listening, said));
            environment.start();
            List<String> line = new ArrayList<>(
                    List.of("connect", "localhost", String.valueOf(listening.getLocalPort()), "--once"));
            Collections.addAll(line, more);
            int code =
                    Commands.run(new PrintWriter(out, true), new PrintWriter(err, true), line.toArray(String[]::new));
            environment.join();
            return code;
        }
    }

    private static void talk(ServerSocket listening, String said) {
        try (Socket socket = listening.accept()) {
            OutputStream out = socket.getOutputStream();
            out.write(said.getBytes(StandardCharsets.UTF_8));
            socket.shutdownOutput();
            socket.getInputStream().readAllBytes();
        } catch (IOException e) {
            // The other end may hang up first.
            assertThat(e).hasMessageMatching(".*(reset|Broken pipe|closed).*");
        }
    }

    @Test
    void aTalkToItsEndIsFine() throws Exception {
        assertThat(connect(HELLO + "{\"type\":\"moves\",\"moves\":[]}\n")).isZero();
        assertThat(out.toString()).startsWith("Connected to localhost:");
        assertThat(err.toString()).isEmpty();
    }

    @Test
    void aTalkIsRecordedAsMessagesOfRos(@TempDir Path folder) throws Exception {
        Path messages = folder.resolve("talk.mcap");
        String said = HELLO
                + "{\"type\":\"init\",\"objects\":[{\"kind\":\"sphere\",\"name\":\"r\",\"moveable\":true,\"center\":[0,0,0],\"radius\":1}]}\n"
                + "{\"type\":\"moves\",\"moves\":[{\"objectName\":\"r\",\"x\":2,\"y\":0,\"z\":0,\"rx\":0,\"ry\":0}]}\n";
        assertThat(connect(said, "--record", messages.toString()))
                .as(err.toString())
                .isZero();
        Path scenario = folder.resolve("talk.scenario.jsonl");
        Path converted = folder.resolve("converted.mcap");
        assertThat(Commands.run(
                        new PrintWriter(out),
                        new PrintWriter(err, true),
                        "convert",
                        scenario.toString(),
                        converted.toString()))
                .as(err.toString())
                .isZero();
        assertThat(messages).hasSameBinaryContentAs(converted);
        // Existing files stay as they are.
        assertThat(Commands.run(
                        new PrintWriter(out),
                        new PrintWriter(err, true),
                        "connect",
                        "localhost",
                        "1",
                        "--record",
                        messages.toString()))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("--record must be a new file");
    }

    @Test
    void anEnvironmentThatAsksNothingIsTold() throws Exception {
        for (String said : List.of("", HELLO, HELLO + "{\"type\":\"ping\"}\n", HELLO + "{\"type\":\"fly\"}\n")) {
            assertThat(connect(said)).as(said).isEqualTo(ExitCodes.FINDINGS);
            assertThat(err.toString()).contains("hung up before its first request");
            assertThat(out.toString()).startsWith("Connected to localhost:");
        }
    }

    @Test
    void aFaultOfTheProtocolIsTold() throws Exception {
        assertThat(connect("what is this?\n")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(connect(HELLO + "{\"type\":\"fly\"\n")).isEqualTo(ExitCodes.UNUSABLE);
    }

    @Test
    void anEnvironmentThatIsNotThereIsTold() throws Exception {
        int free;
        try (ServerSocket closed = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            free = closed.getLocalPort();
        }
        int code = Commands.run(
                new PrintWriter(new StringWriter()),
                new PrintWriter(err, true),
                "connect",
                "localhost",
                String.valueOf(free),
                "--once");
        assertThat(code).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("cannot reach an environment at localhost:" + free);
    }

    @Test
    void aFaultOfTlsIsTold(@TempDir Path folder) throws Exception {
        Path store = folder.resolve("own.p12");
        Process keytool = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "keytool")
                                .toString(),
                        "-genkeypair",
                        "-alias",
                        "own",
                        "-keyalg",
                        "EC",
                        "-dname",
                        "CN=localhost",
                        "-storetype",
                        "PKCS12",
                        "-storepass",
                        "changeit",
                        "-keystore",
                        store.toString())
                .redirectErrorStream(true)
                .start();
        assertThat(new String(keytool.getInputStream().readAllBytes(), StandardCharsets.UTF_8))
                .doesNotContain("error");
        assertThat(keytool.waitFor()).isZero();
        Path password = Files.writeString(folder.resolve("password"), "changeit\n");
        // It speaks without TLS.
        int code = connect(
                HELLO,
                "--key-store",
                store.toString(),
                "--trust-store",
                store.toString(),
                "--password-file",
                password.toString());
        assertThat(err.toString()).isEmpty();
        assertThat(code).isEqualTo(ExitCodes.UNUSABLE);
    }
}
