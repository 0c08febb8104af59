package robosim.geometry.world.shared;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.image.PngReader;
import robosim.geometry.image.RgbPixels;
import robosim.geometry.material.ImageTexture;

/**
 * Reads the pictures that the files of one world name: PNG and JPEG images below given folders, each once, and no more
 * pixels of all together than one picture may have.
 */
public final class TextureFiles {
    /** Where a PNG has its width and height, after its signature and the first chunk's length and name. */
    private static final int SIZE_AT = 16;

    private static final int START = SIZE_AT + 8;

    private static final String MODEL = "model://";

    private final List<Path> roots;
    private final @Nullable List<LeftOut> leftOut;
    private final Map<Path, ImageTexture> known = new HashMap<>();
    private long pixels;

    /** For pictures in the trees of folders, beside the tree of the folder of the file that names one. */
    public TextureFiles(List<Path> roots) {
        this(roots, null);
    }

    /**
     * For pictures in the trees of folders.
     *
     * @param leftOut receives the pictures of meshes that cannot be read; null to refuse such a mesh
     */
    public TextureFiles(List<Path> roots, @Nullable List<LeftOut> leftOut) {
        this.roots = List.copyOf(roots);
        this.leftOut = leftOut;
    }

    /** Leaves out what a file says in a line, or refuses the file. */
    public void leaveOut(Path file, int line, String what, String reason, Exception cause) throws FileProblem {
        if (leftOut == null) {
            throw new FileProblem(file.toString(), line, 0, what + ": " + reason, cause);
        }
        leftOut.add(new LeftOut(file.toString(), line, what, reason));
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
            Path path = candidates(folder, name).stream()
                    .filter(Files::isRegularFile)
                    .findFirst()
                    .orElse(folder.resolve(name));
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

    /** Where Gazebo looks: beside the mesh, among the textures of its model, and for {@code model://} in each folder. */
    private List<Path> candidates(Path folder, String name) {
        List<Path> candidates = new ArrayList<>();
        if (name.startsWith(MODEL)) {
            for (Path root : roots) {
                candidates.add(root.resolve(name.substring(MODEL.length())).normalize());
            }
        } else {
            candidates.add(folder.resolve(name).normalize());
            candidates.add(folder.resolve("../materials/textures").resolve(name).normalize());
        }
        return candidates;
    }

    /**
     * A picture within another file, which covers 1 x 1.
     *
     * @param file  the other file
     * @param name  that of the picture in it
     * @param bytes those of a PNG or a JPEG
     */
    public ImageTexture read(Path file, String name, byte[] bytes) throws FileProblem {
        Path key = file.resolveSibling(file.getFileName() + "#" + name);
        ImageTexture read = known.get(key);
        if (read == null) {
            read = read(key, () -> new ByteArrayInputStream(bytes));
            known.put(key, read);
        }
        return read;
    }

    private ImageTexture read(Path file) throws FileProblem {
        return read(file, () -> new BufferedInputStream(CountedStream.bounded(RegularFile.open(file))));
    }

    /** Opens a picture. */
    @FunctionalInterface
    private interface Opening {
        InputStream open() throws IOException;
    }

    private ImageTexture read(Path file, Opening opening) throws FileProblem {
        try (InputStream in = opening.open()) {
            in.mark(START);
            byte[] start = in.readNBytes(START);
            in.reset();
            if ("JPEG".equals(JdkImageReader.format(start))) {
                RgbPixels pictured = new RgbPixels();
                JdkImageReader.read(in, "JPEG", pictured, (width, height) -> count(file, width, height));
                return texture(pictured.taken());
            }
            if (start.length == START && start[0] == (byte) 0x89 && start[1] == 'P') {
                ByteBuffer size = ByteBuffer.wrap(start, SIZE_AT, 8);
                count(file, Integer.toUnsignedLong(size.getInt()), Integer.toUnsignedLong(size.getInt()));
            }
            return texture(PngReader.read(in));
        } catch (FileProblem e) {
            throw e;
        } catch (FileWork.Ended e) {
            throw e;
        } catch (IOException | RuntimeException e) { // a broken JPEG throws either
            throw new FileProblem(
                    file.toString(), "the picture could not be read; save it as PNG (" + e.getMessage() + ")", e);
        } catch (NoClassDefFoundError e) {
            throw new FileProblem(
                    file.toString(),
                    "a JPEG needs the module java.desktop; save it as PNG (missing: " + e.getMessage() + ")",
                    e);
        }
    }

    private static ImageTexture texture(PngReader.Pixels image) {
        return new ImageTexture(image.width(), image.height(), image.pixels(), 1, 1);
    }

    /** Counts the pixels that a picture claims, before any room is made for them. */
    private void count(Path file, long width, long height) throws FileProblem {
        try {
            count(width, height);
        } catch (IllegalArgumentException e) {
            throw new FileProblem(file.toString(), String.valueOf(e.getMessage()), e);
        }
    }

    private void count(long width, long height) {
        pixels += ImageTexture.checkSize(width, height);
        if (pixels > ImageTexture.MOST_PIXELS) {
            throw new IllegalArgumentException("the pictures of a world must have at most " + ImageTexture.MOST_PIXELS
                    + " pixels together; make them smaller (got: " + pixels + ")");
        }
    }
}
