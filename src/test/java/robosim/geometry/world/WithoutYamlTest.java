package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** The module's classes by themselves, as on the class path of somebody who embeds the jar and nothing else. */
class WithoutYamlTest {
    private static final Path MAP = Path.of("src/test/resources/robosim/geometry/world/maps/TenByTen.yaml");

    private static URLClassLoader alone() throws IOException {
        URL classes = WorldReader.class.getProtectionDomain().getCodeSource().getLocation();
        return new URLClassLoader(new URL[] {classes}, ClassLoader.getPlatformClassLoader());
    }

    @Test
    void aMapNamesTheLibraryThatItNeeds() throws Exception {
        try (URLClassLoader loader = alone()) {
            Method read = loader.loadClass(WorldReader.class.getName()).getMethod("read", Path.class);
            assertThat(read.getDeclaringClass()).isNotEqualTo(WorldReader.class);
            assertThatThrownBy(() -> loader.loadClass("org.snakeyaml.engine.v2.nodes.Node"))
                    .isInstanceOf(ClassNotFoundException.class);
            assertThatThrownBy(() -> read.invoke(null, MAP))
                    .isInstanceOf(InvocationTargetException.class)
                    .cause()
                    .isInstanceOf(IOException.class)
                    .hasMessageStartingWith(MAP + ": ROS maps need snakeyaml-engine, which is not on the class path:"
                            + " add org.snakeyaml:snakeyaml-engine:3.0.1 or newer (missing: org/snakeyaml/");
        }
    }

    @Test
    void aWorldNeedsNothing() throws Exception {
        try (URLClassLoader loader = alone()) {
            Method read = loader.loadClass(WorldReader.class.getName()).getMethod("read", Path.class);
            Path file = Path.of("worlds/cylinders.xml");
            assertThat(read.invoke(null, file))
                    .hasToString(WorldReader.read(file).toString());
        }
    }
}
