package robosim.geometry.world.sdf;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.LeftOut;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.xml.SafeXml;

/** Parses an SDFormat file into elements: those relevant to solid geometry, and counts of the others. */
public final class SdfParser extends DefaultHandler {
    private static final int FIRST_VERSION = 0;
    private static final int LAST_VERSION = 12;

    private final SdfFile file;
    private @Nullable Locator locator;
    private @Nullable SdfElement root;

    /** The open elements that are kept, from the root. */
    private final Deque<SdfElement> open = new ArrayDeque<>();

    /** The depth of the parser within an element that is not kept. */
    private int outside;

    private int count;
    private int models;
    private final Xacro macros = new Xacro();
    private final List<String> notes = new ArrayList<>();

    private SdfParser(SdfFile file) {
        this.file = file;
    }

    /**
     * Reads the root element of a file: an sdf element of a supported version.
     *
     * @param remarks receives remarks
     */
    static SdfElement read(SdfFile file, Consumer<String> remarks) throws FileProblem {
        SdfParser parser;
        try {
            parser = SafeXml.parseLeniently(file.path(), file.shown(), () -> new SdfParser(file), remarks);
        } catch (SAXException e) {
            if (e.getException() instanceof FileProblem refusal) {
                throw refusal;
            }
            throw new FileProblem(file.shown(), 0, 0, "the XML was refused: " + e, e);
        } catch (IOException e) {
            throw FileProblem.unreadable(file.path(), e);
        }
        if (parser.root == null) {
            throw new IllegalStateException("the document has no root");
        }
        parser.macros.report(parser.root);
        parser.notes.forEach(remarks);
        return parser.root;
    }

    private int line() {
        return locator == null ? 0 : locator.getLineNumber();
    }

    private int column() {
        return locator == null ? 0 : locator.getColumnNumber();
    }

    @Override
    public void setDocumentLocator(Locator given) {
        locator = given;
    }

    @Override
    public void startElement(String uri, String local, String written, Attributes attributes) throws SAXException {
        if (outside > 0) {
            outside++;
            return;
        }
        SdfElement parent = open.peek();
        String name = parent == null ? written : SdfNames.kept(parent.name, written);
        if (parent == null) {
            root = keep(null, name.equals("gazebo") ? "sdf" : name, attributes);
            checkRoot(root);
        } else if (name.equals("origin")
                && attributes.getValue("pose") != null
                && SdfNames.isRead(parent.name, "pose")) {
            SdfElement pose = keep(parent, "pose", attributes);
            pose.text.append(pose.attribute("pose"));
        } else if (SdfNames.isRead(parent.name, name)) {
            keep(parent, name, attributes);
            passOver(parent, name);
        } else {
            outside = 1;
            if (Xacro.isMacro(name)) {
                macros.add(file, line(), "<" + name + ">");
            } else if (!passOver(parent, name)) {
                bounded();
                parent.skipped.add(
                        new LeftOut(file.shown(), line(), tag(name, attributes), SdfNames.reason(parent.name, name)));
            }
        }
    }

    /** Counts an element that is irrelevant to solid geometry; answers whether it is. */
    private static boolean passOver(SdfElement parent, String name) {
        boolean isPassedOver = SdfNames.isPassedOver(parent.name, name);
        if (isPassedOver && SdfNames.isCounted(parent.name)) {
            parent.passedOver.merge(name, 1, Integer::sum);
        }
        return isPassedOver;
    }

    private SdfElement keep(@Nullable SdfElement parent, String name, Attributes attributes) throws SAXException {
        bounded();
        Map<String, String> values = attributes.getLength() == 0 ? Map.of() : new TreeMap<>();
        for (int k = 0; k < attributes.getLength(); k++) {
            if (attributes.getValue(k).length() > Limits.MAX_ATTRIBUTE) {
                throw refusal(attributes.getQName(k) + " of <" + name + "> must have at most " + Limits.MAX_ATTRIBUTE
                        + " characters; shorten it (got: "
                        + attributes.getValue(k).length() + ")");
            }
            values.put(attributes.getQName(k), attributes.getValue(k));
        }
        SdfElement element = new SdfElement(file, name, line(), column(), values);
        if (name.equals("model") && ++models > Limits.MAX_GROUPS) {
            throw refusal("models must be nested at most " + Limits.MAX_GROUPS + " deep; nest less (got: one more)");
        }
        if (parent != null) {
            // Otherwise a search for the collisions of a link would go through all of its poses, again for each
            // include.
            if (!SdfNames.isRepeated(name) && parent.child(name) != null) {
                LeftOut second = new LeftOut(
                        file.shown(),
                        line(),
                        element.tag(),
                        "<" + parent.name + "> must have only one <" + name + ">; the first one counts, remove this");
                if (takesText(element)) { // a value, without which nothing is missing
                    notes.add(second.toString());
                } else {
                    parent.skipped.add(second);
                }
            } else {
                parent.children.add(element);
            }
        }
        open.push(element);
        SdfOld.complete(element);
        return element;
    }

    private void bounded() throws SAXException {
        if (++count > Limits.MAX_ELEMENTS) {
            throw refusal("a file must have at most " + Limits.MAX_ELEMENTS
                    + " relevant elements; split it in several files (got: more)");
        }
    }

    private static String tag(String name, Attributes attributes) {
        String given = attributes.getValue("name");
        return "<" + name + ">" + (given == null || given.length() > Limits.MAX_ATTRIBUTE ? "" : " \"" + given + "\"");
    }

    private void checkRoot(SdfElement sdf) throws SAXException {
        if (!sdf.name.equals("sdf") && !sdf.name.equals("gazebo")) {
            throw refusal("the root of SDFormat must be <sdf> (got: <" + sdf.name + ">)");
        }
        String version = sdf.attribute("version");
        int minor = SdfManifest.minor(version);
        if (minor < FIRST_VERSION || minor > LAST_VERSION) {
            throw refusal("version of <sdf> must be 1." + FIRST_VERSION + " to 1." + LAST_VERSION + " (got: "
                    + (version.isEmpty() ? "none" : version) + ")");
        }
    }

    @Override
    public void characters(char[] text, int start, int length) throws SAXException {
        SdfElement element = open.peek();
        if (outside > 0 || element == null) {
            return;
        }
        if (!takesText(element)) {
            return;
        }
        if (element.text.length() + length > Limits.MAX_ATTRIBUTE) {
            throw refusal(
                    "<" + element.name + "> must have at most " + Limits.MAX_ATTRIBUTE + " characters (got: more)");
        }
        element.text.append(text, start, length);
    }

    private static boolean takesText(SdfElement element) {
        return switch (element.name) {
            case "pose",
                    "deleted",
                    "static",
                    "uri",
                    "name",
                    "placement_frame",
                    "child",
                    "size",
                    "radius",
                    "length",
                    "normal",
                    "pos",
                    "radii",
                    "sampling",
                    "point",
                    "height",
                    "center",
                    "scale",
                    "diffuse",
                    "emissive",
                    "shininess",
                    "specular" -> true;
            // of sensors and their noise
            case "update_rate",
                    "samples",
                    "resolution",
                    "min_angle",
                    "max_angle",
                    "min",
                    "max",
                    "near",
                    "far",
                    "horizontal_fov",
                    "width",
                    "type",
                    "mean",
                    "stddev",
                    "bias_mean",
                    "fx",
                    "fy",
                    "cx",
                    "cy",
                    "s",
                    "p_fx",
                    "p_fy",
                    "p_cx",
                    "p_cy",
                    "tx",
                    "ty",
                    "k1",
                    "k2",
                    "k3",
                    "p1",
                    "p2",
                    "bias_stddev",
                    "precision",
                    "dynamic_bias_stddev",
                    "dynamic_bias_correlation_time" -> true;
            default -> false;
        };
    }

    @Override
    public void endElement(String uri, String local, String name) {
        if (outside > 0) {
            outside--;
            return;
        }
        if (open.pop().name.equals("model")) {
            models--;
        }
    }

    @Override
    public void error(SAXParseException e) throws SAXException {
        fatalError(e);
    }

    @Override
    public void fatalError(SAXParseException e) throws SAXException {
        throw new SAXException(SafeXml.refusal(file.shown(), e));
    }

    @Override
    public InputSource resolveEntity(@Nullable String publicId, @Nullable String systemId) throws SAXException {
        throw refusal("external entities are not allowed; remove the reference (got: " + systemId + ")");
    }

    private SAXException refusal(String problem) {
        return new SAXException(new FileProblem(file.shown(), line(), column(), problem));
    }
}
