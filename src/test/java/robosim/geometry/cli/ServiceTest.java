package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.Base64;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.ChildJvm;
import robosim.geometry.cli.network.AdminPortTest;

/** A server as a service manager runs it: it says when it is ready, shows its health, and drains before it ends. */
@Tag("clock")
@EnabledOnOs(OS.LINUX)
class ServiceTest {
    private static final byte[] HELLO = "{\"type\":\"hello\",\"version\":1}\n".getBytes(StandardCharsets.UTF_8);

    @TempDir
    private Path folder;

    private ProcessBuilder serve(String... arguments) {
        List<String> command = ChildJvm.running(Main.class, "serve", "0");
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command).redirectErrorStream(true);
    }

    private static BufferedReader reader(java.io.InputStream in) {
        return new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
    }

    private static int port(BufferedReader output, String word) throws IOException {
        String line = output.readLine();
        while (line != null && !line.startsWith(word)) {
            line = output.readLine();
        }
        assertThat(line).isNotNull();
        return Integer.parseInt(line.substring(line.lastIndexOf(':') + 1));
    }

    @Test
    void itDrainsWhileItsHealthSaysThatItTakesNobody() throws Exception {
        Process process = serve("--admin", "0", "--drain", "60").start();
        try (BufferedReader output = reader(process.getInputStream())) {
            int admin = port(output, "Admin on");
            int port = port(output, "Listening on");
            assertThat(AdminPortTest.http(admin, "GET", "/health")).contains(" 200 ");
            try (Socket session = new Socket(InetAddress.getLoopbackAddress(), port)) {
                session.setSoTimeout(20_000);
                BufferedReader answers = reader(session.getInputStream());
                session.getOutputStream().write(HELLO);
                assertThat(answers.readLine()).contains("hello");
                process.toHandle().destroy();
                while (!AdminPortTest.http(admin, "GET", "/health").contains(" 503 ")) {
                    TimeUnit.MILLISECONDS.sleep(20);
                }
                TimeUnit.MILLISECONDS.sleep(2500); // longer than it would take to end without --drain
                session.getOutputStream().write("{\"type\":\"ping\"}\n".getBytes(StandardCharsets.UTF_8));
                assertThat(answers.readLine()).contains("pong");
            }
            assertThat(process.waitFor(20, TimeUnit.SECONDS)).isTrue();
            assertThat(process.exitValue()).isEqualTo(143);
        } finally {
            process.destroyForcibly();
        }
    }

    @Test
    void aSecondSignalEndsTheDraining() throws Exception {
        Process process = serve("--admin", "0", "--drain", "600").start();
        try (BufferedReader output = reader(process.getInputStream())) {
            int admin = port(output, "Admin on");
            int port = port(output, "Listening on");
            try (Socket session = new Socket(InetAddress.getLoopbackAddress(), port)) {
                session.setSoTimeout(20_000);
                BufferedReader answers = reader(session.getInputStream());
                session.getOutputStream().write(HELLO);
                assertThat(answers.readLine()).contains("hello");
                process.toHandle().destroy();
                while (!AdminPortTest.http(admin, "GET", "/health").contains(" 503 ")) {
                    TimeUnit.MILLISECONDS.sleep(20);
                }
                process.toHandle().destroy();
                assertThat(answers.readLine()).isNull();
                assertThat(process.waitFor(20, TimeUnit.SECONDS)).isTrue();
                assertThat(process.exitValue()).isEqualTo(143);
            }
        } finally {
            process.destroyForcibly();
        }
    }

    /** Polygons of many corners, whose ears are looked for in quadratic time: more than ten seconds in all. */
    private static String longLoad() {
        StringBuilder mesh = new StringBuilder();
        int corners = 1000;
        for (int k = 0; k < corners; k++) {
            mesh.append("v ").append(k < corners / 2 ? k : corners - k - 0.5);
            mesh.append(' ')
                    .append(0)
                    .append(' ')
                    .append(k < corners / 2 ? k % 2 : 3)
                    .append('\n');
        }
        String face =
                "f" + IntStream.rangeClosed(1, corners).mapToObj(k -> " " + k).collect(Collectors.joining()) + "\n";
        byte[] content = mesh.append(face.repeat(4000)).toString().getBytes(StandardCharsets.US_ASCII);
        return "{\"type\":\"load\",\"file\":\"a.obj\",\"files\":{\"a.obj\":\""
                + Base64.getEncoder().encodeToString(content) + "\"}}\n";
    }

    @Test
    void aLoadThatASignalEndsLeavesNoFiles() throws Exception {
        Path temporary = Files.createDirectory(folder.resolve("tmp"));
        ProcessBuilder service = serve("--request-time", "3600");
        service.command().add(1, "-Djava.io.tmpdir=" + temporary);
        Process process = service.start();
        try (BufferedReader output = reader(process.getInputStream())) {
            int port = port(output, "Listening on");
            try (Socket session = new Socket(InetAddress.getLoopbackAddress(), port)) {
                session.setSoTimeout(20_000);
                BufferedReader answers = reader(session.getInputStream());
                session.getOutputStream().write(HELLO);
                session.getOutputStream().write(longLoad().getBytes(StandardCharsets.US_ASCII));
                assertThat(answers.readLine()).contains("hello");
                while (kept(temporary).isEmpty()) {
                    TimeUnit.MILLISECONDS.sleep(5);
                }
                process.toHandle().destroy();
                assertThat(process.waitFor(20, TimeUnit.SECONDS)).isTrue();
                assertThat(answers.readLine()).contains("the module is shutting down");
                assertThat(kept(temporary)).isEmpty();
            }
        } finally {
            process.destroyForcibly();
        }
    }

    private static List<Path> kept(Path temporary) throws IOException {
        try (Stream<Path> all = Files.list(temporary)) {
            return all.filter(each -> String.valueOf(each.getFileName()).startsWith("robosim-world"))
                    .toList();
        }
    }

    @Test
    void itSaysWhenItIsReady() throws Exception {
        Path told = folder.resolve("told");
        Path tool = Files.writeString(
                folder.resolve("systemd-notify"),
                "#!/bin/sh\nprintf '%s\\n' \"$NOTIFY_SOCKET\" \"$@\" > " + told + "\n");
        Files.setPosixFilePermissions(tool, PosixFilePermissions.fromString("rwxr-xr-x"));
        ProcessBuilder service = serve("--log", "json");
        service.environment().put("NOTIFY_SOCKET", "/run/a/socket");
        service.environment().merge("PATH", folder + ":", (old, own) -> own + old);
        Process process = service.start();
        try (BufferedReader output = reader(process.getInputStream())) {
            int port = port(output, "Listening on");
            long end = System.nanoTime() + Duration.ofSeconds(20).toNanos();
            while ((!Files.exists(told) || Files.readAllLines(told).size() < 3) && System.nanoTime() < end) {
                TimeUnit.MILLISECONDS.sleep(20);
            }
            assertThat(Files.readAllLines(told))
                    .containsExactly("/run/a/socket", "READY=1", "STATUS=listening on localhost/127.0.0.1:" + port);
            try (Socket rude = new Socket(InetAddress.getLoopbackAddress(), port)) {
                rude.getOutputStream().write("GET / HTTP/1.1\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
                assertThat(output.readLine())
                        .matches(
                                "\\{\"time\":\"20[-0-9T:.]+Z\",\"level\":\"WARNING\",\"logger\":\"robosim.geometry.net\","
                                        + "\"message\":\"server " + port
                                        + ", peer /127.0.0.1:\\d+: closed at message 1, .*\"}");
            }
        } finally {
            process.destroyForcibly();
        }
    }
}
