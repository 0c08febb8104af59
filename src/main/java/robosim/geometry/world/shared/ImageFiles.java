package robosim.geometry.world.shared;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import robosim.geometry.image.PixelSink;
import robosim.geometry.image.PngReader;

/** Reads the samples of images that stand for numbers: PNG and PGM, and what the JDK reads, told apart by their first bytes. */
public final class ImageFiles {
    private ImageFiles() {}

    /** Reads an image, whose size in bytes is checked first. */
    public static void read(Path file, PixelSink sink) throws FileProblem {
        read(RegularFile.bytes(file, Limits.MAX_IMAGE_BYTES), file.toString(), sink);
    }

    private static boolean isPng(byte[] bytes) {
        return bytes.length >= 4 && bytes[0] == (byte) 0x89 && bytes[1] == 'P' && bytes[2] == 'N' && bytes[3] == 'G';
    }

    /**
     * Reads the bytes of an image.
     *
     * @param source the name of the image in messages
     */
    public static void read(byte[] bytes, String source, PixelSink target) throws FileProblem {
        PixelSink sink = FileWork.watched(target);
        String other = JdkImageReader.format(bytes);
        String kind = isPng(bytes) ? "PNG" : other == null ? "PGM" : other;
        try {
            if (kind.equals("PNG")) {
                PngReader.read(new ByteArrayInputStream(bytes), sink);
            } else if (other != null) {
                JdkImageReader.read(new ByteArrayInputStream(bytes), other, sink, JdkImageReader::check);
            } else {
                PgmReader.read(bytes, source, sink);
            }
        } catch (FileProblem e) {
            throw e;
        } catch (NoClassDefFoundError e) {
            throw new FileProblem(
                    source,
                    "the " + kind + " image needs the module java.desktop, which this Java does not have; save it as"
                            + " PNG or PGM (missing: " + e.getMessage() + ")",
                    e);
        } catch (IOException | IllegalArgumentException e) {
            throw new FileProblem(source, "the " + kind + " image could not be read: " + e.getMessage(), e);
        }
    }
}
