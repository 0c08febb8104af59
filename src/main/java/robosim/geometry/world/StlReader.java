package robosim.geometry.world;

import java.io.InputStream;
import java.nio.file.Path;
import robosim.geometry.WorkLimit;
import robosim.geometry.check.Checks;
import robosim.geometry.model.MeshObject;
import robosim.geometry.world.mesh.MeshFiles;
import robosim.geometry.world.mesh.StlSurface;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;

/**
 * Reads the surface of an STL file, binary or text: its triangles, with equal corners joined.
 *
 * <p>The file's length decides which of the two it is: a binary file of n triangles has 84 + 50 n bytes, whatever its
 * header says. Corners are joined only if their three numbers are the same, so a surface whose file rounds a corner in
 * two ways stays open. Normals, names, attributes and colours are ignored; only the order of corners matters. A text
 * file may contain several solids, which become one mesh.
 */
public final class StlReader {
    private StlReader() {}

    /**
     * Reads a mesh in the units of its file.
     *
     * @throws WorldException naming file and line, if the file cannot be read or contains no surface
     */
    public static MeshObject read(Path file) throws WorldException {
        return read(file, 1);
    }

    /**
     * Reads a mesh in other units.
     *
     * @param scale world units for each unit of the file; above 0
     * @throws WorldException naming file and line, if the file cannot be read or contains no surface
     */
    public static MeshObject read(Path file, double scale) throws WorldException {
        Checks.present("file", file);
        MeshFiles.checkScale(scale);
        try {
            return MeshFiles.read(file, scale, StlSurface::read);
        } catch (FileProblem e) {
            throw new WorldException(e);
        }
    }

    /**
     * Reads a mesh from a stream, which is left open.
     *
     * @param source the name of the stream in messages
     * @param scale  world units for each unit of the stream; above 0
     * @throws WorldException naming source and line (for a binary one the triangle), if the stream fails or contains no
     *     surface
     */
    public static MeshObject read(InputStream in, String source, double scale) throws WorldException {
        Checks.present("in", in);
        Checks.present("source", source);
        MeshFiles.checkScale(scale);
        try {
            return StlSurface.read(in, source, scale);
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
