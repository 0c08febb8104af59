package robosim.geometry.world.mesh;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.RegularFile;
import robosim.geometry.world.shared.TextureFiles;

/**
 * What the readers of meshes share: opening a file, the limits of a scale, and the choice of a reader by a file's name.
 */
public final class MeshFiles {
    private MeshFiles() {}

    /** A reader of one format, which leaves the stream open. */
    @FunctionalInterface
    public interface Format {
        public MeshObject read(InputStream in, String source, double scale) throws FileProblem;
    }

    /** Whether a name has the ending of a supported format: .obj, .stl or .dae. */
    public static boolean isNamed(String file) {
        return isStl(file) || isCollada(file) || file.toLowerCase(Locale.ROOT).endsWith(".obj");
    }

    /** Whether a name has the ending of COLLADA, whose files tell their unit and axes. */
    public static boolean isCollada(String file) {
        return file.toLowerCase(Locale.ROOT).endsWith(".dae");
    }

    private static boolean isStl(String file) {
        return file.toLowerCase(Locale.ROOT).endsWith(".stl");
    }

    /**
     * Reads the surface of a file, in the format given by the ending of its name; OBJ if that is unknown. An OBJ file's
     * materials are read too.
     */
    public static MeshObject read(Path file, double scale, TextureFiles textures) throws FileProblem {
        if (isCollada(file.toString())) {
            return read(file, scale, ColladaSurface::read);
        }
        return isStl(file.toString()) ? read(file, scale, StlSurface::read) : readObj(file, scale, textures);
    }

    /**
     * Reads a part of a file along the axes of its coordinates: of COLLADA a node or a geometry, of OBJ an object or a group,
     * of STL a solid.
     *
     * @param part its name
     */
    public static MeshObject readPart(Path file, String part, TextureFiles textures) throws FileProblem {
        if (isCollada(file.toString())) {
            return read(file, 1, (in, source, scale) -> ColladaSurface.readInItsAxes(in, source, part));
        }
        Path folder = file.toAbsolutePath().resolveSibling("");
        MeshObject read = isStl(file.toString())
                ? read(file, 1, (in, source, scale) -> StlSurface.read(in, source, scale, part))
                : read(file, 1, (in, source, scale) -> ObjSurface.read(in, source, scale, folder, textures, part));
        return used(read);
    }

    /** A mesh without the vertices that no face uses. */
    private static MeshObject used(MeshObject mesh) {
        int[] places = new int[mesh.vertices().size()]; // 1 more than the new index; 0 for those that are not used
        List<Point> vertices = new ArrayList<>();
        int[][] faces = mesh.faces();
        for (int[] face : faces) {
            for (int k = 0; k < face.length; k++) {
                int corner = face[k];
                if (places[corner] == 0) {
                    vertices.add(mesh.vertices().get(corner));
                    places[corner] = vertices.size();
                }
                face[k] = places[corner] - 1;
            }
        }
        return new MeshObject(vertices, faces)
                .withTextureCoordinates(mesh.textureCoordinates())
                .withMaterial(mesh.material());
    }

    /** Reads an OBJ file and its materials. */
    public static MeshObject readObj(Path file, double scale, TextureFiles textures) throws FileProblem {
        Path folder = file.toAbsolutePath().resolveSibling("");
        return read(file, scale, (in, source, scaled) -> ObjSurface.read(in, source, scaled, folder, textures, null));
    }

    /** A mesh without the texture coordinates that its material has no use for. */
    public static MeshObject trimmed(MeshObject mesh) {
        return mesh.material().texture() instanceof ImageTexture ? mesh : mesh.withTextureCoordinates(null);
    }

    public static MeshObject read(Path file, double scale, Format format) throws FileProblem {
        try (InputStream in = RegularFile.open(file)) {
            return format.read(in, file.toString(), scale);
        } catch (IOException e) {
            throw FileProblem.unreadable(file, e);
        }
    }

    public static void checkScale(double scale) {
        if (!(scale > 0 && scale <= 0x1p100)) { // written so that NaN fails it
            throw new IllegalArgumentException("scale must be a number above 0, up to 2^100 (got: " + scale + ")");
        }
    }
}
