package robosim.geometry.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.scenario.Step;

/** The real window, in a process of its own with a virtual display: {@link WindowDriver} uses it. */
@Tag("clock")
@Timeout(180)
class WindowTest {
    private static final Path XVFB = Path.of("/usr/bin/Xvfb");

    /** Puts Java's own drawing in the place of the system's; it needs classes that the JDK has no more from 22 on. */
    private static final String CACIO = "com.github.caciocavallosilano.cacio.ctc.junit.CacioExtension";

    private static final int CACIO_LAST = 21;

    @TempDir
    private Path folder;

    @Test
    void aPersonUsesItOnJavasOwnVirtualDisplay() throws Exception {
        int version = Runtime.version().feature();
        assumeTrue(
                version <= CACIO_LAST, "cacio-tta, a display in pure Java, runs up to JDK 21; this is JDK " + version);
        List<String> options = new ArrayList<>(List.of(
                "-Djava.awt.headless=false",
                "-Dcacio.managed.screensize=1280x1024",
                "-Dnet.bytebuddy.experimental=true",
                "-Xshare:off"));
        for (String name : List.of(
                "java.awt",
                "java.awt.peer",
                "java.awt.dnd.peer",
                "sun.awt",
                "sun.awt.event",
                "sun.awt.image",
                "sun.awt.datatransfer",
                "sun.java2d")) {
            options.add("--add-exports=java.desktop/" + name + "=ALL-UNNAMED");
        }
        options.add("--add-exports=java.base/sun.security.action=ALL-UNNAMED");
        for (String name : List.of(
                "java.base/java.util",
                "java.base/java.lang",
                "java.base/java.lang.reflect",
                "java.base/java.lang.invoke",
                "java.desktop/java.awt",
                "java.desktop/sun.awt",
                "java.desktop/sun.java2d")) {
            options.add("--add-opens=" + name + "=ALL-UNNAMED");
        }
        drive(CACIO, options, null);
    }

    @Test
    void aPersonUsesItOnAVirtualDisplayOfX() throws Exception {
        assumeTrue(Files.isExecutable(XVFB), "there is no " + XVFB + "; apt-get install xvfb");
        Path log = folder.resolve("xvfb.log");
        // It picks a number that is free, and writes it to its standard output.
        Process display = new ProcessBuilder(
                        XVFB.toString(), "-displayfd", "1", "-screen", "0", "1280x1024x24", "-nolisten", "tcp")
                .redirectError(log.toFile())
                .start();
        try {
            String number = new String(display.getInputStream().readNBytes(1), StandardCharsets.UTF_8)
                    + new String(rest(display), StandardCharsets.UTF_8);
            assertThat(number.trim()).as(Files.readString(log)).matches("[0-9]+");
            drive("", List.of("-Djava.awt.headless=false"), ":" + number.trim());
        } finally {
            display.destroy();
            display.waitFor(10, TimeUnit.SECONDS);
        }
    }

    /** Up to the end of the line. */
    private static byte[] rest(Process process) throws IOException {
        var line = new java.io.ByteArrayOutputStream();
        for (int letter = process.getInputStream().read();
                letter > '\n';
                letter = process.getInputStream().read()) {
            line.write(letter);
        }
        return line.toByteArray();
    }

    private void drive(String first, List<String> options, String display) throws Exception {
        Path picture = folder.resolve("screen.png");
        Talk talk = Talk.begun();
        for (int k = 0; k < 39; k++) {
            talk.drives(0.1, true);
        }
        talk.drives(9, false);
        List<String> command = new ArrayList<>(
                List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        command.addAll(List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC"));
        command.addAll(options);
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), WindowDriver.class.getName(), first));
        command.addAll(
                List.of(picture.toString(), to(talk).toString(), from(talk).toString()));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().remove("DISPLAY");
        if (display != null) {
            builder.environment().put("DISPLAY", display);
        }
        Path log = folder.resolve("window.log");
        Process process = builder.redirectOutput(log.toFile()).start();
        boolean ended = process.waitFor(150, TimeUnit.SECONDS);
        process.destroyForcibly();
        assertThat(Files.readString(log)).contains("all as it should be");
        assertThat(ended).isTrue();
        BufferedImage screen = ImageIO.read(picture.toFile());
        assertThat(screen.getWidth()).isGreaterThan(800);
    }

    private Path to(Talk talk) throws IOException {
        Path file = folder.resolve("to-module.bin");
        try (OutputStream out = Files.newOutputStream(file)) {
            MessageWriter writer = new MessageWriter(out);
            for (Step step : talk.steps()) {
                writer.write(step.request());
            }
        }
        return file;
    }

    private Path from(Talk talk) throws IOException {
        Path file = folder.resolve("from-module.bin");
        try (OutputStream out = Files.newOutputStream(file)) {
            MessageWriter writer = new MessageWriter(out);
            for (Step step : talk.steps()) {
                if (step.expected() != null) {
                    writer.write(step.expected().bundle());
                }
            }
        }
        return file;
    }
}
