package robosim.geometry.scenario;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** The module's classes by themselves, as on the class path of somebody who embeds the jar and nothing else. */
class WithoutJacksonTest {
    private static final Path FILE = Path.of("worlds", "scenarios", "quarter-turns.scenario.jsonl");

    @Test
    void aScenarioNamesTheLibraryThatItNeeds() throws Exception {
        URL classes = ScenarioReader.class.getProtectionDomain().getCodeSource().getLocation();
        try (URLClassLoader loader = new URLClassLoader(new URL[] {classes}, ClassLoader.getPlatformClassLoader())) {
            assertThatThrownBy(() -> loader.loadClass("com.fasterxml.jackson.core.JsonFactory"))
                    .isInstanceOf(ClassNotFoundException.class);
            Method open = loader.loadClass(ScenarioReader.class.getName()).getMethod("open", Path.class);
            Method read = loader.loadClass(Scenario.class.getName()).getMethod("read", Path.class);
            // The second time another error tells that a class could not be initialized.
            for (Method method : new Method[] {open, read, open}) {
                assertThatThrownBy(() -> method.invoke(null, FILE))
                        .isInstanceOf(InvocationTargetException.class)
                        .cause()
                        .isInstanceOf(IOException.class)
                        .hasMessageStartingWith(FILE + ":1: scenarios need Jackson: put"
                                + " com.fasterxml.jackson.core:jackson-core on the class path, or on the module path with"
                                + " --add-modules com.fasterxml.jackson.core (missing: ");
            }
        }
    }
}
