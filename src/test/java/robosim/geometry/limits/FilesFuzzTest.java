package robosim.geometry.limits;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.util.stream.Stream;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The readers of other programs' files. An ordinary build tries the seeds; {@code mvn test -Pfuzz} lets Jazzer breed inputs
 * from them, whose first byte is the format.
 */
class FilesFuzzTest {
    private static final HostileFiles READERS = readers();

    private static HostileFiles readers() {
        try {
            HostileFiles readers = new HostileFiles(Files.createTempDirectory("fuzz"));
            for (byte[] seed : HostileFiles.seeds()) {
                assertThat(readers.accepts(seed)).as("format %d", seed[0]).isTrue();
            }
            return readers;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static Stream<Arguments> seeds() {
        return HostileFiles.seeds().stream().map(Arguments::of);
    }

    @MethodSource("seeds")
    @FuzzTest(maxDuration = "2h", maxExecutions = 1_010_000)
    void anyBytes(byte[] bytes) {
        READERS.accepts(bytes);
    }
}
