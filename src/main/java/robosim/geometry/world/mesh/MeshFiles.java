package robosim.geometry.world.mesh;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileKind;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.RegularFile;
import robosim.geometry.world.shared.TextureFiles;
import robosim.geometry.world.xml.SafeXml;

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

    /** The endings of the names of supported formats, for messages. */
    public static final String ENDINGS = ".obj, .stl, .dae, .ply, .glb or .gltf";

    /** Whether a name has the ending of a supported format. */
    public static boolean isNamed(String file) {
        return switch (ending(file)) {
            case "obj", "stl", "dae", "ply", "glb", "gltf" -> true;
            default -> false;
        };
    }

    private static String ending(String file) {
        return file.substring(file.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
    }

    /** Whether a name has the ending of a format whose files tell their unit and axes: COLLADA and glTF. */
    public static boolean isUpright(String file) {
        return isCollada(file) || isGltf(file);
    }

    private static boolean isGltf(String file) {
        return ending(file).equals("glb") || ending(file).equals("gltf");
    }

    /** Whether a name has the ending of COLLADA. */
    public static boolean isCollada(String file) {
        return ending(file).equals("dae");
    }

    /**
     * Reads the surface of a file with Y up, in the format given by the ending of its name; OBJ if that is unknown. An OBJ
     * file's materials are read too.
     */
    public static MeshObject read(Path file, double scale, TextureFiles textures) throws FileProblem {
        return switch (ending(file.toString())) {
            case "dae" ->
                read(
                        file,
                        scale,
                        (in, source, scaled) -> ColladaSurface.read(in, source, scaled, pictures(file, textures)));
            case "stl" -> read(file, scale, StlSurface::read);
            case "ply" -> read(file, scale, PlySurface::read);
            case "glb", "gltf" -> readGltf(file, scale, null, textures);
            default -> readObj(file, scale, textures);
        };
    }

    /** Refuses a name with another ending than those of supported formats. */
    public static void checkNamed(String file) throws FileProblem {
        if (!isNamed(file)) {
            throw new FileProblem(file, "the name of a mesh must end in " + ENDINGS);
        }
    }

    /** Reads the surface of a stream in the format given by the ending of its name; without the files it refers to. */
    public static MeshObject read(InputStream in, String source, double scale) throws FileProblem {
        checkNamed(source);
        return switch (ending(source)) {
            case "dae" -> ColladaSurface.read(in, source, scale, null);
            case "stl" -> StlSurface.read(in, source, scale);
            case "ply" -> PlySurface.read(in, source, scale);
            case "obj" -> ObjSurface.read(in, source, scale);
            default -> throw new FileProblem(source, "glTF must be read from a file, as it refers to others");
        };
    }

    /**
     * Reads a part of a file along the axes of its coordinates: of COLLADA a node or a geometry, of glTF a node or a mesh, of
     * OBJ an object or a group, of STL a solid.
     *
     * @param part its name
     */
    public static MeshObject readPart(Path file, String part, TextureFiles textures) throws FileProblem {
        Path folder = file.toAbsolutePath().resolveSibling("");
        return switch (ending(file.toString())) {
            case "dae" -> readInItsAxes(file, part, textures);
            case "glb", "gltf" -> readGltf(file, 1, part, textures);
            case "ply" -> read(file, 1, (in, source, scale) -> PlySurface.read(in, source, scale, part));
            case "stl" -> used(read(file, 1, (in, source, scale) -> StlSurface.read(in, source, scale, part)));
            default ->
                used(read(file, 1, (in, source, scale) -> ObjSurface.read(in, source, scale, folder, textures, part)));
        };
    }

    /** Reads a COLLADA file along the axes of its coordinates: a part, or all of it if that is null. */
    public static MeshObject readInItsAxes(Path file, @Nullable String part, TextureFiles textures) throws FileProblem {
        return read(
                file,
                1,
                (in, source, scale) -> ColladaSurface.readInItsAxes(in, source, part, pictures(file, textures)));
    }

    private static ColladaSurface.Pictures pictures(Path file, TextureFiles textures) {
        return new ColladaSurface.Pictures(file.toAbsolutePath().resolveSibling(""), textures);
    }

    /** Reads a glTF file and the files of its buffers, which lie below its folder. */
    private static MeshObject readGltf(Path file, double scale, @Nullable String part, TextureFiles textures)
            throws FileProblem {
        Path folder = file.toAbsolutePath().resolveSibling("");
        return read(file, scale, (in, source, scaled) -> GltfSurface.read(in, file, folder, scaled, part, textures));
    }

    /** A mesh without the vertices that no face uses. */
    private static MeshObject used(MeshObject mesh) {
        List<Point> vertices = new ArrayList<>(mesh.vertices());
        int[][] faces = mesh.faces();
        JoinedFaces.dropUnused(vertices, List.of(faces));
        return new MeshObject(vertices, faces)
                .withTextureCoordinates(mesh.textureCoordinates())
                .withMaterial(mesh.material());
    }

    /** Reads an OBJ file and its materials. */
    private static MeshObject readObj(Path file, double scale, TextureFiles textures) throws FileProblem {
        Path folder = file.toAbsolutePath().resolveSibling("");
        return read(file, scale, (in, source, scaled) -> ObjSurface.read(in, source, scaled, folder, textures, null));
    }

    /** A mesh without the texture coordinates that its material has no use for. */
    public static MeshObject trimmed(MeshObject mesh) {
        return mesh.material().texture() instanceof ImageTexture ? mesh : mesh.withTextureCoordinates(null);
    }

    /** Reads a file; COLLADA that is not well-formed XML as Gazebo reads it. */
    public static MeshObject read(Path file, double scale, Format format) throws FileProblem {
        try (InputStream in = RegularFile.open(file)) {
            return format.read(in, file.toString(), scale);
        } catch (FileProblem e) {
            if (FileKind.isPointer(file)) {
                throw new FileProblem(file.toString(), FileKind.POINTER, e);
            }
            if (!SafeXml.isNotWellFormed(e)) {
                throw e;
            }
        } catch (IOException e) {
            throw FileProblem.unreadable(file, e);
        }
        try (InputStream in = SafeXml.mended(RegularFile.open(file))) {
            return format.read(in, file.toString(), scale);
        } catch (IOException e) {
            throw FileProblem.unreadable(file, e);
        }
    }

    /** A material as rough and as metallic: its highlight, and how much of a mirror it is. Both are from 0 to 1. */
    public static Material rough(Material material, double rough, double metal) {
        // The highlight that is as wide: the square of the roughness is the square root of 2 / (n + 2).
        double exponent = rough > 0 ? 2 / (rough * rough * rough * rough) - 2 : Material.MOST_SHININESS;
        Material made = material.withShininess(Math.min(Math.max(1, exponent), Material.MOST_SHININESS))
                .withMirror(metal * (1 - rough));
        return rough >= 1 ? made.withSpecular(0) : made;
    }

    public static void checkScale(double scale) {
        if (!(scale > 0 && scale <= 0x1p100)) { // written so that NaN fails it
            throw new IllegalArgumentException("scale must be a number above 0, up to 2^100 (got: " + scale + ")");
        }
    }
}
