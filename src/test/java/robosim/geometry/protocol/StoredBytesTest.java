package robosim.geometry.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import org.junit.jupiter.api.Test;

/** What the first release wrote is understood for ever. */
class StoredBytesTest {
    private static final String FIRST_RELEASE = "first-release.ser";

    @Test
    void theFirstReleasesBytesMeanWhatTheyMeant() throws IOException {
        byte[] bytes;
        try (InputStream in = Objects.requireNonNull(StoredBytesTest.class.getResourceAsStream(FIRST_RELEASE))) {
            bytes = in.readAllBytes();
        }
        assertThat(MessageTest.readAll(bytes)).isEqualTo(Samples.everyBundle());
    }

    /** Wrote the file; a later release adds one of its own and leaves this one alone. */
    static final class Write {
        private Write() {}

        public static void main(String[] args) throws IOException {
            byte[] bytes = MessageTest.write(Samples.everyBundle().toArray(Bundle[]::new));
            Files.write(Path.of(args[0], FIRST_RELEASE), bytes);
        }
    }
}
