package robosim.geometry.world.mesh;

import java.io.BufferedInputStream;
import java.io.InputStream;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.SAXException;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.xml.ChildNames;
import robosim.geometry.world.xml.SafeXml;
import robosim.geometry.world.xml.XmlHandler;

/** Parses a COLLADA file into the elements that the shape of its surface depends on. */
final class ColladaParser extends XmlHandler {
    /** By element, the children that are read. */
    private static final ChildNames READ = new ChildNames("""
            COLLADA: asset library_geometries library_controllers library_nodes library_visual_scenes scene
            COLLADA: library_materials library_effects library_images
            library_materials: material
            material: instance_effect
            library_effects: effect
            effect: profile_COMMON newparam
            profile_COMMON: newparam technique
            newparam: surface sampler2D
            surface: init_from
            sampler2D: source
            technique: phong lambert blinn constant
            phong lambert blinn constant: emission diffuse specular shininess
            emission diffuse specular: color texture
            shininess: float
            library_images: image
            image: init_from
            init_from: ref
            instance_geometry instance_controller: bind_material
            bind_material: technique_common
            technique_common: instance_material
            asset: unit up_axis
            library_geometries: geometry
            geometry: mesh
            mesh: source vertices triangles polylist polygons tristrips trifans
            source: float_array technique_common
            technique_common: accessor
            vertices: input
            library_controllers: controller
            controller: skin
            skin: bind_shape_matrix
            library_nodes visual_scene: node
            library_visual_scenes: visual_scene
            node: node matrix translate rotate scale lookat skew instance_geometry instance_controller instance_node
            scene: instance_visual_scene
            triangles polylist polygons tristrips trifans: input p ph vcount
            """);

    private static final Set<String> NUMBERS = ChildNames.words(
            "float_array p vcount matrix translate rotate scale bind_shape_matrix lookat skew color float");

    /** The elements whose text is kept. */
    private static final Set<String> TEXTS = ChildNames.words("init_from source ref");

    private final String source;
    private final Deque<ColladaElement> open = new ArrayDeque<>();
    private final Map<String, ColladaElement> byId = new HashMap<>();
    private final StringBuilder upAxis = new StringBuilder();
    private @Nullable ColladaElement root;

    /** The depth of the parser within an element that is not kept. */
    private int outside;

    private int numbers;

    private ColladaParser(String source) {
        super(source);
        this.source = source;
    }

    /** Reads a stream, which is left open. */
    static ColladaParser read(InputStream in, String source) throws FileProblem {
        ColladaParser parser = new ColladaParser(source);
        SafeXml.parse(new BufferedInputStream(in), source, parser);
        return parser;
    }

    ColladaElement root() {
        if (root == null) {
            throw new IllegalStateException("the document has no root");
        }
        return root;
    }

    /** The axis that points up, as the file names it; empty if it names none. */
    String upAxis() {
        return upAxis.toString().strip();
    }

    /** The element of an id; null if there is none. */
    @Nullable
    ColladaElement found(String id) {
        return byId.get(id);
    }

    /** The element that a reference names; only those within the file are followed. */
    ColladaElement referred(ColladaElement from, String attribute) throws FileProblem {
        String reference = from.attribute(attribute);
        ColladaElement found = reference.startsWith("#") ? byId.get(reference.substring(1)) : null;
        if (found == null) {
            throw from.wrong("<" + from.name + "> must refer to an element of this file, as in " + attribute
                    + "=\"#id\" (got: " + (reference.isEmpty() ? "none" : reference) + ")");
        }
        return found;
    }

    @Override
    public void startElement(String uri, String local, String name, Attributes attributes) throws SAXException {
        if (outside > 0) {
            outside++;
            return;
        }
        // Files may write the names with a prefix.
        String plain = local.isEmpty() ? name : local;
        ColladaElement parent = open.peek();
        if (parent == null) {
            if (!plain.equals("COLLADA")) {
                throw refusal("the root of COLLADA must be <COLLADA> (got: <" + plain + ">)");
            }
            root = keep(plain, attributes);
        } else if (READ.of(parent.name).contains(plain)) {
            parent.children.add(keep(plain, attributes));
        } else {
            outside = 1;
        }
    }

    private ColladaElement keep(String name, Attributes attributes) throws SAXException {
        count();
        Map<String, String> values = attributes(name, attributes);
        ColladaElement element = new ColladaElement(source, name, line(), values);
        String id = values.get("id");
        if (id != null) {
            byId.putIfAbsent(id, element);
        }
        open.push(element);
        return element;
    }

    @Override
    public void characters(char[] text, int start, int length) throws SAXException {
        ColladaElement element = open.peek();
        if (outside > 0 || element == null) {
            return;
        }
        if (NUMBERS.contains(element.name)) {
            numbers += element.add(text, start, length);
            if (numbers > Limits.MAX_NUMBERS) {
                throw refusal("a file must have at most " + Limits.MAX_NUMBERS
                        + " numbers; simplify or split the mesh (got: more)");
            }
        } else if (TEXTS.contains(element.name) && element.text.length() + length <= Limits.MAX_ATTRIBUTE) {
            element.text.append(text, start, length);
        } else if (element.name.equals("up_axis") && upAxis.length() + length <= Limits.MAX_ATTRIBUTE) {
            upAxis.append(text, start, length);
        }
    }

    @Override
    public void endElement(String uri, String local, String name) {
        if (outside > 0) {
            outside--;
            return;
        }
        open.pop().end();
    }
}
