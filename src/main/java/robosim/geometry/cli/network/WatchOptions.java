package robosim.geometry.cli.network;

import java.io.PrintWriter;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import robosim.geometry.cli.terminal.Ports;
import robosim.geometry.net.NetOptions;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.WatchServer;
import robosim.geometry.scenario.Watching;

/** How {@code serve} and {@code connect} let others look on. */
public final class WatchOptions {
    @Spec(Spec.Target.MIXEE)
    @SuppressWarnings("NullAway.Init") // set by picocli
    private CommandSpec spec;

    @Option(
            names = "--watch",
            paramLabel = "PORT",
            description = "listen on this machine, on a second port that tells what happens and takes nothing, for"
                    + " `view --watch`; 0 for any that is free")
    private @Nullable Integer port;

    private WatchOptions() {}

    /** What is listening, and the options that let it know; closing it ends nothing where nobody was to watch. */
    record Watch(NetOptions options, @Nullable WatchServer server) implements AutoCloseable {
        @Override
        public void close() {
            if (server != null) {
                server.close();
            }
        }
    }

    /** Begins to listen where that is asked for. */
    Watch begin(NetOptions options) {
        if (port == null) {
            return new Watch(options, null);
        }
        Ports.check(spec, port, 0);
        Watching watching = new Watching(options.session());
        WatchServer server = new WatchServer(port, watching);
        PrintWriter out = spec.commandLine().getOut();
        out.println("To be watched on " + server.address());
        out.flush();
        Function<String, SessionListener> others = options.listeners();
        NetOptions told =
                options.withListeners(connection -> others.apply(connection).and(watching.apply(connection)));
        return new Watch(told, server);
    }
}
