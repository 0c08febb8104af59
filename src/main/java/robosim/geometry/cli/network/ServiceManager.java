package robosim.geometry.cli.network;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import robosim.geometry.net.GeometryServer;

/**
 * Reports to the service manager that started the process, if one did, as systemd does for {@code Type=notify}. Java has no
 * sockets of the kind that this takes, so systemd's own command is run.
 */
final class ServiceManager {
    private static final System.Logger LOG = System.getLogger(GeometryServer.class.getPackageName());
    private static final long PATIENCE_SECONDS = 10;

    private ServiceManager() {}

    static void ready(String status) {
        report("READY=1", "STATUS=" + status);
    }

    private static void report(String... words) {
        if (System.getenv("NOTIFY_SOCKET") == null) {
            return;
        }
        List<String> command = new ArrayList<>(List.of("systemd-notify"));
        command.addAll(List.of(words));
        try {
            Process process = new ProcessBuilder(command)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start();
            boolean ended = process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
            if (!ended || process.exitValue() != 0) {
                warn(ended ? "it ended with " + process.exitValue() : "it took too long");
            }
        } catch (IOException e) {
            warn(String.valueOf(e.getMessage()));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void warn(String reason) {
        LOG.log(
                System.Logger.Level.WARNING,
                "systemd cannot be told that the server is ready, as systemd-notify failed; its package must be"
                        + " installed, and the unit needs NotifyAccess=all (got: " + reason + ")");
    }
}
