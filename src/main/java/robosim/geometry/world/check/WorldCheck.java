package robosim.geometry.world.check;

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
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.world.SonarRing;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

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
 * fewer than {@link Setting#MIN_ANSWERS} moves or distances could be asked, as nobody has room or there is no robot, and where none
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
