package robosim.geometry.world.sdf;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
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

/**
 * Parses a URDF file into the elements of an SDFormat file with one model: its links, each where its joint at rest puts
 * it, and their collisions.
 */
final class UrdfParser extends DefaultHandler {
    private static final Map<String, Set<String>> READ = Map.of(
            "robot", Set.of("link", "joint"),
            "link", Set.of("collision"),
            "collision", Set.of("origin", "geometry"),
            "geometry", Set.of("box", "cylinder", "sphere", "capsule", "mesh"),
            "joint", Set.of("origin", "parent", "child"));

    private final SdfFile file;
    private final Deque<SdfElement> open = new ArrayDeque<>();
    private @Nullable Locator locator;
    private @Nullable SdfElement robot;
    private int outside;
    private int count;
    private final Xacro macros = new Xacro();

    private UrdfParser(SdfFile file) {
        this.file = file;
    }

    /** Whether a file's name has the ending of URDF. */
    static boolean isNamed(SdfFile file) {
        return file.path().toString().endsWith(".urdf");
    }

    /**
     * Reads a file as the root element of SDFormat.
     *
     * @param remarks receives remarks
     */
    static SdfElement read(SdfFile file, Consumer<String> remarks) throws FileProblem {
        UrdfParser parser;
        try {
            parser = SafeXml.parseLeniently(file.path(), file.shown(), () -> new UrdfParser(file), remarks);
        } catch (SAXException e) {
            if (e.getException() instanceof FileProblem refusal) {
                throw refusal;
            }
            throw new FileProblem(file.shown(), 0, 0, "the XML was refused: " + e, e);
        } catch (IOException e) {
            throw FileProblem.unreadable(file.path(), e);
        }
        if (parser.robot == null) {
            throw new IllegalStateException("the document has no root");
        }
        parser.macros.report(parser.robot);
        return parser.model(parser.robot);
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
        SdfElement parent = open.peek();
        if (outside > 0
                || (parent != null && !READ.getOrDefault(parent.name, Set.of()).contains(name))) {
            if (outside++ == 0 && parent != null) {
                passOver(parent, name);
            }
            return;
        }
        if (parent == null && !name.equals("robot")) {
            throw refusal("the root of URDF must be <robot> (got: <" + name + ">)");
        }
        bounded();
        Map<String, String> values = new TreeMap<>();
        for (int k = 0; k < attributes.getLength(); k++) {
            if (attributes.getValue(k).length() > Limits.MAX_ATTRIBUTE) {
                throw refusal(attributes.getQName(k) + " of <" + name + "> must have at most " + Limits.MAX_ATTRIBUTE
                        + " characters (got: " + attributes.getValue(k).length() + ")");
            }
            values.put(attributes.getQName(k), attributes.getValue(k));
        }
        SdfElement element = new SdfElement(file, name, line(), 0, values);
        if (parent == null) {
            robot = element;
        } else {
            parent.children.add(element);
        }
        open.push(element);
        SdfOld.complete(element); // which wrote sizes as URDF does
    }

    private void passOver(SdfElement parent, String name) throws SAXException {
        if (Xacro.isMacro(name)) {
            macros.add(file, line(), name);
        } else if (!parent.name.equals("geometry")) {
            parent.passedOver.merge(name, 1, Integer::sum);
        } else {
            bounded();
            parent.skipped.add(
                    new LeftOut(file.shown(), line(), "<" + name + ">", "URDF has no such shape; check the spelling"));
        }
    }

    private void bounded() throws SAXException {
        if (++count > Limits.MAX_ELEMENTS) {
            throw refusal("a file must have at most " + Limits.MAX_ELEMENTS + " relevant elements (got: more)");
        }
    }

    @Override
    public void endElement(String uri, String local, String name) {
        if (outside > 0) {
            outside--;
        } else {
            open.pop();
        }
    }

    /** The robot as SDFormat. */
    private SdfElement model(SdfElement given) {
        SdfElement root = element(given, "sdf", Map.of());
        String name = given.attribute("name");
        SdfElement model = element(given, "model", Map.of("name", name.isEmpty() ? "robot" : name));
        root.children.add(model);
        model.passedOver.putAll(given.passedOver);
        model.skipped.addAll(given.skipped);
        Map<String, SdfElement> joints = new HashMap<>();
        for (SdfElement joint : given.children) {
            SdfElement child = joint.name.equals("joint") ? joint.child("child") : null;
            if (joint.name.equals("joint")) {
                model.passedOver.merge("joint", 1, Integer::sum);
            }
            SdfElement other = child == null ? null : joints.putIfAbsent(child.attribute("link"), joint);
            if (other != null) {
                model.skipped.add(new LeftOut(
                        file.shown(),
                        joint.line,
                        joint.tag(),
                        "the joint in line " + other.line + " places the same link"));
            }
        }
        for (SdfElement link : given.children) {
            if (link.name.equals("link")) {
                model.children.add(link(link, joints.get(link.attribute("name"))));
            }
        }
        return root;
    }

    private SdfElement link(SdfElement given, @Nullable SdfElement joint) {
        SdfElement link = element(given, "link", given.attributes);
        link.passedOver.putAll(given.passedOver);
        link.skipped.addAll(given.skipped);
        SdfElement parent = joint == null ? null : joint.child("parent");
        if (joint != null && parent != null) {
            link.children.add(pose(joint, parent.attribute("link")));
        }
        int collisions = 0;
        for (SdfElement each : given.children) {
            collisions++;
            String name = each.attribute("name");
            String other = collisions == 1 ? "collision" : "collision_" + collisions;
            SdfElement collision = element(each, "collision", Map.of("name", name.isEmpty() ? other : name));
            collision.skipped.addAll(each.skipped);
            collision.children.add(pose(each, ""));
            for (SdfElement shape : each.children) {
                if (shape.name.equals("geometry")) {
                    collision.children.add(shape);
                }
            }
            link.children.add(collision);
        }
        return link;
    }

    /** The origin of an element as a pose: both are x y z, and angles about the fixed X, then Y, then Z. */
    private SdfElement pose(SdfElement owner, String relativeTo) {
        SdfElement origin = owner.child("origin");
        SdfElement place = origin == null ? owner : origin;
        SdfElement pose = element(place, "pose", relativeTo.isEmpty() ? Map.of() : Map.of("relative_to", relativeTo));
        if (origin != null) {
            String xyz = origin.attribute("xyz");
            String rpy = origin.attribute("rpy");
            pose.text.append(xyz.isEmpty() ? "0 0 0" : xyz).append(' ').append(rpy.isEmpty() ? "0 0 0" : rpy);
        }
        return pose;
    }

    private SdfElement element(SdfElement place, String name, Map<String, String> attributes) {
        return new SdfElement(file, name, place.line, 0, attributes);
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
        return new SAXException(new FileProblem(file.shown(), line(), 0, problem));
    }
}
