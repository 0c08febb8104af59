package robosim.geometry.junit;

import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.extension.ExtensionConfigurationException;
import org.junit.platform.commons.support.ReflectionSupport;
import robosim.geometry.Geometry;
import robosim.geometry.world.WorldException;
import robosim.geometry.world.WorldReader;

/** Creates the world that an annotation names. */
final class WorldFile {
    private WorldFile() {}

    static robosim.geometry.world.World read(String name, Class<?> test) {
        Path file = Path.of(name);
        try {
            if (Files.exists(file)) {
                return read(file);
            }
            URL resource = resource(name, test);
            if (resource == null) {
                throw new ExtensionConfigurationException(
                        "@World must name a file, from " + Path.of("").toAbsolutePath()
                                + ", or a resource of the class path, from its root or beside " + test.getName()
                                + " (got: " + name
                                + ")");
            }
            if (resource.getProtocol().equals("file")) { // so that its meshes are found relative to it
                return read(Path.of(resource.toURI()));
            }
            try (InputStream in = resource.openStream()) {
                return WorldReader.read(in, name, null);
            }
        } catch (IOException | URISyntaxException | IllegalArgumentException e) {
            throw new ExtensionConfigurationException("the world of @World cannot be had: " + e.getMessage(), root(e));
        }
    }

    private static robosim.geometry.world.World read(Path file) throws WorldException {
        try {
            return WorldReader.read(file);
        } catch (WorldException first) {
            List<WorldException> problems = WorldReader.problems(file);
            if (problems.size() < 2) {
                throw first;
            }
            String all = problems.stream().map(Throwable::getMessage).collect(Collectors.joining("\n"));
            throw new IllegalArgumentException(all, first);
        }
    }

    /** Where it began: what lies between has the same message, which a report would repeat each time. */
    private static Throwable root(Throwable failure) {
        Throwable root = failure;
        while (root.getCause() != null) {
            root = root.getCause();
        }
        return root;
    }

    private static @Nullable URL resource(String name, Class<?> test) {
        URL beside = test.getResource(name);
        return beside != null ? beside : test.getResource("/" + name);
    }

    static Geometry build(String method, Class<?> test) {
        Method found = ReflectionSupport.findMethod(test, method)
                .filter(each -> Modifier.isStatic(each.getModifiers()) && each.getReturnType() == Geometry.class)
                .orElseThrow(() -> new ExtensionConfigurationException("@World(method) must name a static method of "
                        + test.getName() + " without parameters that returns a Geometry (got: " + method + ")"));
        if (ReflectionSupport.invokeMethod(found, null) instanceof Geometry geometry) {
            return geometry;
        }
        throw new ExtensionConfigurationException("the method of @World must return a world (got: null)");
    }
}
