package robosim.geometry.cli.network;

import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.net.GeometryClient;
import robosim.geometry.net.NetOptions;
import robosim.geometry.net.SessionListener;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.scenario.drive.WorldLoading;

/** Dials an environment and answers its requests. */
@Command(
        name = "connect",
        description = "Dials RoboSim's environment module and answers its requests; dials again after a disconnect.",
        exitCodeList = {
            ExitCodes.FINE + ":with --once, the environment was served until it hung up",
            ExitCodes.FINDINGS + ":with --once, the environment hung up before its first request",
            ExitCodes.UNUSABLE
                    + ":not done: bad usage, or with --once an environment that cannot be reached or a connection that"
                    + " failed (TLS, the secret, the protocol)",
            ExitCodes.ENDED
        },
        footer = {
            "  robosim-geometry connect localhost 5555",
            "  robosim-geometry connect localhost 5555 --once --record session.scenario.jsonl"
        })
public final class ConnectCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(index = "0", paramLabel = "HOST", description = "the environment's name or address")
    private String host = "localhost";

    @Parameters(index = "1", paramLabel = "PORT", description = "1 to 65535")
    private int port;

    @Option(names = "--once", description = "dial once and end when the environment hangs up")
    private boolean once;

    @Mixin
    private ConnectionOptions common;

    @Mixin
    private ObserverOptions observers;

    @Override
    public Integer call() {
        Arguments.port(port, 1);
        NetOptions options = observers
                .recordedInFile(common.options(given -> once ? given : given.withRedial()))
                .withWorlds(WorldLoading.of(null, List.of()));
        AtomicBoolean isAsked = new AtomicBoolean();
        options = options.withListeners(told(options.listeners(), isAsked));
        ObserverOptions.Watch watched = observers.watched(options);
        int seconds = common.figuresSeconds();
        GeometryClient client = new GeometryClient(host, port, watched.options());
        common.keepFresh(client::renew);
        FiguresPrinter.start(spec.commandLine().getOut(), client.figures(), seconds, () -> {
            watched.release();
            client.close();
            watched.close();
        });
        client.run();
        // A failure of the connection has been logged by then; it decides the exit code only with --once.
        if (once && client.figures().getErrors() > 0) {
            return ExitCodes.UNUSABLE;
        }
        if (once && !isAsked.get()) {
            spec.commandLine()
                    .getErr()
                    .println("the environment at " + host + ":" + port + " hung up before its first request");
            return ExitCodes.FINDINGS;
        }
        return ExitCodes.FINE;
    }

    /** Listeners that also print that a connection was made, and note that there was a request. */
    private Function<String, SessionListener> told(Function<String, SessionListener> others, AtomicBoolean isAsked) {
        PrintWriter out = spec.commandLine().getOut();
        return connection -> {
            out.println("Connected to " + host + ":" + port);
            out.flush();
            SessionListener asked = new SessionListener() {
                @Override
                public void requested(Bundle request) {
                    isAsked.set(true);
                }
            };
            return asked.and(others.apply(connection));
        };
    }
}
