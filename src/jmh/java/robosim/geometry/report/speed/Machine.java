package robosim.geometry.report.speed;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import org.dyn4j.Version;
import org.locationtech.jts.JTSVersion;

/** What a report says of where it was measured. */
final class Machine {
    static final String COMMAND = "mvn -q test-compile exec:java -Dexec.classpathScope=test"
            + " -Dexec.mainClass=robosim.geometry.report.speed.SpeedAgainstError";

    private Machine() {}

    static void describe(Results results, String form) {
        results.head(
                "date",
                ZonedDateTime.now(ZoneOffset.UTC).format(DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm 'UTC'")));
        results.head("machine", processor() + ", " + Runtime.getRuntime().availableProcessors() + " processors");
        results.head("system", System.getProperty("os.name") + " on " + System.getProperty("os.arch"));
        results.head("jdk", System.getProperty("java.vendor") + " " + Runtime.version());
        results.head("jvm options", String.join(" ", Fork.OPTIONS));
        results.head("load at the start", String.format(Locale.ROOT, "%.2f", load()));
        results.head("seed", Long.toString(Form.SEED));
        results.head("form", form);
        results.head("engines", "this module; JTS " + JTSVersion.CURRENT_VERSION + "; dyn4j " + Version.getVersion());
        results.head("command", COMMAND + (form.equals("full") ? "" : " -D" + form));
    }

    /** Runnable tasks at the start, as the system tells; above 0 something else is running. */
    private static double load() {
        return ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
    }

    private static String processor() {
        try {
            return Files.readString(Path.of("/proc/cpuinfo"), StandardCharsets.UTF_8)
                    .lines()
                    .filter(line -> line.startsWith("model name"))
                    .map(line -> line.substring(line.indexOf(':') + 1).strip())
                    .findFirst()
                    .orElse("a processor without a name");
        } catch (IOException e) {
            return "a processor"; // other systems have no such file
        }
    }
}
