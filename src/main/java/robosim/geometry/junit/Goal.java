package robosim.geometry.junit;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/** A place that a robot is to reach, a heading, or a path; all as seen from above. */
public final class Goal {
    private final String words;
    private final Supplier<Pursuit> pursuit;
    private final Function<Geometry, List<GeometryObject>> objects;

    private Goal(String words, Supplier<Pursuit> pursuit, Function<Geometry, List<GeometryObject>> objects) {
        this.words = words;
        this.pursuit = pursuit;
        this.objects = objects;
    }

    /** A robot on its way to the goal; one for each assertion, as a path remembers how far it was followed. */
    @FunctionalInterface
    interface Pursuit {
        /** How far the robot still is from it; called at the beginning and after each step. */
        Shortfall missing(Robot robot);
    }

    /**
     * A disc on the floor.
     *
     * @param radius how close the robot's centre must come to the point
     */
    public static Goal at(double x, double z, double radius) {
        Robot.check("radius", radius);
        Point goal = new Point(x, 0, z);
        String words = place(goal) + " to within " + FailureFormat.number(radius);
        return new Goal(
                words,
                () -> robot -> distance(apart(robot.center(), goal) - radius),
                world -> List.of(disc(goal, radius, words)));
    }

    /**
     * A place near an object.
     *
     * @param distance how close the robot's surface must come to the object's
     */
    public static Goal near(String object, double distance) {
        Checks.present("object", object);
        Robot.check("distance", distance);
        return new Goal(
                Text.quoted(object) + " to within " + FailureFormat.number(distance),
                () -> robot -> distance(robot.rangeTo(object).value() - distance),
                world -> world.hasObject(object) ? List.of(world.getObject(object)) : List.of());
    }

    /**
     * A heading, wherever the robot is.
     *
     * @param heading   degrees from the world's X
     * @param tolerance degrees by which it may be off, from 0 to 180
     */
    public static Goal heading(double heading, double tolerance) {
        Pursuit turn = turn(heading, tolerance);
        return new Goal(headed(heading, tolerance), () -> turn, world -> List.of());
    }

    /** This goal, and a heading there: both at the same time. The parameters are those of {@link #heading}. */
    public Goal facing(double heading, double tolerance) {
        Pursuit turn = turn(heading, tolerance);
        return new Goal(
                words + ", " + headed(heading, tolerance),
                () -> {
                    Pursuit there = pursuit.get();
                    return robot -> {
                        Shortfall missing = there.missing(robot);
                        return missing.isNone() ? turn.missing(robot) : missing.before(1);
                    };
                },
                objects);
    }

    /**
     * A path: places that the robot must pass in their order, the last of which is the goal. Between two steps of the
     * clock it is taken to have gone straight.
     *
     * @param radius how close its centre must come to each
     * @param places at least one; their heights do not count
     */
    public static Goal path(double radius, List<Point> places) {
        Robot.check("radius", radius);
        List<Point> path = Checks.list("places", places);
        if (path.isEmpty()) {
            throw new IllegalArgumentException("places must hold at least one place (got: none)");
        }
        String words = path.stream().map(Goal::place).collect(Collectors.joining(", then ")) + ", each to within "
                + FailureFormat.number(radius);
        return new Goal(words, () -> new Path(radius, path), world -> {
            List<GeometryObject> discs = new ArrayList<>();
            for (int k = 0; k < path.size(); k++) {
                discs.add(disc(path.get(k), radius, (k + 1) + " of " + path.size()));
            }
            return discs;
        });
    }

    /** How far along a path a robot is. */
    private static final class Path implements Pursuit {
        private final double radius;
        private final List<Point> places;
        private int next;
        private @Nullable Point before;

        Path(double radius, List<Point> places) {
            this.radius = radius;
            this.places = places;
        }

        @Override
        public Shortfall missing(Robot robot) {
            Point now = robot.center();
            Point from = before == null ? now : before;
            while (next < places.size()) {
                Point nearest = nearest(from, now, places.get(next));
                if (apart(nearest, places.get(next)) > radius) {
                    break;
                }
                from = nearest; // the next place must be passed after this one
                next++;
            }
            before = now;
            return next == places.size()
                    ? Shortfall.NONE
                    : new Shortfall(
                            places.size() - next,
                            apart(now, places.get(next)) - radius,
                            "%s short of place " + (next + 1) + " of " + places.size());
        }

        /** The point on the way between two places that is nearest to a third. */
        private static Point nearest(Point from, Point to, Point place) {
            double dx = to.x() - from.x();
            double dz = to.z() - from.z();
            double along = (place.x() - from.x()) * dx + (place.z() - from.z()) * dz;
            double share = along > 0 ? Math.min(1, along / (dx * dx + dz * dz)) : 0;
            return share == 1 ? to : new Point(from.x() + share * dx, 0, from.z() + share * dz);
        }
    }

    Pursuit pursue() {
        return pursuit.get();
    }

    /** Objects that mark the goal in a picture. */
    List<GeometryObject> objects(Geometry world) {
        return objects.apply(world);
    }

    private static Pursuit turn(double heading, double tolerance) {
        Checks.refuse(!Double.isFinite(heading), "heading must be a finite angle in degrees", heading);
        if (!(tolerance >= 0 && tolerance <= 180)) { // written so that NaN fails it
            throw new IllegalArgumentException("tolerance must be 0 to 180 degrees (got: " + tolerance + ")");
        }
        return robot -> {
            double off = Math.abs(Math.IEEEremainder(robot.heading() - heading, 360));
            return off <= tolerance
                    ? Shortfall.NONE
                    : new Shortfall(1, off - tolerance, "%s degrees short of its heading");
        };
    }

    private static Shortfall distance(double distance) {
        return distance > 0 ? new Shortfall(1, distance, "%s short of it") : Shortfall.NONE;
    }

    private static double apart(Point a, Point b) {
        double dx = a.x() - b.x();
        double dz = a.z() - b.z();
        return Math.sqrt(dx * dx + dz * dz);
    }

    private static GeometryObject disc(Point place, double radius, String name) {
        return new CylinderObject(new Point(place.x(), 0, place.z()), radius, 0).named("goal " + name);
    }

    private static String place(Point place) {
        return "(" + FailureFormat.number(place.x()) + ", " + FailureFormat.number(place.z()) + ")";
    }

    private static String headed(double heading, double tolerance) {
        return "heading " + FailureFormat.number(heading) + " to within " + FailureFormat.number(tolerance);
    }

    @Override
    public String toString() {
        return words;
    }

    /**
     * How far a robot is from a goal.
     *
     * @param stages number of parts of the goal that are still ahead; 0 where it is reached
     * @param amount what is missing of the present part, in its own unit
     * @param words  how the amount is read: {@code "%s short of it"}
     */
    record Shortfall(int stages, double amount, String words) {
        static final Shortfall NONE = new Shortfall(0, 0, "%s short of it");

        boolean isNone() {
            return stages == 0;
        }

        boolean isLessThan(Shortfall other) {
            return stages < other.stages || (stages == other.stages && amount < other.amount);
        }

        Shortfall before(int more) {
            return new Shortfall(stages + more, amount, words);
        }

        @Override
        public String toString() {
            return words.formatted(FailureFormat.found(amount));
        }
    }
}
