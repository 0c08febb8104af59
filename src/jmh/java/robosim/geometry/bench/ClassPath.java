package robosim.geometry.bench;

import java.io.File;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Where classes lie, for a JVM to be started: this one's own class path is Maven's where Maven runs a program. */
public final class ClassPath {
    private ClassPath() {}

    /** The folders and jars of some classes, each once. */
    public static String of(Class<?>... types) {
        return Stream.of(types).map(ClassPath::place).distinct().collect(Collectors.joining(File.pathSeparator));
    }

    private static String place(Class<?> type) {
        try {
            return Path.of(type.getProtectionDomain()
                            .getCodeSource()
                            .getLocation()
                            .toURI())
                    .toString();
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }
}
