package robosim.geometry.cli.demo;

import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.InvocationTargetException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * What the demo needs of the project, inside of a jar: two programs of examples/, compiled, and a world. The programs have
 * no package, so that they cannot stand among the module's own; this class runs one of them.
 */
public final class DemoProgram {
    private static final String PLACE = "/META-INF/demo/";

    private DemoProgram() {}

    /**
     * Runs a program of the jar.
     *
     * @param arguments its name, and what it takes
     */
    public static void main(String[] arguments) throws ReflectiveOperationException, IOException {
        URL program = find(arguments[0]);
        if (program == null) {
            throw new IllegalArgumentException("the jar must hold the program (got: " + arguments[0] + ")");
        }
        try (URLClassLoader loader =
                new URLClassLoader(new URL[] {new URL(program, ".")}, DemoProgram.class.getClassLoader())) {
            String[] rest = Arrays.copyOfRange(arguments, 1, arguments.length);
            loader.loadClass(arguments[0]).getMethod("main", String[].class).invoke(null, (Object) rest);
        } catch (InvocationTargetException e) {
            throw new IllegalStateException(arguments[0] + " failed: " + e.getCause(), e.getCause());
        }
    }

    /** Where a program's class is, or null where there is none here, as where there is no jar. */
    static @Nullable URL find(String program) {
        return DemoProgram.class.getResource(PLACE + program + ".class");
    }

    /** Copies a world of the jar into a folder that has none of that name, and answers where it is. */
    static Path world(String name, Path folder) throws IOException {
        try (InputStream in = DemoProgram.class.getResourceAsStream(PLACE + name)) {
            if (in == null) {
                throw new IllegalStateException(name + " is missing in " + Program.home() + PLACE);
            }
            Path copy = folder.resolve(name);
            if (!Files.exists(copy)) { // its user may have changed it
                Files.copy(in, copy);
            }
            return copy;
        }
    }
}
