package robosim.geometry.world.check;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.WorkLimit;
import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.world.SonarRing;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldImport;
import robosim.geometry.world.WorldObject;

/**
 * Examines a world before robots are simulated in it: which objects overlap, which robots start in contact, which
 * robots can reach each other, and which accuracy and dimension its queries need. The same world always gives the same
 * result.
 *
 * <p><b>Rooms.</b> Each robot, that is, each moveable object, explores the world on a grid that begins at its own
 * place, by straight moves of one step along the world's X and Z at its own height. A robot that is not round also
 * turns in place, by 45 degrees at a time. Each of these moves is checked by a {@link robosim.geometry.Geometry} of the
 * static objects, so everything reached is truly reachable; what is not reached may still be reachable by moves off the
 * grid, so the step is reported, and with it an upper bound of what any motion reaches, {@link Room#most}. The first step is half of the robot's smaller extent, or coarser in a large world; it
 * is halved until it is half of that extent or the places become too many, and then twice more if not every robot is
 * reached. All other moveable objects are removed, as they may drive away. A
 * robot reaches another if, from a place at which the bodies are within two steps of touching, its body moves straight
 * to the other and hits nothing else first. Two robots share a room if one of them reaches the other, directly or
 * through further ones. The narrowest robots search first, and a robot that has been reached does not search. Robots
 * that start in contact or outside the world are not tested; one that stands on a floor is tested just above it. If the step had to be coarser than half of the smaller
 * extent, a search near the start uses steps of that half; if that does not finish either, it is unknown whether the
 * robots are shut in, and {@link Room#isTold} is false.
 *
 * <p><b>Needs.</b> The same queries, drawn from a fixed seed, are made in both dimensions at each accuracy: whether a
 * robot may stand at a place, whether it may make a random move or turn from there, and what one of its sonars measures
 * (in a world without sonars, a line in a random direction). The places are random; for each robot they include its own
 * start and some places that it reached. A setting is sufficient if it answers all of them as EXACT in the world's own
 * dimension does. No more are made once each setting that could still be recommended has answered otherwise. Nothing is decided if fewer than {@link SettingComparison#MIN_ANSWERS} moves or distances could be queried, for
 * lack of free places or of robots, or if none of them hit anything; nor for an incomplete world, of which objects are
 * outside or were left out of the file. A robot that is a mesh, and therefore slow, gets a
 * twentieth of the queries of others.
 *
 * @param world          the world checked
 * @param counts         number of objects of each kind that occurs
 * @param members        number of members of groups
 * @param triangles      number of triangles of all meshes, a quad counting as two
 * @param robots         the moveable objects
 * @param sonars         number of sensors in all rings
 * @param outside        objects that extend beyond the world's bounds; they are ignored in the rest of the check
 * @param overlaps       pairs in contact: those with a moveable object, and the first ones of two static objects. A moveable
 *                       object has at most {@value #MAX_STARTING_CONTACTS} that hinder it, and where there are thousands of
 *                       those, at least one
 * @param staticOverlaps number of pairs of static objects in contact, including those in {@code overlaps}; {@link #MOST_COUNTED}
 *                       for that many or more
 * @param pile           the place with the most objects if not all pairs were compared; null if all were
 * @param rooms          groups of robots that can reach each other; the first room has the most
 * @param needs          which accuracy and dimension are sufficient
 */
public record WorldCheck(
        World world,
        Map<GeometryObject.Kind, Integer> counts,
        int members,
        long triangles,
        List<WorldObject> robots,
        int sonars,
        List<WorldObject> outside,
        List<Overlap> overlaps,
        int staticOverlaps,
        @Nullable Pile pile,
        List<Room> rooms,
        RecommendedSetting needs) {

    /** Maximum number of pairs of static objects in {@code overlaps}. */
    public static final int MAX_STATIC_OVERLAPS = 100;

    /** Maximum number of contacts of one moveable object in {@code overlaps} that hinder it. */
    public static final int MAX_STARTING_CONTACTS = 100;

    /** Maximum number of pairs of static objects that are counted. */
    public static final int MOST_COUNTED = 100_000;

    /** Copies the collections. */
    public WorldCheck {
        counts = Collections.unmodifiableMap(new EnumMap<>(counts));
        robots = List.copyOf(robots);
        outside = List.copyOf(outside);
        overlaps = List.copyOf(overlaps);
        rooms = List.copyOf(rooms);
    }

    /** Checks a world. */
    public static WorldCheck of(World world) {
        return of(world, (work, done, total) -> {});
    }

    /**
     * Checks a world within a limit: all that is asked of it counts as one call, and each report to the watch as a unit.
     *
     * @throws robosim.geometry.WorkLimitException if it takes more, or the limit is cancelled
     */
    public static WorldCheck of(World world, CheckProgress watch, WorkLimit limit) {
        return of(world, watch, true, Checks.present("limit", limit));
    }

    /** Checks a world and reports progress. */
    public static WorldCheck of(World world, CheckProgress watch) {
        return of(world, watch, true, WorkLimit.none());
    }

    /** Checks the world of a file and reports progress. If parts of the file were left out, {@code needs} is undecided. */
    public static WorldCheck of(WorldImport read, CheckProgress watch) {
        Checks.present("read", read);
        return of(read.world(), watch, read.isWhole(), WorkLimit.none());
    }

    private static WorldCheck of(World world, CheckProgress told, boolean isWhole, WorkLimit limit) {
        Checks.present("world", world);
        Checks.present("watch", told);
        WorkLimit meter = limit.meter("a check");
        CheckProgress watch = (work, done, total) -> {
            meter.take(1);
            told.at(work, done, total);
        };
        Map<GeometryObject.Kind, Integer> counts = new EnumMap<>(GeometryObject.Kind.class);
        Pieces pieces = new Pieces();
        int sonars = 0;
        for (WorldObject object : world.objects()) {
            counts.merge(object.object().kind(), 1, Integer::sum);
            pieces.add(object.object());
            sonars += object.sonars().stream().mapToInt(SonarRing::count).sum();
        }
        Set<WorldObject> left = Collections.newSetFromMap(new IdentityHashMap<>());
        List<WorldObject> outside = new ArrayList<>();
        world.toGeometry(object -> {
            left.add(object);
            outside.add(object);
        });
        World inside = outside.isEmpty() ? world : without(world, left);
        // What was dropped may be what the answers depend on.
        boolean isComplete = isWhole && outside.isEmpty();
        Overlaps overlaps = new Overlaps(inside, watch, meter);
        World free = FloorSupport.raised(inside, overlaps.found());
        // Ten worlds, which are not needed before the robots have searched: built on another thread until then.
        CompletableFuture<List<SettingTally>> tallies =
                CompletableFuture.supplyAsync(() -> isComplete ? SettingTally.all(free) : List.of());
        Set<String> touching = new HashSet<>();
        for (Overlap overlap : overlaps.found()) {
            if (FloorSupport.isStanding(overlap)) {
                continue;
            }
            touching.add(
                    overlap.isStart() ? String.valueOf(overlap.first().object().name()) : "");
            boolean both = overlap.second().object().isMoveable();
            touching.add(both ? String.valueOf(overlap.second().object().name()) : "");
        }
        RobotReachability reachability = new RobotReachability(free, touching, watch, meter);
        List<Room> found = reachability.find();
        return new WorldCheck(
                world,
                counts,
                pieces.members,
                pieces.triangles,
                world.objects().stream().filter(o -> o.object().isMoveable()).toList(),
                sonars,
                outside,
                overlaps.found(),
                overlaps.staticCount(),
                overlaps.pile(),
                found,
                isComplete
                        ? new SampleQueries(free, reachability, pieces.triangles, limited(tallies.join(), meter), watch)
                                .ask()
                        : RecommendedSetting.undecided(world));
    }

    /** The worlds of all settings, whose questions count from now on. */
    private static List<SettingTally> limited(List<SettingTally> tallies, WorkLimit meter) {
        tallies.forEach(tally -> tally.geometry.limitWork(meter));
        return tallies;
    }

    private static World without(World world, Set<WorldObject> left) {
        return world.withObjects(
                world.objects().stream().filter(o -> !left.contains(o)).toList());
    }

    /**
     * Robots that cannot reach the room with the most robots: all rooms except the first and those for which this is
     * unknown.
     */
    public List<Room> shutIn() {
        return rooms.stream().skip(1).filter(Room::isTold).toList();
    }

    /** Robots that cannot make a step. */
    public List<Room> stuck() {
        return rooms.stream()
                .filter(room -> room.isTold() && room.places() == 1)
                .toList();
    }

    /**
     * Rooms of robots that reached no others, or no other place, at a step too coarse to conclude that there is no way.
     */
    public List<Room> untold() {
        return IntStream.range(0, rooms.size())
                .filter(k -> k > 0 || rooms.get(k).places() == 1)
                .mapToObj(rooms::get)
                .filter(room -> !room.isTold())
                .toList();
    }

    /** Contacts in which a moveable object starts, other than with what it stands on. */
    public List<Overlap> startingContacts() {
        return overlaps.stream()
                .filter(each -> each.isStart() && !FloorSupport.isStanding(each))
                .toList();
    }

    /**
     * The falls of robots below which there is nothing but the lower border of a world where heights count, by more than their
     * own height, as soon as bodies move by themselves. They are no findings: moves and sonars know no gravity.
     */
    public static List<Fall> falls(World world) {
        return FloorSupport.falls(Checks.present("world", world));
    }

    /**
     * A fall that is to be expected.
     *
     * @param robot what falls
     * @param drop  how far, world units
     */
    public record Fall(WorldObject robot, double drop) {}

    /**
     * Whether nothing was found that hinders robots: nothing is outside, no robot starts in contact, is shut in or is
     * unable to make a step. Static objects may overlap, as the walls of a plan do, and {@link #untold} rooms are not
     * findings.
     */
    public boolean isFine() {
        return outside.isEmpty() && startingContacts().isEmpty() && shutIn().isEmpty() && stuck().isEmpty();
    }

    /** Counts the parts of groups and meshes. */
    private static final class Pieces {
        int members;
        long triangles;

        void add(GeometryObject object) {
            if (object instanceof ObjectGroup group) {
                members += group.members().size();
                group.members().forEach(this::add);
            } else if (object instanceof MeshObject mesh) {
                for (int[] face : mesh.faces()) {
                    triangles += face.length - 2;
                }
            }
        }
    }
}
