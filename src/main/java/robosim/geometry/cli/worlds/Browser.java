package robosim.geometry.cli.worlds;

import java.io.IOException;
import java.net.URI;
import java.util.List;
import java.util.Locale;

/** The user's browser. */
final class Browser {
    private Browser() {}

    /** Opens an address in it; returns whether there was one to ask. */
    static boolean open(URI address) {
        String system = System.getProperty("os.name", "").toLowerCase(Locale.ROOT);
        String place = address.toString();
        if (system.contains("win")) {
            return runs(List.of("rundll32", "url.dll,FileProtocolHandler", place));
        }
        if (system.contains("mac")) {
            return runs(List.of("open", place));
        }
        boolean hasDisplay = System.getenv("DISPLAY") != null || System.getenv("WAYLAND_DISPLAY") != null;
        return hasDisplay && runs(List.of("xdg-open", place));
    }

    private static boolean runs(List<String> command) {
        try {
            new ProcessBuilder(command)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start();
            return true;
        } catch (IOException e) { // there is no such program
            return false;
        }
    }
}
