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
 * What the demo needs from the project, packed into the jar: two compiled programs of examples/ and a world. The
 * programs are in the unnamed package, so they cannot be among the module's own classes; this class runs one of them.
 */
public final class DemoProgram {
    private static final String PLACE = "/META-INF/demo/";

    private DemoProgram() {}

    /** Runs a program that the jar contains, named by the first argument, with the others. */
    public static void main(String[] arguments) throws ReflectiveOperationException, IOException {
        URL program = find(arguments[0]);
        if (program == null) {
            throw new IllegalArgumentException("the jar must contain the program (got: " + arguments[0] + ")");
        }
        try (URLClassLoader loader =
                new URLClassLoader(new URL[] {new URL(program, ".")}, DemoProgram.class.getClassLoader())) {
            String[] rest = Arrays.copyOfRange(arguments, 1, arguments.length);
            loader.loadClass(arguments[0]).getMethod("main", String[].class).invoke(null, (Object) rest);
        } catch (InvocationTargetException e) {
            throw new IllegalStateException(arguments[0] + " failed: " + e.getCause(), e.getCause());
        }
    }

    /** The location of a program's class; null if it is not there, as when not run from a jar. */
    static @Nullable URL find(String program) {
        return DemoProgram.class.getResource(PLACE + program + ".class");
    }

    /** Copies a world from the jar to a folder, unless a file of that name is there, and returns the file's path. */
    static Path world(String name, Path folder) throws IOException {
        try (InputStream in = DemoProgram.class.getResourceAsStream(PLACE + name)) {
            if (in == null) {
                throw new IllegalStateException(name + " is missing in " + Program.home() + PLACE);
            }
            Path copy = folder.resolve(name);
            if (!Files.exists(copy)) { // the user may have changed it
                Files.copy(in, copy);
            }
            return copy;
        }
    }
}
