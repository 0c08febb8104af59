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
    private static final String FIRST = "first-release.ser";
    private static final String WITH_CAPSULES = "with-capsules.ser";
    private static final String WITH_GRIDS = "with-grids.ser";
    static final String WITH_MATERIALS = "with-materials.ser";

    @Test
    void theFirstReleasesBytesMeanWhatTheyMeant() throws IOException {
        assertThat(MessageTest.readAll(stored(FIRST))).isEqualTo(Samples.everyBundle(Samples.firstShapes()));
    }

    @Test
    void bytesWithCapsulesMeanWhatTheyMeant() throws IOException {
        assertThat(MessageTest.readAll(stored(WITH_CAPSULES)))
                .isEqualTo(Samples.everyBundle(Samples.shapesBeforeTheGrid()));
    }

    @Test
    void bytesWithGridsMeanWhatTheyMeant() throws IOException {
        assertThat(MessageTest.readAll(stored(WITH_GRIDS)))
                .isEqualTo(Samples.everyBundle(Samples.shapesBeforeMaterials()));
    }

    @Test
    void bytesWithMaterialsMeanWhatTheyMeant() throws IOException {
        assertThat(MessageTest.readAll(stored(WITH_MATERIALS))).isEqualTo(Samples.everyBundle());
    }

    /** Who knows no materials understands what has none. */
    @Test
    void objectsWithoutMaterialsAreWrittenAsEver() throws IOException {
        Bundle[] bundles = Samples.everyBundle(Samples.shapesBeforeMaterials()).toArray(Bundle[]::new);
        assertThat(MessageTest.write(bundles)).isEqualTo(stored(WITH_GRIDS));
    }

    static byte[] stored(String file) throws IOException {
        try (InputStream in = Objects.requireNonNull(StoredBytesTest.class.getResourceAsStream(file))) {
            return in.readAllBytes();
        }
    }

    /** Wrote the last file; whoever changes what is written adds one more and leaves these alone. */
    static final class Write {
        private Write() {}

        public static void main(String[] args) throws IOException {
            byte[] bytes = MessageTest.write(Samples.everyBundle().toArray(Bundle[]::new));
            Files.write(Path.of(args[0], WITH_MATERIALS), bytes);
        }
    }
}
