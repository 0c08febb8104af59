package robosim.geometry.cli.network;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import robosim.geometry.check.NumberText;
import robosim.geometry.check.Text;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.cli.terminal.WireFiles;
import robosim.geometry.export.RosRecording;
import robosim.geometry.net.NetOptions;
import robosim.geometry.net.SessionListener;
import robosim.geometry.scenario.Recordings;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.scenario.Watching;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.viewer.playback.Colours;
import robosim.geometry.viewer.web.LiveFilm;
import robosim.geometry.viewer.web.LiveSource;
import robosim.geometry.viewer.web.PageServer;
import robosim.geometry.viewer.web.SessionControl;

/** How {@code serve} and {@code connect} record their sessions, and let them be watched. */
public final class ObserverOptions {
    private static final System.Logger LOG = System.getLogger(ObserverOptions.class.getPackageName());

    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    @Option(
            names = "--record",
            paramLabel = "PLACE",
            description = "record each session as a scenario for `replay`: serve takes a folder and writes a"
                    + " file for each connection; connect takes a file, and numbers those of further connections. A"
                    + " place that ends in .mcap or .wpilog is a file for both, to which the scenario beside it is"
                    + " converted at the end of each session")
    private @Nullable Path place;

    @Option(
            names = "--record-bytes",
            paramLabel = "N",
            description =
                    "largest size of a file; at that size recording stops and the session goes on (default: 1 GiB)")
    private long bytes = Recordings.DEFAULT_BYTES;

    @Option(
            names = "--watch",
            paramLabel = "PORT",
            description = "open a second, read-only port on this machine that reports what happens, for"
                    + " `view HOST:PORT`; 0 for any free port")
    private @Nullable Integer port;

    @Option(
            names = "--view",
            paramLabel = "[ADDRESS:]PORT",
            description = "serve a page that shows the session, at an address with a secret, which is printed: on this"
                    + " machine, or on ADDRESS, such as 0.0.0.0 in a container; port 0 for any free port")
    private @Nullable String view;

    @Option(
            names = "--control",
            description = "let the page of --view pause, step, slow and reset the session, and drag its robots")
    private boolean isControlled;

    /** Records into a folder, which is created if it does not exist; or into a log for other programs. */
    NetOptions recordedInFolder(NetOptions options) {
        Path folder = place;
        if (folder == null) {
            return options;
        }
        if (RosRecording.isLog(folder)) {
            return recordedAsLog(options, folder);
        }
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw new UsageException(
                    "--record must be a folder, or a path where one can be created (got: " + folder + ")");
        }
        Arguments.refuse(!Files.isWritable(folder), "--record must be a folder that can be written to", folder);
        return options.withListeners(limited(Recordings.inFolder(folder, options.session())));
    }

    /** Records into a new file in an existing folder. */
    NetOptions recordedInFile(NetOptions options) {
        Path file = place;
        if (file == null) {
            return options;
        }
        if (RosRecording.isLog(file)) {
            return recordedAsLog(options, file);
        }
        return options.withListeners(
                limited(Recordings.inFile(Arguments.newFile("--record", file), options.session())));
    }

    /** Records scenarios beside the file; each is converted when its session has ended, and stays. */
    private NetOptions recordedAsLog(NetOptions options, Path file) {
        Arguments.newFile("--record", file);
        String name = file.toString();
        String ending = name.substring(name.lastIndexOf('.'));
        Path scenario = withEnding(file, ending, ScenarioReader.ENDING);
        Arguments.newFile("--record, whose scenario is written beside it,", scenario);
        Recordings recordings = Recordings.inFile(scenario, options.session());
        return options.withListeners(limited(recordings.whenClosed(recording -> convert(recording, ending))));
    }

    private static Path withEnding(Path file, String ending, String other) {
        String name = String.valueOf(file.getFileName());
        return file.resolveSibling(name.substring(0, name.length() - ending.length()) + other);
    }

    private static void convert(Path scenario, String ending) {
        Path messages = withEnding(scenario, ScenarioReader.ENDING, ending);
        try (StepReader recording = WireFiles.recording(scenario)) {
            long steps = RosRecording.write(recording, RosRecording.TICK, messages, step -> {});
            LOG.log(System.Logger.Level.INFO, "wrote " + Text.line(messages + ": " + NumberText.count(steps, "step")));
        } catch (IOException | RuntimeException e) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    Text.line(messages + " could not be written; convert " + scenario + " to try again (" + e + ")"));
        }
    }

    private Recordings limited(Recordings recordings) {
        Arguments.refuse(bytes < 1, "--record-bytes must be at least 1", bytes);
        return recordings.atMost(bytes);
    }

    /**
     * What shows sessions, and the options that report to it.
     *
     * @param control what may hold sessions; null if nothing may
     */
    record Watch(
            NetOptions options,
            List<AutoCloseable> open,
            @Nullable SessionControl control) implements AutoCloseable {
        /** Lets all sessions go on. */
        void release() {
            if (control != null) {
                control.close();
            }
        }

        @Override
        public void close() {
            for (AutoCloseable each : open) {
                try {
                    each.close();
                } catch (Exception e) {
                    throw new IllegalStateException("what shows sessions could not be closed", e);
                }
            }
        }
    }

    /** Starts to listen if watching or viewing was requested. */
    Watch watched(NetOptions options) {
        Arguments.refuse(isControlled && view == null, "--control is for a page; add --view PORT", "none");
        if (port == null && view == null) {
            return new Watch(options, List.of(), null);
        }
        Watching watching = new Watching(options.session());
        List<AutoCloseable> open = new ArrayList<>();
        LiveFilm film = new LiveFilm("RoboSim", "");
        SessionControl control = isControlled ? new SessionControl(film) : null;
        Function<String, SessionListener> listeners = both(options.listeners(), watching);
        PrintWriter out = spec.commandLine().getOut();
        if (view != null) {
            open.addAll(viewed(view, watching, film, control));
            // Before the others, which then see the requests that the page makes.
            listeners = control == null ? listeners : both(control, listeners);
        }
        open.add(watching);
        if (port != null) {
            Arguments.port(port, 0);
            out.println("Watch on " + new InetSocketAddress(InetAddress.getLoopbackAddress(), watching.listen(port)));
        }
        out.flush();
        return new Watch(options.withListeners(listeners), open, control);
    }

    private static Function<String, SessionListener> both(
            Function<String, SessionListener> first, Function<String, SessionListener> second) {
        return connection -> first.apply(connection).and(second.apply(connection));
    }

    private List<AutoCloseable> viewed(
            String place, Watching watching, LiveFilm film, @Nullable SessionControl control) {
        PageServer server;
        try {
            server = PageServer.live(address(place), film, control);
        } catch (IOException e) {
            throw new UsageException("--view cannot be served (got: " + place + "): " + e.getMessage(), e);
        } catch (NoClassDefFoundError e) {
            throw new UsageException("--view needs the JDK's module jdk.httpserver (got: a Java without it)", e);
        }
        spec.commandLine().getOut().println("View on " + server.page());
        LiveSource source = new LiveSource(
                film,
                () -> StepReader.of(ScenarioReader.of(watching.lines(), "the server")),
                Colours.NONE,
                connection -> {
                    if (control != null) {
                        control.show(connection);
                    }
                });
        return List.of(server, source);
    }

    /** The address of a page: a port of this machine, or one of an address of it. */
    private static InetSocketAddress address(String place) {
        int colon = place.lastIndexOf(':');
        String number = place.substring(colon + 1);
        Arguments.refuse(!number.matches("\\d{1,5}"), "--view must be PORT or ADDRESS:PORT, such as 8080", place);
        int at = Integer.parseInt(number);
        Arguments.port(at, 0);
        try {
            InetAddress address = colon < 0
                    ? InetAddress.getLoopbackAddress()
                    : InetAddress.getByName(place.substring(0, colon).replaceAll("^\\[|]$", ""));
            return new InetSocketAddress(address, at);
        } catch (UnknownHostException e) {
            throw new UsageException("--view must name an address of this machine (got: " + place + ")", e);
        }
    }
}
