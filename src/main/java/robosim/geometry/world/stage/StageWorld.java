package robosim.geometry.world.stage;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import robosim.geometry.check.NumberText;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.LeftOut;
import robosim.geometry.world.shared.LimitProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Placement;

/** The objects of a Stage world: each model at its top is one, of all its bodies and those of its children. */
public final class StageWorld {
    private static final Set<String> MODELS = Set.of("model", "position", "actuator");

    /** Models without a body of their own unless they have blocks or a bitmap. */
    private static final Set<String> DEVICES = Set.of(
            "ranger",
            "laser",
            "sonar",
            "fiducial",
            "camera",
            "blobfinder",
            "bumper",
            "gripper",
            "wifi",
            "blinkenlight",
            "lightindicator");

    private static final Set<String> IGNORED =
            Set.of("window", "block", "sensor", "powerpack", "gui", "visualization", "speech", "task", "puck_list");

    public final List<Found> objects = new ArrayList<>();
    public final List<LeftOut> leftOut = new ArrayList<>();
    public final List<String> remarks = new ArrayList<>();
    public final Map<String, Integer> read = new TreeMap<>();
    public final Map<String, Integer> passedOver = new TreeMap<>();

    private final Path folder;
    private final Set<String> names = new HashSet<>();
    private int parts;

    /**
     * An object, with the range sensors of a robot.
     *
     * @param rings count, first, step, min, max and width of each ring
     */
    public record Found(GeometryObject object, List<double[]> rings) {
        /** Keeps a copy. */
        public Found {
            rings = List.copyOf(rings);
        }
    }

    private StageWorld(Path main) {
        folder = main.toAbsolutePath().resolveSibling("").normalize();
    }

    /** Reads a world and the files that it includes. */
    public static StageWorld read(Path file) throws FileProblem {
        StageWorld world = new StageWorld(file);
        for (StageEntity each : new StageParser(file, world.leftOut).read(file)) {
            world.top(each);
        }
        return world;
    }

    private void top(StageEntity model) throws FileProblem {
        try {
            if (isModel(model)) {
                object(model);
            }
        } catch (LimitProblem e) {
            throw e;
        } catch (FileProblem e) {
            leftOut.add(new LeftOut(e.source(), e.line(), what(model), e.problem()));
        } catch (IllegalArgumentException e) {
            leftOut.add(new LeftOut(model.file.toString(), model.line, what(model), String.valueOf(e.getMessage())));
        }
    }

    private static String what(StageEntity model) {
        String name = model.text("name", "");
        return model.type + (name.isEmpty() ? "" : " \"" + name + "\"");
    }

    /** Whether an entity is a model; one that is unknown is left out. */
    private boolean isModel(StageEntity entity) {
        if (MODELS.contains(entity.type) || DEVICES.contains(entity.type)) {
            return true;
        }
        if (IGNORED.contains(entity.type)) {
            passedOver.merge(entity.type, 1, Integer::sum);
        } else {
            leftOut.add(new LeftOut(
                    entity.file.toString(),
                    entity.line,
                    what(entity),
                    "there is no such model; define it before, or include the file that does"));
        }
        return false;
    }

    /** What is gathered of a model and its children, in its own frame. */
    private static final class Body {
        private final List<GeometryObject> members = new ArrayList<>();
        private final List<double[]> rings = new ArrayList<>();
        private double offset;
    }

    private void object(StageEntity model) throws FileProblem {
        boolean isRobot = model.type.equals("position");
        double[] size = StageShape.size(model);
        double[] pose = model.numbers("pose", 0, 0, 0, 0);
        // A robot's centre is in the middle of its height, so that its sensors are not on the ground.
        double middle = isRobot ? size[2] / 2 : 0;
        Body body = new Body();
        gather(model, Placement.upright(new Point(0, -middle, 0), 0, 0), 0, body, 0);
        if (body.members.isEmpty()) {
            passedOver.merge("model without a body", 1, Integer::sum);
            return;
        }
        GeometryObject first = body.members.get(0);
        boolean isItself =
                body.members.size() == 1 && (!isRobot || first.center().equals(new Point()));
        GeometryObject whole = isItself ? first : new ObjectGroup(body.members);
        Placement place = Placement.upright(new Point(pose[0], pose[2] + middle, -pose[1]), pose[3], 0);
        GeometryObject placed =
                whole.at(isItself ? place.then(Placement.of(first.pose())).pose() : place.pose());
        String name = unique(model.text("name", model.type));
        objects.add(new Found(isRobot ? placed.moveable(name) : placed.named(name), isRobot ? body.rings : List.of()));
        if (isRobot && body.offset > 0) {
            remarks.add(model.file + ":" + model.line + ": the range sensors of " + name
                    + " are at its centre here; in Stage they are up to " + Math.ceil(1000 * body.offset) / 1000
                    + " m from it");
        }
    }

    private String unique(String name) {
        String given = name;
        for (int k = 2; !names.add(given); k++) {
            given = name + " (" + k + ")";
        }
        return given;
    }

    /** Stage itself reads no further where a property has too few numbers; in its second version three were a pose. */
    private void tellShort(StageEntity model, String property, String numbers) {
        int needed = numbers.split(" ").length;
        int count = model.count(property, needed);
        if (count < needed) {
            remarks.add(model.file + ":" + model.line + ": " + property + " of " + what(model) + " must be [" + numbers
                    + "] (got: " + NumberText.count(count, "number") + "); what is missing is as if it were left out");
        }
    }

    private void gather(StageEntity model, Placement frame, double heading, Body body, int depth) throws FileProblem {
        read.merge(model.type, 1, Integer::sum);
        tellShort(model, "pose", "x y z heading");
        tellShort(model, "size", "x y z");
        tellShort(model, "origin", "x y z heading");
        double[] size = StageShape.size(model);
        double[] origin = model.numbers("origin", 0, 0, 0, 0);
        double obstacle = model.number("obstacle_return", 1);
        double echo = model.number("ranger_return", 1);
        Placement shape = frame.then(Placement.upright(new Point(origin[0], origin[2], -origin[1]), origin[3], 0));
        if (obstacle == 0 && (echo < 0 || depth > 0)) {
            passedOver.merge("body that is no obstacle", 1, Integer::sum);
        } else {
            for (GeometryObject part : StageShape.of(model, MODELS.contains(model.type), folder)) {
                FileWork.take(1);
                if (++parts > Limits.MAX_OBJECTS) {
                    throw new LimitProblem(
                            model.file.toString(),
                            model.line,
                            0,
                            "all bodies together must have at most " + Limits.MAX_OBJECTS
                                    + " parts; use simpler shapes (got: more)");
                }
                body.members.add(part.at(shape.then(Placement.of(part.pose())).pose()));
            }
            if (obstacle == 0) {
                remarks.add(model.file + ":" + model.line + ": " + what(model)
                        + " is solid here; in Stage robots drive through it, as its obstacle_return is 0");
            }
        }
        if (model.type.equals("ranger") || model.type.equals("laser") || model.type.equals("sonar")) {
            double far = StrictMath.hypot(frame.origin().x(), frame.origin().z());
            StageSensors.add(model, heading, body.rings);
            body.offset = Math.max(body.offset, StageSensors.farthest(model, far));
        }
        double above = model.number("stack_children", 1) == 0 ? 0 : size[2];
        for (StageEntity child : model.children) {
            if (!isModel(child)) {
                continue;
            }
            double[] pose = child.numbers("pose", 0, 0, 0, 0);
            Placement inner = frame.then(Placement.upright(new Point(pose[0], pose[2] + above, -pose[1]), pose[3], 0));
            gather(child, inner, heading + pose[3], body, depth + 1);
        }
    }
}
