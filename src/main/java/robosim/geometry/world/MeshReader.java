package robosim.geometry.world;

import java.io.InputStream;
import java.nio.file.Path;
import java.util.List;
import robosim.geometry.WorkLimit;
import robosim.geometry.check.Checks;
import robosim.geometry.model.MeshObject;
import robosim.geometry.world.mesh.MeshFiles;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.TextureFiles;

/**
 * Reads a mesh from a file of Wavefront OBJ, STL, COLLADA, PLY or glTF, in the format given by the ending of its name.
 * {@code docs/importing.md} says which parts of each format are read, ignored and refused.
 *
 * <p>COLLADA is turned into metres with Y up; glTF has these already; the others are read in the units and along the axes of
 * their files. A polygon with more than four corners, which may be concave, is cut into triangles; one that crosses itself is
 * refused. Texture coordinates are kept, and the materials of OBJ and glTF are read, whose pictures must exist; a mesh has
 * one material, that of most of its faces.
 */
public final class MeshReader {
    private MeshReader() {}

    /**
     * Reads a mesh in the units of its file, or in metres where the format has them.
     *
     * @throws WorldException naming file and line, if the file cannot be read or contains no surface
     */
    public static MeshObject read(Path file) throws WorldException {
        return read(file, 1);
    }

    /**
     * Reads a mesh in other units.
     *
     * @param scale world units for each unit of the file, or for each metre where the format has them; above 0
     * @throws WorldException naming file and line, if the file cannot be read or contains no surface
     */
    public static MeshObject read(Path file, double scale) throws WorldException {
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
    public static MeshObject read(InputStream in, String source, double scale) throws WorldException {
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
     * Reads a mesh from a stream as {@link #read(InputStream, String, double)} does, within a limit of work.
     *
     * @throws robosim.geometry.WorkLimitException if reading it takes more, or the limit is cancelled
     */
    public static MeshObject read(InputStream in, String source, double scale, WorkLimit limit) throws WorldException {
        Checks.present("in", in);
        WorkLimit.Meter meter = Checks.present("limit", limit).meter("reading a mesh");
        return FileWork.counted(meter::take, () -> read(FileWork.watched(in), source, scale));
    }
}
