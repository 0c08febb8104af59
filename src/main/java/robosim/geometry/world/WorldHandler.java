package robosim.geometry.world;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import javax.xml.validation.ValidatorHandler;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.world.body.ObjectBody;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Placement;
import robosim.geometry.world.xml.XmlHandler;

/**
 * Handles the parser's events for a world file. Each event passes the limits, then the schema validator, and only then
 * contributes to the world.
 */
final class WorldHandler extends XmlHandler {
    /** Reads the files that worlds include. */
    @FunctionalInterface
    interface Includes {
        /**
         * The objects of a file that an element names, where the element puts them.
         *
         * @param base  the folder of the file with the element; null if it has none
         * @param outer the world of the element, without its objects
         */
        List<WorldObject> include(Element element, @Nullable Path base, Placement place, World outer)
                throws FileProblem;
    }

    private final String source;
    private final ValidatorHandler validator;
    private final ObjectBuilder builder;
    private final @Nullable List<FileProblem> problems;
    private final @Nullable Path base;
    private final Includes reader;
    private final Map<String, Integer> linesOfNames = new HashMap<>();
    private final List<WorldObject> objects = new ArrayList<>();

    private @Nullable Element open;
    private @Nullable World world;
    private @Nullable SAXParseException detail;
    private boolean mute;
    private int count;

    /**
     * A handler of one file.
     *
     * @param problems receives the problems, and reading continues; null to throw the first one
     * @param reader   reads the files that it includes
     */
    WorldHandler(
            String source,
            @Nullable Path base,
            ValidatorHandler validator,
            @Nullable List<FileProblem> problems,
            Includes reader) {
        super(source);
        this.source = source;
        this.base = base;
        this.reader = reader;
        this.problems = problems;
        this.builder = new ObjectBuilder(source, base);
        this.validator = validator;
        validator.setErrorHandler(new DefaultHandler() {
            @Override
            public void error(SAXParseException e) throws SAXException {
                invalid(e);
            }

            @Override
            public void fatalError(SAXParseException e) throws SAXException {
                invalid(e);
            }
        });
    }

    /** The world read. */
    World world() {
        if (world == null) {
            throw new IllegalStateException("the document has not ended");
        }
        return world;
    }

    @Override
    public void setDocumentLocator(Locator given) {
        super.setDocumentLocator(given);
        validator.setDocumentLocator(given);
    }

    @Override
    public void startDocument() throws SAXException {
        validator.startDocument();
    }

    @Override
    public void endDocument() throws SAXException {
        validator.endDocument();
    }

    @Override
    public void startPrefixMapping(String prefix, String uri) throws SAXException {
        validator.startPrefixMapping(prefix, uri);
    }

    @Override
    public void endPrefixMapping(String prefix) throws SAXException {
        validator.endPrefixMapping(prefix);
    }

    @Override
    public void startElement(String uri, String name, String qualified, Attributes attributes) throws SAXException {
        attributes(name, attributes);
        Element element = new Element(open, uri, name, attributes, line(), column());
        open = element;
        if (element.groups() > Limits.MAX_GROUPS) {
            throw refusal("groups must be nested at most " + Limits.MAX_GROUPS + " deep; nest less (got: one more)");
        }
        if (ObjectBuilder.isObject(element) && ++count > Limits.MAX_OBJECTS) {
            throw refusal("a world must have at most " + Limits.MAX_OBJECTS
                    + " objects; split it, or make one mesh of many (got: more)");
        }
        checkName(element);
        String allowed = element.parent == null ? null : element.parent.allowed;
        validator.startElement(uri, name, qualified, attributes);
        flushDetail();
        if (allowed != null && !element.broken && !allowed.contains("<" + name + ">")) {
            // A validator reports the first wrong child of an element alone.
            refuse("<" + name + "> is not allowed in <world>; " + allowed);
        }
    }

    private void checkName(Element element) throws SAXException {
        String name = element.attribute("name");
        if (element.parent == null
                || element.parent.parent != null
                || name == null
                || element.name.equals("material")) {
            return; // names are unique only directly in the world, and those of materials among themselves
        }
        Integer earlier = linesOfNames.putIfAbsent(name, element.line);
        if (earlier != null) {
            refuse("names must be unique in a world; rename this object or the one in line " + earlier + " (got twice: "
                    + name + ")");
        }
    }

    @Override
    public void characters(char[] text, int start, int length) throws SAXException {
        if (open != null && open.takesText()) {
            open.text.add(text, start, length, line());
        }
        validator.characters(text, start, length);
    }

    @Override
    public void ignorableWhitespace(char[] text, int start, int length) throws SAXException {
        characters(text, start, length);
    }

    @Override
    public void processingInstruction(String target, String data) throws SAXException {
        validator.processingInstruction(target, data);
    }

    @Override
    public void endElement(String uri, String name, String qualified) throws SAXException {
        Element element = open;
        if (element == null) {
            throw new IllegalStateException("an element ended that had not begun: " + name);
        }
        // Before the validator, which would only say that some number is wrong, not which one.
        mute = !succeeds(element, () -> builder.readText(element));
        validator.endElement(uri, name, qualified);
        flushDetail();
        mute = false;
        if (!element.broken) {
            succeeds(element, () -> finish(element));
        }
        open = element.parent;
        if (element.broken && open != null && open.parent != null) {
            open.broken = true;
        }
    }

    /** A step that may fail because of an element's content. */
    @FunctionalInterface
    private interface Step {
        void take() throws FileProblem;
    }

    private boolean succeeds(Element element, Step step) throws SAXException {
        try {
            step.take();
            return true;
        } catch (FileProblem e) {
            refuse(e);
        } catch (IllegalArgumentException e) {
            refuse(new FileProblem(
                    source, element.line, element.column, "<" + element.name + ">: " + e.getMessage(), e));
        }
        return false;
    }

    private void finish(Element element) throws FileProblem {
        Element parent = element.parent;
        if (parent == null) {
            if (problems != null && !problems.isEmpty()) {
                return; // some objects are missing
            }
            world = world(element, objects);
            return;
        }
        if (ObjectBuilder.isObject(element)) {
            GeometryObject object = builder.object(element);
            if (parent.parent == null) {
                ObjectBody body = ObjectBuilder.body(element.motion, object);
                GeometryObject seen = element.visuals == null ? object : object.withVisuals(element.visuals);
                objects.add(new WorldObject(
                        seen, element.attribute("color"), element.sonars, body, element.attribute("attached")));
            } else if (element.attribute("attached") != null) {
                throw new IllegalArgumentException(
                        "attached must not be given inside a group; give it to the group (got: "
                                + element.attribute("attached") + ")");
            } else {
                parent.members.add(object);
            }
            return;
        }
        if (element.name.equals("include")) {
            include(element);
            return;
        }
        switch (element.name) {
            case "bounds" -> parent.bounds = element.members.get(0);
            case "visual" -> parent.visuals = element.members;
            case "sonar" -> parent.sonars.add(builder.sonar(element));
            case "sky" -> parent.sky = WorldLights.sky(element);
            case "sun", "lamp", "spot" -> parent.lights.add(WorldLights.light(element, builder));
            case "scenery" -> parent.scenery = element.members;
            case "lighting" -> parent.lighting = WorldLights.of(element);
            case "body", "drive" -> parent.motion = element;
            case "material" -> builder.materials.define(element);
            case "checker", "stripes", "image" -> parent.texture = builder.materials.texture(element);
            case "uv" -> parent.uv = element.uv;
            case "corners" -> parent.corners = element.corners;
            case "heights" -> {
                parent.vertices.addAll(element.vertices);
                parent.faces.addAll(element.faces);
            }
            case "vertices" -> parent.vertices.addAll(element.vertices);
            default -> parent.faces.addAll(element.faces);
        }
    }

    private World world(Element root, List<WorldObject> all) {
        return new World(
                builder.length(root, "width", "0"),
                builder.length(root, "height", "0"),
                builder.length(root, "length", "0"),
                builder.unit(root),
                Dimension.valueOf(root.attribute("dimension", "SPATIAL")),
                Accuracy.valueOf(root.attribute("accuracy", "EXACT")),
                all,
                root.lighting,
                root.scenery);
    }

    /** Adds the objects of another file. */
    private void include(Element element) throws FileProblem {
        World outer = world(Objects.requireNonNull(element.parent), List.of());
        List<WorldObject> included = reader.include(element, base, Placement.of(builder.pose(element, "at")), outer);
        for (WorldObject each : included) {
            count += members(each.object());
            builder.countCells(each.object());
            if (count > Limits.MAX_OBJECTS) {
                throw new IllegalArgumentException("a world must have at most " + Limits.MAX_OBJECTS
                        + " objects, included ones too; leave some out, or make one mesh of many (got: more)");
            }
            String name = each.object().name();
            Integer earlier = name == null ? null : linesOfNames.putIfAbsent(name, element.line);
            if (earlier != null) {
                throw new IllegalArgumentException(
                        "names must be unique in a world, and one of the file is also in line " + earlier
                                + "; give a prefix (got twice: " + name + ")");
            }
        }
        objects.addAll(included);
    }

    private static int members(GeometryObject object) {
        int count = 1;
        if (object instanceof ObjectGroup group) {
            for (GeometryObject member : group.members()) {
                count += members(member);
            }
        }
        return count;
    }

    // Errors of the validator.

    private void invalid(SAXParseException e) throws SAXException {
        if (SchemaErrors.isDetail(e)) {
            detail = detail == null ? e : detail;
        } else {
            detail = null;
            explain(e);
        }
    }

    private void flushDetail() throws SAXException {
        SAXParseException left = detail;
        detail = null;
        if (left != null) {
            explain(left);
        }
    }

    private void explain(SAXParseException e) throws SAXException {
        if (mute) {
            return;
        }
        Element element = open;
        String problem = element == null ? String.valueOf(e.getMessage()) : SchemaErrors.explain(e, element);
        refuse(new FileProblem(source, e.getLineNumber(), e.getColumnNumber(), problem, e));
        Element parent = element == null ? null : element.parent;
        int allowed = problem.indexOf(SchemaErrors.ALLOWED);
        if (parent != null && parent.parent == null && allowed >= 0) {
            parent.allowed = problem.substring(allowed);
        }
    }

    private void refuse(String problem) throws SAXException {
        refuse(new FileProblem(source, line(), column(), problem));
    }

    /** Throws the problem, or records it if reading is to continue. */
    private void refuse(FileProblem refusal) throws SAXException {
        if (problems == null || problems.size() == Limits.MAX_PROBLEMS - 1) {
            throw new SAXException(refusal);
        }
        problems.add(refusal);
        if (open != null) {
            open.broken = true;
        }
    }
}
