package robosim.geometry.sweep;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;

/** Sweeps that tests have in common. */
final class Sweeps {
    private Sweeps() {}

    /** 2 worlds x 4 combinations x 20 replicates. */
    static ParameterSweep wander(int pauseMillis) {
        try {
            return ParameterSweep.of(new Wander(pauseMillis))
                    .over(SweepWorld.read(Path.of("worlds", "rooms.xml")))
                    .over(SweepWorld.read(Path.of("worlds", "maze.xml")))
                    .vary("step", "0.25", "1")
                    .vary("accuracy", "EXACT", "DOP")
                    .replicates(20)
                    .seed(7);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A process that is to be killed: carries it out slowly into a file. */
    public static void main(String[] arguments) throws Exception {
        SweepRun.of(wander(100), Path.of(arguments[0])).withThreads(2).resume().run();
    }
}
