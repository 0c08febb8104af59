package robosim.geometry.world;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.WorkLimit;
import robosim.geometry.check.Checks;
import robosim.geometry.model.MeshObject;
import robosim.geometry.world.mesh.MeshFiles;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.TextureFiles;

/**
 * Reads worlds and meshes. The format of a world is that of the schema {@code world.xsd}; docs/world-format.md explains it.
 *
 * <p>An untrusted file is safe to read: document types and entities are refused and no address is followed, mesh files
 * are read only from the world file's own folder tree, and files that are too large, or too deep or long in any part,
 * are refused. A world is read completely or not at all.
 *
 * <p>Meshes are read from files of Wavefront OBJ, STL, COLLADA, PLY or glTF, in the format given by the ending of the name.
 * {@code docs/importing.md} says which parts of each format are read, ignored and refused. COLLADA is turned into metres with Y
 * up; glTF has these already; the others are read in the units and along the axes of their files. A polygon with more than four
 * corners, which may be concave, is cut into triangles; one that crosses itself is refused. Texture coordinates are kept, and the
 * materials of OBJ and glTF are read, whose pictures must exist; a mesh has one material, that of most of its faces.
 *
 * <pre>{@code
 * String xml = """
 *         <world xmlns="urn:robosim:world:1" width="10" height="4" length="10" unit="m">
 *           <box name="wall" center="2 0 0" width="10cm" height="2" length="4"/>
 *         </world>""";
 * World world = WorldReader.read(new ByteArrayInputStream(xml.getBytes("UTF-8")), "here", null);
 * world.objects().size(); // 1
 * String fault = "";
 * try {
 *     WorldReader.read(new ByteArrayInputStream(xml.replace("10cm", "-1").getBytes("UTF-8")), "here", null);
 * } catch (WorldException e) {
 *     fault = e.getMessage();
 * }
 * fault.startsWith("here:2:"); // true: it names line and column, and what should be there
 * }</pre>
 */
public final class WorldReader {
    private static final int MOST_WARNINGS = 10;
    private static final System.Logger LOG = System.getLogger(WorldReader.class.getPackageName());

    private WorldReader() {}

    /**
     * Reads a world file of any format that {@link WorldImport#read} knows, with its default options. Each part of a
     * file of another format that is left out is logged as a warning to the system logger of this package.
     *
     * @throws WorldException naming file, line, column and remedy, if the file cannot be read or is not a world
     */
    public static World read(Path file) throws WorldException {
        WorldImport imported = WorldImport.read(file, ImportOptions.DEFAULT);
        List<Skipped> skipped = imported.skipped();
        for (Skipped each : skipped.subList(0, Math.min(MOST_WARNINGS, skipped.size()))) {
            LOG.log(System.Logger.Level.WARNING, each);
        }
        if (skipped.size() > MOST_WARNINGS) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    () -> file + ": left out " + (skipped.size() - MOST_WARNINGS)
                            + " more; the command convert lists them");
        }
        return imported.world();
    }

    /**
     * Reads a world from a stream, which is left open.
     *
     * @param source the name of the stream in messages
     * @param base   the folder in whose tree mesh files are looked up; null if the stream may not refer to any
     * @throws WorldException naming source, line, column and remedy, if the stream fails or contains no world
     */
    public static World read(InputStream in, String source, @Nullable Path base) throws WorldException {
        Checks.present("in", in);
        Checks.present("source", source);
        try {
            return XmlWorld.read(in, source, base, WorldImport.others(ImportOptions.DEFAULT));
        } catch (FileProblem e) {
            throw new WorldException(e);
        }
    }

    /**
     * Reads a world from a stream as {@link #read(InputStream, String, Path)} does, within a limit of work.
     *
     * @throws robosim.geometry.WorkLimitException if reading it takes more, or the limit is cancelled
     */
    public static World read(InputStream in, String source, @Nullable Path base, WorkLimit limit)
            throws WorldException {
        Checks.present("in", in);
        WorkLimit meter = Checks.present("limit", limit).meter("reading a world");
        return FileWork.counted(meter::take, () -> read(FileWork.watched(in), source, base));
    }

    /**
     * Reads a mesh in the units of its file, or in metres where the format has them.
     *
     * @throws WorldException naming file and line, if the file cannot be read or contains no surface
     */
    public static MeshObject readMesh(Path file) throws WorldException {
        return readMesh(file, 1);
    }

    /**
     * Reads a mesh in other units.
     *
     * @param scale world units for each unit of the file, or for each metre where the format has them; above 0
     * @throws WorldException naming file and line, if the file cannot be read or contains no surface
     */
    public static MeshObject readMesh(Path file, double scale) throws WorldException {
        Checks.present("file", file);
        MeshFiles.checkScale(scale);
        try {
            MeshFiles.checkNamed(file.toString());
            return MeshFiles.read(file, scale, new TextureFiles(List.of()));
        } catch (FileProblem e) {
            throw new WorldException(e);
        }
    }

    /**
     * Reads a mesh from a stream, which is left open; without materials, which are in other files. glTF is read from files
     * only.
     *
     * @param source the name of the stream in messages, with the ending of its format
     * @param scale  world units for each unit of the stream, or for each metre where the format has them; above 0
     * @throws WorldException naming source and line, if the stream fails or contains no surface
     */
    public static MeshObject readMesh(InputStream in, String source, double scale) throws WorldException {
        Checks.present("in", in);
        Checks.present("source", source);
        MeshFiles.checkScale(scale);
        try {
            return MeshFiles.read(in, source, scale);
        } catch (FileProblem e) {
            throw new WorldException(e);
        }
    }

    /**
     * Reads a mesh from a stream as {@link #readMesh(InputStream, String, double)} does, within a limit of work.
     *
     * @throws robosim.geometry.WorkLimitException if reading it takes more, or the limit is cancelled
     */
    public static MeshObject readMesh(InputStream in, String source, double scale, WorkLimit limit)
            throws WorldException {
        Checks.present("in", in);
        WorkLimit meter = Checks.present("limit", limit).meter("reading a mesh");
        return FileWork.counted(meter::take, () -> readMesh(FileWork.watched(in), source, scale));
    }

    /**
     * All problems of a world file, in the order of its lines: {@link #read(Path)} stops at the first, this method
     * reads on as far as it can, up to 100 problems. Empty if the file is a valid world.
     */
    public static List<WorldException> problems(Path file) {
        return problems(file, ImportOptions.DEFAULT);
    }

    /** All problems of a world file of any format, read as {@link WorldImport#read} does. */
    public static List<WorldException> problems(Path file, ImportOptions options) {
        Checks.present("file", file);
        Checks.present("options", options);
        try {
            WorldImport.read(file, options);
            return List.of();
        } catch (WorldException first) {
            List<FileProblem> problems;
            try {
                problems = XmlWorld.problems(file, options.models(), WorldImport.others(options));
            } catch (IOException e) {
                return List.of(first);
            }
            // A file of another format would only give misleading problems.
            boolean same = !problems.isEmpty()
                    && String.valueOf(first.getMessage()).equals(problems.get(0).getMessage());
            return same ? problems.stream().map(WorldException::new).toList() : List.of(first);
        }
    }
}
