package robosim.geometry.world.mesh;

import java.io.InputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.Folder;
import robosim.geometry.world.shared.LimitProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.TextureFiles;

/**
 * The surface of a glTF file: the meshes that its scene shows, each where its nodes put it, in metres and with Y up, as the
 * format has it. Equal vertices are joined. Cameras, animations, skins and morph targets are ignored; what cannot be read is
 * left out by its path in the file.
 */
final class GltfSurface {
    private static final int TRIANGLES = 4;
    private static final int STRIP = 5;
    private static final int FAN = 6;

    private static final String DRACO = "KHR_draco_mesh_compression";
    private static final String INSTANCING = "EXT_mesh_gpu_instancing";

    /** Extensions that change no shape, or whose parts are judged one by one. */
    private static final Pattern KNOWN = Pattern.compile(DRACO + "|" + INSTANCING
            + "|KHR_mesh_quantization|(EXT|KHR)_meshopt_compression|KHR_materials_.*|(KHR|EXT|MSFT)_texture_.*"
            + "|KHR_lights_.*|EXT_lights_.*|KHR_xmp.*|KHR_animation_.*|KHR_techniques_.*");

    private final GltfFile file;
    private final Path path;
    private final TextureFiles leftOut;

    /** The name of the node or mesh that is wanted; null for all. */
    private final @Nullable String part;

    private final Map<Integer, List<Shape>> meshes = new HashMap<>();
    private final JoinedFaces joined = new JoinedFaces();
    private long numbers;

    /** Why the first part that was left out is missing. */
    private @Nullable FileProblem first;

    /** A primitive of a mesh. */
    private record Shape(GltfPart from, JoinedFaces.Part part) {}

    private GltfSurface(GltfFile file, Path path, @Nullable String part, TextureFiles leftOut) {
        this.file = file;
        this.path = path;
        this.part = part;
        this.leftOut = leftOut;
    }

    /**
     * Reads a mesh from a stream, which is left open.
     *
     * @param folder  that of the files of its buffers
     * @param part    the name of the nodes or meshes to read; null for all
     * @param leftOut receives the parts that cannot be read, or refuses the file
     */
    static MeshObject read(
            InputStream in, Path path, Path folder, double scale, @Nullable String part, TextureFiles leftOut)
            throws FileProblem {
        GltfFile file = new GltfFile(in, path.toString(), folder);
        return new GltfSurface(file, path, part, leftOut).read(scale);
    }

    private MeshObject read(double scale) throws FileProblem {
        for (String required : file.root.texts("extensionsRequired")) {
            if (!KNOWN.matcher(required).matches()) {
                leaveOut(
                        "extension " + required,
                        problem("it is not supported, so what it adds or changes is missing; save the file without"
                                + " it"));
            }
        }
        show(AffineTransform.scaled(scale, scale, scale));
        if (joined.size() == 0 && first != null) {
            throw problem("nothing in its scene can be read: " + first.problem());
        }
        if (joined.size() == 0) {
            throw problem(
                    part == null
                            ? "the scene of a glTF file must show at least one triangle (got: none)"
                            : "there is no node or mesh of this name with a triangle in the scene (got: " + part + ")");
        }
        try {
            return joined.mesh(this::material);
        } catch (IllegalArgumentException e) {
            throw new FileProblem(path.toString(), String.valueOf(e.getMessage()), e);
        }
    }

    private FileProblem problem(String text) {
        return new FileProblem(path.toString(), text);
    }

    private void leaveOut(String what, FileProblem why) throws FileProblem {
        if (why instanceof LimitProblem) {
            throw why;
        }
        first = first == null ? problem(what + ": " + why.problem()) : first;
        leftOut.leaveOut(path, 0, what, why.problem(), why);
    }

    /** The nodes of the scene; without scenes those that are in no other. */
    private int[] roots() throws FileProblem {
        if (file.root.size("scenes") > 0) {
            return file.root.item("scenes", file.root.whole("scene", 0)).indices("nodes");
        }
        int count = file.root.size("nodes");
        boolean[] isInner = new boolean[count];
        for (int k = 0; k < count; k++) {
            for (int child : file.root.item("nodes", k).indices("children")) {
                if (child < count) {
                    isInner[child] = true;
                }
            }
        }
        int[] roots = new int[count];
        int found = 0;
        for (int k = 0; k < count; k++) {
            if (!isInner[k]) {
                roots[found++] = k;
            }
        }
        return Arrays.copyOf(roots, found);
    }

    /** A node that is to be shown. */
    private record Visit(int node, AffineTransform place, int depth) {}

    private void show(AffineTransform place) throws FileProblem {
        List<Visit> waiting = new ArrayList<>();
        push(waiting, roots(), place, 0);
        int visits = 0;
        while (!waiting.isEmpty()) {
            Visit visit = waiting.remove(waiting.size() - 1);
            FileWork.take(1);
            if (++visits > Limits.MAX_OBJECTS || visit.depth > Limits.MAX_DEPTH) {
                throw new LimitProblem(
                        path.toString(),
                        0,
                        0,
                        "a scene must have at most " + Limits.MAX_OBJECTS + " nodes, nested at most " + Limits.MAX_DEPTH
                                + " deep, and no node may contain itself; join some, or nest less (got: more)");
            }
            try {
                GltfPart node = file.root.item("nodes", visit.node);
                AffineTransform at = visit.place.then(transform(node));
                push(waiting, node.indices("children"), at, visit.depth + 1);
                if (node.has("mesh")) {
                    mesh(node, at);
                }
            } catch (FileProblem e) {
                leaveOut("nodes[" + visit.node + "]", e);
            }
        }
    }

    /** In the order of the file. */
    private static void push(List<Visit> waiting, int[] nodes, AffineTransform place, int depth) {
        for (int k = nodes.length - 1; k >= 0; k--) {
            waiting.add(new Visit(nodes[k], place, depth));
        }
    }

    private static AffineTransform transform(GltfPart node) throws FileProblem {
        if (node.has("matrix")) {
            double[] m = node.numbers("matrix", 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1); // column by column
            return new AffineTransform(
                    new double[] {m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14]});
        }
        double[] t = node.numbers("translation", 0, 0, 0);
        double[] r = node.numbers("rotation", 0, 0, 0, 1);
        double[] s = node.numbers("scale", 1, 1, 1);
        try {
            return AffineTransform.moved(t[0], t[1], t[2])
                    .then(AffineTransform.quaternion(r[0], r[1], r[2], r[3]))
                    .then(AffineTransform.scaled(s[0], s[1], s[2]));
        } catch (IllegalArgumentException e) {
            throw node.wrong(String.valueOf(e.getMessage()));
        }
    }

    private void mesh(GltfPart node, AffineTransform place) throws FileProblem {
        GltfPart extensions = node.child("extensions");
        if (extensions != null && extensions.has(INSTANCING)) {
            throw problem("its instances are made by " + INSTANCING
                    + ", which is not supported; save the file without instances");
        }
        int number = node.whole("mesh");
        GltfPart mesh = file.root.item("meshes", number);
        if (part != null
                && !node.text("name").equals(part)
                && !mesh.text("name").equals(part)) {
            return;
        }
        List<Shape> shapes = meshes.get(number);
        if (shapes == null) {
            shapes = shapes(mesh);
            meshes.put(number, shapes);
        }
        for (Shape shape : shapes) {
            if (joined.size() + shape.part.faces().size() > Limits.MAX_FACES) {
                throw new LimitProblem(
                        path.toString(),
                        0,
                        0,
                        "all meshes of a file together must have at most " + Limits.MAX_FACES
                                + " faces, each instance counted; simplify or split it (got: more)");
            }
            try {
                joined.add(shape.part, place, name -> name);
            } catch (IllegalArgumentException e) {
                leaveOut(node.path, problem(shape.from.path + ": a vertex, once placed: " + e.getMessage()));
            }
        }
    }

    private List<Shape> shapes(GltfPart mesh) throws FileProblem {
        List<Shape> shapes = new ArrayList<>();
        for (int k = 0; k < mesh.size("primitives"); k++) {
            try {
                GltfPart primitive = mesh.item("primitives", k);
                int mode = primitive.whole("mode", TRIANGLES);
                if (mode >= TRIANGLES && mode <= FAN) { // not points or lines
                    shapes.add(shape(primitive, mode));
                }
            } catch (FileProblem e) {
                leaveOut(mesh.path + ".primitives[" + k + "]", e);
            }
        }
        return shapes;
    }

    private Shape shape(GltfPart primitive, int mode) throws FileProblem {
        int positions = primitive.required("attributes").whole("POSITION");
        GltfPart extensions = primitive.child("extensions");
        if (extensions != null
                && extensions.has(DRACO)
                && !file.root.item("accessors", positions).has("bufferView")) {
            throw problem(
                    "it is compressed by " + DRACO + ", which is not supported; save the file without compression");
        }
        double[] places = numbers(positions, 3);
        int count = places.length / 3;
        double[] corners = null;
        if (primitive.has("indices")) {
            corners = numbers(primitive.whole("indices"), 1);
            for (double corner : corners) {
                if (!(corner >= 0 && corner < count) || corner != Math.rint(corner)) {
                    throw problem("indices must be below " + count + ", the number of vertices (got: " + corner + ")");
                }
            }
        }
        List<int[]> faces = faces(corners, corners == null ? count : corners.length, mode);
        List<Point> vertices = new ArrayList<>(count);
        try {
            for (int k = 0; k < places.length; k += 3) {
                vertices.add(new Point(places[k], places[k + 1], places[k + 2]));
            }
        } catch (IllegalArgumentException e) {
            throw problem("vertex " + vertices.size() + ": " + e.getMessage());
        }
        double[] points = points(primitive, count);
        List<int[]> textures = new ArrayList<>();
        for (int[] face : faces) {
            textures.add(points.length > 0 ? face.clone() : new int[] {-1, -1, -1});
        }
        String material = primitive.has("material") ? String.valueOf(primitive.whole("material")) : "";
        List<String> materials = Collections.nCopies(faces.size(), material);
        return new Shape(primitive, new JoinedFaces.Part(vertices, faces, textures, points, materials).used());
    }

    /** Two shares of the picture for each vertex, from below; none if they cannot be read, which harms no shape. */
    private double[] points(GltfPart primitive, int count) throws FileProblem {
        GltfPart attributes = primitive.required("attributes");
        if (!attributes.has("TEXCOORD_0")) {
            return new double[0];
        }
        try {
            double[] shares = numbers(attributes.whole("TEXCOORD_0"), 2);
            for (int k = 0; k < shares.length; k++) {
                shares[k] = Checks.coordinate("TEXCOORD_0", k % 2 == 0 ? shares[k] : 1 - shares[k]);
            }
            return shares.length == 2 * count ? shares : new double[0];
        } catch (LimitProblem e) {
            throw e;
        } catch (FileProblem | IllegalArgumentException e) {
            return new double[0];
        }
    }

    private double[] numbers(int accessor, int parts) throws FileProblem {
        numbers += (long) file.root.item("accessors", accessor).whole("count") * parts;
        if (numbers > Limits.MAX_NUMBERS) {
            throw new LimitProblem(
                    path.toString(),
                    0,
                    0,
                    "all primitives together must have at most " + Limits.MAX_NUMBERS
                            + " numbers; simplify or split the mesh (got: more)");
        }
        return GltfAccessor.read(file, accessor, parts);
    }

    private List<int[]> faces(double @Nullable [] corners, int count, int mode) throws FileProblem {
        if (mode == TRIANGLES && count % 3 != 0) {
            throw problem("triangles must have 3 corners each (got: " + count + " corners in all)");
        }
        List<int[]> faces = new ArrayList<>();
        int step = mode == TRIANGLES ? 3 : 1;
        for (int k = 0; k + 2 < count; k += step) {
            FileWork.take(1);
            // Every other triangle of a strip is written the other way round.
            int turned = mode == STRIP ? k % 2 : 0;
            int first = mode == FAN ? 0 : k;
            faces.add(
                    new int[] {corner(corners, first), corner(corners, k + 1 + turned), corner(corners, k + 2 - turned)
                    });
        }
        return faces;
    }

    private static int corner(double @Nullable [] corners, int k) {
        return corners == null ? k : (int) corners[k];
    }

    /**
     * The material of a number; the default for none: the base colour and its picture, what it emits, and how rough and metallic
     * it is. What cannot be read of it is ignored, a picture too, since it costs no shape; the plain colour is seen there.
     */
    private Material material(String number) {
        if (number.isEmpty()) {
            return Material.DEFAULT;
        }
        try {
            GltfPart material = file.root.item("materials", Integer.parseInt(number));
            double[] glow = material.numbers("emissiveFactor", 0, 0, 0);
            Material made = Material.DEFAULT.withEmission(color(glow));
            GltfPart surface = material.child("pbrMetallicRoughness");
            return surface == null ? made : material(made, surface);
        } catch (FileProblem e) {
            return Material.DEFAULT;
        }
    }

    private Material material(Material material, GltfPart surface) throws FileProblem {
        double rough = share(surface.number("roughnessFactor", 1));
        double metal = share(surface.number("metallicFactor", 1));
        Material made = MeshFiles.rough(
                material.withColor(color(surface.numbers("baseColorFactor", 1, 1, 1, 1))), rough, metal);
        GltfPart texture = surface.child("baseColorTexture");
        if (texture == null) {
            return made;
        }
        try {
            int image = file.root.item("textures", texture.whole("index")).whole("source");
            GltfPart picture = file.root.item("images", image);
            byte[] bytes = file.picture(picture);
            Path folder = path.toAbsolutePath().resolveSibling("");
            return made.withTexture(
                    bytes == null
                            ? leftOut.read(folder, Folder.decoded(picture.text("uri")))
                            : leftOut.read(path.toAbsolutePath(), "images[" + image + "]", bytes));
        } catch (FileProblem | IllegalArgumentException e) {
            return made;
        }
    }

    /** Of linear components; what is brighter than white is white. */
    private static Color color(double[] linear) {
        return Color.ofLinear(share(linear[0]), share(linear[1]), share(linear[2]));
    }

    private static double share(double number) {
        return Math.min(Math.max(0, number), 1);
    }
}
