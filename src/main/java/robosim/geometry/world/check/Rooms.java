package robosim.geometry.world.check;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** Which robots of a world can get to each other, as {@link WorldCheck} defines it. */
final class Rooms {
    /** How often the step is halved. */
    private static final int HALVINGS = 2;

    private final World world;
    private final Watch watch;
    private final List<GeometryObject> robots = new ArrayList<>();

    /** Of each robot, one that it shares a room with, and in the end the same one for all of a room. */
    private final int[] leaders;

    /** Of each robot, its last trip; null where it has not been sent out. */
    private final @Nullable GridReachability[] trips;

    private final Map<String, GridReachability> byName = new HashMap<>();

    /** @param touching the names of robots that are not asked */
    Rooms(World world, Set<String> touching, Watch watch) {
        this.world = world;
        this.watch = watch;
        for (WorldObject object : world.objects()) {
            String name = object.object().name();
            if (object.object().isMoveable() && name != null && !touching.contains(name)) {
                robots.add(object.object());
            }
        }
        leaders = new int[robots.size()];
        Arrays.setAll(leaders, k -> k);
        trips = new GridReachability[robots.size()];
    }

    List<Room> find() {
        if (robots.isEmpty()) {
            return List.of();
        }
        Geometry statics =
                new Geometry(world.width(), world.height(), world.length(), world.dimension(), world.accuracy());
        for (WorldObject object : world.objects()) {
            if (!object.object().isMoveable()) {
                statics.addObjectUnchecked(object.object());
            }
        }
        for (int halvings = 0; halvings <= HALVINGS; halvings++) {
            for (int k : toBeSent(halvings)) {
                send(statics, k, halvings);
            }
            if (isDone()) {
                break;
            }
        }
        if (!isDone()) {
            lookNear(statics);
        }
        return rooms();
    }

    /** The trip that tells most of where a robot gets to; null where it starts in contact. */
    @Nullable
    GridReachability trip(String name) {
        if (byName.isEmpty()) {
            for (List<Integer> group : groups()) {
                GridReachability largest = largest(group);
                for (int k : group) {
                    GridReachability own = trips[k] == null ? largest : trips[k];
                    if (own != null) {
                        byName.put(String.valueOf(robots.get(k).name()), own);
                    }
                }
            }
        }
        return byName.get(name);
    }

    /** Where the step of all trips was too coarse to tell, a finer one may find that there is no way out near the start. */
    private void lookNear(Geometry statics) {
        for (List<Integer> group : groups()) {
            GridReachability far = largest(group);
            if (far == null || far.isFine()) {
                continue;
            }
            int k = group.stream().min(narrowestFirst()).orElseThrow();
            GridReachability near = GridReachability.near(world, statics, robots.get(k));
            if (near == null) {
                continue;
            }
            go(near, k);
            // What came to no end says less than the coarse trip through all of the world.
            if (near.isWhole()) {
                group.forEach(each -> trips[each] = null);
                trips[k] = near;
            }
        }
    }

    /**
     * At first all, later one of each room: those that fit through most doors before the others. Who has been met by one of
     * them need not go himself.
     */
    private List<Integer> toBeSent(int halvings) {
        Comparator<Integer> order = narrowestFirst();
        if (halvings > 0) {
            return groups().stream()
                    .map(group -> group.stream().min(order).orElseThrow())
                    .toList();
        }
        List<Integer> sent = new ArrayList<>();
        for (int k = 0; k < robots.size(); k++) {
            sent.add(k);
        }
        sent.sort(order);
        return sent;
    }

    private Comparator<Integer> narrowestFirst() {
        return Comparator.<Integer, Boolean>comparing(k -> isMany(robots.get(k)))
                .thenComparingDouble(k -> Enclosure.of(robots.get(k)).narrow());
    }

    /** Whether it has so many parts that it moves slowly. */
    static boolean isMany(GeometryObject robot) {
        return switch (robot.kind()) {
            case MESH -> true;
            case GROUP -> ((ObjectGroup) robot).members().stream().anyMatch(Rooms::isMany);
            case BOX, CYLINDER, SPHERE -> false;
        };
    }

    private void send(Geometry statics, int k, int halvings) {
        GridReachability trip = GridReachability.far(world, statics, robots.get(k), halvings);
        GridReachability last = trips[k];
        boolean coarse = last != null && trip.step() >= last.step();
        if (coarse || (halvings == 0 && anyTrip(k))) {
            return;
        }
        trips[k] = trip;
        go(trip, k);
    }

    private void go(GridReachability trip, int k) {
        List<Integer> others = new ArrayList<>();
        for (int other = 0; other < robots.size(); other++) {
            if (leader(other) != leader(k)) {
                others.add(other);
            }
        }
        List<GeometryObject> wanted = others.stream().map(robots::get).toList();
        trip.go(wanted, met -> leaders[leader(others.get(met))] = leader(k), watch);
    }

    private boolean anyTrip(int k) {
        for (int other = 0; other < robots.size(); other++) {
            if (trips[other] != null && leader(other) == leader(k)) {
                return true;
            }
        }
        return false;
    }

    private boolean isDone() {
        List<List<Integer>> groups = groups();
        boolean moves = true;
        for (GridReachability trip : trips) {
            moves &= trip == null || trip.places() > 1;
        }
        return groups.size() == 1 && moves;
    }

    private int leader(int k) {
        int at = k;
        while (leaders[at] != at) {
            at = leaders[at];
        }
        return at;
    }

    /** The robots by room: the most first, then those with the largest trip, then in the world's order. */
    private List<List<Integer>> groups() {
        List<List<Integer>> groups = new ArrayList<>();
        for (int k = 0; k < robots.size(); k++) {
            if (leader(k) == k) {
                List<Integer> group = new ArrayList<>();
                for (int other = 0; other < robots.size(); other++) {
                    if (leader(other) == k) {
                        group.add(other);
                    }
                }
                groups.add(group);
            }
        }
        groups.sort(Comparator.<List<Integer>>comparingInt(group -> -group.size())
                .thenComparing(
                        Comparator.<List<Integer>>comparingDouble(this::area).reversed())
                .thenComparing(group -> group.get(0)));
        return groups;
    }

    private double area(List<Integer> group) {
        GridReachability largest = largest(group);
        return largest == null ? 0 : largest.area();
    }

    private @Nullable GridReachability largest(List<Integer> group) {
        GridReachability best = null;
        for (int k : group) {
            GridReachability trip = trips[k];
            if (trip != null && (best == null || trip.area() > best.area())) {
                best = trip;
            }
        }
        return best;
    }

    private List<Room> rooms() {
        List<Room> rooms = new ArrayList<>();
        for (List<Integer> group : groups()) {
            List<String> names = group.stream()
                    .map(k -> String.valueOf(robots.get(k).name()))
                    .toList();
            GridReachability trip = largest(group);
            if (trip == null) {
                throw new IllegalStateException("nobody was sent out from " + names);
            }
            rooms.add(trip.room(names));
        }
        return rooms;
    }
}
