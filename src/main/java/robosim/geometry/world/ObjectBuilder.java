package robosim.geometry.world;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Attitude;
import robosim.geometry.material.Material;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.Kind;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.world.body.BodyXml;
import robosim.geometry.world.body.ObjectBody;
import robosim.geometry.world.mesh.MeshFiles;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.Folder;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Numbers;
import robosim.geometry.world.xml.ChildNames;
import robosim.geometry.world.xml.GridRuns;
import robosim.geometry.world.xml.Text;

/** Creates objects from complete elements. Invalid values throw an {@link IllegalArgumentException}. */
final class ObjectBuilder {
    /** The most vertices of a hull in a file: of the worst kind they take a second. */
    private static final int MOST_HULL_VERTICES = 16_384;

    private final String source;
    private final @Nullable Path base;

    /** What objects are made of. */
    final WorldMaterials materials;

    private final Map<MeshKey, MeshObject> files = new HashMap<>();
    private final Map<MeshObject, MeshObject> meshes = new HashMap<>();

    /** The number of cells of all grids so far that are spelled out, and of those of included files. */
    private long cells;

    private long includedCells;

    private record MeshKey(
            Path file,
            double scale,
            boolean solid,
            boolean hull,
            @Nullable GeometryObject bounds) {}

    ObjectBuilder(String source, @Nullable Path base) {
        this.source = source;
        this.base = base;
        materials = new WorldMaterials(this, source, base);
    }

    /** The world unit, or null if the file does not specify it. */
    @Nullable
    Unit unit(Element element) {
        Element root = element;
        while (root.parent != null) {
            root = root.parent;
        }
        return Unit.of(root.attribute("unit", ""));
    }

    double length(Element element, String attribute, String otherwise) {
        return named(attribute, () -> Unit.length(element.attribute(attribute, otherwise), unit(element)));
    }

    static double number(Element element, String attribute, String otherwise) {
        return named(attribute, () -> Numbers.parse(element.attribute(attribute, otherwise)));
    }

    static <T> T named(String attribute, Supplier<T> value) {
        try {
            return value.get();
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(attribute + ": " + e.getMessage(), e);
        }
    }

    SonarRing sonar(Element element) {
        int count = Numbers.integer(element.attribute("count", ""));
        return new SonarRing(
                count,
                number(element, "first", "0"),
                element.attribute("step") == null ? 360.0 / count : number(element, "step", "0"),
                length(element, "min", "0"),
                element.attribute("max") == null ? Double.POSITIVE_INFINITY : length(element, "max", "0"),
                number(element, "width", "0"));
    }

    /** What a {@code <body>} says about its object; null if there is none. */
    static @Nullable ObjectBody body(@Nullable Element body, GeometryObject object) {
        if (body == null) {
            return null;
        }
        Element drive = body.motion;
        return BodyXml.body(body::attribute, drive == null ? null : BodyXml.drive(drive::attribute, object));
    }

    static boolean isObject(Element element) {
        return kind(element) != null;
    }

    private static @Nullable Kind kind(Element element) {
        for (Kind kind : Kind.values()) {
            if (kind.word().equals(element.name)) {
                return kind;
            }
        }
        return null;
    }

    GeometryObject object(Element element) throws FileProblem {
        Kind kind = kind(element);
        GeometryObject shape;
        if (kind == Kind.GROUP) {
            shape = new ObjectGroup(element.members, element.bounds);
        } else if (kind == Kind.GRID) {
            shape = grid(element);
        } else if (kind == null || kind == Kind.MESH) {
            shape = mesh(element);
        } else {
            double[] sizes = new double[kind.sizes().size()];
            for (int k = 0; k < sizes.length; k++) {
                sizes[k] = length(element, kind.sizes().get(k), "0");
            }
            shape = kind.of(new Point(), sizes);
        }
        Material material = materials.of(element);
        GeometryObject placed = tagged(element, shape.at(pose(element, "center")));
        return material == null ? placed : placed.withMaterial(material);
    }

    private GridObject grid(Element element) {
        return new GridObject(
                new Point(),
                length(element, "cell", "0"),
                length(element, "height", "0"),
                Numbers.integer(element.attribute("columns", "0")),
                Numbers.integer(element.attribute("rows", "0")),
                Objects.requireNonNull(element.occupied));
    }

    private static GeometryObject tagged(Element element, GeometryObject shape) {
        String layers = element.attribute("layers");
        GeometryObject object = layers == null ? shape : shape.withLayers(ChildNames.words(layers));
        String name = element.attribute("name");
        boolean moveable = element.isTrue("moveable");
        if (name == null) {
            if (moveable) {
                throw new IllegalArgumentException("a moveable object must have a name; add name=\"...\" (got: none)");
            }
            return object;
        }
        return moveable ? object.moveable(name) : object.named(name);
    }

    /** @param place the attribute with its point */
    Pose pose(Element element, String place) {
        Point center = point(element, place);
        String heading = element.attribute("heading");
        String turned = element.attribute("turned");
        String rotation = element.attribute("rotation");
        int given = (heading == null ? 0 : 1) + (turned == null ? 0 : 1) + (rotation == null ? 0 : 1);
        if (given > 1) {
            throw new IllegalArgumentException(
                    "only one of heading, turned and rotation may be given; remove the others (got: " + given + ")");
        }
        if (rotation != null) {
            return Pose.of(center, 0).oriented(numbers("rotation", rotation));
        }
        if (turned != null) {
            double[] angles = numbers("turned", turned);
            return Pose.of(center, 0).turned(angles[0], angles[1]);
        }
        double[] parts = numbers("heading", element.attribute("heading", "0"));
        Pose upright = Pose.of(center, parts[0]);
        if (parts.length == 1) {
            return upright;
        }
        double[] attitude = Attitude.identity();
        Attitude.setHeading(attitude, 0, parts[0], Pose.of(center, parts[1]).heading());
        return Pose.of(center, attitude, 0);
    }

    Point point(Element element, String attribute) {
        String[] parts = Numbers.words(element.attribute(attribute, "0 0 0"));
        return named(attribute, () -> {
            Unit unit = unit(element);
            return new Point(Unit.length(parts[0], unit), Unit.length(parts[1], unit), Unit.length(parts[2], unit));
        });
    }

    static double[] numbers(String attribute, String value) {
        String[] parts = Numbers.words(value);
        double[] numbers = new double[parts.length];
        return named(attribute, () -> {
            for (int k = 0; k < parts.length; k++) {
                numbers[k] = Numbers.parse(parts[k]);
            }
            return numbers;
        });
    }

    private MeshObject mesh(Element element) throws FileProblem {
        String file = element.attribute("file");
        if (file == null) {
            return shared(inline(element));
        }
        if (!element.faces.isEmpty() || !element.vertices.isEmpty()) {
            throw new IllegalArgumentException(
                    "a mesh must have either vertices or a file; remove one of them (got: both)");
        }
        Path path = locate(element, file);
        double scale = number(element, "scale", "1");
        boolean hull = element.isTrue("hull");
        MeshObject read = fromFile(new MeshKey(path, scale, element.isTrue("solid"), hull, element.bounds));
        Material material = materials.of(element);
        return shared(MeshFiles.trimmed(material == null ? read : read.withMaterial(material)));
    }

    /** A mesh that is written in the world's file. */
    private static MeshObject inline(Element element) {
        boolean hull = element.isTrue("hull");
        if (element.vertices.isEmpty() || (element.faces.isEmpty() && !hull)) {
            throw new IllegalArgumentException(
                    "a mesh must have vertices with triangles or quads, vertices with hull=\"true\", or a file (got: "
                            + (element.vertices.isEmpty() ? "neither" : "vertices alone") + ")");
        }
        if (element.attribute("scale") != null) {
            throw new IllegalArgumentException(
                    "scale applies only to a mesh from a file; remove it (got: " + element.attribute("scale") + ")");
        }
        if (hull) {
            if (!element.faces.isEmpty()) {
                throw new IllegalArgumentException(
                        "a mesh with hull=\"true\" must have vertices alone; remove its triangles" + " and quads (got: "
                                + element.faces.size() + " faces)");
            }
            takeHull(element.vertices.size());
            return bounded(MeshObject.hull(element.vertices), element.bounds);
        }
        MeshObject mesh =
                mesh(element.vertices, element.faces.toArray(int[][]::new), element.bounds, element.isTrue("solid"));
        double[] uv = element.uv;
        int[] corners = element.corners;
        return uv == null || corners == null ? mesh : mesh.withTextureCoordinates(new TextureCoordinates(uv, corners));
    }

    /** Counts the work of a hull, which for points on two circles grows with the square of their number. */
    private static void takeHull(int vertices) {
        if (vertices > MOST_HULL_VERTICES) {
            throw new IllegalArgumentException("a mesh with hull=\"true\" must have at most " + MOST_HULL_VERTICES
                    + " vertices; leave out those inside, or take the mesh without hull (got: " + vertices + ")");
        }
        FileWork.take(vertices + (long) vertices * vertices / 1000);
    }

    private static MeshObject bounded(MeshObject hull, @Nullable GeometryObject bounds) {
        return bounds == null ? hull : mesh(hull.vertices(), hull.faces(), bounds, true);
    }

    private MeshObject fromFile(MeshKey key) throws FileProblem {
        MeshObject known = files.get(key);
        if (known == null) {
            MeshKey plain = new MeshKey(key.file, key.scale, false, false, null);
            if (key.equals(plain)) {
                known = MeshFiles.read(key.file, key.scale, materials.textures);
            } else if (key.hull) {
                MeshObject surface = fromFile(plain);
                takeHull(surface.vertices().size());
                known = bounded(surface.hull(), key.bounds).withMaterial(surface.material());
            } else if (key.bounds == null) {
                known = fromFile(plain).solid();
            } else {
                MeshObject surface = fromFile(plain);
                known = mesh(surface.vertices(), surface.faces(), key.bounds, key.solid)
                        .withTextureCoordinates(surface.textureCoordinates())
                        .withMaterial(surface.material());
            }
            files.put(key, known);
        }
        return known;
    }

    /**
     * The first equal mesh, so that all placements of one mesh share their triangles, even if each was written in full.
     */
    private MeshObject shared(MeshObject mesh) {
        MeshObject first = meshes.putIfAbsent(mesh, mesh);
        return first == null ? mesh : first;
    }

    private static MeshObject mesh(
            List<Point> vertices, int[][] faces, @Nullable GeometryObject bounds, boolean solid) {
        MeshObject mesh = bounds == null ? new MeshObject(vertices, faces) : new MeshObject(vertices, faces, bounds);
        return solid ? mesh.solid() : mesh;
    }

    /** The file that a mesh names; it must exist within the tree of the world's folder. */
    private Path locate(Element element, String file) throws FileProblem {
        if (base == null) {
            throw new IllegalArgumentException(
                    "a world from a stream without a folder cannot use files; give the mesh inline (got: " + file
                            + ")");
        }
        try {
            return Folder.locate(base, file, "world", "mesh");
        } catch (IOException e) {
            throw new FileProblem(
                    source, element.line, element.column, "the mesh file " + file + " could not be read: " + e, e);
        }
    }

    /** Reads the numbers of an element of text, or the runs of a grid. */
    void readText(Element element) throws FileProblem {
        if (element.name.equals("grid")) {
            if (!element.broken) {
                element.occupied = occupied(element);
            }
        } else if (WorldMaterials.reads(element)) {
            materials.readText(element);
        } else if (element.name.equals("heights")) {
            readHeights(element);
        } else if (element.takesText()) {
            readNumbers(element);
        }
    }

    private BitSet occupied(Element element) throws FileProblem {
        int columns = Numbers.integer(element.attribute("columns", "0"));
        int rows = Numbers.integer(element.attribute("rows", "0"));
        // Checked before memory is allocated: a run of one number may claim any number of cells.
        cells += (long) columns * rows;
        if (cells > Limits.MAX_CELLS) {
            throw new IllegalArgumentException("the grids of a world must have at most " + Limits.MAX_CELLS
                    + " cells together; use larger cells (got: " + cells + ")");
        }
        try {
            return GridRuns.read(element.text, columns, rows);
        } catch (IllegalArgumentException e) {
            if (element.text.token().isEmpty()) {
                throw e;
            }
            throw new FileProblem(source, element.text.line(), element.text.column(), "<grid>: " + e.getMessage(), e);
        }
    }

    /** Counts the cells of a grid of an included file. */
    void countCells(GeometryObject object) {
        if (object instanceof GridObject grid) {
            includedCells += (long) grid.columns() * grid.rows();
            if (includedCells > Limits.MAX_MAP_CELLS) {
                throw new IllegalArgumentException("included grids must have at most " + Limits.MAX_MAP_CELLS
                        + " cells together; use larger cells (got: " + includedCells + ")");
            }
        }
    }

    /** Reads a terrain into the corners and faces of its surface. */
    private void readHeights(Element element) throws FileProblem {
        double cell = length(element, "cell", "0");
        int columns = Numbers.integer(element.attribute("columns", "0"));
        Text text = element.text;
        Unit unit = unit(element);
        double[] heights = new double[64];
        int count = 0;
        while (text.next()) {
            if (count > Limits.MAX_FACES / 2) {
                throw new IllegalArgumentException("a terrain must have at most " + Limits.MAX_FACES / 2
                        + " heights; take every other one, or several terrains (got: more)");
            }
            heights = count == heights.length ? Arrays.copyOf(heights, 2 * count) : heights;
            try {
                heights[count++] = Unit.length(text.token(), unit);
            } catch (IllegalArgumentException e) {
                throw new FileProblem(source, text.line(), text.column(), "<heights>: " + e.getMessage(), e);
            }
        }
        if (columns == 0 || count % columns != 0) {
            throw new IllegalArgumentException(
                    "heights must be whole rows of " + columns + " numbers (got: " + count + " numbers)");
        }
        FileWork.take(count);
        MeshObject surface = MeshObject.heightfield(cell, columns, count / columns, Arrays.copyOf(heights, count));
        element.vertices.addAll(surface.vertices());
        element.faces.addAll(Arrays.asList(surface.faces()));
    }

    private void readNumbers(Element element) throws FileProblem {
        Text text = element.text;
        boolean places = element.name.equals("vertices");
        int size = element.name.equals("quads") ? 4 : 3;
        Unit unit = unit(element);
        double[] place = new double[3];
        int[] face = new int[size];
        int count = 0;
        while (text.next()) {
            try {
                if (places) {
                    place[count % 3] = Unit.length(text.token(), unit);
                } else {
                    face[count % size] = Numbers.index(text.token());
                }
                count++;
                if (count % size == 0) {
                    if (places) {
                        element.vertices.add(new Point(place[0], place[1], place[2]));
                    } else {
                        element.faces.add(face.clone());
                    }
                }
            } catch (IllegalArgumentException e) {
                throw new FileProblem(
                        source, text.line(), text.column(), "<" + element.name + ">: " + e.getMessage(), e);
            }
        }
        if (count == 0 || count % size != 0) {
            throw new IllegalArgumentException((places ? "x y z of each vertex" : size + " indices for each face")
                    + " are needed (got: " + count + " numbers)");
        }
    }
}
