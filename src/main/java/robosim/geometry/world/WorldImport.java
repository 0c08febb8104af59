package robosim.geometry.world;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import robosim.geometry.WorkLimit;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.MeshObject;
import robosim.geometry.world.mesh.MeshFiles;
import robosim.geometry.world.sdf.SdfManifest;
import robosim.geometry.world.shared.FileKind;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.LeftOut;
import robosim.geometry.world.shared.RegularFile;
import robosim.geometry.world.shared.TextureFiles;
import robosim.geometry.world.stage.StageWorld;

/**
 * A world from a file of any supported format, and a report on the file: what was read, what was ignored because it is
 * irrelevant to solid geometry, and what was left out although it may be relevant.
 *
 * @param world      the world made from the file
 * @param format     its format, by name
 * @param read       number of elements that were read, by the format's names
 * @param passedOver number of irrelevant elements, by the format's names
 * @param skipped    what is missing from the world, each with its place and the reason
 * @param remarks    other things that a user should know
 */
public record WorldImport(
        World world,
        String format,
        Map<String, Integer> read,
        Map<String, Integer> passedOver,
        List<Skipped> skipped,
        List<String> remarks) {

    /** How many left-out parts the refusal of an empty world lists. */
    private static final int MOST_REASONS = 3;

    /** Keeps copies, in the order of their names. */
    public WorldImport {
        read = Collections.unmodifiableMap(new TreeMap<>(read));
        passedOver = Collections.unmodifiableMap(new TreeMap<>(passedOver));
        skipped = List.copyOf(skipped);
        remarks = List.copyOf(remarks);
    }

    /** An import with nothing left out. */
    WorldImport(World world, String format, Map<String, Integer> read) {
        this(world, format, read, Map.of(), List.of(), List.of());
    }

    /** Whether everything relevant in the file is in the world. */
    public boolean isWhole() {
        return skipped.isEmpty();
    }

    /**
     * Reads a file in the format given by the ending of its name: a world of this module ({@code .xml}), a ROS map
     * ({@code .yaml}, {@code .yml}), SDFormat ({@code .sdf}, {@code .world}, {@code model.config} or the folder of a
     * model), a world of Stage ({@code .world}), URDF ({@code .urdf}), or a mesh ({@code .obj}, {@code .stl}, {@code .dae},
     * {@code .ply}, {@code .glb}, {@code .gltf}). A file with any other name is read as a world of this module. A ROS map
     * becomes a PLANAR world, others a SPATIAL one, unless the options or a file of this module say otherwise.
     *
     * @throws WorldException naming file, line and remedy, if the file cannot be read, is of no such format, or is
     *     SDFormat that yields no object
     */
    public static WorldImport read(Path file, ImportOptions options) throws WorldException {
        Checks.present("file", file);
        Checks.present("options", options);
        WorldImport read = readAny(file, options);
        Dimension dimension = options.dimension();
        World world = read.world;
        if (dimension == null || dimension == world.dimension()) {
            return read;
        }
        World other = dimension == Dimension.PLANAR ? world.planar() : world.spatial();
        return new WorldImport(other, read.format, read.read, read.passedOver, read.skipped, read.remarks);
    }

    private static WorldImport readAny(Path file, ImportOptions options) throws WorldException {
        Path last = file.getFileName();
        String name = last == null ? "" : last.toString().toLowerCase(Locale.ROOT);
        if (Files.isDirectory(file)) {
            return solid(file, SdfReader.readFolder(file, options.models()));
        }
        if (name.equals(SdfManifest.NAME)) {
            return solid(file, SdfReader.readFolder(file.toAbsolutePath().resolveSibling(""), options.models()));
        }
        String ending = ending(name);
        refuseByName(file, ending);
        try {
            return read(file, ending, options);
        } catch (WorldException e) {
            String readAs = switch (ending) {
                case "world" -> FileKind.isStage(file) ? "stage" : "sdf";
                case "sdf" -> "sdf";
                case "yaml", "yml" -> "yaml";
                case "obj", "stl", "dae", "ply", "glb", "gltf", "urdf" -> ending;
                default -> "xml";
            };
            String other = e.source().equals(file.toString()) ? FileKind.other(file, readAs) : null;
            throw other == null
                    ? e
                    : new WorldException(new FileProblem(file.toString(), other + " (got: " + name + ")", e));
        }
    }

    /**
     * Reads a file as {@link #read(Path, ImportOptions)} does, and names each file that it opens: the file itself,
     * meshes, textures, a map's image, models. So a program can refuse to overwrite what it has read.
     *
     * @param opened told of each file when it is opened; of one that is opened twice, twice
     */
    public static WorldImport read(Path file, ImportOptions options, Consumer<Path> opened) throws WorldException {
        Checks.present("opened", opened);
        return RegularFile.told(opened, () -> read(file, options));
    }

    /**
     * Reads a file as {@link #read(Path, ImportOptions)} does, within a limit of work. A unit is about 64 bytes or 256 pixels, or
     * an element, a line, a vertex, a face or an object.
     *
     * @throws robosim.geometry.WorkLimitException if reading it takes more, or the limit is cancelled
     */
    public static WorldImport read(Path file, ImportOptions options, WorkLimit limit) throws WorldException {
        WorkLimit meter = Checks.present("limit", limit).meter("reading a file");
        return FileWork.counted(meter::take, () -> read(file, options));
    }

    private static void refuseByName(Path file, String ending) throws WorldException {
        String other = FileKind.byEnding(ending);
        if (other != null) {
            throw new WorldException(new FileProblem(file.toString(), other + " (got: ." + ending + ")"));
        }
        switch (ending) {
            case "xacro" -> {
                String name = String.valueOf(file.getFileName());
                throw new WorldException(new FileProblem(
                        file.toString(),
                        "macros are not carried out; run the file through xacro first: xacro " + name + " > "
                                + (name.contains(".sdf.") || name.contains(".world.") ? "NEW.sdf" : "NEW.urdf")
                                + " (got: .xacro)"));
            }
            case "pgm", "png" ->
                throw new WorldException(new FileProblem(
                        file.toString(), "a map is read from its .yaml file, which gives the size of a cell"));
            case "fbx", "gz", "zip" ->
                throw new WorldException(new FileProblem(
                        file.toString(),
                        "files of this format are not supported; unpack this one, or export it as SDFormat,"
                                + " glTF, COLLADA, OBJ or STL (got: ." + ending + ")"));
            default -> {}
        }
    }

    /** Refuses SDFormat or a world of Stage that yields no object: an empty world is not what the user wants. */
    private static WorldImport solid(Path file, WorldImport read) throws WorldException {
        if (!read.world.objects().isEmpty()) {
            return read;
        }
        List<String> reasons = new ArrayList<>();
        shown(reasons, Skipped.joined(read.skipped), MOST_REASONS);
        shown(reasons, read.remarks, MOST_REASONS);
        throw new WorldException(new FileProblem(
                file.toString(),
                "nothing in it is solid, so the world would be empty; check that its models have collisions and"
                        + " that they are found (got: " + counted(read.read)
                        + (reasons.isEmpty() ? "" : "; " + String.join("; ", reasons)) + ")"));
    }

    private static WorldImport read(Path file, String ending, ImportOptions options) throws WorldException {
        return switch (ending) {
            case "world" -> solid(file, FileKind.isStage(file) ? stage(file) : SdfReader.read(file, options.models()));
            case "sdf", "urdf" -> solid(file, SdfReader.read(file, options.models()));
            case "obj" -> mesh(file, "Wavefront OBJ", options);
            case "stl" -> mesh(file, "STL", options);
            case "dae" -> mesh(file, "COLLADA", options);
            case "ply" -> mesh(file, "PLY", options);
            case "glb", "gltf" -> mesh(file, "glTF", options);
            case "yaml", "yml" -> RosMapReader.readImport(file, options);
            default -> {
                try {
                    yield of(XmlWorld.read(file, options.models(), others(options)));
                } catch (FileProblem e) {
                    throw new WorldException(e);
                }
            }
        };
    }

    private static WorldImport of(XmlWorld.Found found) {
        return new WorldImport(
                found.world(),
                found.format(),
                found.read(),
                Map.of(),
                List.copyOf(found.skipped()),
                List.copyOf(found.remarks()));
    }

    /** How a world file reads those of other formats that it includes. */
    static XmlWorld.Others others(ImportOptions options) {
        return (file, folders) -> {
            // The world that includes it says whether heights count.
            WorldImport read = read(file, options.withModels(folders).withDimension(null));
            return new XmlWorld.Found(
                    read.world,
                    read.format,
                    read.read,
                    new LinkedHashSet<>(read.skipped),
                    new LinkedHashSet<>(read.remarks));
        };
    }

    private static String ending(String name) {
        return name.substring(name.lastIndexOf('.') + 1);
    }

    /** A world of Stage, with a margin of at least a metre around its objects. */
    private static WorldImport stage(Path file) throws WorldException {
        try {
            StageWorld found = StageWorld.read(file);
            List<WorldObject> objects = new ArrayList<>();
            for (StageWorld.Found each : found.objects) {
                List<SonarRing> rings = each.rings().stream()
                        .map(r -> new SonarRing((int) r[0], r[1], r[2], r[3], r[4], r[5]))
                        .toList();
                objects.add(new WorldObject(each.object(), null, rings));
            }
            double[] reach =
                    Bounds.reach(objects.stream().map(WorldObject::object).toList());
            World world = new World(
                    2 * (reach[0] + 1),
                    2 * (reach[1] + 1),
                    2 * (reach[2] + 1),
                    Unit.METRE,
                    Dimension.SPATIAL,
                    Accuracy.EXACT,
                    objects);
            List<Skipped> skipped = found.leftOut.stream().map(Skipped::of).toList();
            return new WorldImport(world, "Stage", found.read, found.passedOver, skipped, found.remarks);
        } catch (FileProblem e) {
            throw new WorldException(e);
        } catch (IllegalArgumentException e) {
            throw new WorldException(new FileProblem(file.toString(), String.valueOf(e.getMessage()), e));
        }
    }

    /** A mesh at the origin of its own coordinates, in a world with a margin of a quarter of its size. */
    private static WorldImport mesh(Path file, String format, ImportOptions options) throws WorldException {
        MeshObject mesh;
        boolean isUpright = MeshFiles.isUpright(file.toString());
        List<LeftOut> leftOut = new ArrayList<>();
        try {
            mesh = MeshFiles.trimmed(MeshFiles.read(file, options.scale(), new TextureFiles(List.of(), leftOut)));
        } catch (FileProblem e) {
            throw new WorldException(e);
        }
        if (options.up() == ImportOptions.Up.Z && !isUpright) { // which says itself what is up
            mesh = mesh.turned(-90, 0);
        }
        Path last = file.getFileName();
        String name = last == null ? "mesh" : last.toString().replaceFirst("\\.[^.]*$", "");
        List<WorldObject> objects = List.of(new WorldObject(name.isBlank() ? mesh : mesh.named(name)));
        double[] reach = Bounds.reach(List.of(mesh));
        double most = Math.max(reach[0], Math.max(reach[1], reach[2]));
        double margin = most > 0 ? most / 4 : 1;
        World world = new World(
                2 * (reach[0] + margin),
                2 * (reach[1] + margin),
                2 * (reach[2] + margin),
                isUpright && options.scale() == 1 ? Unit.METRE : null,
                Dimension.SPATIAL,
                Accuracy.EXACT,
                objects);
        return new WorldImport(
                world,
                format,
                Map.of("vertex", mesh.vertices().size(), "face", mesh.faces().length),
                Map.of(),
                leftOut.stream().map(Skipped::of).toList(),
                List.of());
    }

    /**
     * What was read and what was not, as lines for users: first what was left out, at most {@code most} lines of it. If
     * it is more, parts that were left out for the same reason share a line.
     */
    public List<String> lines(int most) {
        List<String> lines = new ArrayList<>();
        lines.add("Read " + format + ": " + counted(read));
        if (!passedOver.isEmpty()) {
            lines.add("Ignored, as irrelevant to solid geometry: " + counted(passedOver));
        }
        boolean isAll = most >= skipped.size();
        shown(lines, isAll ? skipped.stream().map(Skipped::toString).toList() : Skipped.joined(skipped), most);
        shown(lines, remarks, most);
        return lines;
    }

    private static void shown(List<String> lines, List<String> all, int most) {
        lines.addAll(all.subList(0, Math.min(most, all.size())));
        if (all.size() > most) {
            lines.add("... and " + (all.size() - most) + " more");
        }
    }

    private static String counted(Map<String, Integer> counts) {
        List<String> parts = new ArrayList<>();
        counts.forEach((name, count) -> parts.add(name + " " + count));
        return parts.isEmpty() ? "nothing" : String.join(", ", parts);
    }
}
