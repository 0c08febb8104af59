package robosim.geometry.cli.network;

import java.io.PrintWriter;
import java.net.InetAddress;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Ports;
import robosim.geometry.cli.terminal.Version;
import robosim.geometry.net.GeometryServer;

/** Serves environments that dial in, until the process is ended. */
@Command(
        name = "serve",
        description = {
            "Serves environment modules that dial in, until it is ended.",
            "It holds no world: each connection sends its own, as robosim.load of examples/robosim.py does with a file."
        },
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        exitCodeListHeading = ExitCodes.HEADING,
        exitCodeList = {ExitCodes.REFUSED, ExitCodes.ENDED},
        footerHeading = "%nExamples:%n",
        footer = {
            "  robosim-geometry serve 5555",
            "  robosim-geometry serve 5555 --record recordings --figures 60",
            "  robosim-geometry serve 5555 --watch 5556"
        })
public final class ServeCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private CommandSpec spec;

    @Parameters(paramLabel = "PORT", description = "1 to 65535, or 0 for any free port")
    private int port;

    @Option(
            names = "--host",
            paramLabel = "ADDRESS",
            defaultValue = "localhost",
            description =
                    "address to listen on; 0.0.0.0 for all (default: ${DEFAULT-VALUE}). Any but this machine's own needs TLS"
                            + " or a secret.")
    private String host = "localhost";

    @Option(
            names = "--connections",
            paramLabel = "N",
            defaultValue = "256",
            description = "maximum number of connections at a time (default: ${DEFAULT-VALUE})")
    private int connections;

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private ConnectionOptions common;

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private RecordOptions record;

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private WatchOptions watch;

    private ServeCommand() {}

    @Override
    public Integer call() throws Exception {
        Ports.check(spec, port, 0);
        WatchOptions.Watch watched = watch.begin(record.inFolder(common.options(connections)));
        int seconds = common.figuresSeconds();
        GeometryServer server = new GeometryServer(InetAddress.getByName(host), port, watched.options());
        PrintWriter out = spec.commandLine().getOut();
        out.println("Listening on " + server.address());
        out.flush();
        FiguresPrinter.start(out, server.figures(), seconds, () -> {
            server.close();
            watched.close();
        });
        return 0;
    }
}
