package robosim.geometry.cli.worlds;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.cli.terminal.Version;
import robosim.geometry.cli.terminal.WireFiles;
import robosim.geometry.cli.terminal.WorldFiles;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.scenario.source.WatchReader;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.viewer.window.Viewer;
import robosim.geometry.world.World;

/** Shows a world, a recording or a session in a window. */
@Command(
        name = ViewCommand.NAME,
        description = {
            "Shows a world, a recording or a running session in a window, from above or in three dimensions.",
            "Keys there: V for the plan, three dimensions or both, C for more cameras, R for what a robot sees, I K J L O U"
                    + " to fly, F to see everything, Space to play or pause; docs/viewer.md has them all."
        },
        exitCodeList = {ExitCodes.DONE, ExitCodes.UNUSABLE + ":not shown: there is no display, or no such file"},
        footer = {
            "  robosim-geometry view worlds/rooms.xml",
            "  robosim-geometry view recordings/session.scenario.jsonl",
            "  robosim-geometry view target/demo --world worlds/rooms.xml",
            "  robosim-geometry view --watch localhost:5556"
        })
public final class ViewCommand implements Callable<Integer> {
    public static final String NAME = "view";

    @Spec
    private CommandSpec spec;

    @Parameters(
            arity = "0..1",
            paramLabel = "FILE",
            description = "a world in any format that convert reads, a recording (*" + ScenarioReader.ENDING
                    + "), or a folder with the demo's " + WireFiles.TO_MODULE + " and " + WireFiles.FROM_MODULE)
    private @Nullable Path file;

    @Option(
            names = "--watch",
            paramLabel = "HOST:PORT",
            description = "a live session: the port of a serve or connect with --watch; nothing is sent to it")
    private @Nullable String watched;

    @Option(
            names = "--world",
            paramLabel = "WORLD",
            description = "for a recording or a session: a world file to take colours and the unit from")
    private @Nullable Path colours;

    @Mixin
    private WorldFiles files;

    @Option(names = "--dark", description = "use a dark background; D toggles it in the window")
    private boolean dark;

    @Override
    public Integer call() throws Exception {
        Path shown = file;
        if ((shown == null) == (watched == null)) {
            throw new UsageException(
                    "either FILE or --watch must be given (got: " + (shown == null ? "neither" : "both") + ")");
        }
        if (shown != null && !Files.exists(shown)) {
            throw new UsageException("FILE must exist; check the path (got: " + shown + ")");
        }
        if (shown != null && !Files.isDirectory(shown)) {
            Arguments.input("FILE", shown);
        }
        files.check();
        if (!Viewer.hasDisplay()) {
            spec.commandLine()
                    .getErr()
                    .println("view needs a display for its window, and there is none here; to draw a world to a"
                            + " picture, use `" + Version.PROGRAM + " render`.");
            return ExitCodes.UNUSABLE;
        }
        if (shown != null) {
            view(shown);
        } else if (watched != null) {
            watch(watched);
        }
        return ExitCodes.FINE;
    }

    private void watch(String place) throws IOException, InterruptedException {
        int colon = place.lastIndexOf(':');
        if (colon < 1 || !place.substring(colon + 1).matches("[0-9]{1,5}")) {
            throw new UsageException("--watch must be HOST:PORT, such as localhost:5556 (got: " + place + ")");
        }
        int port = Integer.parseInt(place.substring(colon + 1));
        Arguments.port(port, 1);
        String host = place.substring(0, colon).replaceAll("^\\[|]$", "");
        World lender = lender();
        Viewer.live(WatchReader.dial(host, port), place, lender, theme());
    }

    private void view(Path shown) throws IOException, InterruptedException {
        String name = shown.toString().toLowerCase(Locale.ROOT);
        String title = Pictures.title(shown);
        if (WireFiles.at(shown) != null || name.endsWith(".jsonl")) {
            Viewer.recording(WireFiles.recording(shown), title, lender(), theme());
        } else {
            Viewer.world(files.world(shown), title, theme());
        }
    }

    private @Nullable World lender() throws IOException {
        return colours == null ? null : files.world(Arguments.input("--world", colours));
    }

    private Theme theme() {
        return dark ? Theme.DARK : Theme.LIGHT;
    }
}
