package robosim.geometry.world.sdf;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Pose;
import robosim.geometry.render.Lighting;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.LimitProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Placement;

/**
 * Creates objects from models. A static model becomes static objects, one for each collision; any other model becomes
 * one moveable object with everything in it, in the pose given by the file.
 */
public final class SdfObjects {
    private final SdfTree tree;
    private final SdfShapes shapes;
    private final SdfVisuals visuals;
    private final List<GeometryObject> scenery = new ArrayList<>();
    private final SdfLights lights = new SdfLights();
    private final List<GeometryObject> objects = new ArrayList<>();
    private final Set<String> names = new HashSet<>();
    private final Map<String, Integer> namesakes = new HashMap<>();
    private final Map<String, Integer> counts = new TreeMap<>();
    private final List<String> remarks = new ArrayList<>();
    private final List<SensorElement> sensors = new ArrayList<>();
    private final Set<String> floors = new HashSet<>();
    private int collisions;

    /** A moveable model: the shapes found in it so far, in its own frame. */
    private static final class Body {
        final List<GeometryObject> members = new ArrayList<>();

        /** The placement of its first member. */
        @Nullable
        Placement first;

        /** What is seen of it, in its own frame. */
        final List<GeometryObject> visuals = new ArrayList<>();

        /** The sensors in it. */
        final List<Carried> sensors = new ArrayList<>();
    }

    /** A sensor, and where it is in its body and in the world. */
    private record Carried(String path, SdfElement element, Placement inBody, Placement inWorld) {}

    public SdfObjects(SdfTree tree, SdfShapes shapes) {
        this.tree = tree;
        this.shapes = shapes;
        visuals = new SdfVisuals(shapes.ofVisuals());
    }

    public List<GeometryObject> objects() {
        return objects;
    }

    /** The names of the objects that are floors, which are to fill the world. */
    public Set<String> floors() {
        return floors;
    }

    /** The sensors of all links that are read. */
    public List<SensorElement> sensors() {
        return sensors;
    }

    /** What is only seen: the visuals of models without collisions. */
    public List<GeometryObject> scenery() {
        return scenery;
    }

    /** The light of the world; null if the file says nothing of it. */
    public @Nullable Lighting lighting() {
        return lights.lighting();
    }

    public Map<String, Integer> counts() {
        return counts;
    }

    public List<String> remarks() {
        List<String> all = new ArrayList<>(remarks);
        visuals.remark(all);
        lights.remark(all);
        return all;
    }

    /** Adds everything in a world. */
    public void add(SdfScope world) throws FileProblem {
        SdfElement scene = world.scene;
        if (scene != null) {
            lights.scene(scene);
        }
        for (SdfNode light : world.lights) {
            lights.add(light.element, () -> world.placement(light));
        }
        for (SdfNode model : world.models) {
            Placement place = world.placement(model);
            if (model.isStatic || model.inner == null) {
                statics(model, place);
            } else {
                moveable(model, model.inner, place);
            }
        }
    }

    private void moveable(SdfNode model, SdfScope inner, Placement place) throws FileProblem {
        Body body = new Body();
        gather(model, place, Placement.NONE, body);
        Placement first = body.first;
        if (body.members.isEmpty() || first == null) {
            if (isOnlySeen(inner)) {
                remarks.add(model.element.file.shown() + ":" + model.element.line + ": " + model.element.tag()
                        + " has visuals and no collisions, so it is scenery, which does not move");
            }
            for (GeometryObject seen : body.visuals) {
                scenery.add(seen.at(place.then(Placement.of(seen.pose())).pose()));
            }
            for (Carried each : body.sensors) {
                sensors.add(SensorElement.of(each.path, each.element, null, each.inWorld.pose()));
            }
            return;
        }
        SdfElement element = model.element;
        leaveOutMistakes(element, () -> {
            String name = unique(inner.path, element);
            // A single shape that turns about the model's own vertical is the object itself; else a group keeps the
            // frame.
            GeometryObject only = body.members.get(0);
            boolean isAlone = body.members.size() == 1 && first.isOnTheSpot();
            GeometryObject whole =
                    isAlone ? only.at(place.then(first).pose()) : new ObjectGroup(body.members).at(place.pose());
            if (!body.visuals.isEmpty() && !body.visuals.equals(body.members)) {
                // In the object's own frame, which is the model's unless it is a single shape.
                GeometryObject inModel = isAlone ? only : whole.at(Pose.ORIGIN);
                whole = whole.withVisuals(
                        SdfVisuals.seenAs(inModel, body.visuals).visuals());
            }
            objects.add(whole.moveable(name));
            for (Carried each : body.sensors) {
                Placement mount = isAlone ? first.inverse().then(each.inBody) : each.inBody;
                sensors.add(SensorElement.of(each.path, each.element, name, mount.pose()));
            }
        });
    }

    /** Whether a model looks like something that nothing meets. */
    private boolean isOnlySeen(SdfScope model) {
        return model.links.stream().allMatch(link -> collisions(link).isEmpty())
                && model.links.stream()
                        .anyMatch(link ->
                                link.element.child("visual") != null || link.element.passedOver.containsKey("visual"));
    }

    /** A step that fails for a mistake in the file. */
    @FunctionalInterface
    private interface Step {
        void run() throws FileProblem;
    }

    /** Runs a step; if it finds a mistake, the element is left out, and the rest of the world is read nevertheless. */
    private void leaveOutMistakes(SdfElement element, Step step) throws FileProblem {
        try {
            step.run();
        } catch (LimitProblem e) {
            throw e;
        } catch (FileProblem e) {
            tree.skip(element, element.tag(), e);
        } catch (IllegalArgumentException e) {
            tree.skip(element, element.tag(), String.valueOf(e.getMessage()));
        }
    }

    /** Counts a model; not one that only contains others, such as an {@code include}. */
    private void countModel(SdfScope scope) {
        if (!scope.links.isEmpty() || scope.models.isEmpty()) {
            counts.merge("model", 1, Integer::sum);
        }
    }

    /** Collects the shapes that move with a body; static models in it become separate objects. */
    private void gather(SdfNode model, Placement inWorld, Placement inBody, Body body) throws FileProblem {
        SdfScope scope = inner(model);
        countModel(scope);
        for (SdfNode link : scope.links) {
            counts.merge("link", 1, Integer::sum);
            for (SdfElement visual : children(link, "visual")) {
                GeometryObject seen = visuals.read(visual, link, inBody, () -> local(scope, link, visual));
                if (seen != null) {
                    body.visuals.add(seen);
                }
            }
            for (SdfElement collision : collisions(link)) {
                leaveOutMistakes(collision, () -> {
                    String path = path(scope, link, collision);
                    Placement local = local(scope, link, collision);
                    Placement there = inWorld.then(local);
                    GeometryObject shape = shape(link, collision, path, there);
                    if (shape != null && SdfShapes.isFloor(collision, there)) { // which stays where it is
                        addFloor(shape, path, collision);
                    } else if (shape != null) {
                        Placement place = inBody.then(local);
                        body.members.add(placed(collision, shape, place));
                        body.first = body.first == null ? place : body.first;
                    }
                });
            }
            for (SdfElement light : children(link, "light")) {
                lights.add(light, () -> inWorld.then(local(scope, link, light)));
            }
            for (SdfElement sensor : sensors(link)) {
                leaveOutMistakes(sensor, () -> {
                    Placement local = local(scope, link, sensor);
                    body.sensors.add(
                            new Carried(path(scope, link, sensor), sensor, inBody.then(local), inWorld.then(local)));
                });
            }
        }
        for (SdfNode nested : scope.models) {
            Placement local = scope.placement(nested);
            if (nested.isStatic) {
                statics(nested, inWorld.then(local));
            } else {
                gather(nested, inWorld.then(local), inBody.then(local), body);
            }
        }
    }

    /** Adds all of a static model; models within it are static too. */
    private void statics(SdfNode model, Placement inWorld) throws FileProblem {
        Map<SdfElement, GeometryObject> found = new LinkedHashMap<>();
        Map<SdfElement, String> paths = new HashMap<>();
        Set<SdfElement> grounds = new HashSet<>();
        List<GeometryObject> seen = new ArrayList<>(); // in the world
        SdfScope scope = inner(model);
        countModel(scope);
        for (SdfNode link : scope.links) {
            counts.merge("link", 1, Integer::sum);
            for (SdfElement collision : collisions(link)) {
                leaveOutMistakes(collision, () -> {
                    String path = path(scope, link, collision);
                    Placement place = inWorld.then(local(scope, link, collision));
                    GeometryObject shape = shape(link, collision, path, place);
                    if (shape != null) {
                        boolean isFloor = SdfShapes.isFloor(collision, place) && grounds.add(collision);
                        found.put(collision, isFloor ? shape : placed(collision, shape, place));
                        paths.put(collision, path);
                    }
                });
            }
            for (SdfElement visual : children(link, "visual")) {
                GeometryObject look = visuals.read(visual, link, inWorld, () -> local(scope, link, visual));
                if (look != null) {
                    seen.add(look);
                }
            }
            for (SdfElement light : children(link, "light")) {
                lights.add(light, () -> inWorld.then(local(scope, link, light)));
            }
            for (SdfElement sensor : sensors(link)) {
                leaveOutMistakes(sensor, () -> {
                    Pose pose = inWorld.then(local(scope, link, sensor)).pose();
                    sensors.add(SensorElement.of(path(scope, link, sensor), sensor, null, pose));
                });
            }
        }
        if (!seen.isEmpty() && !seen.equals(List.copyOf(found.values()))) {
            show(found, grounds, seen);
        }
        boolean alone = found.size() == 1 && scope.models.isEmpty();
        for (Map.Entry<SdfElement, GeometryObject> each : found.entrySet()) {
            SdfElement collision = each.getKey();
            leaveOutMistakes(collision, () -> {
                String path = alone ? scope.path : paths.getOrDefault(collision, scope.path);
                GeometryObject object = each.getValue();
                if (grounds.contains(collision)) {
                    addFloor(object, path, collision);
                } else {
                    objects.add(object.named(unique(path, collision)));
                }
            });
        }
        for (SdfNode nested : scope.models) {
            statics(nested, inWorld.then(scope.placement(nested)));
        }
    }

    /**
     * Lets the first object of a static model be seen as all visuals of the model, and the others not at all; where there is
     * nothing but ground, the visuals are scenery.
     */
    private void show(Map<SdfElement, GeometryObject> found, Set<SdfElement> grounds, List<GeometryObject> seen) {
        List<GeometryObject> left = seen;
        for (Map.Entry<SdfElement, GeometryObject> each : found.entrySet()) {
            if (!grounds.contains(each.getKey())) {
                each.setValue(SdfVisuals.seenAs(each.getValue(), left));
                left = List.of();
            }
        }
        scenery.addAll(left);
    }

    private void addFloor(GeometryObject floor, String path, SdfElement collision) throws FileProblem {
        String name = unique(path, collision);
        floors.add(name);
        objects.add(floor.named(name));
    }

    private static SdfScope inner(SdfNode model) {
        if (model.inner == null) {
            throw new IllegalStateException("a model must have a scope");
        }
        return model.inner;
    }

    private static List<SdfElement> sensors(SdfNode link) {
        return children(link, "sensor");
    }

    private static List<SdfElement> collisions(SdfNode link) {
        return children(link, "collision");
    }

    private static List<SdfElement> children(SdfNode link, String name) {
        return link.element.children.stream()
                .filter(each -> each.name.equals(name))
                .toList();
    }

    private static String path(SdfScope scope, SdfNode link, SdfElement collision) throws FileProblem {
        return scope.pathOf(link.element.givenName() + "::" + collision.givenName());
    }

    /** The placement of a collision in its model: relative to its link, unless its pose names another frame. */
    private static Placement local(SdfScope scope, SdfNode link, SdfElement collision) throws FileProblem {
        SdfElement pose = collision.child("pose");
        if (pose == null) {
            return scope.placement(link);
        }
        String base = pose.relativeTo();
        if (base.isEmpty()) {
            return scope.placement(link).then(SdfPose.read(pose));
        }
        Placement found = scope.placement(base, link.home, pose).then(SdfPose.read(pose));
        // Of a link that a saved state has moved, what is fixed to it has moved too.
        return link.stood == null
                ? found
                : scope.placement(link).then(link.stood.inverse().then(found));
    }

    private @Nullable GeometryObject shape(SdfNode link, SdfElement collision, String path, Placement place)
            throws FileProblem {
        FileWork.take(1);
        if (++collisions > Limits.MAX_OBJECTS) {
            throw collision.beyond("a world must have at most " + Limits.MAX_OBJECTS
                    + " collisions; leave some out, or make one mesh of many (got: more)");
        }
        counts.merge("collision", 1, Integer::sum);
        tree.account(collision);
        GeometryObject shape = shapes.shape(collision, path, place, link.scale);
        if (shape == null) {
            return null;
        }
        counts.merge(collision.required("geometry").children.get(0).name, 1, Integer::sum);
        Material material = null;
        try {
            material = SdfMaterials.of(link.element, collision);
        } catch (FileProblem e) { // which costs the colour, and not the shape
            tree.skip(collision, "<material> of " + path, e);
        }
        return material == null ? shape : shape.withMaterial(material);
    }

    private static GeometryObject placed(SdfElement collision, GeometryObject shape, Placement place)
            throws FileProblem {
        try {
            return shape.at(place.pose());
        } catch (IllegalArgumentException e) {
            throw collision.wrong("<collision>: " + e.getMessage());
        }
    }

    /** A name that no other object has. */
    private String unique(String name, SdfElement place) throws FileProblem {
        SdfScope.checkName(name, place);
        String given = name;
        while (!names.add(given)) {
            given = name + " (" + namesakes.merge(name, 2, (before, two) -> before + 1) + ")";
        }
        if (!given.equals(name)) {
            remarks.add(place.file.shown() + ":" + place.line + ": another object is named " + name
                    + ", so this one is named " + given);
        }
        return given;
    }
}
