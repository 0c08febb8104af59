package robosim.geometry.world.shared;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.util.concurrent.ThreadLocalRandom;
import robosim.geometry.check.Checks;

/** Writes a file atomically: an existing file stays as it was until the new one is complete. */
public final class AtomicFileWriter {
    /** The content of a file. */
    @FunctionalInterface
    public interface Content {
        /** Writes all of it; the caller closes the stream. */
        void writeTo(OutputStream out) throws IOException;
    }

    private AtomicFileWriter() {}

    /**
     * Writes a file through a temporary file in the same folder, which is removed in any case. If the name is a link,
     * its target is written. Anything that is not a regular file, such as a device, is written directly.
     *
     * @throws IOException naming the file given
     */
    public static void write(Path file, Content content) throws IOException {
        Checks.present("file", file);
        Checks.present("content", content);
        Path target = Files.exists(file) ? file.toRealPath() : file.toAbsolutePath();
        if (Files.exists(target) && !Files.isRegularFile(target)) {
            try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(target))) {
                content.writeTo(out);
            }
            return;
        }
        // Not Files.createTempFile, which makes the file readable by the user only.
        Path half = target.resolveSibling("." + target.getFileName() + "."
                + Long.toHexString(ThreadLocalRandom.current().nextLong()) + ".tmp");
        OutputStream opened;
        try {
            opened = Files.newOutputStream(half, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
        } catch (FileSystemException e) {
            throw named(file, e);
        }
        try {
            try (OutputStream out = new BufferedOutputStream(opened)) {
                content.writeTo(out);
            }
            replace(half, target);
        } catch (FileSystemException e) {
            throw String.valueOf(e.getFile()).equals(half.toString()) ? named(file, e) : e;
        } finally {
            Files.deleteIfExists(half);
        }
    }

    private static void replace(Path half, Path target) throws IOException {
        if (Files.exists(target)) {
            PosixFileAttributeView earlier = Files.getFileAttributeView(target, PosixFileAttributeView.class);
            PosixFileAttributeView now = Files.getFileAttributeView(half, PosixFileAttributeView.class);
            if (earlier != null && now != null) {
                now.setPermissions(earlier.readAttributes().permissions());
            }
        }
        try {
            Files.move(half, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(half, target, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** The failure with the file name that the user gave. */
    private static FileSystemException named(Path file, FileSystemException failure) {
        FileSystemException named;
        if (failure instanceof NoSuchFileException) {
            named = new NoSuchFileException(file.toString(), null, "there is no such folder");
        } else if (failure instanceof AccessDeniedException) {
            named = new AccessDeniedException(file.toString());
        } else if (failure instanceof FileAlreadyExistsException) {
            named = new FileAlreadyExistsException(file.toString());
        } else {
            named = new FileSystemException(file.toString(), null, failure.getReason());
        }
        named.initCause(failure);
        return named;
    }
}
