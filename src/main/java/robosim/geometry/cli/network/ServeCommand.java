package robosim.geometry.cli.network;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.Function;
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
import robosim.geometry.cli.terminal.ProofOptions;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.cli.terminal.WorldFiles;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.NetOptions;
import robosim.geometry.net.SessionListener;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.scenario.AnswerProofs;
import robosim.geometry.scenario.drive.WorldLoading;
import robosim.geometry.scenario.drive.WorldOpening;
import robosim.geometry.world.WorldException;

/** Serves environments that dial in, until the process is ended. */
@Command(
        name = "serve",
        description = {
            "Serves environment modules that dial in, until it is ended.",
            "Each connection sends its own world, as load in Python does with a file, or begins"
                    + " with that of --world, which is its own from then on."
        },
        exitCodeList = {ExitCodes.REFUSED, ExitCodes.ENDED},
        footer = {
            "  robosim-geometry serve 5555",
            "  robosim-geometry serve 5555 --world worlds/rooms.xml",
            "  robosim-geometry serve 5555 --record recordings --figures 60",
            "  robosim-geometry serve 5555 --prove 0.001",
            "  robosim-geometry serve 5555 --watch 5556",
            "  robosim-geometry serve 5555 --view 8080 --control",
            "  robosim-geometry serve 5555 --admin 5580 --drain 60 --log json"
        })
public final class ServeCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "PORT", description = "1 to 65535, or 0 for any free port")
    private int port;

    @Option(
            names = "--host",
            paramLabel = "ADDRESS",
            defaultValue = "localhost",
            description =
                    "address to listen on; 0.0.0.0 for all (default: ${DEFAULT-VALUE}). Any but this machine's own"
                            + " needs TLS or a secret.")
    private String host = "localhost";

    @Option(
            names = "--connections",
            paramLabel = "N",
            defaultValue = "256",
            description = "maximum number of connections at a time (default: ${DEFAULT-VALUE})")
    private int connections;

    @Option(
            names = "--admission",
            paramLabel = "SECONDS",
            defaultValue = "10",
            description = "longest time until a new peer has sent its first message, TLS and the secret included"
                    + " (default: ${DEFAULT-VALUE})")
    private int admission;

    @Option(
            names = "--drain",
            paramLabel = "SECONDS",
            defaultValue = "0",
            description =
                    "when it is told to end, accept no new connections and let the open ones go on until they end,"
                            + " for at most that time (default: ${DEFAULT-VALUE})")
    private int drain;

    @Option(
            names = "--admin",
            paramLabel = "PORT",
            description = "open an HTTP port on this machine for its operator: /health, /metrics for Prometheus,"
                    + " /connections; 0 for any free port")
    private @Nullable Integer admin;

    @Option(
            names = "--world",
            paramLabel = "FILE",
            description =
                    "the world with which each connection begins, unless it sends one first: any file that convert"
                            + " reads, with the bodies and drives of its robots (default: none)")
    private @Nullable Path world;

    @Option(
            names = "--worlds",
            paramLabel = "DIR",
            description = "a folder whose world files peers may load by their paths in it, as load in Python"
                    + " does; without it they can send theirs (default: none)")
    private @Nullable Path worlds;

    @Option(
            names = "--attached",
            description = "end when standard input ends: a server of the program that starts it ends with that program")
    private boolean isAttached;

    @Mixin
    private WorldFiles files;

    @Mixin
    private ConnectionOptions common;

    @Mixin
    private ObserverOptions observers;

    @Mixin
    private ProofOptions proofs;

    @Override
    public Integer call() throws Exception {
        Arguments.port(port, 0);
        WorldLoading loading = loading();
        NetOptions options = common.options(
                        given -> given.withConnections(connections).withAdmission(Duration.ofSeconds(admission)))
                .withWorlds(loading);
        List<Bundle> opening = opening();
        int seconds = common.figuresSeconds();
        Arguments.refuse(drain < 0, "--drain must be at least 0", drain);
        if (admin != null) {
            Arguments.port(admin, 0);
        }
        NetOptions recorded = observers.recordedInFolder(options.withOpening(opening));
        AnswerProofs answers = proofs.of(options.session());
        Function<String, SessionListener> recording = recorded.listeners();
        ObserverOptions.Watch watched = observers.watched(
                answers == null
                        ? recorded
                        : recorded.withListeners(name -> recording.apply(name).and(answers.apply(name))));
        GeometryServer server = new GeometryServer(InetAddress.getByName(host), port, watched.options());
        common.keepFresh(server::renew);
        PrintWriter out = spec.commandLine().getOut();
        if (!opening.isEmpty()) {
            out.println("Connections begin with the world of " + world + ", "
                    + NumberText.count(((InitBundle) opening.get(0)).objects().size(), "object"));
        }
        AdminPort operator = admin == null ? null : operator(server, out);
        out.println("Listening on " + server.address());
        out.flush();
        FiguresPrinter.start(out, server.figures(), seconds, () -> {
            if (drain > 0) {
                NextSignal.runs(server::close);
            }
            watched.release();
            server.drain(Duration.ofSeconds(drain));
            loading.close();
            watched.close();
            proofs.tell(out);
            if (operator != null) {
                operator.close();
            }
        });
        ServiceManager.ready("listening on " + server.address());
        if (isAttached) {
            Thread input = new Thread(ServeCommand::endWithInput, "standard-input");
            input.setDaemon(true);
            input.start();
        }
        return 0;
    }

    private static void endWithInput() {
        try {
            System.in.transferTo(OutputStream.nullOutputStream());
        } catch (IOException e) {
            // It has ended, too.
        }
        System.exit(ExitCodes.FINE);
    }

    private AdminPort operator(GeometryServer server, PrintWriter out) {
        try {
            AdminPort port = new AdminPort(admin == null ? 0 : admin, server);
            out.println("Admin on " + port.address());
            return port;
        } catch (NoClassDefFoundError e) {
            server.close();
            throw new UsageException("--admin needs the JDK's module jdk.httpserver (got: a Java without it)", e);
        } catch (RuntimeException e) {
            server.close();
            throw e;
        }
    }

    private WorldLoading loading() {
        if (worlds != null) {
            Arguments.folders("--worlds", List.of(worlds));
        }
        return WorldLoading.of(worlds, files.folders());
    }

    /** The requests with which connections begin; none without a world. */
    private List<Bundle> opening() throws WorldException {
        files.check();
        if (world == null) {
            return List.of();
        }
        Arguments.input("--world", world);
        try {
            return WorldOpening.of(files.world(world));
        } catch (IllegalArgumentException e) {
            throw new UsageException("--world must be a world that can be (got: " + world + "): " + e.getMessage(), e);
        }
    }
}
