package robosim.geometry.world;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;

/**
 * What there is to know of a world before robots are let loose in it: what stands in what, who starts in contact, who can
 * get to whom, and which accuracy and dimension its questions need. The same world has the same check.
 *
 * <p><b>Rooms.</b> A robot, which is every moveable object, is taken through the world on a grid that begins at its own
 * place: from each place that it can get to by straight moves of one step along the world's X and Z at its own height. What
 * is not round also turns in place, by 45 degrees at a time. Each of these moves is one that a {@link
 * robosim.geometry.Geometry} of the static objects allows, so what is reached is reached; what is not may be reached by
 * moves between those of the grid, and the step is told. The first step is half of the robot's smaller extent, or coarser
 * in a large world; it is halved twice where not everything is reached. All other moveable objects are taken out, as they
 * may drive away. A robot can get to another where, from so near that the bodies would touch but for two steps, its body goes straight
 * to the other and meets nothing else first; two robots share a room where one of them can get to the other, also by way of
 * further ones. The narrowest go first, and who has been met need not go. Who starts in contact or outside of the world is
 * not asked. Where the step had to be coarser than half of the smaller extent, a search near the start goes in steps of
 * that half; where it comes to no end either, it could not be told whether the robots are shut in, and {@link Room#isTold}
 * is false.
 *
 * <p><b>Needs.</b> The same questions, drawn from a fixed seed, are put to the world in both dimensions at each accuracy:
 * may a robot stand at a place, may it make a random move or turn from there, what does one of its sonars hear (in
 * a world without sonars, a line in a random direction). The places are random, and for each robot also its own start and
 * some that it got to. A setting is enough where it answers all of them as EXACT in the world's own dimension does; where
 * fewer than {@link #MIN_ANSWERS} moves or distances could be asked, as nobody has room or there is no robot, and where none
 * of them met anything, nothing can be told. A robot that is a mesh, and so slow, asks a twentieth of what others do.
 *
 * @param world           what was checked
 * @param counts          how many objects of each kind, for the kinds that there are
 * @param members         objects that the groups are made of
 * @param triangles       of all meshes, a quad being two
 * @param robots          the moveable objects
 * @param sonars          sensors of all rings
 * @param outside         objects that reach beyond the border; none of what follows knows them
 * @param overlaps        pairs in contact: all that a moveable object takes part in, and the first of static objects
 * @param staticOverlaps  how many pairs of static objects are in contact, those in {@code overlaps} included
 * @param rooms           the robots that can get to each other; the first room is the one with most of them
 * @param needs           which accuracy and dimension is enough
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
        List<Room> rooms,
        Needs needs) {

    /** Most pairs of static objects that are told one by one. */
    public static final int MAX_STATIC_OVERLAPS = 100;

    /** So many moves and as many distances must be asked for a setting to be called enough. */
    public static final int MIN_ANSWERS = 50;

    /** Copies the collections. */
    public WorldCheck {
        counts = Collections.unmodifiableMap(new EnumMap<>(counts));
        robots = List.copyOf(robots);
        outside = List.copyOf(outside);
        overlaps = List.copyOf(overlaps);
        rooms = List.copyOf(rooms);
    }

    /**
     * Two objects in contact.
     *
     * @param first   the moveable one, or the earlier of two static ones
     * @param second  what it touches or overlaps
     * @param contact a point of both
     * @param normal  of length 1, from the second towards the first
     * @param depth   how far the first must go along {@code normal} to be clear of the second, to within a hundredth,
     *                world units; 0 where they only touch, {@code +Infinity} where that way does not lead out
     */
    public record Overlap(WorldObject first, WorldObject second, Point contact, Point normal, double depth) {
        /** Whether a moveable object starts in this contact. */
        public boolean isStart() {
            return first.object().isMoveable();
        }
    }

    /**
     * A part of the world that robots share.
     *
     * @param robots their names, in the world's order
     * @param minX   of the places that the centre of one of them gets to, and half of its smaller side around them; so are
     *               the other three
     * @param area   of the places that the centre of one of them gets to, world units squared: their number times the
     *               square of the step
     * @param places how many places of the grid that are; 1 where the robot cannot make a step
     * @param step   the grid's, world units: finer ways may have been missed
     * @param isTold whether the step was as fine as half of the robot's smaller extent, where it has any; else what was not reached tells
     *               nothing
     */
    public record Room(
            List<String> robots,
            double minX,
            double minZ,
            double maxX,
            double maxZ,
            double area,
            int places,
            double step,
            boolean isTold) {
        /** Copies the list. */
        public Room {
            robots = List.copyOf(robots);
        }
    }

    /**
     * Which setting is enough.
     *
     * @param dimension the coarsest that answered every question alike; PLANAR in a PLANAR world, and the world's own where
     *                  it cannot be told
     * @param accuracy  the coarsest that did so in that dimension; the world's own where it cannot be told
     * @param isProven  whether PLANAR is enough whatever level moves and sonars are asked for: every object stands upright
     *                  and reaches the height of every robot's centre
     * @param met       how many of the questions met something: a place that is taken, a move that is refused, a sonar that
     *                  hears; none tells nothing
     * @param seed      of the questions
     * @param settings  what each setting answered, PLANAR before SPATIAL and the coarsest first
     */
    public record Needs(
            Dimension dimension, Accuracy accuracy, boolean isProven, int met, long seed, List<Setting> settings) {
        /** Copies the list. */
        public Needs {
            settings = List.copyOf(settings);
        }

        /** Whether enough was asked, and enough was there, to tell. */
        public boolean isTold() {
            return met > 0 && settings.stream().allMatch(Setting::isAskedEnough);
        }

        /** What one setting answered. */
        public Setting setting(Dimension wanted, Accuracy level) {
            return settings.stream()
                    .filter(setting -> setting.dimension() == wanted && setting.accuracy() == level)
                    .findFirst()
                    .orElseThrow(() -> new IllegalArgumentException(
                            "setting must have been asked (got: " + wanted + ", " + level + ")"));
        }
    }

    /**
     * What one setting answered, beside EXACT in the world's own dimension.
     *
     * @param places            how often it was asked whether a robot may stand somewhere
     * @param placesOtherwise   how often it said something else
     * @param moves             moves and turns
     * @param movesOtherwise    of them answered otherwise
     * @param distances         of sonars
     * @param distancesOtherwise of them off by more than a billionth of the world's diagonal
     * @param shortest          by how much a distance fell short at most, world units; {@code +Infinity} where it heard
     *                          something where there is no echo
     */
    public record Setting(
            Dimension dimension,
            Accuracy accuracy,
            int places,
            int placesOtherwise,
            int moves,
            int movesOtherwise,
            int distances,
            int distancesOtherwise,
            double shortest) {
        /** Whether there were enough moves and distances to compare. */
        public boolean isAskedEnough() {
            return moves >= MIN_ANSWERS && distances >= MIN_ANSWERS;
        }

        /** Whether enough was asked and everything was answered alike. */
        public boolean isSame() {
            return isAskedEnough() && placesOtherwise + movesOtherwise + distancesOtherwise == 0;
        }
    }

    /** Told how far a check is; it may take a while. */
    @FunctionalInterface
    public interface Watch {
        /** So much of that work is done. */
        void at(String work, long done, long total);
    }

    /** Checks a world. */
    public static WorldCheck of(World world) {
        return of(world, (work, done, total) -> {});
    }

    /** Checks a world and tells how far that is. */
    public static WorldCheck of(World world, Watch watch) {
        Checks.present("world", world);
        Checks.present("watch", watch);
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
        Overlaps overlaps = new Overlaps(inside, watch);
        Set<String> touching = new HashSet<>();
        for (Overlap overlap : overlaps.found()) {
            touching.add(
                    overlap.isStart() ? String.valueOf(overlap.first().object().name()) : "");
            boolean both = overlap.second().object().isMoveable();
            touching.add(both ? String.valueOf(overlap.second().object().name()) : "");
        }
        Rooms rooms = new Rooms(inside, touching, watch);
        List<Room> found = rooms.find();
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
                found,
                new Questions(inside, rooms, watch).ask());
    }

    private static World without(World world, Set<WorldObject> left) {
        return new World(
                world.width(),
                world.height(),
                world.length(),
                world.unit(),
                world.dimension(),
                world.accuracy(),
                world.objects().stream().filter(o -> !left.contains(o)).toList());
    }

    /** Robots that cannot get to where most are: all rooms but the first, and but those of which that cannot be told. */
    public List<Room> shutIn() {
        return rooms.stream().skip(1).filter(Room::isTold).toList();
    }

    /** Robots that cannot make a step. */
    public List<Room> stuck() {
        return rooms.stream()
                .filter(room -> room.isTold() && room.places() == 1)
                .toList();
    }

    /** Robots that got to no others or nowhere at a step that is too coarse to say that there is no way. */
    public List<Room> untold() {
        return IntStream.range(0, rooms.size())
                .filter(k -> k > 0 || rooms.get(k).places() == 1)
                .mapToObj(rooms::get)
                .filter(room -> !room.isTold())
                .toList();
    }

    /** Contacts in which a moveable object starts. */
    public List<Overlap> startingContacts() {
        return overlaps.stream().filter(Overlap::isStart).toList();
    }

    /**
     * Whether nothing was found that keeps robots from what they are there for: nothing is outside, no robot starts in
     * contact, none is shut in or cannot make a step. Static objects may overlap, as the walls of a plan do, and {@link
     * #untold} is no finding.
     */
    public boolean isFine() {
        return outside.isEmpty() && startingContacts().isEmpty() && shutIn().isEmpty() && stuck().isEmpty();
    }

    /** What groups and meshes are made of. */
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
