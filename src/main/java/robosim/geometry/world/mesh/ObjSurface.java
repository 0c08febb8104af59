package robosim.geometry.world.mesh;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.CountedStream;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.Folder;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Numbers;
import robosim.geometry.world.shared.PlainBytes;
import robosim.geometry.world.shared.TextureFiles;

/** The surface of a Wavefront OBJ file while it is read: its vertices, and its faces with polygons cut. */
public final class ObjSurface {
    /** The statements of curved surfaces, whose shape would be lost. */
    private static final Set<String> CURVED = Set.of(
            "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp", "end",
            "con", "bsp", "bzp", "cdc", "cdp", "res");

    private final double scale;
    private final List<Point> vertices = new ArrayList<>();
    private final ObjFaces faces = new ObjFaces(vertices);
    private final List<String> libraries = new ArrayList<>();
    /** The object or group that is wanted; null for all. */
    private final @Nullable String part;

    private String object = "";
    private List<String> groups = List.of();
    private int line;
    private boolean ended;

    private ObjSurface(double scale, @Nullable String part) {
        this.scale = scale;
        this.part = part;
    }

    /** Reads a mesh from a stream, which is left open; without its materials, which are in other files. */
    public static MeshObject read(InputStream in, String source, double scale) throws FileProblem {
        return read(in, source, scale, null, null, null);
    }

    /**
     * Reads a mesh from a stream, which is left open.
     *
     * @param folder   where its material libraries are; one that does not exist is ignored
     * @param textures where pictures come from
     * @param part     the name of the object or group whose faces are read; null for all
     */
    static MeshObject read(
            InputStream in,
            String source,
            double scale,
            @Nullable Path folder,
            @Nullable TextureFiles textures,
            @Nullable String part)
            throws FileProblem {
        ObjSurface reader = new ObjSurface(scale, part);
        try {
            // Latin-1 accepts every byte; everything that is evaluated is ASCII.
            reader.readLines(new BufferedReader(
                    new InputStreamReader(PlainBytes.of(CountedStream.bounded(in)), StandardCharsets.ISO_8859_1)));
            return reader.faces.mesh(
                    folder == null || textures == null
                            ? null
                            : reader.library(folder, new MaterialLibrary(textures))::get);
        } catch (FileProblem e) {
            throw e;
        } catch (IOException e) {
            throw new FileProblem(source, reader.line, 0, "the file could not be read: " + e.getMessage(), e);
        } catch (IllegalArgumentException e) {
            throw new FileProblem(source, reader.line, 0, String.valueOf(e.getMessage()), e);
        }
    }

    private MaterialLibrary library(Path folder, MaterialLibrary library) throws IOException {
        for (String names : libraries) {
            // One name with spaces, or several names.
            List<String> single = List.of(names);
            List<String> all = exists(folder, names) ? single : List.of(Numbers.words(names));
            for (String name : all) {
                if (exists(folder, name)) {
                    library.add(Folder.locate(folder, name, "OBJ", "MTL"));
                }
            }
        }
        return library;
    }

    private static boolean exists(Path folder, String name) {
        try {
            return !name.isBlank() && Files.isRegularFile(folder.resolve(name));
        } catch (InvalidPathException e) {
            return false;
        }
    }

    private void readLines(Reader in) throws IOException {
        while (!ended) {
            StringBuilder text = new StringBuilder();
            int begin = line + 1; // errors name the line on which a statement begins
            readLine(in, text);
            while (text.length() > 0 && text.charAt(text.length() - 1) == '\\' && !ended) {
                text.setCharAt(text.length() - 1, ' ');
                readLine(in, text);
            }
            int end = line;
            line = begin;
            statement(text.toString().strip());
            line = end;
        }
        if (faces.size() == 0) {
            line = 0;
            throw new IllegalArgumentException(
                    part == null
                            ? "an OBJ file must have at least one face (got: none)"
                            : "there is no object or group of this name with a face (got: " + part + ")");
        }
    }

    /**
     * Appends one line without its comment and line end; long lines are refused, so a file without line ends is not
     * read into memory.
     */
    private void readLine(Reader in, StringBuilder text) throws IOException {
        line++;
        boolean comment = false;
        for (int c = in.read(); c != '\n'; c = in.read()) {
            if (c < 0) {
                ended = true;
                break;
            }
            comment |= c == '#';
            if (!comment && c != '\r') {
                text.append((char) c);
                if (text.length() > Limits.MAX_STATEMENT) {
                    throw new IllegalArgumentException("a statement must have at most " + Limits.MAX_STATEMENT
                            + " characters; end lines with a line feed, and split larger polygons (got: more)");
                }
            }
        }
    }

    private void statement(String text) {
        FileWork.take(1);
        if (text.isEmpty()) {
            return;
        }
        String[] words = Numbers.words(text);
        switch (words[0]) {
            case "v" -> vertex(words);
            case "vt" -> texturePoint(words);
            case "f" -> {
                if (part == null || object.equals(part) || groups.contains(part)) {
                    face(words);
                }
            }
            case "o" -> object = rest(text, 1);
            case "g" -> groups = List.of(words).subList(1, words.length);
            case "usemtl" -> faces.use(rest(text));
            case "mtllib" -> libraries.add(rest(text).replace('\\', '/')); // as Windows programs write it
            default -> {
                // What nobody knows changes no surface that v and f describe.
                if (CURVED.contains(words[0])) {
                    throw new IllegalArgumentException(
                            "a surface must be of polygons, f; export the curves and curved surfaces of the file as"
                                    + " polygons (got: " + words[0] + ")");
                }
            }
        }
    }

    /** What follows the first word, whose bytes are those of UTF-8. */
    private static String rest(String text) {
        return rest(text, 6);
    }

    private static String rest(String text, int from) {
        byte[] bytes = text.substring(from).strip().getBytes(StandardCharsets.ISO_8859_1);
        return new String(bytes, StandardCharsets.UTF_8);
    }

    /** u and v; v is 0 where it is left out. Some programs write what is no number. */
    private void texturePoint(String[] words) {
        faces.point(share(words, 1), words.length == 2 ? 0 : share(words, 2));
    }

    private static double share(String[] words, int at) {
        try {
            return words.length <= at ? Double.NaN : Checks.coordinate("vt", Numbers.parse(words[at]));
        } catch (IllegalArgumentException e) {
            return Double.NaN;
        }
    }

    private void vertex(String[] words) {
        if (words.length < 4) {
            throw new IllegalArgumentException("a vertex must have x y z (got: " + String.join(" ", words) + ")");
        }
        vertices.add(new Point(
                scale * Numbers.parse(words[1]), scale * Numbers.parse(words[2]), scale * Numbers.parse(words[3])));
    }

    private void face(String[] words) {
        int corners = words.length - 1;
        if (corners < 3 || corners > Limits.MAX_CORNERS) {
            throw new IllegalArgumentException(
                    "a face must have 3 to " + Limits.MAX_CORNERS + " corners; cut larger ones (got: " + corners + ")");
        }
        int[] face = new int[corners];
        int[] texture = new int[corners];
        for (int k = 0; k < corners; k++) {
            String word = words[k + 1];
            int slash = word.indexOf('/');
            int index = Numbers.integer(slash < 0 ? word : word.substring(0, slash));
            face[k] = index > 0 ? index - 1 : vertices.size() + index;
            if (index == 0 || face[k] < 0 || face[k] >= vertices.size()) {
                throw new IllegalArgumentException("a face must use vertices defined before it, from 1 to "
                        + vertices.size() + " or -1 to -" + vertices.size() + " (got: " + index + ")");
            }
            int second = word.indexOf('/', slash + 1);
            texture[k] = slash < 0 ? TextureCoordinates.NONE : texturePoint(word, slash + 1, second);
        }
        if (faces.size() + corners - 2 > Limits.MAX_FACES) {
            throw new IllegalArgumentException("a file must have at most " + Limits.MAX_FACES
                    + " faces, cut into triangles; simplify or split it (got: more)");
        }
        faces.add(face, texture);
    }

    /** The texture point of a corner; {@link TextureCoordinates#NONE} for one that there is not, which harms no shape. */
    private int texturePoint(String word, int from, int to) {
        try {
            int index = Integer.parseInt(word, from, to < 0 ? word.length() : to, 10);
            int point = index > 0 ? index - 1 : faces.points() + index;
            return index != 0 && faces.hasPoint(point) ? point : TextureCoordinates.NONE;
        } catch (NumberFormatException e) {
            return TextureCoordinates.NONE;
        }
    }
}
