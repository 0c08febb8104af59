package robosim.geometry.cli.worlds;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.check.Text;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.SonarRing;
import robosim.geometry.world.Unit;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.check.SubstituteRobot;
import robosim.geometry.world.check.WorldCheck;
import robosim.geometry.world.shared.ObjectNames;

/**
 * A robot in words: {@code [NAME=]disc:RADIUS[xHEIGHT]@X,Z[,HEADING][#RRGGBB]}, or {@code box:WIDTHxLENGTH[xHEIGHT]} in the
 * place of the disc. It stands a little above the floor of its world.
 */
final class RobotSpec {
    static final String FORM = "[NAME=]disc:RADIUS[xHEIGHT]@X,Z[,HEADING][#RRGGBB] or"
            + " [NAME=]box:WIDTHxLENGTH[xHEIGHT]@X,Z[,HEADING][#RRGGBB]";

    private static final String NUMBER = "[-+]?[0-9]*\\.?[0-9]+(?:[eE][-+]?[0-9]{1,3})?";
    private static final Pattern WORDS = Pattern.compile("(?:([^=]+)=)?(disc|box):(" + NUMBER + ")(?:x(" + NUMBER
            + "))?(?:x(" + NUMBER + "))?@(" + NUMBER + "),(" + NUMBER + ")(?:,(" + NUMBER + "))?(#[0-9a-fA-F]{6})?");

    /** The gap between a robot and the floor, as a part of its height: what touches cannot move. */
    private static final double GAP = 1.0 / 64;

    /** The gap around a robot at a place that is proposed, as a part of its smaller side. */
    private static final double MARGIN = 1.0 / 16;

    /** The most of the world's height that a robot has whose height is not given. */
    private static final double TALLEST = 0.5;

    /** The range of a sonar, and the opening angle of its cone: what those of indoor robots have. */
    private static final double SONAR_METRES = 6;

    private static final double SONAR_DEGREES = 15;

    private RobotSpec() {}

    /**
     * A world with one more robot.
     *
     * @param sonars how many there are around it; 0 for none
     * @throws IllegalArgumentException saying what is wrong with the words, or what stands there
     */
    static World add(World world, String words, int sonars) {
        Matcher match = WORDS.matcher(words.strip());
        if (!match.matches()) {
            throw new IllegalArgumentException("a robot must be " + FORM + " (got: " + words + ")");
        }
        boolean isDisc = match.group(2).equals("disc");
        double first = Double.parseDouble(match.group(3));
        @Nullable String length = isDisc ? null : match.group(4);
        @Nullable String height = isDisc ? match.group(4) : match.group(5);
        if (isDisc ? match.group(5) != null : length == null) {
            throw new IllegalArgumentException("a robot must be " + FORM + " (got: " + words + ")");
        }
        double side = isDisc ? 2 * first : Math.min(first, number(length, 0));
        double tall = number(height, Math.min(side, TALLEST * world.height()));
        if (!(first > 0 && side > 0 && tall > 0)) {
            throw new IllegalArgumentException("the sizes of a robot must be above 0 (got: " + words + ")");
        }
        double floor = SubstituteRobot.floorOf(world);
        Point at = new Point(
                Double.parseDouble(match.group(6)), floor + tall * (0.5 + GAP), Double.parseDouble(match.group(7)));
        GeometryObject shape =
                isDisc ? new CylinderObject(at, first, tall) : new BoxObject(at, first, tall, number(length, 0));
        GeometryObject robot = shape.turned(0, number(match.group(8), 0)).moveable(name(world, match.group(1)));
        double margin = side * MARGIN;
        GeometryObject roomy = isDisc
                ? new CylinderObject(at, first + margin, tall)
                : new BoxObject(at, first + 2 * margin, tall, number(length, 0) + 2 * margin);
        checkPlace(world, robot, roomy.turned(0, robot.heading()), match, side);
        Unit unit = world.unit();
        List<SonarRing> rings = sonars == 0
                ? List.of()
                : List.of(new SonarRing(sonars, 0, SONAR_METRES / (unit == null ? 1 : unit.metres()), SONAR_DEGREES));
        List<WorldObject> objects = new ArrayList<>(world.objects());
        objects.add(new WorldObject(robot, match.group(9), rings));
        return world.withObjects(objects);
    }

    /**
     * The closed surfaces around the last object of a world, which is free to move since a mesh is hollow unless its file
     * says that it is solid: the inside of a bed, or that of a house.
     */
    static List<String> around(World world) {
        List<GeometryObject> all =
                world.objects().stream().map(WorldObject::object).toList();
        GeometryObject robot = all.get(all.size() - 1);
        List<String> found = new ArrayList<>();
        for (GeometryObject object : all.subList(0, all.size() - 1)) {
            if (object instanceof MeshObject mesh && !mesh.isSolid() && contains(mesh, robot)) {
                found.add(String.valueOf(object.name()));
            }
        }
        return found;
    }

    private static boolean contains(MeshObject mesh, GeometryObject robot) {
        Bounds a = mesh.bounds();
        Bounds b = robot.bounds();
        if (a.maxX() < b.minX() || b.maxX() < a.minX() || a.maxZ() < b.minZ() || b.maxZ() < a.minZ()) {
            return false;
        }
        try {
            return CollisionDetection.intersects(mesh.solid(), robot);
        } catch (IllegalArgumentException e) {
            return false; // it is open
        }
    }

    /** Warns of a robot, the last of the world, that is inside something hollow, or that will fall. */
    static void warn(World world, PrintWriter err) {
        String robot = String.valueOf(
                world.objects().get(world.objects().size() - 1).object().name());
        for (WorldCheck.Fall fall : WorldCheck.falls(world)) {
            if (robot.equals(fall.robot().object().name())) {
                err.println("warning: " + CheckText.fall(fall, world));
            }
        }
        for (String each : around(world)) {
            err.println("warning: " + Text.quoted(robot) + " is inside the closed surface " + Text.quoted(each)
                    + ", which it cannot leave; put it elsewhere unless that is a room");
        }
    }

    private static double number(@Nullable String text, double otherwise) {
        return text == null ? otherwise : Double.parseDouble(text);
    }

    /** The name given, or the first of robot, robot 2, ... that is free. */
    private static String name(World world, @Nullable String given) {
        Set<String> names = new HashSet<>();
        world.objects().forEach(each -> names.add(String.valueOf(each.object().name())));
        if (given != null) {
            if (names.contains(given)) {
                throw new IllegalArgumentException("a robot must have a name of its own (got twice: " + given + ")");
            }
            return given;
        }
        String name = "robot";
        for (int k = 2; names.contains(name); k++) {
            name = "robot " + k;
        }
        return name;
    }

    /**
     * Refuses a place that is taken, with a free one nearby as it is written on the command line.
     *
     * @param roomy the robot with a margin, for which there must be room at the place that is proposed
     * @param words what was written
     * @param size  of the robot, on the floor
     */
    private static void checkPlace(
            World world, GeometryObject robot, GeometryObject roomy, Matcher words, double size) {
        Geometry geometry = world.toGeometry(refused -> {});
        if (!geometry.addObjectUnchecked(robot)) {
            throw new IllegalArgumentException("a robot must stand within the world of " + world.width() + " x "
                    + world.height() + " x " + world.length() + " about the origin (got: " + robot + ")");
        }
        geometry.removeObject(Objects.requireNonNull(robot.name()));
        if (geometry.testObject(robot)) {
            String place = new FreePlace(geometry, roomy).find(words.group(6), words.group(7), size);
            String whole = words.group();
            String remedy = place == null
                    ? "and none nearby has room for it, see check or render"
                    : "free nearby is " + whole.substring(0, words.start(6)) + place + whole.substring(words.end(7));
            String taken = geometry.search()
                    .firstTouching(robot)
                    .map(ObjectNames::kindAndName)
                    .orElse("something");
            throw new IllegalArgumentException("a robot must stand where nothing is, since what touches cannot move; "
                    + taken + " is at this place, " + remedy + " (got: " + whole + ")");
        }
    }
}
