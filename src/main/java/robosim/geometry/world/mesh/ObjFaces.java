package robosim.geometry.world.mesh;

import java.util.AbstractList;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileProblem;

/** The faces of a file with their texture coordinates and materials, while they are read, and the mesh of them. */
final class ObjFaces {
    private final List<Point> vertices;
    private final List<int[]> faces = new ArrayList<>();

    /** By corner of all faces, the index of its texture point. */
    private int[] corners = new int[16];

    private int cornerCount;

    /** By face, the index of its material's name. */
    private int[] materials = new int[16];

    private double[] points = new double[16];
    private int pointCount;

    /** The names of materials in use, each with its index. */
    private final Map<String, Integer> names = new LinkedHashMap<>();

    private int material;

    ObjFaces(List<Point> vertices) {
        this.vertices = vertices;
        use("");
    }

    int size() {
        return faces.size();
    }

    int points() {
        return pointCount;
    }

    /** Whether there is a point of that index, whose two numbers are such. */
    boolean hasPoint(int index) {
        return index >= 0 && index < pointCount && !Double.isNaN(points[2 * index] + points[2 * index + 1]);
    }

    /** Adds a texture point; one that is NaN has no use. */
    void point(double u, double v) {
        if (2 * pointCount == points.length) {
            points = Arrays.copyOf(points, 2 * points.length);
        }
        points[2 * pointCount] = u;
        points[2 * pointCount + 1] = v;
        pointCount++;
    }

    /** Says what the next faces are made of. */
    void use(String name) {
        material = names.computeIfAbsent(name, other -> names.size());
    }

    /**
     * Adds a polygon, cut into faces.
     *
     * @param face    its vertices
     * @param texture the texture point of each of its corners, or {@link TextureCoordinates#NONE}
     */
    void add(int[] face, int[] texture) {
        if (face.length == 3) {
            keep(face, texture);
            return;
        }
        // Cut as corners of its own, since a vertex may occur twice, with two texture points.
        List<Point> places = new AbstractList<>() {
            @Override
            public Point get(int corner) {
                return vertices.get(face[corner]);
            }

            @Override
            public int size() {
                return face.length;
            }
        };
        int[] all = new int[face.length];
        Arrays.setAll(all, k -> k);
        List<int[]> pieces = new ArrayList<>();
        Polygon.cut(places, all, pieces);
        for (int[] piece : pieces) {
            keep(picked(face, piece), picked(texture, piece));
        }
    }

    private static int[] picked(int[] from, int[] indices) {
        int[] picked = new int[indices.length];
        for (int k = 0; k < picked.length; k++) {
            picked[k] = from[indices[k]];
        }
        return picked;
    }

    /** Adds a face of three or four corners as it is. */
    void keep(int[] face, int[] texture) {
        if (faces.size() == materials.length) {
            materials = Arrays.copyOf(materials, 2 * materials.length);
        }
        materials[faces.size()] = material;
        faces.add(face);
        if (cornerCount + texture.length > corners.length) {
            corners = Arrays.copyOf(corners, 2 * corners.length);
        }
        System.arraycopy(texture, 0, corners, cornerCount, texture.length);
        cornerCount += texture.length;
    }

    /** What a name of a file stands for. */
    @FunctionalInterface
    interface Materials {
        Material get(String name) throws FileProblem;
    }

    /** The mesh, with its texture coordinates and its material. */
    MeshObject mesh(@Nullable Materials library) throws FileProblem {
        MeshObject mesh = new MeshObject(vertices, faces.toArray(int[][]::new));
        int[] uses = new int[names.size()];
        for (int f = 0; f < faces.size(); f++) {
            uses[materials[f]]++;
        }
        List<Material> found = new ArrayList<>();
        Material most = Material.DEFAULT;
        Material mostPictured = null;
        int mostUses = 0;
        int mostPicturedUses = 0;
        Set<Color> colors = new LinkedHashSet<>();
        for (Map.Entry<String, Integer> name : names.entrySet()) {
            int count = uses[name.getValue()];
            Material made = library == null || count == 0 ? Material.DEFAULT : library.get(name.getKey());
            found.add(made);
            if (count > mostPicturedUses && made.texture() != null) {
                mostPictured = made;
                mostPicturedUses = count;
            }
            if (count > mostUses && made.texture() == null) {
                most = made;
                mostUses = count;
            }
            if (count > 0) {
                colors.add(made.color());
            }
        }
        if (mostPictured != null) {
            return pictured(mesh, mostPictured, mostUses == 0 ? mostPictured.color() : most.color(), found);
        }
        return colors.size() > 1
                ? painted(mesh, most, new ArrayList<>(colors), found)
                : plain(mesh).withMaterial(most);
    }

    private MeshObject plain(MeshObject mesh) {
        for (int k = 0; k < cornerCount; k++) {
            if (corners[k] != TextureCoordinates.NONE) {
                return mesh.withTextureCoordinates(coordinates(corners));
            }
        }
        return mesh;
    }

    private TextureCoordinates coordinates(int[] ofCorners) {
        double[] used = Arrays.copyOf(points, 2 * pointCount);
        for (int k = 0; k < used.length; k++) {
            used[k] = Double.isNaN(used[k]) ? 0 : used[k];
        }
        return new TextureCoordinates(used, Arrays.copyOf(ofCorners, cornerCount));
    }

    /** One picture; the faces of other materials have a plain colour. */
    private MeshObject pictured(MeshObject mesh, Material picture, Color other, List<Material> found) {
        int[] ofCorners = corners.clone();
        int at = 0;
        for (int f = 0; f < faces.size(); f++) {
            int next = at + faces.get(f).length;
            if (!found.get(materials[f]).equals(picture)) {
                Arrays.fill(ofCorners, at, next, TextureCoordinates.NONE);
            }
            at = next;
        }
        return mesh.withTextureCoordinates(coordinates(ofCorners)).withMaterial(picture.withColor(other));
    }

    /** A palette as a picture, a pixel for each colour, with each face in the middle of one. */
    private MeshObject painted(MeshObject mesh, Material most, List<Color> colors, List<Material> found) {
        Map<Color, Integer> indices = new HashMap<>();
        int[] pixels = new int[colors.size()];
        double[] middles = new double[2 * pixels.length];
        for (int k = 0; k < pixels.length; k++) {
            indices.put(colors.get(k), k);
            pixels[k] = colors.get(k).packed();
            middles[2 * k] = (k + 0.5) / pixels.length;
            middles[2 * k + 1] = 0.5;
        }
        int[] ofCorners = new int[cornerCount];
        int at = 0;
        for (int f = 0; f < faces.size(); f++) {
            int next = at + faces.get(f).length;
            Arrays.fill(
                    ofCorners,
                    at,
                    next,
                    indices.getOrDefault(found.get(materials[f]).color(), 0));
            at = next;
        }
        return mesh.withTextureCoordinates(new TextureCoordinates(middles, ofCorners))
                .withMaterial(most.withTexture(new ImageTexture(pixels.length, 1, pixels, 1, 1)));
    }
}
