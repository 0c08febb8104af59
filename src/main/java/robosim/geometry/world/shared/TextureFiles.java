package robosim.geometry.world.shared;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import robosim.geometry.image.PngReader;
import robosim.geometry.material.ImageTexture;

/**
 * Reads the pictures that the files of one world name: PNG images below given folders, each once, and no more pixels of all
 * together than one picture may have.
 */
public final class TextureFiles {
    /** Where a PNG has its width and height, after its signature and the first chunk's length and name. */
    private static final int SIZE_AT = 16;

    private final List<Path> roots;
    private final Map<Path, ImageTexture> known = new HashMap<>();
    private long pixels;

    /** For pictures in the trees of folders, beside the tree of the folder of the file that names one. */
    public TextureFiles(List<Path> roots) {
        this.roots = List.copyOf(roots);
    }

    /**
     * The picture of a name, which covers 1 x 1.
     *
     * @param folder that of the file that names it
     * @param name   a path with / relative to that folder
     * @throws IllegalArgumentException saying what is wrong with the name
     * @throws FileProblem if the picture cannot be read
     */
    public ImageTexture read(Path folder, String name) throws FileProblem {
        Path file = locate(folder, name);
        ImageTexture read = known.get(file);
        if (read == null) {
            read = read(file);
            known.put(file, read);
        }
        return read;
    }

    private Path locate(Path folder, String name) throws FileProblem {
        try {
            Path path = folder.resolve(name).normalize();
            if (name.isBlank() || name.indexOf('\\') >= 0 || Path.of(name).isAbsolute()) {
                throw new IllegalArgumentException(
                        "a picture must be a path with / relative to the file that names it (got: " + name + ")");
            }
            if (!Files.isRegularFile(path)) {
                throw new IllegalArgumentException(
                        "there is no such picture in " + folder + "; check the path, or remove it (got: " + name + ")");
            }
            Path real = path.toRealPath();
            boolean isWithin = real.startsWith(folder.toRealPath());
            for (Path root : roots) {
                isWithin |= real.startsWith(root.toRealPath());
            }
            if (!isWithin) {
                throw new IllegalArgumentException(
                        "a picture must be below the folder of the file that is read; move it" + " there (got: " + name
                                + ")");
            }
            return real;
        } catch (InvalidPathException e) {
            throw new IllegalArgumentException("a picture must be a path (got: " + name + ")", e);
        } catch (IOException e) {
            throw FileProblem.unreadable(folder.resolve(name), e);
        }
    }

    private ImageTexture read(Path file) throws FileProblem {
        try (InputStream in = RegularFile.open(file)) {
            byte[] bytes = new Bounded(in).readAllBytes();
            count(bytes);
            PngReader.Pixels image = PngReader.read(new ByteArrayInputStream(bytes));
            return new ImageTexture(image.width(), image.height(), image.pixels(), 1, 1);
        } catch (IOException e) {
            throw e instanceof FileProblem problem
                    ? problem
                    : new FileProblem(
                            file.toString(),
                            0,
                            0,
                            "the picture could not be read; save it as PNG (" + e.getMessage() + ")",
                            e);
        } catch (IllegalArgumentException e) {
            throw new FileProblem(file.toString(), 0, 0, String.valueOf(e.getMessage()), e);
        }
    }

    /** Counts the pixels that a picture claims, before any room is made for them. */
    private void count(byte[] bytes) {
        if (bytes.length < SIZE_AT + 8 || bytes[0] != (byte) 0x89 || bytes[1] != 'P') {
            return; // refused by its reader
        }
        ByteBuffer size = ByteBuffer.wrap(bytes, SIZE_AT, 8);
        pixels += ImageTexture.checkSize(Integer.toUnsignedLong(size.getInt()), Integer.toUnsignedLong(size.getInt()));
        if (pixels > ImageTexture.MOST_PIXELS) {
            throw new IllegalArgumentException("the pictures of a world must have at most " + ImageTexture.MOST_PIXELS
                    + " pixels together (got: " + pixels + ")");
        }
    }
}
