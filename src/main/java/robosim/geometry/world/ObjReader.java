package robosim.geometry.world;

import java.io.InputStream;
import java.nio.file.Path;
import java.util.List;
import robosim.geometry.WorkLimit;
import robosim.geometry.check.Checks;
import robosim.geometry.model.MeshObject;
import robosim.geometry.world.mesh.MeshFiles;
import robosim.geometry.world.mesh.ObjSurface;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.TextureFiles;

/**
 * Reads the surface of a Wavefront OBJ file: its vertices and faces, with indices from 1 or back from the end.
 *
 * <p>Triangles and quads are kept; a quad that would fold over along the diagonal from its first corner is rotated to
 * begin at its second. A polygon with more corners, which may be concave, is cut into triangles; one that crosses
 * itself is refused. Texture coordinates are kept. Vertex colours, normals, groups, smoothing, lines and points are ignored;
 * free-form curves and surfaces, which would be lost, are refused.
 *
 * <p>A file's materials are those of its MTL files, if they exist: {@code Kd}, {@code Ks}, {@code Ns}, {@code Ke} and
 * {@code map_Kd}, a PNG or JPEG image, which must exist. A mesh has one material: that of most faces. Where the faces have several colours and no
 * picture, these become a texture; where they have several pictures, that of most faces is kept.
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
            return MeshFiles.readObj(file, scale, new TextureFiles(List.of()));
        } catch (FileProblem e) {
            throw new WorldException(e);
        }
    }

    /**
     * Reads a mesh from a stream, which is left open; without materials, which are in other files.
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
