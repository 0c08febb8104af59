package robosim.geometry.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ModelFoldersTest {
    @TempDir
    Path folder;

    @Test
    void foldersOfTheEnvironmentFollowThoseThatAreGiven() throws IOException {
        Path a = Files.createDirectories(folder.resolve("a"));
        Path b = Files.createDirectories(folder.resolve("b"));
        Path share = Files.createDirectories(folder.resolve("install/share"));
        Path given = Files.createDirectories(folder.resolve("given"));
        Map<String, String> environment = Map.of(
                "GZ_SIM_RESOURCE_PATH",
                a + File.pathSeparator + folder.resolve("gone") + File.pathSeparator + given,
                "ROS_PACKAGE_PATH",
                File.pathSeparator + b + File.pathSeparator + a,
                "AMENT_PREFIX_PATH",
                folder.resolve("install").toString(),
                "OTHER_PATH",
                folder.toString());
        assertThat(ModelFolders.with(List.of(given), environment)).containsExactly(given, a, b, share);
        assertThat(ModelFolders.with(List.of(given), Map.of())).containsExactly(given);
    }

    @Test
    void whatGazeboHasDownloadedComesLast() throws IOException {
        Path home = Files.createDirectories(folder.resolve("home/.gz/fuel")).resolve("../..");
        Path old = Files.createDirectories(folder.resolve("home/.ignition/fuel"));
        Path own = Files.createDirectories(folder.resolve("own"));
        assertThat(ModelFolders.with(
                        List.of(),
                        Map.of(
                                "HOME",
                                home.toString(),
                                "GZ_FUEL_CACHE_PATH",
                                own.toString(),
                                "SDF_PATH",
                                folder.toString())))
                .usingElementComparator((a, b) -> a.normalize().compareTo(b.normalize()))
                .containsExactly(folder, own, folder.resolve("home/.gz/fuel"), old);
    }
}
