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
import robosim.geometry.WorkLimit;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** Decides which robots of a world can reach each other, and so which are shut in, as {@link WorldCheck} defines it. */
final class RobotReachability {
    /** The levels of searches after the first: at the desired step, and with that halved twice. */
    private static final int LEVELS = 3;

    /** Maximum number of cells that are looked at for upper bounds of areas: about a second among boxes and cylinders. */
    private static final int CELLS = 400_000;

    private final World world;
    private final CheckProgress watch;
    private final WorkLimit meter;
    private final List<GeometryObject> robots = new ArrayList<>();

    /** By robot, one with which it shares a room; in the end the same one for all robots of a room. */
    private final int[] leaders;

    /** By robot, its last search; null if there was none. */
    private final @Nullable GridSearch[] searches;

    private final Map<String, GridSearch> byName = new HashMap<>();

    /** @param touching names of robots that start in contact and are not tested */
    RobotReachability(World world, Set<String> touching, CheckProgress watch, WorkLimit meter) {
        this.world = world;
        this.watch = watch;
        this.meter = meter;
        for (WorldObject object : world.objects()) {
            String name = object.object().name();
            if (object.object().isMoveable() && name != null && !touching.contains(name)) {
                robots.add(object.object());
            }
        }
        leaders = new int[robots.size()];
        Arrays.setAll(leaders, k -> k);
        searches = new GridSearch[robots.size()];
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
        Geometry geometry = statics.snapshot().toGeometry();
        statics.limitWork(meter);
        geometry.limitWork(meter);
        for (int level = 0; level <= LEVELS; level++) {
            for (int k : toSearch(level)) {
                search(geometry, statics, k, level);
            }
            if (isDone()) {
                break;
            }
        }
        refine(statics);
        if (!isDone()) {
            lookNear(geometry, statics);
        }
        return rooms(new AreaBound(world, statics, CELLS, watch));
    }

    /**
     * Searches each room again at finer steps until the step is the desired one or the places become too many: a step
     * wider than a corridor ends at its first bend, and what it reached is then a small part of what can be reached.
     */
    private void refine(Geometry statics) {
        for (List<Integer> group : groups()) {
            GridSearch last = largest(group);
            int k = last == null ? -1 : Arrays.asList(searches).indexOf(last);
            while (last != null) {
                GridSearch finer = last.finer(world, statics);
                if (finer != null) {
                    explore(finer, k, false);
                    // An unfinished search may have covered less than the coarser one.
                    if (finer.isWhole() || finer.area() > last.area()) {
                        searches[k] = finer;
                    }
                }
                last = finer != null && finer.isWhole() ? finer : null;
            }
        }
    }

    /** The most informative search of a robot; null if it starts in contact. */
    @Nullable
    GridSearch search(String name) {
        if (byName.isEmpty()) {
            for (List<Integer> group : groups()) {
                GridSearch largest = largest(group);
                for (int k : group) {
                    GridSearch own = searches[k] == null ? largest : searches[k];
                    if (own != null) {
                        byName.put(String.valueOf(robots.get(k).name()), own);
                    }
                }
            }
        }
        return byName.get(name);
    }

    /**
     * If the step of all searches was too coarse to decide, a finer one near the start may find that there is no way
     * out.
     */
    private void lookNear(Geometry geometry, Geometry statics) {
        List<List<Integer>> groups = groups();
        for (List<Integer> group : groups) {
            GridSearch far = largest(group);
            boolean isMain = groups.size() > 1 && group == groups.get(0) && !isStuck(group);
            if (far == null || far.isFine() || isMain) {
                continue;
            }
            int k = group.stream().min(narrowestFirst()).orElseThrow();
            GridSearch near = GridSearch.near(world, geometry, statics, robots.get(k));
            if (near == null) {
                continue;
            }
            explore(near, k, false);
            // An unfinished search says less than the coarse one through the whole world.
            if (near.isWhole()) {
                group.forEach(each -> searches[each] = null);
                searches[k] = near;
            }
        }
    }

    /**
     * The robots to search for, at first all, later one of each room but the main one, which a way out of another leads to,
     * in order of how well they fit through doors. A robot that has been reached by another need not search.
     */
    private List<Integer> toSearch(int level) {
        Comparator<Integer> order = narrowestFirst();
        if (level > 0) {
            List<List<Integer>> groups = groups();
            return groups.stream()
                    .filter(group -> group != groups.get(0) || isStuck(group))
                    .map(group -> group.stream().min(order).orElseThrow())
                    .toList();
        }
        List<Integer> all = new ArrayList<>();
        for (int k = 0; k < robots.size(); k++) {
            all.add(k);
        }
        all.sort(order);
        return all;
    }

    private Comparator<Integer> narrowestFirst() {
        return Comparator.<Integer, Boolean>comparing(k -> isMany(robots.get(k)))
                .thenComparingDouble(k -> PlaceGrid.narrow(robots.get(k)));
    }

    /** Whether it has so many parts that moving it is slow. */
    static boolean isMany(GeometryObject robot) {
        return robot instanceof ObjectGroup group
                ? group.members().stream().anyMatch(RobotReachability::isMany)
                : robot instanceof MeshObject;
    }

    private boolean isStuck(List<Integer> group) {
        GridSearch largest = largest(group);
        return largest != null && largest.places() == 1;
    }

    private void search(Geometry geometry, Geometry statics, int k, int level) {
        GridSearch search = GridSearch.far(world, geometry, statics, robots.get(k), level);
        GridSearch last = searches[k];
        boolean coarse = last != null && search.step() >= last.step();
        if (coarse || (level == 0 && hasSearched(k))) {
            return;
        }
        searches[k] = search;
        explore(search, k, level > 0);
    }

    /** @param isOver whether the search ends when all others are reached */
    private void explore(GridSearch search, int k, boolean isOver) {
        List<Integer> others = new ArrayList<>();
        for (int other = 0; other < robots.size(); other++) {
            if (leader(other) != leader(k)) {
                others.add(other);
            }
        }
        List<GeometryObject> wanted = others.stream().map(robots::get).toList();
        search.run(wanted, isOver && !wanted.isEmpty(), met -> leaders[leader(others.get(met))] = leader(k), watch);
    }

    private boolean hasSearched(int k) {
        for (int other = 0; other < robots.size(); other++) {
            if (searches[other] != null && leader(other) == leader(k)) {
                return true;
            }
        }
        return false;
    }

    private boolean isDone() {
        List<List<Integer>> groups = groups();
        boolean moves = true;
        for (GridSearch search : searches) {
            moves &= search == null || search.places() > 1;
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

    /** The robots by room: most robots first, then the largest search, then in the world's order. */
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
        GridSearch largest = largest(group);
        return largest == null ? 0 : largest.area();
    }

    private @Nullable GridSearch largest(List<Integer> group) {
        GridSearch best = null;
        for (int k : group) {
            GridSearch search = searches[k];
            if (search != null && (best == null || search.isBetterThan(best))) {
                best = search;
            }
        }
        return best;
    }

    private List<Room> rooms(AreaBound bound) {
        List<Room> rooms = new ArrayList<>();
        for (List<Integer> group : groups()) {
            List<String> names = group.stream()
                    .map(k -> String.valueOf(robots.get(k).name()))
                    .toList();
            GridSearch search = largest(group);
            if (search == null) {
                throw new IllegalStateException("no robot searched from " + names);
            }
            rooms.add(search.room(names, bound));
        }
        return rooms;
    }
}
