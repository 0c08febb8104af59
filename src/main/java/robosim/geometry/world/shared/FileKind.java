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
    private static final Pattern PLY = Pattern.compile("ply\\r?\n");
    private static final Pattern GLTF = Pattern.compile("\"(?:asset|accessors|bufferViews|extensionsUsed)\"\\s*:");
    private static final Pattern STAGE = Pattern.compile("(?m)^\\s*(?:define\\s+\\w+\\s+\\w+|include\\s+\"[^\"]+\""
            + "|(?:window|floorplan|model|position)\\s*(?:\\(|$)"
            + "|(?:interval_sim|interval_real|resolution|quit_time|speedup|paused|threads)\\s+[\\d.]+\\s*(?:#|$))");
    private static final Pattern VERTEX = Pattern.compile("(?m)^v\\s+[-+.\\d]");
    private static final Pattern RESOLUTION = Pattern.compile("(?m)^resolution\\s*:");

    /** What stands for a large file where only the repository was fetched. */
    private static final Pattern LFS = Pattern.compile("version https://git-lfs\\S*\\s+(?:ext-\\S+ \\S+\\s+)*oid ");

    /** What is wrong with such a file, and the remedy. */
    public static final String POINTER =
            "this is not the file but a pointer of Git LFS to it; fetch it: git lfs pull (got: a pointer)";

    /** The top-level keys of a world of IR-SIM, whose obstacles and robots are lists. */
    private static final Pattern IR_SIM = Pattern.compile("(?m)^(?:robot|obstacle)s?\\s*:\\s*(?:#.*)?$");

    private static final Pattern FLATLAND = Pattern.compile("(?m)^layers\\s*:");
    private static final Pattern FLATLAND_MAP = Pattern.compile("(?m)^[\\s{-]*map\\s*:\\s*[\"']?([^\"'\\s]+)");

    private static final String WEBOTS =
            "this is a file of Webots, which is not supported; export its robots as URDF and"
                    + " its shapes as OBJ, or write them as a world file, which ends in .xml";
    private static final String MJCF = "this is MJCF, of MuJoCo, which is not supported; convert it to SDFormat with"
            + " mjcf2sdformat of gz-mujoco, or export it as URDF";
    private static final String USD =
            "this is USD, which is not supported; export it as glTF, or convert it to SDFormat"
                    + " with usd2sdf of gz-usd";

    private FileKind() {}

    /** What to do with a file of another simulator or program, by the ending of its name; null if that says nothing. */
    public static @Nullable String byEnding(String ending) {
        return switch (ending) {
            case "usd", "usda", "usdc", "usdz" -> USD;
            case "wbt", "wbo", "proto" -> WEBOTS;
            case "mjcf" -> MJCF;
            default -> null;
        };
    }

    /** Whether a file is a pointer of Git LFS, which the repository has instead of the file itself. */
    public static boolean isPointer(Path file) {
        try (InputStream in = RegularFile.open(file)) {
            return LFS.matcher(new String(in.readNBytes(HEAD), StandardCharsets.ISO_8859_1))
                    .lookingAt();
        } catch (IOException e) {
            return false;
        }
    }

    /**
     * What a file really is and what to do with it, if it is not in the format it was read as; null if that is unknown,
     * or it is in that format.
     *
     * @param readAs the ending of the names that its reader expects: {@code xml}, {@code sdf}, {@code yaml}, {@code
     *     obj}, {@code stl}, {@code dae}, {@code stage}, {@code ply}, {@code glb} or {@code gltf}
     */
    public static @Nullable String other(Path file, String readAs) {
        byte[] head;
        try (InputStream in = RegularFile.open(file)) {
            head = in.readNBytes(HEAD);
        } catch (IOException e) {
            return null;
        }
        String bytes = new String(head, StandardCharsets.ISO_8859_1);
        if (LFS.matcher(bytes).lookingAt()) {
            return POINTER.substring(0, POINTER.lastIndexOf(" ("));
        }
        String binary = binary(bytes, readAs);
        return binary != null ? binary : text(bytes, readAs);
    }

    /** The name of the root of an XML document, by its first lines; null if there is none. */
    public static @Nullable String root(Path file) {
        try (InputStream in = RegularFile.open(file)) {
            String text = new String(in.readNBytes(16 * HEAD), StandardCharsets.ISO_8859_1);
            Matcher root = ROOT.matcher(text.replaceFirst("^\u00ef\u00bb\u00bf", ""));
            return root.lookingAt() ? root.group(1) : null;
        } catch (IOException e) {
            return null;
        }
    }

    /** Whether a file is a world of Stage, by its first lines; its name ends as that of SDFormat may. */
    public static boolean isStage(Path file) {
        try (InputStream in = RegularFile.open(file)) {
            String text = new String(in.readNBytes(16 * HEAD), StandardCharsets.UTF_8);
            return !ROOT.matcher(text).lookingAt() && STAGE.matcher(text).find();
        } catch (IOException e) {
            return false;
        }
    }

    private static @Nullable String binary(String bytes, String readAs) {
        if (bytes.startsWith("\u0089PNG") || bytes.startsWith("\u00ff\u00d8\u00ff") || bytes.startsWith("GIF8")) {
            return "this is an image; a ROS map is read from its .yaml file";
        }
        if (bytes.matches("(?s)P[1-6]\\s.*")) {
            return "this is an image (PNM); a ROS map is read from its .yaml file";
        }
        if (bytes.startsWith("PK\u0003\u0004") || bytes.startsWith("\u001f\u008b") || bytes.startsWith("BZh")) {
            return "this is an archive; unpack it first";
        }
        if (bytes.startsWith("glTF")) {
            return readAs.equals("glb") || readAs.equals("gltf")
                    ? null
                    : "this is glTF in its binary form; give it a name that ends in .glb";
        }
        if (bytes.startsWith("PXR-USDC")) {
            return USD;
        }
        if (bytes.startsWith("Kaydara FBX")) {
            return "this is FBX, which is not supported; export it as glTF, COLLADA, OBJ or STL";
        }
        if (bytes.startsWith("%PDF")) {
            return "this is a PDF, which contains no world";
        }
        if (bytes.startsWith("\u00ac\u00ed")) {
            return "this is a conversation in Java serialization; give its folder to replay or view";
        }
        return null;
    }

    private static @Nullable String text(String bytes, String readAs) {
        String text = bytes.replaceFirst("^\u00ef\u00bb\u00bf", "");
        Matcher root = ROOT.matcher(text);
        if (root.lookingAt()) {
            return xml(root.group(1), readAs);
        }
        if (text.startsWith("#usda")) {
            return USD;
        }
        if (text.startsWith("#VRML_SIM")) {
            return WEBOTS;
        }
        if (text.startsWith("#VRML")) {
            return "this is VRML, which is not supported; export it as glTF, COLLADA or OBJ";
        }
        if (readAs.equals("yaml")) {
            return yaml(text);
        }
        if (PLY.matcher(text).lookingAt()) {
            return readAs.equals("ply") ? null : "this is PLY; give it a name that ends in .ply";
        }
        if (text.stripLeading().startsWith("{")) {
            if (GLTF.matcher(text).find()) {
                return readAs.equals("gltf") || readAs.equals("glb")
                        ? null
                        : "this is glTF; give it a name that ends in .gltf";
            }
            return "this is JSON; recordings of this module end in .jsonl and are for replay, view, render and export";
        }
        if (STAGE.matcher(text).find()) {
            return readAs.equals("stage") ? null : "this is a world of Stage; give it a name that ends in .world";
        }
        if (!readAs.equals("stl") && text.toLowerCase(Locale.ROOT).startsWith("solid")) {
            return "this is STL; give it a name that ends in .stl";
        }
        if (!readAs.equals("obj") && VERTEX.matcher(text).find()) {
            return "this is Wavefront OBJ; give it a name that ends in .obj";
        }
        if (RESOLUTION.matcher(text).find()) {
            return "this is a ROS map; give it a name that ends in .yaml";
        }
        return null;
    }

    /** The world of another simulator, which is YAML as a ROS map is. */
    private static @Nullable String yaml(String text) {
        if (RESOLUTION.matcher(text).find()) {
            return null;
        }
        if (FLATLAND.matcher(text).find()) {
            Matcher map = FLATLAND_MAP.matcher(text);
            return "this is a world of Flatland, which is not supported; read the ROS map of one of its layers"
                    + (map.find() ? ", such as " + map.group(1) : "");
        }
        return IR_SIM.matcher(text).find()
                ? "this is a world of IR-SIM, which is not supported; write its shapes as a world file, which ends in .xml"
                : null;
    }

    private static @Nullable String xml(String root, String readAs) {
        return switch (root) {
            case "mujoco", "mujocoinclude" -> MJCF;
            case "mvsim_world" ->
                "this is a world of MVSim, which is not supported; read the ROS map that it names, or write its blocks as"
                        + " a world file with the root <world>";
            case "sdf" ->
                readAs.equals("sdf") || readAs.equals("urdf")
                        ? null
                        : "this is SDFormat; give it a name that ends in .sdf or .world";
            case "world" ->
                readAs.equals("xml") ? null : "this is a world of this module; give it a name that ends in .xml";
            case "robot" ->
                readAs.equals("urdf") || readAs.equals("sdf")
                        ? null
                        : "this is URDF; give it a name that ends in .urdf";
            case "COLLADA" -> readAs.equals("dae") ? null : "this is COLLADA; give it a name that ends in .dae";
            case "svg" -> "this is an image (SVG), which contains no world";
            case "html" -> "this is a web page: what was downloaded is not the file but the page around it";
            case "gazebo" -> readAs.equals("sdf") ? null : "this is SDFormat; give it a name that ends in .world";
            case "gazebo_world" -> "this is a Gazebo world older than SDFormat; convert it with Gazebo";
            default ->
                readAs.equals("xml") || readAs.equals("sdf") || readAs.equals("dae")
                        ? null
                        : "this is XML, with the root <" + root + ">";
        };
    }
}
