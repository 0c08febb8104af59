package robosim.geometry.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** What the first release wrote is understood for ever. */
class StoredBytesTest {
    private static final String FIRST = "first-release.ser";
    private static final String WITH_CAPSULES = "with-capsules.ser";
    private static final String WITH_GRIDS = "with-grids.ser";
    static final String WITH_MATERIALS = "with-materials.ser";
    static final String WITH_VISUALS = "with-visuals.ser";
    static final String WITH_LAYERS = "with-layers.ser";
    static final String WITH_PUSHES = "with-pushes.ser";

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

    @Test
    void bytesWithCopiesAndVisualsMeanWhatTheyMeant() throws IOException {
        assertThat(MessageTest.readAll(stored(WITH_VISUALS))).isEqualTo(withVisuals());
    }

    @Test
    void bytesWithDrivesAndLayersMeanWhatTheyMeant() throws IOException {
        assertThat(MessageTest.readAll(stored(WITH_LAYERS))).isEqualTo(BatchSamples.drives());
    }

    @Test
    void bytesWithAttachmentsAndPushesMeanWhatTheyMeant() throws IOException {
        assertThat(MessageTest.readAll(stored(WITH_PUSHES)))
                .isEqualTo(List.of(BatchSamples.attachments(), StepSamples.pushing()));
    }

    /** Requests about copies of a world, and an object that is seen as another one. */
    private static List<Bundle> withVisuals() {
        List<Bundle> bundles = new ArrayList<>(BatchSamples.copies());
        GeometryObject seen = new SphereObject(new Point(0, 0.5, 0), 0.25).withMaterial(Material.of(Color.WHITE));
        bundles.add(new InitBundle(List.of(new BoxObject(new Point(1, 2, 3), 1, 1, 1)
                .withVisuals(List.of(seen))
                .moveable("robot"))));
        return bundles;
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
            byte[] bytes = MessageTest.write(BatchSamples.attachments(), StepSamples.pushing());
            Files.write(Path.of(args[0], WITH_PUSHES), bytes);
        }
    }
}
