package robosim.geometry.limits;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.util.stream.Stream;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The decoder of Java serialization. An ordinary build tries the seeds; {@code mvn test -Pfuzz} lets Jazzer breed a million inputs
 * from them.
 */
class JavaFuzzTest {
    private static final Hostile DECODER = Hostile.javaSerialization();

    static Stream<Arguments> seeds() {
        return Hostile.javaSeeds().stream().map(Arguments::of);
    }

    @MethodSource("seeds")
    @FuzzTest(maxDuration = "2h", maxExecutions = 1_010_000)
    void anyBytes(byte[] bytes) {
        DECODER.accepts(bytes);
    }
}
