package robosim.geometry.world.shared;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** Recognizes the format of a file by its first bytes, to explain files whose name suggests another format. */
public final class FileKind {
    private static final int HEAD = 1000;

    private static final Pattern ROOT =
            Pattern.compile("^(?:\\s|<\\?.*?\\?>|<!--.*?-->|<!DOCTYPE[^>]*>)*<([A-Za-z][\\w.:-]*)", Pattern.DOTALL);
    private static final Pattern VERTEX = Pattern.compile("(?m)^v\\s+[-+.\\d]");
    private static final Pattern RESOLUTION = Pattern.compile("(?m)^resolution\\s*:");

    private FileKind() {}

    /**
     * What a file really is and what to do with it, if it is not in the format it was read as; null if that is unknown,
     * or it is in that format.
     *
     * @param readAs the ending that its reader is for: {@code xml}, {@code sdf}, {@code yaml}, {@code obj} or {@code stl}
     */
    public static @Nullable String other(Path file, String readAs) {
        byte[] head;
        try (InputStream in = RegularFile.open(file)) {
            head = in.readNBytes(HEAD);
        } catch (IOException e) {
            return null;
        }
        String bytes = new String(head, StandardCharsets.ISO_8859_1);
        String binary = binary(bytes);
        return binary != null ? binary : text(bytes, readAs);
    }

    private static @Nullable String binary(String bytes) {
        if (bytes.startsWith("\u0089PNG") || bytes.startsWith("\u00ff\u00d8\u00ff") || bytes.startsWith("GIF8")) {
            return "this is a picture; a map of ROS is read from its .yaml";
        }
        if (bytes.matches("(?s)P[1-6]\\s.*")) {
            return "this is a picture (PNM); a map of ROS is read from its .yaml";
        }
        if (bytes.startsWith("PK\u0003\u0004") || bytes.startsWith("\u001f\u008b") || bytes.startsWith("BZh")) {
            return "this is an archive; unpack it first";
        }
        if (bytes.startsWith("glTF")) {
            return "this is glTF, which is not read; export it as OBJ or STL";
        }
        if (bytes.startsWith("Kaydara FBX")) {
            return "this is FBX, which is not read; export it as OBJ or STL";
        }
        if (bytes.startsWith("%PDF")) {
            return "this is a PDF, and holds no world";
        }
        if (bytes.startsWith("\u00ac\u00ed")) {
            return "this is a conversation in Java serialization; replay and view take the folder that it is in";
        }
        return null;
    }

    private static @Nullable String text(String bytes, String readAs) {
        String text = bytes.replaceFirst("^\u00ef\u00bb\u00bf", "");
        Matcher root = ROOT.matcher(text);
        if (root.lookingAt()) {
            return xml(root.group(1), readAs);
        }
        if (text.startsWith("ply")) {
            return "this is PLY, which is not read; export it as OBJ or STL";
        }
        if (text.stripLeading().startsWith("{")) {
            return "this is JSON; a recording of the module ends in .scenario.jsonl, and replay and view take it";
        }
        if (!readAs.equals("stl") && text.toLowerCase(Locale.ROOT).startsWith("solid")) {
            return "this is STL; give it a name that ends in .stl";
        }
        if (!readAs.equals("obj") && VERTEX.matcher(text).find()) {
            return "this is Wavefront OBJ; give it a name that ends in .obj";
        }
        if (!readAs.equals("yaml") && RESOLUTION.matcher(text).find()) {
            return "this is a map of ROS; give it a name that ends in .yaml";
        }
        return null;
    }

    private static @Nullable String xml(String root, String readAs) {
        return switch (root) {
            case "sdf" -> readAs.equals("sdf") ? null : "this is SDFormat; give it a name that ends in .sdf or .world";
            case "world" ->
                readAs.equals("xml") ? null : "this is a world of the module; give it a name that ends in .xml";
            case "robot" -> "this is URDF, which is not read; export it as SDFormat (gz sdf -p does)";
            case "COLLADA" -> "this is COLLADA, which is not read; export it as OBJ or STL";
            case "svg" -> "this is a picture (SVG), and holds no world";
            case "html" -> "this is a page of the web: what was fetched is no file but the page around it";
            case "gazebo", "gazebo_world" -> "this is a world of a Gazebo older than SDFormat 1.4; convert it there";
            default ->
                readAs.equals("xml") || readAs.equals("sdf") ? null : "this is XML, with the root <" + root + ">";
        };
    }
}
