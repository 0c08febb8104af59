package robosim.geometry.world;

import java.io.InputStream;
import java.nio.file.Path;
import robosim.geometry.WorkLimit;
import robosim.geometry.check.Checks;
import robosim.geometry.model.MeshObject;
import robosim.geometry.world.mesh.ColladaSurface;
import robosim.geometry.world.mesh.MeshFiles;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;

/**
 * Reads the surface of a COLLADA file ({@code .dae}): the meshes that its visual scene shows, each where its nodes put
 * it.
 *
 * <p>The file's unit is turned into metres and its axis that points up into Y. Triangles, polygons, strips and fans are
 * read; equal vertices are joined; a skin has its bind shape. A polygon with more than four corners, which may be
 * concave, is cut into triangles. Cameras, lights, materials, animations, physics, lines and splines are ignored; polygons
 * with holes, and references to other files, are refused.
 */
public final class ColladaReader {
    private ColladaReader() {}

    /**
     * Reads a mesh in metres.
     *
     * @throws WorldException naming file and line, if the file cannot be read or shows no surface
     */
    public static MeshObject read(Path file) throws WorldException {
        return read(file, 1);
    }

    /**
     * Reads a mesh in other units.
     *
     * @param scale world units for each metre; above 0
     * @throws WorldException naming file and line, if the file cannot be read or shows no surface
     */
    public static MeshObject read(Path file, double scale) throws WorldException {
        Checks.present("file", file);
        MeshFiles.checkScale(scale);
        try {
            return MeshFiles.read(file, scale, ColladaSurface::read);
        } catch (FileProblem e) {
            throw new WorldException(e);
        }
    }

    /**
     * Reads a mesh from a stream, which is left open.
     *
     * @param source the name of the stream in messages
     * @param scale  world units for each metre; above 0
     * @throws WorldException naming source and line, if the stream fails or shows no surface
     */
    public static MeshObject read(InputStream in, String source, double scale) throws WorldException {
        Checks.present("in", in);
        Checks.present("source", source);
        MeshFiles.checkScale(scale);
        try {
            return ColladaSurface.read(in, source, scale);
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
