package robosim.geometry.world.mesh;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.xml.SafeXml;

/** Parses a COLLADA file into the elements that the shape of its surface depends on. */
final class ColladaParser extends DefaultHandler {
    private static final Set<String> PRIMITIVES = Set.of("triangles", "polylist", "polygons", "tristrips", "trifans");

    /** By element, the children that are read. */
    private static final Map<String, Set<String>> READ = Map.ofEntries(
            Map.entry(
                    "COLLADA",
                    Set.of(
                            "asset",
                            "library_geometries",
                            "library_controllers",
                            "library_nodes",
                            "library_visual_scenes",
                            "scene")),
            Map.entry("asset", Set.of("unit", "up_axis")),
            Map.entry("library_geometries", Set.of("geometry")),
            Map.entry("geometry", Set.of("mesh")),
            Map.entry(
                    "mesh", Set.of("source", "vertices", "triangles", "polylist", "polygons", "tristrips", "trifans")),
            Map.entry("source", Set.of("float_array", "technique_common")),
            Map.entry("technique_common", Set.of("accessor")),
            Map.entry("vertices", Set.of("input")),
            Map.entry("library_controllers", Set.of("controller")),
            Map.entry("controller", Set.of("skin")),
            Map.entry("skin", Set.of("bind_shape_matrix")),
            Map.entry("library_nodes", Set.of("node")),
            Map.entry("library_visual_scenes", Set.of("visual_scene")),
            Map.entry("visual_scene", Set.of("node")),
            Map.entry(
                    "node",
                    Set.of(
                            "node",
                            "matrix",
                            "translate",
                            "rotate",
                            "scale",
                            "lookat",
                            "skew",
                            "instance_geometry",
                            "instance_controller",
                            "instance_node")),
            Map.entry("scene", Set.of("instance_visual_scene")));

    private static final Set<String> OF_PRIMITIVES = Set.of("input", "p", "ph", "vcount");
    private static final Set<String> NUMBERS = Set.of(
            "float_array",
            "p",
            "vcount",
            "matrix",
            "translate",
            "rotate",
            "scale",
            "bind_shape_matrix",
            "lookat",
            "skew");

    private final String source;
    private final Deque<ColladaElement> open = new ArrayDeque<>();
    private final Map<String, ColladaElement> byId = new HashMap<>();
    private final StringBuilder upAxis = new StringBuilder();
    private @Nullable Locator locator;
    private @Nullable ColladaElement root;

    /** The depth of the parser within an element that is not kept. */
    private int outside;

    private int elements;
    private int numbers;

    private ColladaParser(String source) {
        this.source = source;
    }

    /** Reads a stream, which is left open. */
    static ColladaParser read(InputStream in, String source) throws FileProblem {
        ColladaParser parser = new ColladaParser(source);
        try {
            SafeXml.parse(new BufferedInputStream(in), source, parser);
        } catch (SAXException e) {
            if (e.getException() instanceof FileProblem refusal) {
                throw refusal;
            }
            throw new FileProblem(source, parser.line(), 0, "the XML was refused: " + e, e);
        } catch (FileProblem e) {
            throw e;
        } catch (IOException e) {
            throw new FileProblem(source, parser.line(), 0, "the file could not be read: " + e.getMessage(), e);
        }
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

    private int line() {
        return locator == null ? 0 : locator.getLineNumber();
    }

    @Override
    public void setDocumentLocator(Locator given) {
        locator = given;
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
        } else if (isRead(parent.name, plain)) {
            parent.children.add(keep(plain, attributes));
        } else {
            outside = 1;
        }
    }

    private static boolean isRead(String parent, String name) {
        return PRIMITIVES.contains(parent)
                ? OF_PRIMITIVES.contains(name)
                : READ.getOrDefault(parent, Set.of()).contains(name);
    }

    private ColladaElement keep(String name, Attributes attributes) throws SAXException {
        if (++elements > Limits.MAX_ELEMENTS) {
            throw refusal("a file must have at most " + Limits.MAX_ELEMENTS
                    + " relevant elements; split it in several files (got: more)");
        }
        Map<String, String> values = attributes.getLength() == 0 ? Map.of() : new HashMap<>();
        for (int k = 0; k < attributes.getLength(); k++) {
            String value = attributes.getValue(k);
            if (value.length() > Limits.MAX_ATTRIBUTE) {
                throw refusal(attributes.getQName(k) + " of <" + name + "> must have at most " + Limits.MAX_ATTRIBUTE
                        + " characters; shorten it (got: " + value.length() + ")");
            }
            values.put(attributes.getQName(k), value);
        }
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

    @Override
    public void error(SAXParseException e) throws SAXException {
        fatalError(e);
    }

    @Override
    public void fatalError(SAXParseException e) throws SAXException {
        throw new SAXException(SafeXml.refusal(source, e));
    }

    @Override
    public InputSource resolveEntity(@Nullable String publicId, @Nullable String systemId) throws SAXException {
        throw refusal("external entities are not allowed; remove the reference (got: " + systemId + ")");
    }

    private SAXException refusal(String problem) {
        return new SAXException(new FileProblem(source, line(), 0, problem));
    }
}
