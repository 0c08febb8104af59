package robosim.geometry.cli.network;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
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
                    + " `view --watch`; 0 for any free port")
    private @Nullable Integer port;

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
     * What watchers dial, null if there is none, and the options that report to it. Closing it stops to listen.
     */
    record Watch(NetOptions options, @Nullable Watching watching) implements AutoCloseable {
        @Override
        public void close() {
            if (watching != null) {
                watching.close();
            }
        }
    }

    /** Starts to listen if watching was asked for. */
    Watch watched(NetOptions options) {
        if (port == null) {
            return new Watch(options, null);
        }
        Arguments.port(port, 0);
        Watching watching = new Watching(options.session());
        InetSocketAddress address = new InetSocketAddress(InetAddress.getLoopbackAddress(), watching.listen(port));
        PrintWriter out = spec.commandLine().getOut();
        out.println("Watch on " + address);
        out.flush();
        Function<String, SessionListener> others = options.listeners();
        NetOptions told =
                options.withListeners(connection -> others.apply(connection).and(watching.apply(connection)));
        return new Watch(told, watching);
    }
}
