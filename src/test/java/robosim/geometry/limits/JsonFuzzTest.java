package robosim.geometry.limits;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.util.stream.Stream;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The decoder of JSON lines. An ordinary build tries the seeds; {@code mvn test -Pfuzz} lets Jazzer breed a million inputs
 * from them.
 */
class JsonFuzzTest {
    private static final Hostile DECODER = Hostile.jsonLines();

    static Stream<Arguments> seeds() {
        return Hostile.jsonSeeds().stream().map(Arguments::of);
    }

    @MethodSource("seeds")
    @FuzzTest(maxDuration = "2h", maxExecutions = 1_010_000)
    void anyBytes(byte[] bytes) {
        DECODER.accepts(bytes);
    }
}
