package robosim.geometry.world.mesh;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.AsciiScanner;
import robosim.geometry.world.shared.CountedStream;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.PlainBytes;

/** The surface of an STL file while it is read: its triangles, with equal corners joined. */
public final class StlSurface {
    private static final int HEADER = 84;
    private static final int TRIANGLE = 50;
    private static final String MAGICS = "COLOR=";

    private final double scale;
    private final Map<Point, Integer> indices = new HashMap<>();
    private final List<Point> vertices = new ArrayList<>();
    private final List<int[]> faces = new ArrayList<>();

    /** The solid that is wanted; null for all. */
    private final @Nullable String part;

    private StlSurface(double scale, @Nullable String part) {
        this.scale = scale;
        this.part = part;
    }

    /** Reads a mesh from a stream, which is left open. */
    public static MeshObject read(InputStream in, String source, double scale) throws FileProblem {
        return read(in, source, scale, null);
    }

    /** @param part the name of the solids that are read, which only text has; null for all */
    static MeshObject read(InputStream in, String source, double scale, @Nullable String part) throws FileProblem {
        byte[] bytes;
        try {
            bytes = CountedStream.bounded(in).readAllBytes();
        } catch (IOException e) {
            throw new FileProblem(source, "the file could not be read: " + e.getMessage(), e);
        }
        StlSurface reader = new StlSurface(scale, part);
        boolean isBinary = isBinary(bytes);
        AsciiScanner words = new AsciiScanner(isBinary ? bytes : PlainBytes.of(bytes), source, -1);
        if (isBinary && part != null) {
            throw new FileProblem(
                    source, "a binary STL file has no parts with names; save this one as its own (got: " + part + ")");
        }
        if (isBinary) {
            reader.binary(bytes, source);
        } else if (words.next() && words.is("solid") && !isCut(bytes)) {
            reader.text(words);
        } else {
            throw new FileProblem(source, noStl(bytes));
        }
        try {
            if (reader.faces.isEmpty()) {
                throw new IllegalArgumentException(
                        part == null
                                ? "an STL file must have at least one triangle (got: none)"
                                : "there is no solid of this name with a triangle (got: " + part + ")");
            }
            return reader.mesh(isBinary ? colors(bytes) : List.of());
        } catch (IllegalArgumentException e) {
            throw new FileProblem(source, String.valueOf(e.getMessage()), e);
        }
    }

    /** Whether it has all its triangles, and perhaps other data after them, in which no triangle may be lost. */
    private static boolean isBinary(byte[] bytes) {
        long more = bytes.length < HEADER ? -1 : bytes.length - HEADER - TRIANGLE * triangles(bytes);
        return more == 0 || (more > 0 && more % TRIANGLE != 0 && triangles(bytes) > 0);
    }

    /** Whether it is binary without some of its triangles: text has no zeros, of which each number of triangles has some. */
    private static boolean isCut(byte[] bytes) {
        return bytes.length >= HEADER && bytes[HEADER - 1] == 0 && PlainBytes.of(bytes) == bytes;
    }

    // Unsigned; no text file is mistaken for a binary one, since four of its bytes give more triangles than a file can
    // have.
    private static long triangles(byte[] bytes) {
        return Integer.toUnsignedLong(
                ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).getInt(HEADER - 4));
    }

    private static String noStl(byte[] bytes) {
        String begin = "an STL file must begin with the word solid, or be binary with 84 + 50 bytes for each triangle";
        if (bytes.length < HEADER) {
            return begin + " (got: " + bytes.length + " bytes)";
        }
        long count = triangles(bytes);
        long need = HEADER + TRIANGLE * count;
        return begin
                + (bytes.length < need
                        ? "; if it is one, it is truncated (got: "
                        : "; if it is one, it has more triangles than it says, so save it again (got: ")
                + bytes.length + " bytes that would hold " + count + " triangles, which take " + need + ")";
    }

    private void binary(byte[] bytes, String source) throws FileProblem {
        ByteBuffer numbers = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        int count = (bytes.length - HEADER) / TRIANGLE;
        for (int k = 0; k < count; k++) {
            FileWork.take(1);
            int[] face = new int[3];
            for (int corner = 0; corner < 3; corner++) {
                int at = HEADER + TRIANGLE * k + 12 * (corner + 1); // after the normal
                try {
                    face[corner] = vertex(numbers.getFloat(at), numbers.getFloat(at + 4), numbers.getFloat(at + 8));
                } catch (IllegalArgumentException e) {
                    throw new FileProblem(
                            source, "corner " + (corner + 1) + " of triangle " + (k + 1) + ": " + e.getMessage(), e);
                }
            }
            faces.add(face);
        }
    }

    private MeshObject mesh(List<String> colors) throws FileProblem {
        if (colors.isEmpty()) {
            return new MeshObject(vertices, faces.toArray(int[][]::new));
        }
        JoinedFaces joined = new JoinedFaces();
        joined.add(
                new JoinedFaces.Part(vertices, faces, List.of(), new double[0], colors),
                AffineTransform.NONE,
                name -> name);
        return joined.mesh(name -> name.isEmpty() ? Material.DEFAULT : Material.of(Color.parse(name)));
    }

    /**
     * The colours of the triangles of a binary file, empty for a triangle without; no list if there are none. Two bytes of
     * a triangle have 5 bits for each component. In a file of Magics, whose header has {@code COLOR=} and the colour of all, red is
     * the lowest, and the highest bit marks a triangle of that colour; in any other red is the highest, and the highest bit
     * marks a triangle that has a colour.
     */
    private static List<String> colors(byte[] bytes) {
        ByteBuffer numbers = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        int at = new String(bytes, 0, HEADER - 4, StandardCharsets.ISO_8859_1).indexOf(MAGICS) + MAGICS.length();
        boolean isMagics = at >= MAGICS.length() && at + 3 <= HEADER - 4;
        String whole = isMagics ? hex(bytes[at], bytes[at + 1], bytes[at + 2]) : "";
        int count = (bytes.length - HEADER) / TRIANGLE;
        List<String> colors = new ArrayList<>(count);
        boolean hasOwn = false;
        for (int k = 0; k < count; k++) {
            int code = numbers.getShort(HEADER + TRIANGLE * (k + 1) - 2);
            boolean isOwn = isMagics == ((code & 0x8000) == 0);
            hasOwn |= isOwn && code != 0;
            int low = level(code);
            int high = level(code >> 10);
            colors.add(!isOwn ? whole : hex(isMagics ? low : high, level(code >> 5), isMagics ? high : low));
        }
        // All zeros are no colours, but what a program writes that knows of none.
        return hasOwn ? colors : isMagics ? Collections.nCopies(count, whole) : List.of();
    }

    /** Five bits as eight. */
    private static int level(int code) {
        return Math.round((code & 31) * 255f / 31);
    }

    private static String hex(int red, int green, int blue) {
        return String.format(Locale.ROOT, "#%02x%02x%02x", red & 0xff, green & 0xff, blue & 0xff);
    }

    private void text(AsciiScanner words) throws FileProblem {
        do {
            boolean isWanted = words.restOfLine().equals(part) || part == null; // the solid's name
            while (words.expect("facet or endsolid", "facet", "endsolid") == 0) {
                FileWork.take(1);
                facet(words, isWanted);
            }
            words.skipLine();
        } while (words.next() && words.expectCurrent("solid or the file's end", "solid"));
    }

    private void facet(AsciiScanner words, boolean isWanted) throws FileProblem {
        words.expect("normal", "normal");
        for (int k = 0; k < 3; k++) {
            words.any("a number of the normal"); // which may be nan if the triangle has none
        }
        words.expect("outer", "outer");
        words.expect("loop", "loop");
        int[] face = new int[3];
        for (int corner = 0; corner < 3; corner++) {
            words.expect("vertex", "vertex");
            double x = words.number("x of a vertex");
            double y = words.number("y of a vertex");
            double z = words.number("z of a vertex");
            try {
                face[corner] = isWanted ? vertex(x, y, z) : 0;
            } catch (IllegalArgumentException e) {
                throw words.wrong(String.valueOf(e.getMessage()));
            }
        }
        words.expect("endloop (a facet is a triangle)", "endloop");
        words.expect("endfacet", "endfacet");
        if (isWanted) {
            faces.add(face);
        }
    }

    private int vertex(double x, double y, double z) {
        Point point = new Point(scale * x, scale * y, scale * z);
        Integer known = indices.putIfAbsent(point, vertices.size());
        if (known != null) {
            return known;
        }
        vertices.add(point);
        return vertices.size() - 1;
    }
}
