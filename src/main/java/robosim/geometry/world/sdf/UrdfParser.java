package robosim.geometry.world.sdf;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.SAXException;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.LeftOut;
import robosim.geometry.world.shared.Numbers;
import robosim.geometry.world.xml.ChildNames;
import robosim.geometry.world.xml.SafeXml;
import robosim.geometry.world.xml.XmlHandler;

/**
 * Parses a URDF file into the elements of an SDFormat file with one model: its links, each where its joint at rest puts
 * it, and their collisions.
 */
final class UrdfParser extends XmlHandler {
    private static final ChildNames READ = new ChildNames("""
            robot: link joint material
            link: collision visual
            collision: origin geometry
            visual: origin geometry material
            material: color
            geometry: box cylinder sphere capsule mesh
            joint: origin parent child
            """);

    /** The attributes without which a shape has no size. */
    private static final ChildNames NEEDED = new ChildNames("""
            box: size
            cylinder capsule: radius length
            sphere: radius
            mesh: filename
            """);

    /** How many numbers an attribute of a shape has. */
    private static final Map<String, Integer> NUMBERS = Map.of("size", 3, "radius", 1, "length", 1, "scale", 3);

    private final SdfFile file;
    private final Deque<SdfElement> open = new ArrayDeque<>();
    private @Nullable SdfElement robot;
    private int outside;
    private final Xacro macros = new Xacro();

    private UrdfParser(SdfFile file) {
        super(file.shown());
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
        UrdfParser parser = SafeXml.parseLeniently(file.path(), file.shown(), () -> new UrdfParser(file), remarks);
        if (parser.robot == null) {
            throw new IllegalStateException("the document has no root");
        }
        parser.macros.report(parser.robot);
        return parser.model(parser.robot, remarks);
    }

    @Override
    public void startElement(String uri, String local, String name, Attributes attributes) throws SAXException {
        SdfElement parent = open.peek();
        if (outside > 0 || (parent != null && !READ.of(parent.name).contains(name))) {
            if (outside++ == 0 && parent != null) {
                passOver(parent, name);
            }
            return;
        }
        if (parent == null && !name.equals("robot")) {
            throw refusal("the root of URDF must be <robot> (got: <" + name + ">)");
        }
        count();
        Map<String, String> values = attributes(name, attributes);
        values.forEach((key, value) -> {
            if (Xacro.isExpression(value)) {
                macros.add(file, line(), key + "=\"" + value + "\"");
            }
        });
        SdfElement element = new SdfElement(file, name, line(), 0, values);
        if (parent == null) {
            robot = element;
        } else {
            parent.children.add(element);
            if (name.equals("visual") || name.equals("material")) {
                parent.passedOver.merge(name, 1, Integer::sum); // by what is solid
            }
        }
        open.push(element);
        SdfOld.complete(element); // which wrote sizes as URDF does
    }

    private void passOver(SdfElement parent, String name) throws SAXException {
        if (Xacro.isMacro(name)) {
            macros.add(file, line(), "<" + name + ">");
        } else if (!parent.name.equals("geometry")) {
            parent.passedOver.merge(name, 1, Integer::sum);
        } else {
            count();
            parent.skipped.add(
                    new LeftOut(file.shown(), line(), "<" + name + ">", "URDF has no such shape; check the spelling"));
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
    private SdfElement model(SdfElement given, Consumer<String> remarks) {
        SdfElement root = element(given, "sdf", Map.of());
        String name = given.attribute("name");
        SdfElement model = element(given, "model", Map.of("name", name.isEmpty() ? "robot" : name));
        root.children.add(model);
        model.passedOver.putAll(given.passedOver);
        model.skipped.addAll(given.skipped);
        Map<String, SdfElement> joints = joints(given, model);
        int roots = 0;
        for (SdfElement link : given.children) {
            if (link.name.equals("link")) {
                SdfElement joint = joints.get(link.attribute("name"));
                if (joint == null && ++roots > 1) {
                    remarks.accept(file.shown() + ":" + link.line + ": no joint places " + link.tag()
                            + ", so it is at the robot's origin; ROS refuses a robot with more than one such link");
                }
                try {
                    model.children.add(link(link, joint));
                } catch (FileProblem e) {
                    model.skipped.add(new LeftOut(e.source(), e.line(), link.tag(), e.problem()));
                }
            }
        }
        return root;
    }

    /** The joint of each link that has one, by the link's name; others are left out of the model. */
    private Map<String, SdfElement> joints(SdfElement given, SdfElement model) {
        Set<String> links = new HashSet<>();
        for (SdfElement each : given.children) {
            if (each.name.equals("link")) {
                links.add(each.attribute("name"));
            }
        }
        Map<String, SdfElement> joints = new HashMap<>();
        for (SdfElement joint : given.children) {
            if (joint.name.equals("joint")) {
                model.passedOver.merge("joint", 1, Integer::sum);
                SdfElement child = joint.child("child");
                String link = child == null ? "" : child.attribute("link");
                SdfElement other = links.contains(link) ? joints.putIfAbsent(link, joint) : null;
                String problem = !links.contains(link)
                        ? "<child> must name a link of the robot (got: " + (link.isEmpty() ? "none" : link) + ")"
                        : other != null ? "the joint in line " + other.line + " places the same link" : "";
                if (!problem.isEmpty()) {
                    model.skipped.add(new LeftOut(file.shown(), joint.line, joint.tag(), problem));
                }
            }
        }
        return joints;
    }

    private SdfElement link(SdfElement given, @Nullable SdfElement joint) throws FileProblem {
        SdfElement link = element(given, "link", given.attributes);
        link.passedOver.putAll(given.passedOver);
        link.skipped.addAll(given.skipped);
        SdfElement parent = joint == null ? null : joint.child("parent");
        if (joint != null && parent != null) {
            link.children.add(pose(joint, parent.attribute("link")));
        }
        int collisions = 0;
        for (SdfElement each : given.children) {
            if (each.name.equals("visual")) {
                link.children.add(visual(each));
                continue;
            }
            collisions++;
            String name = each.attribute("name");
            String other = collisions == 1 ? "collision" : "collision_" + collisions;
            SdfElement collision = element(each, "collision", Map.of("name", name.isEmpty() ? other : name));
            collision.skipped.addAll(each.skipped);
            try {
                collision.children.add(pose(each, ""));
                for (SdfElement shape : each.children) {
                    if (shape.name.equals("geometry")) {
                        collision.children.add(checked(shape));
                    }
                }
                link.children.add(collision);
            } catch (FileProblem e) {
                link.skipped.add(new LeftOut(e.source(), e.line(), collision.tag(), e.problem()));
            }
        }
        return link;
    }

    private SdfElement visual(SdfElement given) throws FileProblem {
        SdfElement visual = element(given, "visual", Map.of("name", given.attribute("name")));
        visual.children.add(pose(given, ""));
        SdfElement geometry = given.child("geometry");
        if (geometry != null) {
            visual.children.add(geometry);
        }
        SdfElement material = given.child("material");
        SdfElement color = material == null ? null : material.child("color");
        if (material != null && color == null && robot != null) { // one of the robot's, by its name
            for (SdfElement each : robot.children) {
                boolean isMeant =
                        each.name.equals("material") && each.attribute("name").equals(material.attribute("name"));
                color = isMeant ? each.child("color") : color;
            }
        }
        if (color != null) {
            SdfElement made = element(color, "material", Map.of());
            SdfElement diffuse = element(color, "diffuse", Map.of());
            diffuse.text.append(color.attribute("rgba"));
            made.children.add(diffuse);
            visual.children.add(made);
        }
        return visual;
    }

    /** Refuses a shape without its size in the words of URDF, which has attributes where SDFormat has elements. */
    private static SdfElement checked(SdfElement geometry) throws FileProblem {
        for (SdfElement shape : geometry.children) {
            for (String needed : new TreeSet<>(NEEDED.of(shape.name))) {
                if (shape.attribute(needed).isEmpty()) {
                    throw shape.wrong("<" + shape.name + "> must have the attribute " + needed + " (got: none)");
                }
            }
            for (Map.Entry<String, Integer> each : new TreeMap<>(NUMBERS).entrySet()) {
                if (!shape.attribute(each.getKey()).isEmpty()) {
                    checkNumbers(shape, each.getKey(), each.getValue());
                }
            }
        }
        return geometry;
    }

    /** The origin of an element as a pose: both are x y z, and angles about the fixed X, then Y, then Z. */
    private SdfElement pose(SdfElement owner, String relativeTo) throws FileProblem {
        SdfElement origin = owner.child("origin");
        SdfElement place = origin == null ? owner : origin;
        SdfElement pose = element(place, "pose", relativeTo.isEmpty() ? Map.of() : Map.of("relative_to", relativeTo));
        if (origin != null) {
            pose.text.append(three(origin, "xyz")).append(' ').append(three(origin, "rpy"));
        }
        return pose;
    }

    private static String three(SdfElement origin, String name) throws FileProblem {
        String value = origin.attribute(name);
        if (value.isEmpty()) {
            return "0 0 0";
        }
        checkNumbers(origin, name, 3);
        return value;
    }

    /** Refuses an attribute that is not so many numbers, in the words of URDF. */
    private static void checkNumbers(SdfElement element, String name, int count) throws FileProblem {
        String what = name + " of <" + element.name + ">";
        String[] words = Numbers.words(element.attribute(name));
        if (words.length != count) {
            throw element.wrong(what + " must be " + count + (count == 1 ? " number" : " numbers") + " (got: "
                    + words.length + ")");
        }
        for (String word : words) {
            try {
                Numbers.parse(word);
            } catch (IllegalArgumentException e) {
                throw element.wrong(what + ": " + e.getMessage());
            }
        }
    }

    private SdfElement element(SdfElement place, String name, Map<String, String> attributes) {
        return new SdfElement(file, name, place.line, 0, attributes);
    }
}
