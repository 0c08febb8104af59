package robosim.geometry.cli.network;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.net.LogCapture;
import robosim.geometry.net.NetOptions;

class RenewalTest {
    @TempDir
    private Path folder;

    private static NetOptions read(Path file) {
        try {
            return NetOptions.defaults().withAccess(null, Files.readString(file).toCharArray());
        } catch (IOException e) {
            throw new IllegalArgumentException("the file must be there (got: " + file + ")", e);
        }
    }

    @Test
    void readsFilesAgainOnceTheyHaveChangedAndComeToRest() throws Exception {
        Path file = Files.writeString(folder.resolve("secret"), "a secret of sixteen letters");
        List<NetOptions> renewed = new ArrayList<>();
        try (LogCapture log = new LogCapture()) {
            Renewal renewal = new Renewal(List.of(file), () -> renewed.add(read(file)));
            renewal.look();
            renewal.look();
            assertThat(renewed).isEmpty();
            Files.writeString(file, "another secret, and longer");
            renewal.look();
            assertThat(renewed).as("it may be half written").isEmpty();
            Files.writeString(file, "another secret, and longer, to its end");
            renewal.look();
            assertThat(renewed).isEmpty();
            renewal.look();
            renewal.look();
            assertThat(renewed).hasSize(1);
            assertThat(log.lines()).isEmpty();
            Files.writeString(file, "short");
            renewal.look();
            renewal.look();
            renewal.look();
            assertThat(renewed).hasSize(1);
            assertThat(log.linesWith("stay as they were: a secret must have at least 16 letters (got: 5)"))
                    .hasSize(1);
            Files.delete(file);
            renewal.look();
            renewal.look();
            assertThat(log.linesWith("the file must be there")).hasSize(1);
        }
    }
}
