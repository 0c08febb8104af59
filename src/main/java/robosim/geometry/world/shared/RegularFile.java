package robosim.geometry.world.shared;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** Opens regular files only: reading a pipe may block forever, and a device may never end. */
public final class RegularFile {
    /** Who is told of the files that this thread opens. A world is read by one thread, through many readers. */
    private static final ThreadLocal<@Nullable Consumer<Path>> LISTENER = new ThreadLocal<>();

    private RegularFile() {}

    /** A reader of files. */
    @FunctionalInterface
    public interface Reading<T, E extends Exception> {
        T read() throws E;
    }

    /** Reads something, and tells a listener of each file that is opened for it. */
    public static <T, E extends Exception> T told(Consumer<Path> listener, Reading<T, E> reading) throws E {
        Consumer<Path> before = LISTENER.get();
        LISTENER.set(listener);
        try {
            return reading.read();
        } finally {
            if (before == null) {
                LISTENER.remove();
            } else {
                LISTENER.set(before);
            }
        }
    }

    /** Opens a file after following all links. */
    public static InputStream open(Path file) throws IOException {
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new FileProblem(
                    file.toString(),
                    Files.isDirectory(file)
                            ? "the path must be that of a file; name one in this folder (got: a folder)"
                            : "the file must be a regular one; save the output of a pipe or device to one (got: a pipe,"
                                    + " a socket or a device)");
        }
        InputStream in = Files.newInputStream(file);
        Consumer<Path> listener = LISTENER.get();
        if (listener != null) {
            listener.accept(file);
        }
        return FileWork.watched(in);
    }

    /** All bytes of a file, whose size is checked before there is room for them. */
    public static byte[] bytes(Path file, long most) throws FileProblem {
        try (InputStream in = open(file)) {
            long size = Files.size(file);
            if (size > most) {
                throw new FileProblem(
                        file.toString(),
                        "the file must have at most " + most
                                + " bytes; split it in several files, or simplify what is in it (got: more)");
            }
            byte[] bytes = new byte[(int) size];
            int read = in.readNBytes(bytes, 0, bytes.length);
            return read == bytes.length ? bytes : Arrays.copyOf(bytes, read);
        } catch (IOException e) {
            throw FileProblem.unreadable(file, e);
        }
    }
}
