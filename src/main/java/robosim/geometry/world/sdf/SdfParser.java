package robosim.geometry.world.sdf;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.SAXException;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.LeftOut;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.xml.ChildNames;
import robosim.geometry.world.xml.SafeXml;
import robosim.geometry.world.xml.XmlHandler;

/** Parses an SDFormat file into elements: those relevant to solid geometry, and counts of the others. */
public final class SdfParser extends XmlHandler {
    private static final int FIRST_VERSION = 0;
    private static final int LAST_VERSION = 12;

    /** The elements whose text is kept; from update_rate on, those of sensors and their noise. */
    private static final Set<String> WITH_TEXT = ChildNames.words("""
            pose deleted static uri name placement_frame child size radius length normal pos radii
            sampling point height center scale diffuse emissive shininess specular
            update_rate samples resolution min_angle max_angle min max near far horizontal_fov width
            type mean stddev bias_mean fx fy cx cy s p_fx p_fy p_cx p_cy tx ty k1 k2 k3 p1 p2
            albedo_map metalness roughness intensity direction cast_shadows light_on constant linear quadratic light_range outer_angle ambient background shadows
            bias_stddev precision dynamic_bias_stddev dynamic_bias_correlation_time
            """);

    private final SdfFile file;
    private @Nullable SdfElement root;

    /** The open elements that are kept, from the root. */
    private final Deque<SdfElement> open = new ArrayDeque<>();

    /** The depth of the parser within an element that is not kept. */
    private int outside;

    private int models;
    private final Xacro macros = new Xacro();
    private final List<String> notes = new ArrayList<>();

    private SdfParser(SdfFile file) {
        super(file.shown());
        this.file = file;
    }

    /**
     * Reads the root element of a file: an sdf element of a supported version.
     *
     * @param remarks receives remarks
     */
    static SdfElement read(SdfFile file, Consumer<String> remarks) throws FileProblem {
        SdfParser parser = SafeXml.parseLeniently(file.path(), file.shown(), () -> new SdfParser(file), remarks);
        if (parser.root == null) {
            throw new IllegalStateException("the document has no root");
        }
        parser.macros.report(parser.root);
        parser.notes.forEach(remarks);
        return parser.root;
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
                count();
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
        count();
        SdfElement element = new SdfElement(file, name, line(), column(), attributes(name, attributes));
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
        return WITH_TEXT.contains(element.name);
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
}
