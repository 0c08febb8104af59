package robosim.geometry.cli;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.net.GeometryClient;

/** Dials an environment and answers it. */
@Command(
        name = "connect",
        description = "Dials RoboSim's environment module and answers it until it hangs up.",
        mixinStandardHelpOptions = true)
final class ConnectCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private CommandSpec spec;

    @Parameters(index = "0", paramLabel = "HOST", description = "the environment's name or address")
    private String host = "localhost";

    @Parameters(index = "1", paramLabel = "PORT", description = "1 to 65535")
    private int port;

    private ConnectCommand() {}

    @Override
    public Integer call() {
        Ports.check(spec, port, 1);
        new GeometryClient(host, port).run();
        return 0;
    }
}
