package robosim.geometry.world.sdf;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.LeftOut;
import robosim.geometry.world.shared.LimitProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Numbers;

/** Builds the scopes of a world, with included models in place, and a report of what is not read. */
public final class SdfTree {
    /** Models that come with Gazebo and that most worlds include, so that their files may be missing. */
    private static final String SUN = "model://sun";

    private static final String GROUND = "model://ground_plane";

    private static final int MOST_NAMES = 5;

    private final SdfFiles files;
    private final Map<String, Integer> passedOver = new TreeMap<>();
    private final List<LeftOut> skipped = new ArrayList<>();
    private final Set<String> remarks = new LinkedHashSet<>();

    /** The chain of files that are being included. */
    private final Set<SdfFile> open;

    private int nodes;
    private int depth;

    public SdfTree(SdfFiles files) {
        this.files = files;
        this.open = new HashSet<>();
    }

    /** A separate tree, whose remarks and losses are its own. */
    SdfTree aside() {
        return new SdfTree(this);
    }

    /** A separate tree for looking at a part on its own, within the remaining limits. */
    private SdfTree(SdfTree outer) {
        this.files = outer.files;
        this.open = new HashSet<>(outer.open);
        this.nodes = outer.nodes;
        this.depth = outer.depth;
    }

    public Map<String, Integer> passedOver() {
        return passedOver;
    }

    public List<LeftOut> skipped() {
        return skipped;
    }

    /** Remarks, none of which means that something is missing. */
    public List<String> remarks() {
        return List.copyOf(remarks);
    }

    /** Something that a user should know of an element that is read. */
    void remark(SdfElement place, String remark) {
        remarks.add(place.file.shown() + ":" + place.line + ": " + remark);
    }

    /** Reads the scope of a file's only world, or of its models if it has no world. */
    public SdfScope read(SdfElement sdf) throws FileProblem {
        account(sdf);
        open.add(sdf.file);
        SdfElement holder = sdf;
        List<SdfElement> worlds =
                sdf.children.stream().filter(each -> each.name.equals("world")).toList();
        if (!worlds.isEmpty()) {
            holder = worlds.get(0);
            for (SdfElement each : sdf.children) {
                if (each != holder) {
                    skip(each, each.tag(), "a file is read as one world, the first one; split it in two");
                }
            }
            account(holder);
        } else if (sdf.children.isEmpty() && sdf.skipped.isEmpty()) {
            throw sdf.wrong("<sdf> must have a <world> or a <model> (got: none)");
        }
        SdfScope world = new SdfScope("");
        fill(world, holder);
        return world;
    }

    /** Adds models to a world that has been read. */
    void insert(SdfScope world, SdfElement models) throws FileProblem {
        account(models);
        add(world, models, null);
        keepPlaced(world, world.models);
    }

    /** Some names, in a message. */
    static String listed(List<String> names) {
        return String.join(", ", names.subList(0, Math.min(MOST_NAMES, names.size())))
                + (names.size() > MOST_NAMES ? " and " + (names.size() - MOST_NAMES) + " more" : "");
    }

    /** Adds what is not read of an element to the report. */
    void account(SdfElement element) throws FileProblem {
        element.passedOver.forEach((name, count) -> passedOver.merge(name, count, Integer::sum));
        for (LeftOut each : element.skipped) {
            skip(element, each);
        }
    }

    void skip(SdfElement place, String what, String reason) throws FileProblem {
        skip(place, new LeftOut(place.file.shown(), place.line, what, reason));
    }

    private void skip(SdfElement place, LeftOut each) throws FileProblem {
        if (skipped.size() >= Limits.MAX_OBJECTS) {
            throw place.beyond("at most " + Limits.MAX_OBJECTS
                    + " elements may be left out of a world; remove what is not supported (got: more)");
        }
        skipped.add(each);
    }

    /** Fills a scope with the contents of an element, and computes their placements. */
    private void fill(SdfScope scope, SdfElement element) throws FileProblem {
        add(scope, element, null);
        // Only now do all frames exist that others may refer to. Frames that none refers to must have a valid placement
        // too.
        keepPlaced(scope, scope.models);
        keepPlaced(scope, scope.links);
    }

    /** Leaves out what cannot be placed. */
    private void keepPlaced(SdfScope scope, List<SdfNode> nodes) throws FileProblem {
        List<SdfNode> placed = new ArrayList<>(nodes.size());
        for (SdfNode node : nodes) {
            try {
                scope.placement(node);
                placed.add(node);
            } catch (LimitProblem e) {
                throw e;
            } catch (FileProblem e) {
                skip(node.element, what(node.element), e);
            }
        }
        if (placed.size() < nodes.size()) {
            nodes.clear();
            nodes.addAll(placed);
        }
    }

    /** What is left out, in messages: an included model with its address and its pose. */
    private static String what(SdfElement element) {
        if (!element.name.equals("include")) {
            return element.tag();
        }
        String pose = String.join(" ", Numbers.words(element.valueOf("pose")));
        return "<include> of " + element.valueOf("uri") + (pose.isEmpty() ? "" : " at " + pose);
    }

    /** Leaves out what has a mistake. */
    void skip(SdfElement place, String what, FileProblem mistake) throws FileProblem {
        boolean isHere = mistake.source().equals(place.file.shown());
        skip(
                place,
                new LeftOut(
                        place.file.shown(),
                        isHere && mistake.line() > 0 ? mistake.line() : place.line,
                        what,
                        isHere ? mistake.problem() : String.valueOf(mistake.getMessage())));
    }

    private void add(SdfScope scope, SdfElement element, @Nullable SdfNode home) throws FileProblem {
        if (++depth > Limits.MAX_GROUPS) {
            throw element.beyond("models must be nested at most " + Limits.MAX_GROUPS
                    + " deep, included ones too; nest less (got: one more)");
        }
        for (SdfElement child : element.children) {
            FileWork.take(1);
            if (++nodes > Limits.MAX_FRAMES) {
                throw child.beyond("a world must have at most " + Limits.MAX_FRAMES
                        + " models, links and frames, those of included files too; leave some out (got: more)");
            }
            int outer = depth;
            try {
                add(scope, child, child.name, home);
            } catch (LimitProblem e) {
                throw e;
            } catch (FileProblem e) {
                depth = outer;
                skip(child, what(child), e);
            }
        }
        depth--;
    }

    private void add(SdfScope scope, SdfElement child, String name, @Nullable SdfNode home) throws FileProblem {
        switch (name) {
            case "model" -> model(scope, child, home);
            case "include" -> include(scope, child, home);
            case "link" -> link(scope, child, home);
            case "frame" -> frame(scope, child, child.attribute("attached_to"), home);
            case "joint" -> joint(scope, child, home);
            case "light" -> scope.lights.add(new SdfNode(child, child.child("pose"), "", home));
            case "scene" -> scope.scene = child;
            default -> {} // pose and static are the model's own
        }
    }

    private void link(SdfScope scope, SdfElement link, @Nullable SdfNode home) throws FileProblem {
        if (scope.path.isEmpty()) {
            throw link.wrong("a link must be in a model (got: <link> in <world>)");
        }
        account(link);
        SdfNode node = new SdfNode(link, link.child("pose"), "", home);
        named(scope, link.givenName(), node);
        scope.links.add(node);
    }

    private void frame(SdfScope scope, SdfElement frame, String base, @Nullable SdfNode home) throws FileProblem {
        account(frame);
        named(scope, frame.givenName(), new SdfNode(frame, frame.child("pose"), base, home));
    }

    /**
     * A joint is only a frame, placed at its child; in older files it may have the name of a link, and is then not a
     * frame.
     */
    private void joint(SdfScope scope, SdfElement joint, @Nullable SdfNode home) throws FileProblem {
        passedOver.merge("joint", 1, Integer::sum);
        String name = joint.givenName();
        scope.add(name, new SdfNode(joint, joint.child("pose"), joint.valueOf("child"), home));
    }

    private void named(SdfScope scope, String name, SdfNode node) throws FileProblem {
        SdfNode earlier = scope.named(name);
        if (scope.add(name, node) || earlier == null) {
            return;
        }
        String where = "names must be unique in " + (scope.path.isEmpty() ? "the world" : scope.path)
                + "; rename this or the one in line " + earlier.element.line + " of " + earlier.element.file.shown()
                + " (got twice: " + name + ")";
        if (node.inner == null && !node.element.name.equals("link")) {
            throw node.element.wrong(where);
        }
        // Gazebo Classic, too, has both then, and finds the first by the name.
        remark(node.element, where + "; both are read, and poses relative to " + name + " are to the first one");
    }

    private void model(SdfScope scope, SdfElement model, @Nullable SdfNode home) throws FileProblem {
        model(scope, model, model, home, model.givenName(), model.child("pose"), isStatic(model, false));
    }

    private static boolean isStatic(SdfElement element, boolean otherwise) throws FileProblem {
        SdfElement given = element.child("static");
        return given == null ? otherwise : SdfElement.isTrue(given, "<static>", given.value());
    }

    private void model(
            SdfScope scope,
            SdfElement model,
            SdfElement placed,
            @Nullable SdfNode home,
            String name,
            @Nullable SdfElement pose,
            boolean isStatic)
            throws FileProblem {
        account(model);
        String frame = placed == model ? "" : placed.valueOf("placement_frame");
        String path = scope.pathOf(name);
        SdfScope.checkName(path, placed);
        SdfScope inner = new SdfScope(path);
        fill(inner, model);
        SdfNode node = new SdfNode(
                placed, pose, "", home, inner, frame.isEmpty() ? model.attribute("placement_frame") : frame, isStatic);
        named(scope, name, node);
        scope.models.add(node);
    }

    private void include(SdfScope scope, SdfElement include, @Nullable SdfNode home) throws FileProblem {
        account(include);
        SdfElement uri = include.required("uri");
        String address = uri.value();
        SdfElement root = files.included(uri);
        if (root == null) {
            String model = SdfFiles.isRemote(address) ? localName(address) : address;
            if (model.equals(GROUND)) {
                included(scope, include, groundPlane(include), home);
                return;
            }
            if (model.equals(SUN)) {
                scope.lights.add(new SdfNode(SdfLights.sun(include), include.child("pose"), "", home));
                return;
            }
            if (SdfFiles.isRemote(address)) {
                skip(include, what(include), files.remote(address));
                return;
            }
            throw files.missing(uri);
        }
        if (!open.add(root.file)) {
            throw uri.wrong("a file must not include itself, directly or through others (got: " + address + ")");
        }
        try {
            account(root);
            if (!root.children.isEmpty() && root.children.stream().allMatch(each -> each.name.equals("light"))) {
                for (SdfElement light : root.children) {
                    SdfElement own = include.child("pose");
                    scope.lights.add(new SdfNode(light, own == null ? light.child("pose") : own, "", home));
                }
                return;
            }
            SdfElement model = theModel(root, uri);
            if (model != null) {
                included(scope, include, model, home);
            }
        } finally {
            open.remove(root.file);
        }
    }

    /** Gazebo's model of an infinite ground, where it is included. */
    private static SdfElement groundPlane(SdfElement include) {
        SdfElement model = new SdfElement(include.file, "model", include.line, 0, Map.of("name", "ground_plane"));
        SdfElement inner = model;
        for (String name : List.of("link", "collision", "geometry", "plane")) {
            SdfElement next = new SdfElement(include.file, name, include.line, 0, Map.of("name", name));
            inner.children.add(next);
            inner = next;
        }
        SdfElement isStatic = new SdfElement(include.file, "static", include.line, 0, Map.of());
        isStatic.text.append("true");
        model.children.add(isStatic);
        return model;
    }

    /** The address of the same model in a folder: Fuel writes Ground Plane where a folder is called ground_plane. */
    private static String localName(String address) {
        FuelUri fuel = FuelUri.of(address);
        String last = fuel == null ? address.substring(address.lastIndexOf('/') + 1) : fuel.name();
        return "model://" + last.toLowerCase(Locale.ROOT).replace("%20", "_").replace(' ', '_');
    }

    /** The only model of an included file; null if it contains only what is not read. */
    private static @Nullable SdfElement theModel(SdfElement root, SdfElement uri) throws FileProblem {
        if (root.children.isEmpty() && !(root.passedOver.isEmpty() && root.skipped.isEmpty())) {
            return null;
        }
        if (root.children.size() != 1 || !root.children.get(0).name.equals("model")) {
            throw uri.wrong("an included file must contain one model (got: " + root.children.size()
                    + " models or worlds in " + root.file.shown() + ")");
        }
        return root.children.get(0);
    }

    private void included(SdfScope scope, SdfElement include, SdfElement model, @Nullable SdfNode home)
            throws FileProblem {
        SdfElement ownPose = include.child("pose");
        String frame = include.valueOf("placement_frame");
        if (ownPose == null && !frame.isEmpty()) {
            throw include.wrong("an <include> with a placement_frame must have a <pose>; add <pose/> (got: none)");
        }
        SdfElement pose = ownPose == null ? model.child("pose") : ownPose;
        String merge = include.attribute("merge");
        if (!merge.isEmpty() && SdfElement.isTrue(include, "merge of <include>", merge)) {
            account(model);
            String placementFrame = frame.isEmpty() ? model.attribute("placement_frame") : frame;
            SdfScope alone = placementFrame.isEmpty() ? null : alone(model);
            // Stands for the frame of the merged model, which no longer exists.
            SdfNode proxy = new SdfNode(include, pose, "", home, alone, placementFrame, false);
            add(scope, model, proxy);
            return;
        }
        String name = include.valueOf("name");
        boolean isStatic = isStatic(include, isStatic(model, false));
        model(scope, model, include, home, name.isEmpty() ? model.givenName() : name, pose, isStatic);
    }

    /** The scope of a model on its own; nothing of it is added to the report. */
    private SdfScope alone(SdfElement model) throws FileProblem {
        SdfTree aside = new SdfTree(this);
        SdfScope scope = new SdfScope(model.givenName());
        try {
            aside.fill(scope, model);
        } finally {
            nodes = aside.nodes;
        }
        return scope;
    }
}
