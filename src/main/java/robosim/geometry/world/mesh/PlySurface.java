package robosim.geometry.world.mesh;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.CountedStream;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Numbers;
import robosim.geometry.world.shared.PlainBytes;

/**
 * The surface of a PLY file (G. Turk, The PLY polygon file format, 1994): its faces of any number of corners and its strips
 * of triangles. A face has the mean colour of its vertices. Equal vertices are joined, and other properties and elements are
 * skipped.
 */
public final class PlySurface {
    private static final Set<String> CORNERS = Set.of("vertex_indices", "vertex_index");

    /** More colours than these are rounded, so that a palette of all of them is a small picture. */
    private static final int MOST_COLORS = 4096;

    private final String source;
    private final double scale;
    private final PlyHeader header;
    private final PlyNumbers numbers;

    private double[] coordinates = {};
    private int count;

    /** By vertex, 0xRRGGBB; empty if they have none. */
    private int[] colors = {};

    /** Polygons as they are read: the vertices may follow them. */
    private final List<int[]> polygons = new ArrayList<>();

    private PlySurface(byte[] bytes, String source, double scale) throws FileProblem {
        this.source = source;
        this.scale = scale;
        header = PlyHeader.read(bytes, source);
        numbers = new PlyNumbers(bytes, source, header);
    }

    /** Reads a mesh from a stream, which is left open. */
    public static MeshObject read(InputStream in, String source, double scale) throws FileProblem {
        return read(in, source, scale, null);
    }

    /** @param part a part's name, which is refused, since PLY has no parts; null for all */
    static MeshObject read(InputStream in, String source, double scale, @Nullable String part) throws FileProblem {
        if (part != null) {
            throw new FileProblem(
                    source, "a PLY file has no parts with names; save this one as its own (got: " + part + ")");
        }
        byte[] bytes;
        try {
            bytes = PlainBytes.of(CountedStream.bounded(in).readAllBytes());
        } catch (IOException e) {
            throw new FileProblem(source, "the file could not be read: " + e.getMessage(), e);
        }
        return new PlySurface(bytes, source, scale).read();
    }

    private MeshObject read() throws FileProblem {
        for (PlyHeader.Element element : header.elements) {
            switch (element.name()) {
                case "vertex" -> vertices(element);
                case "face" -> lists(element, false);
                case "tristrips" -> lists(element, true);
                default -> skip(element);
            }
        }
        if (polygons.isEmpty()) {
            throw new FileProblem(
                    source,
                    "a PLY file must have at least one face; a cloud of points must be made a surface by another"
                            + " program (got: " + count / 3 + " vertices)");
        }
        List<Point> vertices = points();
        List<int[]> faces = new ArrayList<>();
        List<String> names = new ArrayList<>(); // of the colours of faces
        int rounding = colors.length == 0
                        || polygons.stream().mapToInt(this::color).distinct().count() <= MOST_COLORS
                ? 0xffffff
                : 0xf0f0f0;
        for (int[] polygon : polygons) {
            if (faces.size() + polygon.length - 2 > Limits.MAX_FACES) {
                throw new FileProblem(
                        source,
                        "a mesh must have at most " + Limits.MAX_FACES
                                + " faces, cut into triangles; simplify or split it (got: more)");
            }
            Polygon.cutOrFan(vertices, polygon, faces);
            if (colors.length > 0) {
                String name = String.format(Locale.ROOT, "#%06x", color(polygon) & rounding);
                names.addAll(Collections.nCopies(faces.size() - names.size(), name));
            }
        }
        try {
            JoinedFaces joined = new JoinedFaces();
            joined.add(
                    new JoinedFaces.Part(vertices, faces, List.of(), new double[0], names),
                    AffineTransform.NONE,
                    name -> name);
            return names.isEmpty() ? joined.mesh() : joined.mesh(name -> Material.of(Color.parse(name)));
        } catch (IllegalArgumentException e) {
            throw new FileProblem(source, String.valueOf(e.getMessage()), e);
        }
    }

    /** The vertices of faces; others, whose coordinates may be none, are at the origin. */
    private List<Point> points() throws FileProblem {
        Point[] points = new Point[count / 3];
        Arrays.fill(points, new Point());
        boolean[] isPlaced = new boolean[points.length];
        for (int[] polygon : polygons) {
            for (int corner : polygon) {
                if (corner >= points.length) {
                    throw new FileProblem(
                            source,
                            "a corner must be from 0 and below " + points.length + ", the number of vertices (got: "
                                    + corner + ")");
                }
                if (!isPlaced[corner]) {
                    points[corner] = point(corner);
                    isPlaced[corner] = true;
                }
            }
        }
        return List.of(points);
    }

    /** The mean of the colours of its corners. */
    private int color(int[] polygon) {
        int color = 0;
        for (int shift = 0; shift <= 16; shift += 8) {
            int sum = 0;
            for (int corner : polygon) {
                sum += colors[corner] >> shift & 0xff;
            }
            color |= ((sum + polygon.length / 2) / polygon.length) << shift;
        }
        return color;
    }

    private Point point(int index) throws FileProblem {
        int at = 3 * index;
        try {
            return new Point(scale * coordinates[at], scale * coordinates[at + 1], scale * coordinates[at + 2]);
        } catch (IllegalArgumentException e) {
            throw new FileProblem(source, "vertex " + (index + 1) + ": " + e.getMessage(), e);
        }
    }

    private void skip(PlyHeader.Element element) throws FileProblem {
        for (long row = 0; row < element.count() && !element.properties().isEmpty(); row++) {
            numbers.at(element, row);
            for (PlyHeader.Property property : element.properties()) {
                skip(property);
            }
        }
    }

    private void skip(PlyHeader.Property property) throws FileProblem {
        PlyHeader.Type length = property.count();
        numbers.skip(property, length == null ? 1 : numbers.length(property, length));
    }

    private void vertices(PlyHeader.Element element) throws FileProblem {
        int[] axes = new int[element.properties().size()];
        int known = 0;
        for (int k = 0; k < axes.length; k++) {
            axes[k] = axis(element.properties().get(k));
            known |= axes[k] < 0 ? 0 : 1 << axes[k];
        }
        if ((known & 0b111) != 0b111) {
            throw new FileProblem(source, "the element vertex must have the properties x, y and z (got: not all)");
        }
        double[] place = new double[6];
        for (long row = 0; row < element.count(); row++) {
            numbers.at(element, row);
            for (int k = 0; k < axes.length; k++) {
                PlyHeader.Property property = element.properties().get(k);
                if (axes[k] < 0) {
                    skip(property);
                } else {
                    place[axes[k]] = numbers.next(property, property.type());
                    place[axes[k]] *= axes[k] < 3 ? 1 : levels(property.type());
                }
            }
            if (count + 3 > Limits.MAX_NUMBERS) {
                throw numbers.wrong("a mesh must have at most " + Limits.MAX_NUMBERS / 3
                        + " vertices; simplify or split them (got: more)");
            }
            if (count == coordinates.length) {
                coordinates = Arrays.copyOf(coordinates, Math.max(96, 2 * count));
                colors = known == 0b111111 ? Arrays.copyOf(colors, coordinates.length / 3) : colors;
            }
            System.arraycopy(place, 0, coordinates, count, 3);
            if (known == 0b111111) {
                colors[count / 3] = level(place[3]) << 16 | level(place[4]) << 8 | level(place[5]);
            }
            count += 3;
        }
    }

    /** Which number of a vertex a property is, coordinate or colour; -1 if neither. */
    private static int axis(PlyHeader.Property property) {
        return property.count() != null
                ? -1
                : switch (property.name()) {
                    case "x" -> 0;
                    case "y" -> 1;
                    case "z" -> 2;
                    case "red", "diffuse_red" -> 3;
                    case "green", "diffuse_green" -> 4;
                    case "blue", "diffuse_blue" -> 5;
                    default -> -1;
                };
    }

    /** What a number of a colour is multiplied by to be from 0 to 255: one with a fraction is a share. */
    private static double levels(PlyHeader.Type type) {
        return switch (type) {
            case FLOAT32, FLOAT64 -> 255;
            case UINT16, INT16 -> 255 / 65535.0;
            default -> 1;
        };
    }

    private static int level(double number) {
        return (int) Math.rint(Math.min(Math.max(0, number), 255)); // 0 of NaN
    }

    /** Faces, or strips of triangles. */
    private void lists(PlyHeader.Element element, boolean isStrip) throws FileProblem {
        for (long row = 0; row < element.count() && !element.properties().isEmpty(); row++) {
            numbers.at(element, row);
            for (PlyHeader.Property property : element.properties()) {
                PlyHeader.Type length = property.count();
                if (length == null || !CORNERS.contains(property.name())) {
                    skip(property);
                } else if (isStrip) {
                    strip(property, numbers.length(property, length));
                } else {
                    polygon(property, numbers.length(property, length));
                }
            }
        }
    }

    private void polygon(PlyHeader.Property property, int length) throws FileProblem {
        if (length > Limits.MAX_CORNERS) {
            throw numbers.wrong("a face must have at most " + Limits.MAX_CORNERS
                    + " corners; cut it into smaller ones (got: " + length + ")");
        }
        int[] corners = new int[length];
        for (int k = 0; k < length; k++) {
            corners[k] = corner(property, 0);
        }
        if (length > 2) { // fewer are a point or an edge
            add(corners);
        }
    }

    /** A strip, in which -1 ends one and begins another. */
    private void strip(PlyHeader.Property property, int length) throws FileProblem {
        int before = 0;
        int last = 0;
        int inStrip = 0;
        for (int k = 0; k < length; k++) {
            int corner = corner(property, -1);
            if (corner < 0) {
                inStrip = 0;
                continue;
            }
            if (++inStrip > 2) {
                // Every other triangle of a strip is written the other way round.
                add(inStrip % 2 == 1 ? new int[] {before, last, corner} : new int[] {last, before, corner});
            }
            before = last;
            last = corner;
        }
    }

    private int corner(PlyHeader.Property property, int least) throws FileProblem {
        double corner = numbers.next(property, property.type());
        if (!(corner >= least && corner <= Integer.MAX_VALUE) || corner != Math.rint(corner)) {
            throw numbers.wrong("a corner must be a whole number of at least " + least + " (got: "
                    + Numbers.shown(Double.toString(corner)) + ")");
        }
        return (int) corner;
    }

    private void add(int[] corners) throws FileProblem {
        if (polygons.size() == Limits.MAX_FACES) {
            throw numbers.wrong(
                    "a mesh must have at most " + Limits.MAX_FACES + " faces; simplify or split it (got: more)");
        }
        polygons.add(corners);
    }
}
