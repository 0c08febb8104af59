package robosim.geometry.cli.network;

import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import robosim.geometry.cli.terminal.Ports;
import robosim.geometry.net.NetOptions;
import robosim.geometry.net.SessionListener;
import robosim.geometry.scenario.Watching;

/** How {@code serve} and {@code connect} let a session be watched. */
public final class WatchOptions {
    @Spec(Spec.Target.MIXEE)
    @SuppressWarnings("NullAway.Init") // set by picocli
    private CommandSpec spec;

    @Option(
            names = "--watch",
            paramLabel = "PORT",
            description = "open a second, read-only port on this machine that reports what happens, for"
                    + " `view --watch`; 0 for any free port")
    private @Nullable Integer port;

    private WatchOptions() {}

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
    Watch begin(NetOptions options) {
        if (port == null) {
            return new Watch(options, null);
        }
        Ports.check(spec, port, 0);
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
