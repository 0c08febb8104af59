package robosim.geometry.world.mesh;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Base64;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import robosim.geometry.world.shared.CountedStream;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Folder;
import robosim.geometry.world.shared.JsonText;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.RegularFile;

/** A glTF 2.0 file (ISO/IEC 12113), in JSON or binary: its objects, and the bytes of its buffers. */
final class GltfFile {
    private static final int MAGIC = 0x46546c67;
    private static final int JSON = 0x4e4f534a;
    private static final int BINARY = 0x004e4942;
    private static final Pattern DATA = Pattern.compile("data:[^,]{0,200};base64,");

    final GltfPart root;
    private final String source;
    private final Path folder;
    private final Map<Integer, ByteBuffer> buffers = new HashMap<>();

    /** The bytes of the binary form's own buffer. */
    private @Nullable ByteBuffer binary;

    private long read;

    /** @param folder that of the files of buffers */
    GltfFile(InputStream in, String source, Path folder) throws FileProblem {
        this.source = source;
        this.folder = folder;
        byte[] bytes;
        try {
            bytes = CountedStream.bounded(in).readAllBytes();
        } catch (IOException e) {
            throw new FileProblem(source, "the file could not be read: " + e.getMessage(), e);
        }
        read = bytes.length;
        ByteBuffer file = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        boolean isBinary = bytes.length >= 12 && file.getInt(0) == MAGIC;
        String text = isBinary ? chunks(file) : new String(bytes, StandardCharsets.UTF_8);
        root = GltfPart.root(source, JsonText.parse(text, source));
        GltfPart asset = root.child("asset");
        String version = asset == null ? "" : asset.text("version");
        if (!version.startsWith("2.")) {
            throw new FileProblem(
                    source,
                    "glTF must be of version 2.0; save it as that (got: asset.version "
                            + (version.isEmpty() ? "none" : version) + ")");
        }
    }

    /** Takes the chunks of the binary form; answers the text of the first. */
    private String chunks(ByteBuffer file) throws FileProblem {
        if (file.getInt(4) != 2) {
            throw wrong("binary glTF must be of version 2; save it as that (got: " + file.getInt(4) + ")");
        }
        String text = null;
        int at = 12;
        while (at + 8 <= file.limit() && (text == null || binary == null)) {
            int length = file.getInt(at);
            int kind = file.getInt(at + 4);
            if (length < 0 || length > file.limit() - at - 8) {
                throw wrong("a chunk of binary glTF must end before the file does; it is truncated, so fetch or save it"
                        + " again (got: " + Integer.toUnsignedString(length) + " bytes of "
                        + (file.limit() - at - 8) + ")");
            }
            if (kind == JSON && text == null) {
                text = new String(file.array(), file.arrayOffset() + at + 8, length, StandardCharsets.UTF_8);
            } else if (kind == BINARY && text != null) {
                binary = file.slice(at + 8, length).order(ByteOrder.LITTLE_ENDIAN);
            }
            at += 8 + length;
        }
        if (text == null) {
            throw wrong("binary glTF must have a chunk of JSON (got: none)");
        }
        return text;
    }

    /** How many bytes were read so far: of this file, and of those of its buffers. */
    long bytes() {
        return read;
    }

    /** The bytes of a view of a buffer. */
    ByteBuffer view(int index) throws FileProblem {
        GltfPart view = root.item("bufferViews", index);
        int number = view.whole("buffer");
        ByteBuffer known = buffers.get(number);
        if (known == null) {
            known = buffer(view, number);
            buffers.put(number, known);
        }
        int offset = view.whole("byteOffset", 0);
        int length = view.whole("byteLength");
        if (length > known.limit() - (long) offset) {
            throw view.wrong("a view must end before its buffer does (got: " + length + " bytes from " + offset + " of "
                    + known.limit() + ")");
        }
        return known.slice(offset, length).order(ByteOrder.LITTLE_ENDIAN);
    }

    private ByteBuffer buffer(GltfPart view, int index) throws FileProblem {
        GltfPart extensions = view.child("extensions");
        GltfPart buffer = root.item("buffers", index);
        String uri = buffer.text("uri");
        if (uri.isEmpty() && (index != 0 || binary == null)) {
            throw extensions == null
                    ? buffer.wrong("a buffer must have a uri, or be the first one of a .glb file (got: none)")
                    : view.wrong("its bytes are compressed, which is not supported; save the file without compression"
                            + " (got: " + String.join(", ", extensions.names()) + ")");
        }
        ByteBuffer bytes = uri.isEmpty() && binary != null ? binary : ByteBuffer.wrap(bytes(buffer, uri));
        int length = buffer.whole("byteLength");
        if (length > bytes.limit()) {
            throw buffer.wrong("a buffer must have the bytes that it says; it is truncated, so fetch or save it again"
                    + " (got: " + bytes.limit() + " of " + length + ")");
        }
        return bytes;
    }

    /** The bytes of a picture within the file or in data of base64; null if it is in a file of its own. */
    byte @Nullable [] picture(GltfPart image) throws FileProblem {
        String uri = image.text("uri");
        if (image.has("bufferView")) {
            ByteBuffer view = view(image.whole("bufferView"));
            byte[] bytes = new byte[view.remaining()];
            view.get(bytes);
            return bytes;
        }
        return DATA.matcher(uri).lookingAt() ? bytes(image, uri) : null;
    }

    private byte[] bytes(GltfPart buffer, String uri) throws FileProblem {
        Matcher data = DATA.matcher(uri);
        if (data.lookingAt()) {
            try {
                return Base64.getDecoder().decode(uri.substring(data.end()));
            } catch (IllegalArgumentException e) {
                throw buffer.wrong("uri must be data in base64 (got: " + e.getMessage() + ")");
            }
        }
        try {
            return file(buffer, uri);
        } catch (IllegalArgumentException e) {
            throw buffer.wrong("uri: " + e.getMessage());
        } catch (FileProblem e) {
            throw e;
        } catch (IOException e) {
            throw buffer.wrong("the buffer could not be read: " + e);
        }
    }

    private byte[] file(GltfPart buffer, String uri) throws IOException {
        int colon = uri.indexOf(':');
        if (uri.toLowerCase(Locale.ROOT).startsWith("data:") || (colon > 0 && uri.startsWith("//", colon + 1))) {
            throw buffer.wrong("a buffer must be data in base64, or a file below the folder of this one (got: "
                    + uri.substring(0, Math.min(60, uri.length())) + ")");
        }
        Path file = Folder.locate(folder, Folder.decoded(uri), "glTF", "buffer");
        try (InputStream in = CountedStream.bounded(RegularFile.open(file))) {
            byte[] bytes = in.readAllBytes();
            read += bytes.length;
            if (read > Limits.MAX_INCLUDED_BYTES) {
                throw buffer.wrong("all files of a glTF file must have at most " + Limits.MAX_INCLUDED_BYTES
                        + " bytes together; simplify some, or leave some out (got: more)");
            }
            return bytes;
        }
    }

    private FileProblem wrong(String problem) {
        return new FileProblem(source, problem);
    }
}
