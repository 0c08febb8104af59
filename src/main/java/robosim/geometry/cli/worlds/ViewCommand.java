package robosim.geometry.cli.worlds;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.check.NumberText;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.cli.terminal.WireFiles;
import robosim.geometry.cli.terminal.WorldFiles;
import robosim.geometry.export.PageWriter;
import robosim.geometry.scenario.source.WatchReader;
import robosim.geometry.viewer.playback.Colours;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.viewer.playback.StateHistory;
import robosim.geometry.viewer.web.LiveFilm;
import robosim.geometry.viewer.web.LiveSource;
import robosim.geometry.viewer.web.PageServer;
import robosim.geometry.viewer.web.WorldControl;
import robosim.geometry.world.World;

/** Shows a world, a recording or a session in a browser. */
@Command(
        name = ViewCommand.NAME,
        description = {
            "Shows a world, a recording or a running session in a browser, from above and in three dimensions, until"
                    + " it is ended (Ctrl+C).",
            "The page is served on this machine alone, at an address with a secret; ? in it shows all keys."
        },
        exitCodeList = {ExitCodes.DONE, ExitCodes.UNUSABLE + ":not shown: no such file, or nothing to watch"},
        footer = {
            "  robosim-geometry view worlds/rooms.xml",
            "  robosim-geometry view recordings/session.scenario.jsonl",
            "  robosim-geometry view target/demo --world worlds/rooms.xml",
            "  robosim-geometry view localhost:5556",
            "  robosim-geometry view worlds/rooms.xml --no-browser --port 8080"
        })
public final class ViewCommand implements Callable<Integer> {
    public static final String NAME = "view";

    private static final Pattern PLACE = Pattern.compile("(.+):(\\d{1,5})");

    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "WHAT",
            description = "a world in any format that convert reads, a recording (*.jsonl"
                    + "), a folder with the demo's " + WireFiles.TO_MODULE + " and " + WireFiles.FROM_MODULE
                    + ", or HOST:PORT, the port of a serve or connect with --watch")
    private String shown = "";

    @Option(
            names = "--world",
            paramLabel = "WORLD",
            description = "for a recording or a session: a world file to take colours and the unit from")
    private @Nullable Path colours;

    @Mixin
    private WorldFiles files;

    @Option(
            names = "--port",
            paramLabel = "PORT",
            defaultValue = "0",
            description = "the port of the page; 0 for any free port (default: ${DEFAULT-VALUE})")
    private int port;

    @Option(names = "--no-browser", description = "only print the address of the page")
    private boolean isQuiet;

    @Override
    public Integer call() throws Exception {
        Arguments.port(port, 0);
        files.check();
        Matcher place = PLACE.matcher(shown);
        try {
            if (!Files.exists(Path.of(shown)) && place.matches()) {
                watch(place.group(1).replaceAll("^\\[|]$", ""), Integer.parseInt(place.group(2)));
            } else {
                view(Path.of(shown));
            }
        } catch (NoClassDefFoundError e) {
            throw new UsageException("view needs the JDK's module jdk.httpserver (got: a Java without it)", e);
        }
        return ExitCodes.FINE;
    }

    @SuppressWarnings("try") // the source reads by itself
    private void watch(String host, int from) throws IOException {
        Arguments.port(from, 1);
        World lender = lender();
        LiveFilm film = new LiveFilm(host + ":" + from, Pictures.unit(lender));
        WatchReader.dial(host, from).close(); // a wrong address ends the command, and not only the page's hope
        LiveSource source =
                new LiveSource(film, () -> WatchReader.dial(host, from), Colours.of(lender), connection -> {});
        try (PageServer server = PageServer.live(address(), film, null)) {
            show(server);
        } finally {
            source.close();
        }
    }

    private void view(Path file) throws IOException {
        Arguments.refuse(!Files.exists(file), "WHAT must be a file that exists, or HOST:PORT; check the path", file);
        boolean isDemo = WireFiles.at(file) != null;
        if (!isDemo) {
            Arguments.input("WHAT", file);
        }
        if (RecordingOptions.isRecording(file)) {
            try (PageServer server = PageServer.of(address(), recording(file))) {
                show(server);
            }
            return;
        }
        if (colours != null) {
            throw new UsageException(
                    "--world is for a recording or a session, and WHAT is a world (got: " + colours + ")");
        }
        World world = files.world(file);
        LiveFilm film = new LiveFilm(Pictures.title(file), Pictures.unit(world));
        try (PageServer server = PageServer.live(address(), film, new WorldControl(world, film))) {
            show(server);
        }
    }

    private PageWriter recording(Path file) throws IOException {
        World lender = lender();
        StateHistory film = RecordingOptions.read(spec, file, lender);
        int first = RecordingOptions.first(film, "WHAT", file);
        return new PageWriter(film)
                .ofSteps(first, film.size())
                .titled(Pictures.title(file))
                .described(NumberText.count(film.size() - first, "step"), Pictures.unit(lender));
    }

    /** Prints the address, opens a browser, and waits until the command is ended. */
    private void show(PageServer server) {
        spec.commandLine().getOut().println("View on " + server.page());
        spec.commandLine().getOut().flush();
        if (!isQuiet && !Browser.open(server.page())) {
            spec.commandLine().getErr().println("No browser was opened; open this address in one");
        }
        try {
            new CountDownLatch(1).await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt(); // the command is over
        }
    }

    private InetSocketAddress address() {
        return new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
    }

    private @Nullable World lender() throws IOException {
        return colours == null ? null : files.world(Arguments.input("--world", colours));
    }
}
