package robosim.geometry;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.engine.World;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.proof.Attempt;
import robosim.geometry.proof.Claim;
import robosim.geometry.proof.ProofChecker;
import robosim.geometry.proof.Prover;
import robosim.geometry.proof.Scene;

/**
 * Proves what a world answers: the same questions as {@link Geometry}'s, each with a proof that a {@link ProofChecker} can verify. It
 * follows its world and belongs to its thread; {@link Geometry#prove} returns it. Nothing is moved.
 *
 * <pre>{@code
 * Geometry geometry = new Geometry(20, 5, 20);
 * geometry.addObject(new BoxObject(new Point(4, 0, 0), 0.2, 2, 6).named("wall"));
 * geometry.addObject(new CylinderObject(new Point(0, 0, 0), 0.3, 1).moveable("robot"));
 * Attempt attempt = geometry.prove().apart("robot");
 * attempt.isProved();                                                              // true
 * geometry.prove().checker().check(attempt.proof()).isValid();                     // true
 * geometry.prove().move("robot", new Move(5, 0, 0, 0, 0)).get(0).claim();          // Blocked: the wall
 * }</pre>
 *
 * <p>An answer that cannot be proved comes as an {@link Attempt} without a proof, with the reason. Proofs are about the objects
 * themselves: answers at a coarser accuracy than {@code EXACT} have none.
 */
public final class WorldProver {
    /** The largest tangent of half an angle of a turn that a single claim is about: 179.9 degrees. */
    private static final double MOST_TANGENT = 1146;

    private final World world;
    private final double[] vector = new double[6];
    private Prover prover;

    WorldProver(World world) {
        this.world = world;
        prover = new Prover(scene(), world::take);
    }

    /** The objects of the world as they are now, which proofs are about. */
    public Scene scene() {
        Point size = new Point(world.width, world.height, world.length);
        return new Scene(world.registry.present(), world.dimension, size);
    }

    /** A checker of proofs about the world as it is now. */
    public ProofChecker checker() {
        return new ProofChecker(scene());
    }

    /** Proves that an object is within the world and touches no other. */
    public Attempt apart(String name) {
        int self = begin(name);
        return prover.apart(present(name), self, Claim.ALL);
    }

    /** Proves that an object is within the world and overlaps no other: pieces that it touches are listed in the claim. */
    public Attempt clear(String name) {
        int self = begin(name);
        return prover.clear(present(name), self);
    }

    /** Proves that two objects touch, or that they do not. */
    public Attempt pair(String name, String other) {
        begin(name);
        GeometryObject body = present(name);
        int index = index(other);
        Attempt apart = prover.apart(body, Claim.ALL, index);
        return apart.isProved() ? apart : prover.touching(body, index);
    }

    /**
     * Proves how far an object is from the nearest other one, as {@link Geometry#getProximity} returns it.
     *
     * @param max a range, world units, finite
     */
    public Attempt proximity(String name, double max) {
        int self = begin(name);
        Checks.range(0, max);
        double distance = world.proximity.of(world.view, world.registry.known(name), max);
        GeometryObject body = present(name);
        if (distance > max) {
            return prover.distance(body, self, Claim.ALL, max, Double.POSITIVE_INFINITY);
        }
        double error = 0x1p-40 * (distance + body.bounds().size());
        return prover.distance(body, self, Claim.ALL, Math.max(0, distance - error), distance + error);
    }

    /**
     * Proves what {@link Geometry#move} would answer: that the translation is free, or up to where and what then blocks it; that the
     * turns are free; and that nothing is overlapped at the end.
     *
     * @return one attempt for each of these that the move has
     */
    public List<Attempt> move(String name, Move move) {
        int self = begin(name);
        boolean isAllowed = world.motion.attemptOwn(world.view, world.mover(name), Checks.present("move", move), 0);
        double[] way = new double[3];
        world.objects.toWorld(world.mover(name), move.x(), move.y(), move.z(), way);
        return motion(name, self, new Point(way[0], way[1], way[2]), move, isAllowed, true);
    }

    /** Proves what {@link Geometry#moveGlobal} would answer, likewise. */
    public List<Attempt> moveGlobal(String name, Move move) {
        int self = begin(name);
        Checks.present("move", move);
        double rx = world.dimension == Dimension.PLANAR ? 0 : move.rx();
        boolean isAllowed =
                world.motion.attempt(world.view, world.mover(name), move.x(), move.y(), move.z(), rx, move.ry(), 0);
        Move made = new Move(move.x(), move.y(), move.z(), rx, move.ry());
        return motion(name, self, new Point(move.x(), move.y(), move.z()), made, isAllowed, false);
    }

    private List<Attempt> motion(String name, int self, Point way, Move move, boolean isAllowed, boolean isOwn) {
        GeometryObject start = present(name);
        double fraction = isAllowed ? 1 : world.motion.fraction();
        int obstacle = isAllowed ? World.NOTHING : world.motion.obstacle();
        double share = isAllowed ? 1 : world.motion.turnFraction();
        Pose end = Pose.of(world.motion.end(), 0);
        List<Attempt> attempts = new ArrayList<>();
        if (fraction < 1) {
            int other = obstacle == World.BORDER ? Claim.BORDER : index(world.objects.present(obstacle));
            attempts.add(prover.blocked(start, self, way, fraction, other));
            return attempts;
        }
        if (way.x() != 0 || way.y() != 0 || way.z() != 0) {
            attempts.add(prover.translation(start, self, way, 1));
        }
        GeometryObject there = start.at(start.pose().movedTo(end.center()));
        boolean isBoth = move.ry() != 0 && move.rx() != 0;
        double first = isBoth ? Math.min(1, 2 * share) : share;
        double second = isBoth ? Math.max(0, 2 * share - 1) : share;
        if (move.ry() != 0) {
            Point axis = isOwn ? axis(there, 1) : new Point(0, 1, 0);
            attempts.add(turn(there, self, axis, within(first) * move.ry()));
        }
        if (move.rx() != 0 && (!isBoth || first == 1)) {
            GeometryObject turned = isOwn ? there.turned(0, move.ry()) : there;
            Point axis = isOwn ? axis(turned, 0) : new Point(1, 0, 0);
            attempts.add(
                    !isOwn && isBoth
                            ? new Attempt(
                                    new Claim.Turn(there, self, axis, MOST_TANGENT, List.of()),
                                    null,
                                    "a turn about the world's X after another one is not proved")
                            : turn(turned, self, axis, within(second) * move.rx()));
        }
        attempts.add(prover.clear(start.at(end), self));
        return attempts;
    }

    /** A blocked turn is proved free up to slightly before its contact. */
    private static double within(double share) {
        return share < 1 ? share * (1 - 0x1p-26) : 1;
    }

    private static Point axis(GeometryObject object, int column) {
        Pose pose = object.pose();
        return new Point(pose.rotation(column), pose.rotation(3 + column), pose.rotation(6 + column));
    }

    private Attempt turn(GeometryObject body, int self, Point axis, double degrees) {
        Point about = degrees < 0 ? new Point(-axis.x(), -axis.y(), -axis.z()) : axis;
        double half = Math.abs(degrees) / 2;
        double length = Math.sqrt(about.x() * about.x() + about.y() * about.y() + about.z() * about.z());
        double tangent = half < 90 ? Degrees.sin(half) / Degrees.cos(half) / length * (1 + 0x1p-50) : MOST_TANGENT;
        return half < 90 && tangent <= MOST_TANGENT
                ? prover.turn(body, self, about, tangent)
                : new Attempt(
                        new Claim.Turn(body, self, about, MOST_TANGENT, List.of()),
                        null,
                        "a turn of half a circle and more is not proved");
    }

    /**
     * Proves what a ray hits first, as {@link Geometry#castRay} returns it, or that it hits nothing within a range.
     *
     * @param max a range, world units; finite if nothing is hit
     */
    public Attempt ray(Ray ray, double max) {
        begin(null);
        double distance = world.beams.cast(world.view, ray, max, vector);
        return distance == Double.POSITIVE_INFINITY
                ? prover.ray(ray.start(), ray.direction(), Claim.ALL, max, Claim.ALL)
                : prover.ray(
                        ray.start(),
                        ray.direction(),
                        Claim.ALL,
                        distance,
                        index(world.objects.present(world.beams.hit())));
    }

    /**
     * Proves that nothing in a cone is nearer than {@link Geometry#getRayDistance} returns, or than the range.
     *
     * @param max   a range, world units; finite if nothing is detected
     * @param width full opening angle in degrees, above 0 and below 180
     */
    public Attempt cone(Ray ray, double max, double width) {
        begin(null);
        double distance = world.beams.distance(world.view, ray, 0, max, width, -1);
        double cosine = Degrees.cos(Checks.width(width) / 2);
        return prover.cone(ray.start(), ray.direction(), cosine, Claim.ALL, Math.min(distance, max), Claim.ALL);
    }

    /**
     * Proves what {@link Geometry#getSonarDistance(String, double, double, double, double, double)} returns with a blind range of
     * 0: of a line what it hits first, of a wider beam that nothing is nearer.
     *
     * @param x     part of the direction along the object's own X
     * @param z     part along its own Z
     * @param max   a range, world units; finite if nothing is detected
     * @param width full opening angle in degrees, from 0 up to, not including, 180
     */
    public Attempt sonar(String name, double x, double z, double max, double width) {
        return sonar(name, new Ray(new Point(), new Point(x, 0, z)), max, width);
    }

    /**
     * Proves what {@link Geometry#getSonarDistance(String, Ray, double, double, double)} returns with a blind range of 0, likewise.
     *
     * @param mount where the sensor is in the object's own frame, and where it looks
     * @param max   a range, world units; finite if nothing is detected
     * @param width full opening angle in degrees, from 0 up to, not including, 180
     */
    public Attempt sonar(String name, Ray mount, double max, double width) {
        int self = begin(name);
        int id = world.mover(name);
        double distance = world.beams.sonar(world.view, id, Checks.present("mount", mount), 0, max, width);
        int hit = world.beams.hit();
        Point direction = toWorld(id, mount.direction());
        Point offset = toWorld(id, mount.start());
        Point center = present(name).center();
        Point start = new Point(center.x() + offset.x(), center.y() + offset.y(), center.z() + offset.z());
        if (width > 0) {
            return prover.cone(start, direction, Degrees.cos(width / 2), self, Math.min(distance, max), Claim.ALL);
        }
        return distance == Double.POSITIVE_INFINITY
                ? prover.ray(start, direction, self, max, Claim.ALL)
                : prover.ray(start, direction, self, distance, index(world.objects.present(hit)));
    }

    private Point toWorld(int id, Point own) {
        world.objects.toWorld(id, own.x(), own.y(), own.z(), vector);
        return new Point(vector[0], vector[1], vector[2]);
    }

    /** Takes the world as it is now; the index of an object. */
    private int begin(@Nullable String name) {
        if (world.accuracy() != Accuracy.EXACT) {
            throw new IllegalArgumentException(
                    "accuracy must be EXACT for a proof, which is about the objects and not their"
                            + " enclosures (got: " + world.accuracy() + ")");
        }
        world.registry.begin("prove");
        prover = prover.with(scene());
        return name == null ? Claim.ALL : index(name);
    }

    private GeometryObject present(String name) {
        return world.objects.present(world.registry.known(name));
    }

    private int index(String name) {
        return index(present(name));
    }

    private int index(GeometryObject object) {
        List<GeometryObject> objects = prover.scene().objects();
        for (int k = 0; k < objects.size(); k++) {
            if (objects.get(k) == object) {
                return k;
            }
        }
        int found = objects.indexOf(object);
        if (found < 0) {
            throw new IllegalStateException("the object must be in the world (got: " + object + ")");
        }
        return found;
    }
}
