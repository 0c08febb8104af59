package robosim.geometry.world.shared;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AtomicFileWriterTest {
    @TempDir
    Path folder;

    private static void write(Path file, String text) throws IOException {
        AtomicFileWriter.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.sorted().toList();
        }
    }

    @Test
    void writesTheFileAndTouchesNoOther() throws IOException {
        Path users = Files.writeString(folder.resolve("a.xml.new"), "mine");
        Path file = folder.resolve("a.xml");
        write(file, "one");
        write(file, "two");
        assertThat(file).hasContent("two");
        assertThat(users).hasContent("mine");
        assertThat(files()).containsExactly(file, users);
    }

    @Test
    void leavesNothingAfterAFailure() throws IOException {
        Path file = Files.writeString(folder.resolve("a.xml"), "old");
        assertThatThrownBy(() -> AtomicFileWriter.write(file, out -> {
                    out.write(new byte[100_000]);
                    throw new IOException("full");
                }))
                .hasMessage("full");
        assertThatThrownBy(() -> AtomicFileWriter.write(file, out -> {
                    throw new IllegalStateException("stopped");
                }))
                .hasMessage("stopped");
        assertThat(file).hasContent("old");
        assertThat(files()).containsExactly(file);
    }

    @Test
    void messagesNameTheFileThatWasAskedFor() throws IOException {
        Path nowhere = folder.resolve("no/a.xml");
        assertThatThrownBy(() -> write(nowhere, "x"))
                .isInstanceOf(NoSuchFileException.class)
                .hasMessageStartingWith(nowhere + ":");
        // A folder that is not empty cannot be replaced, and is no file to write into.
        Path full = Files.createDirectories(folder.resolve("full.xml/in")).getParent();
        assertThatThrownBy(() -> write(full, "x"))
                .isInstanceOf(IOException.class)
                .hasMessageContaining(full.toString())
                .hasMessageNotContaining(".tmp");
    }

    @Test
    void aLinkStaysALinkAndPermissionsStay() throws IOException {
        assumeThat(FileSystems.getDefault().supportedFileAttributeViews()).contains("posix");
        Path file = Files.writeString(folder.resolve("a.xml"), "old");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-rw-r--"));
        Path link = Files.createSymbolicLink(folder.resolve("link.xml"), file);
        write(link, "new");
        assertThat(link).isSymbolicLink();
        assertThat(file).hasContent("new");
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
                .isEqualTo("rw-rw-r--");
        // A new file is as readable as any other.
        Path fresh = folder.resolve("fresh.xml");
        write(fresh, "x");
        Path plain = Files.writeString(folder.resolve("plain.xml"), "x");
        assertThat(Files.getPosixFilePermissions(fresh)).isEqualTo(Files.getPosixFilePermissions(plain));
    }
}
