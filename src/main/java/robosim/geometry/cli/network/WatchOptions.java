package robosim.geometry.cli.network;

import java.io.PrintWriter;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.net.NetOptions;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.WatchServer;
import robosim.geometry.scenario.Watching;

/** How {@code serve} and {@code connect} let a session be watched. */
public final class WatchOptions {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    @Option(
            names = "--watch",
            paramLabel = "PORT",
            description = "open a second, read-only port on this machine that reports what happens, for"
                    + " `view --watch`; 0 for any free port")
    private @Nullable Integer port;

    /**
     * The server for watchers, null if none was asked for, and the options that report to it. Closing it closes that
     * server.
     */
    record Watch(NetOptions options, @Nullable WatchServer server) implements AutoCloseable {
        @Override
        public void close() {
            if (server != null) {
                server.close();
            }
        }
    }

    /** Starts to listen if watching was asked for. */
    Watch begin(NetOptions options) {
        if (port == null) {
            return new Watch(options, null);
        }
        Arguments.port(port, 0);
        Watching watching = new Watching(options.session());
        WatchServer server = new WatchServer(port, watching);
        PrintWriter out = spec.commandLine().getOut();
        out.println("Watch on " + server.address());
        out.flush();
        Function<String, SessionListener> others = options.listeners();
        NetOptions told =
                options.withListeners(connection -> others.apply(connection).and(watching.apply(connection)));
        return new Watch(told, server);
    }
}
