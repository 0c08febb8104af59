package robosim.geometry.world.mesh;

import java.io.InputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.MeshObject;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Numbers;
import robosim.geometry.world.shared.TextureFiles;

/**
 * The surface of a COLLADA file: the meshes that its visual scene shows, each where its nodes put it, in metres. Equal
 * vertices are joined. Cameras, lights, animations and physics are ignored, and skins are in their bind shape.
 */
public final class ColladaSurface {
    private final ColladaParser file;

    /** The name of the node or geometry that is wanted; null for all. */
    private final @Nullable String part;

    private final ColladaMaterials materials;
    private final Map<ColladaElement, JoinedFaces.Part> meshes = new HashMap<>();
    private final Map<ColladaElement, Boolean> shown = new HashMap<>();
    private final JoinedFaces joined = new JoinedFaces();
    private int visits;

    private ColladaSurface(ColladaParser file, @Nullable String part, @Nullable Pictures pictures) {
        this.file = file;
        this.part = part;
        materials = new ColladaMaterials(file, pictures);
    }

    /**
     * Reads a mesh with Y up from a stream, which is left open.
     *
     * @param scale    world units for each metre
     * @param pictures where its pictures are; null to read none
     */
    public static MeshObject read(InputStream in, String source, double scale, @Nullable Pictures pictures)
            throws FileProblem {
        ColladaParser file = ColladaParser.read(in, source);
        return new ColladaSurface(file, null, pictures).read(source, file.upAxis(), scale);
    }

    /**
     * Reads a mesh in metres and along the axes of its coordinates, whichever of them the file says is up: simulators
     * ignore that, and models are made for them.
     *
     * @param part     the name or id of the nodes or geometries to read; null for all
     * @param pictures where its pictures are; null to read none
     */
    public static MeshObject readInItsAxes(
            InputStream in, String source, @Nullable String part, @Nullable Pictures pictures) throws FileProblem {
        return new ColladaSurface(ColladaParser.read(in, source), part, pictures).read(source, "", 1);
    }

    /**
     * Where the pictures of a file are.
     *
     * @param folder that of the file
     */
    public record Pictures(Path folder, TextureFiles files) {}

    private MeshObject read(String source, String upAxis, double scale) throws FileProblem {
        ColladaElement root = file.root();
        show(scene(root), ColladaTransform.upright(upAxis, scale * unit(root)));
        if (joined.size() == 0) {
            throw root.wrong(
                    part == null
                            ? "a COLLADA file must show at least one face in its <visual_scene> (got: none)"
                            : "there is no node or geometry of this name with a face in the <visual_scene> (got: "
                                    + part + ")");
        }
        try {
            return joined.mesh(materials::get);
        } catch (IllegalArgumentException e) {
            throw new FileProblem(source, String.valueOf(e.getMessage()), e);
        }
    }

    /** How many metres one unit of the file has. */
    private static double unit(ColladaElement root) throws FileProblem {
        ColladaElement asset = root.child("asset");
        ColladaElement unit = asset == null ? null : asset.child("unit");
        if (unit == null || unit.attribute("meter").isEmpty()) {
            return 1;
        }
        String given = unit.attribute("meter");
        try {
            double metres = Numbers.parse(given);
            if (metres > 0) {
                return metres;
            }
        } catch (IllegalArgumentException e) {
            throw unit.wrong("meter of <unit>: " + e.getMessage());
        }
        throw unit.wrong("meter of <unit> must be above 0 (got: " + given + ")");
    }

    /** The visual scene of the scene; else the first one. */
    private ColladaElement scene(ColladaElement root) throws FileProblem {
        ColladaElement scene = root.child("scene");
        ColladaElement instance = scene == null ? null : scene.child("instance_visual_scene");
        if (instance != null) {
            return file.referred(instance, "url");
        }
        return root.required("library_visual_scenes").required("visual_scene");
    }

    /** A visual scene or a node that is to be shown. */
    private record Visit(ColladaElement element, AffineTransform place, int depth) {}

    /** Shows a scene with all its nodes, in the order of the file. */
    private void show(ColladaElement scene, AffineTransform place) throws FileProblem {
        List<Visit> waiting = new ArrayList<>(List.of(new Visit(scene, place, 0)));
        while (!waiting.isEmpty()) {
            Visit visit = waiting.remove(waiting.size() - 1);
            FileWork.take(1);
            if (++visits > Limits.MAX_OBJECTS || visit.depth > Limits.MAX_DEPTH) {
                throw visit.element.wrong(
                        "a scene must have at most " + Limits.MAX_OBJECTS + " nodes, nested at most " + Limits.MAX_DEPTH
                                + " deep, instances included, and no node may contain itself; join some, or nest less"
                                + " (got: more)");
            }
            List<Visit> inner = new ArrayList<>();
            visit(visit, inner);
            for (int k = inner.size() - 1; k >= 0; k--) {
                waiting.add(inner.get(k));
            }
        }
    }

    private void visit(Visit visit, List<Visit> inner) throws FileProblem {
        ColladaElement node = visit.element;
        AffineTransform place = visit.place;
        for (ColladaElement child : node.children) {
            if (ColladaTransform.isTransform(child)) {
                place = place.then(ColladaTransform.of(child));
            }
        }
        for (ColladaElement child : node.children) {
            switch (child.name) {
                case "node" -> {
                    // A node that shows nothing, such as the view that SketchUp saves, may have any transform.
                    if (isShown(child)) {
                        inner.add(new Visit(child, place, visit.depth + 1));
                    }
                }
                case "instance_node" -> inner.add(new Visit(expected(child, "url", "node"), place, visit.depth + 1));
                case "instance_geometry" -> geometry(node, child, expected(child, "url", "geometry"), place);
                case "instance_controller" -> controller(node, child, place);
                default -> {} // transforms, and what is no shape
            }
        }
    }

    /** Whether a node, or one within it, may have a surface. */
    private boolean isShown(ColladaElement node) {
        Boolean known = shown.get(node);
        if (known == null) {
            known = false;
            for (ColladaElement child : node.children) {
                known |= child.name.startsWith("instance_") || (child.name.equals("node") && isShown(child));
            }
            shown.put(node, known);
        }
        return known;
    }

    private ColladaElement expected(ColladaElement from, String attribute, String name) throws FileProblem {
        ColladaElement found = file.referred(from, attribute);
        if (!found.name.equals(name)) {
            throw from.wrong("<" + from.name + "> must refer to a <" + name + "> (got: <" + found.name + ">)");
        }
        return found;
    }

    /** A skin in the shape in which it was bound to its skeleton; a morph, which has none, is not shown. */
    private void controller(ColladaElement node, ColladaElement instance, AffineTransform place) throws FileProblem {
        ColladaElement controller = expected(instance, "url", "controller");
        ColladaElement skin = controller.child("skin");
        if (skin == null) {
            return;
        }
        ColladaElement bind = skin.child("bind_shape_matrix");
        AffineTransform bound = bind == null ? place : place.then(ColladaTransform.of(bind));
        geometry(node, instance, expected(skin, "source", "geometry"), bound);
    }

    private boolean isWanted(ColladaElement element) {
        return element.attribute("name").equals(part) || element.attribute("id").equals(part);
    }

    private void geometry(ColladaElement node, ColladaElement instance, ColladaElement geometry, AffineTransform place)
            throws FileProblem {
        ColladaElement mesh = geometry.child("mesh");
        if (mesh == null || (part != null && !isWanted(node) && !isWanted(geometry))) {
            return; // splines and hulls have no mesh
        }
        JoinedFaces.Part known = meshes.get(mesh);
        if (known == null) {
            known = ColladaFaces.read(mesh, file);
            meshes.put(mesh, known);
        }
        if (joined.size() + known.faces().size() > Limits.MAX_FACES) {
            throw geometry.wrong("all meshes of a file together must have at most " + Limits.MAX_FACES
                    + " faces, each instance counted; simplify or split it (got: more)");
        }
        try {
            joined.add(known, place, symbol -> materials.bound(instance, symbol));
        } catch (IllegalArgumentException e) {
            throw geometry.wrong("<geometry>: a vertex, once placed: " + e.getMessage());
        }
    }
}
