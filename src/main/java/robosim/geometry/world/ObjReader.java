package robosim.geometry.world;

import java.io.InputStream;
import java.nio.file.Path;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.MeshObject;
import robosim.geometry.world.mesh.MeshFiles;
import robosim.geometry.world.mesh.ObjSurface;
import robosim.geometry.world.shared.FileProblem;

/**
 * Reads the surface of a Wavefront OBJ file: its vertices and faces, with indices from 1 or back from the end.
 *
 * <p>Triangles and quads are kept; a quad that would fold over along the diagonal from its first corner is rotated to
 * begin at its second. A polygon with more corners, which may be concave, is cut into triangles; one that crosses
 * itself is refused. Vertex colours, normals, textures, materials, groups, smoothing, lines and points are ignored;
 * free-form curves and surfaces, which would be lost, are refused.
 */
public final class ObjReader {
    private ObjReader() {}

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
            return MeshFiles.read(file, scale, ObjSurface::read);
        } catch (FileProblem e) {
            throw new WorldException(e);
        }
    }

    /**
     * Reads a mesh from a stream, which is left open.
     *
     * @param source the name of the stream in messages
     * @param scale  world units for each unit of the stream; above 0
     * @throws WorldException naming source and line, if the stream fails or contains no surface
     */
    public static MeshObject read(InputStream in, String source, double scale) throws WorldException {
        Checks.present("in", in);
        Checks.present("source", source);
        MeshFiles.checkScale(scale);
        try {
            return ObjSurface.read(in, source, scale);
        } catch (FileProblem e) {
            throw new WorldException(e);
        }
    }
}
