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

    /** One of each bundle with every shape, the capsule among them. */
    private static final String CAPSULES = "capsules.ser";

    @Test
    void theFirstReleasesBytesMeanWhatTheyMeant() throws IOException {
        assertThat(MessageTest.readAll(stored(FIRST_RELEASE))).isEqualTo(Samples.firstBundles());
    }

    @Test
    void capsulesMeanWhatTheyMeant() throws IOException {
        assertThat(MessageTest.readAll(stored(CAPSULES))).isEqualTo(Samples.everyBundle());
    }

    private static byte[] stored(String name) throws IOException {
        try (InputStream in = Objects.requireNonNull(StoredBytesTest.class.getResourceAsStream(name))) {
            return in.readAllBytes();
        }
    }

    /** Wrote a file; a later release adds one of its own and leaves this one alone. */
    static final class Write {
        private Write() {}

        public static void main(String[] args) throws IOException {
            byte[] bytes = MessageTest.write(Samples.everyBundle().toArray(Bundle[]::new));
            Files.write(Path.of(args[0], CAPSULES), bytes);
        }
    }
}
