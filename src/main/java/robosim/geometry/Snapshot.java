package robosim.geometry;

import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serial;
import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import robosim.geometry.check.Checks;
import robosim.geometry.engine.World;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.broadphase.SharedIndex;
import robosim.geometry.engine.objects.Attachments;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.engine.objects.WorldBounds;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;

/**
 * An immutable copy of a world at one moment. Its static objects and the trees over them are built once and shared by
 * all worlds made from it. Each such world costs only its moveable objects and its working memory, and gives the same
 * answers, to the bit, as the original world.
 *
 * <p>Many threads may make worlds from one snapshot at once and query their own. A world made from it may be changed
 * like any other, without effect on the others. Static objects added to it belong to it alone; before a shared static
 * object is removed, the world makes its own copy of all of them, which takes as long as adding them.
 *
 * <p>Serialized as plain values: settings, shapes, names and places with their rounding errors, so worlds made from the
 * deserialized snapshot give the same bits. Placements of one mesh still share its triangles. What is read is checked
 * as objects added to a new world are. As with all Java serialization, read only data from a source that you trust.
 */
public final class Snapshot implements WorldQueries, Serializable {
    private static final long serialVersionUID = 1;

    private final transient Settings settings;
    private final transient SharedIndex statics;
    private final transient GeometryObject[] movers;

    /** For each moveable object, how many objects had been added before it. */
    private final transient long[] arrivals;

    /** How many objects had been added, removed ones included. */
    private final transient long time;

    /** Who answers questions about this snapshot itself. */
    private final transient WorldCopies copies;

    /** How many threads may work on one answer. */
    private final transient int threads;

    private Snapshot(Settings settings, SharedIndex statics, GeometryObject[] movers, long[] arrivals, long time) {
        this.settings = settings;
        this.statics = statics;
        this.movers = movers;
        this.arrivals = arrivals;
        this.time = time;
        copies = new WorldCopies(() -> toGeometry().engine());
        threads = 1;
        statics.table(settings.accuracy); // else the first query would have to wait for it
    }

    /** The same snapshot, with another number of threads. */
    private Snapshot(Snapshot of, int threads) {
        settings = of.settings;
        statics = of.statics;
        movers = of.movers;
        arrivals = of.arrivals;
        time = of.time;
        copies = of.copies;
        this.threads = threads;
    }

    private record Settings(double width, double height, double length, Dimension dimension, Accuracy accuracy) {
        SharedIndex statics(GeometryObject[] objects, long[] arrivals) {
            return new SharedIndex(width, length, dimension, objects, arrivals);
        }
    }

    static Snapshot of(Geometry world, ObjectRegistry registry) {
        ObjectTable objects = registry.objects;
        Settings settings =
                new Settings(world.width(), world.height(), world.length(), world.dimension(), world.accuracy());
        SharedIndex shared = registry.share(() -> {
            int[] fixed = objects.ids().filter(id -> !objects.isMoveable(id)).toArray();
            return settings.statics(present(objects, fixed), times(objects, fixed));
        });
        int[] ids = objects.moverIds().toArray();
        return new Snapshot(settings, shared, present(objects, ids), times(objects, ids), objects.arrivals());
    }

    private static GeometryObject[] present(ObjectTable objects, int[] ids) {
        return Arrays.stream(ids).mapToObj(objects::present).toArray(GeometryObject[]::new);
    }

    private static long[] times(ObjectTable objects, int[] ids) {
        return Arrays.stream(ids).mapToLong(objects::arrival).toArray();
    }

    @Override
    public double width() {
        return settings.width;
    }

    @Override
    public double height() {
        return settings.height;
    }

    @Override
    public double length() {
        return settings.length;
    }

    @Override
    public Dimension dimension() {
        return settings.dimension;
    }

    @Override
    public Accuracy accuracy() {
        return settings.accuracy;
    }

    /** The number of objects. */
    public int size() {
        return movers.length + statics.objects.size();
    }

    @Override
    public List<GeometryObject> objects() {
        record Arrival(GeometryObject object, long time) {}
        Stream<Arrival> fixed = IntStream.range(0, statics.objects.size())
                .mapToObj(id -> new Arrival(statics.objects.value(id), statics.arrival(id)));
        Stream<Arrival> moving = IntStream.range(0, movers.length).mapToObj(k -> new Arrival(movers[k], arrivals[k]));
        return Stream.concat(fixed, moving)
                .sorted(Comparator.comparingLong(Arrival::time))
                .map(Arrival::object)
                .toList();
    }

    /** Makes an independent world in the state of this snapshot. Safe to call from many threads at once. */
    public Geometry toGeometry() {
        return toGeometry(new Scratch());
    }

    /**
     * Makes many worlds for one thread, which share their working memory: each takes a fifth of the memory of one from
     * {@link #toGeometry()}. All of them must be used by the same thread at a time.
     *
     * @param count number of worlds; at least 0
     */
    public List<Geometry> toGeometries(int count) {
        Checks.count(count);
        Scratch scratch = new Scratch();
        List<Geometry> worlds = new ArrayList<>(count);
        for (int k = 0; k < count; k++) {
            worlds.add(toGeometry(scratch));
        }
        return List.copyOf(worlds);
    }

    /**
     * The same objects in a SPATIAL world, where heights count: what cameras see of a PLANAR one. The world is made as high
     * as needed, since a PLANAR one does not bound heights. A SPATIAL snapshot is returned as it is.
     */
    public Snapshot withHeights() {
        if (dimension() == Dimension.SPATIAL) {
            return this;
        }
        double half = settings.height / 2;
        for (GeometryObject object : objects()) {
            half = Math.max(
                    half, Math.max(-object.bounds().minY(), object.bounds().maxY()));
        }
        Settings high =
                new Settings(width(), Checks.worldSize("height", 2 * half), length(), Dimension.SPATIAL, accuracy());
        GeometryObject[] fixed = IntStream.range(0, statics.objects.size())
                .mapToObj(statics.objects::value)
                .toArray(GeometryObject[]::new);
        long[] came =
                IntStream.range(0, fixed.length).mapToLong(statics::arrival).toArray();
        return new Snapshot(high, high.statics(fixed, came), movers, arrivals, time);
    }

    /**
     * The same world as pictures show it: with heights, and with the visuals of each object in its place. It is larger, if
     * visuals reach beyond it. A SPATIAL snapshot without visuals is returned as it is.
     */
    public Snapshot asSeen() {
        List<GeometryObject> all = objects();
        if (all.stream().allMatch(object -> object.visuals() == null)) {
            return withHeights();
        }
        List<GeometryObject> seen = new ArrayList<>();
        double[] size = {width(), height(), length()};
        for (GeometryObject object : all) {
            GeometryObject look = object.seen();
            if (look != null) {
                seen.add(look);
                Bounds box = look.bounds();
                size[0] = Math.max(size[0], 2 * Math.max(-box.minX(), box.maxX()));
                size[1] = Math.max(size[1], 2 * Math.max(-box.minY(), box.maxY()));
                size[2] = Math.max(size[2], 2 * Math.max(-box.minZ(), box.maxZ()));
            }
        }
        Geometry world = new Geometry(
                Checks.worldSize("width", size[0]),
                Checks.worldSize("height", size[1]),
                Checks.worldSize("length", size[2]),
                Dimension.SPATIAL,
                accuracy());
        seen.forEach(world::addObjectUnchecked);
        return world.snapshot();
    }

    private Geometry toGeometry(Scratch scratch) {
        Geometry world = new Geometry(width(), height(), length(), dimension(), accuracy(), statics, scratch);
        for (int k = 0; k < movers.length; k++) {
            world.restore(movers[k], arrivals[k]);
        }
        world.restored(time);
        return world;
    }

    /**
     * The same snapshot, but up to a number of threads work on each batch of poses or edges. As with
     * {@link SenseOptions#withThreads}, the calling thread is helped by those of the {@link java.util.concurrent.ForkJoinPool} that it
     * belongs to, or of the common one; all have finished when a call returns, and it waits for none that is busy with something
     * else. No call starts threads of its own. The snapshot keeps a working copy of the world for each thread that has been at
     * work for it at once.
     *
     * @param count from 1, as at first, to 1024
     */
    public Snapshot withThreads(int count) {
        return new Snapshot(this, Checks.threads(count));
    }

    @Override
    public void sense(String name, Pose mount, RayPattern pattern, SenseOptions options, SenseBuffer out) {
        copies.sense(Checks.present("name", name), Checks.present("mount", mount), pattern, options, out);
    }

    @Override
    public void sense(Pose sensor, RayPattern pattern, SenseOptions options, SenseBuffer out) {
        copies.sense(null, Checks.present("sensor", sensor), pattern, options, out);
    }

    @Override
    public void castRays(double[] rays, int count, SenseBuffer out) {
        World world = copies.borrow();
        try {
            Geometry.castRays(world, rays, count, out);
        } finally {
            copies.giveBack(world);
        }
    }

    @Override
    public int freeRays(double[] rays, int count, long[] free) {
        World world = copies.borrow();
        try {
            return Geometry.freeRays(world, rays, count, -1, free);
        } finally {
            copies.giveBack(world);
        }
    }

    @Override
    public int freeRays(double[] rays, int count, String ignored, long[] free) {
        World world = copies.borrow();
        try {
            return Geometry.freeRays(
                    world, rays, count, world.registry.known(Checks.present("ignored", ignored)), free);
        } finally {
            copies.giveBack(world);
        }
    }

    @Override
    public int freePoses(String name, double[] poses, long[] free) {
        Checks.present("name", name);
        if (threads > 1) {
            return copies.answer(PlaceBatch.standing(name, poses, free), threads);
        }
        World world = copies.borrow(); // without a batch, so that nothing is allocated
        try {
            return Geometry.freePoses(world, name, poses, free);
        } finally {
            copies.giveBack(world);
        }
    }

    @Override
    public int freeEdges(String name, double[] edges, long[] free) {
        Checks.present("name", name);
        if (threads > 1) {
            return copies.answer(PlaceBatch.driving(name, edges, free), threads);
        }
        World world = copies.borrow();
        try {
            return Geometry.freeEdges(world, name, edges, free);
        } finally {
            copies.giveBack(world);
        }
    }

    @Override
    public int freePoses(String name, double[] poses, Avoidance avoid, long[] free) {
        return copies.answer(PlaceBatch.poses(name, poses, avoid, free), threads);
    }

    @Override
    public int freeEdges(String name, double[] edges, Avoidance avoid, long[] free) {
        return copies.answer(PlaceBatch.edges(name, edges, avoid, free), threads);
    }

    @Override
    public int edgeFractions(String name, double[] edges, Avoidance avoid, double[] fractions) {
        return copies.answer(PlaceBatch.fractions(name, edges, avoid, fractions), threads);
    }

    @Override
    public int driveFractions(String name, double[] drives, Avoidance avoid, double[] fractions) {
        return copies.answer(PlaceBatch.drives(name, drives, avoid, fractions), threads);
    }

    @Override
    public int clearances(String name, double[] poses, double max, Avoidance avoid, double[] out) {
        return copies.answer(PlaceBatch.clearances(name, poses, max, avoid, out), threads);
    }

    /** The serialized form of a snapshot. */
    private record Form(
            double width, double height, double length, Dimension dimension, Accuracy accuracy, ObjectRows objects)
            implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        @Serial
        private Object readResolve() throws InvalidObjectException {
            try {
                return snapshot();
            } catch (IllegalArgumentException e) {
                InvalidObjectException invalid = new InvalidObjectException("no snapshot: " + e.getMessage());
                invalid.initCause(e);
                throw invalid;
            }
        }

        private Snapshot snapshot() {
            Settings settings = new Settings(
                    Checks.worldSize("width", width),
                    Checks.worldSize("height", height),
                    Checks.worldSize("length", length),
                    Checks.present("dimension", dimension),
                    Checks.present("accuracy", accuracy));
            List<GeometryObject> all = Checks.present("objects", objects).objects();
            check(all);
            int[] fixed = ids(all, false);
            int[] moving = ids(all, true);
            SharedIndex statics = settings.statics(at(all, fixed), times(fixed));
            return new Snapshot(settings, statics, at(all, moving), times(moving), all.size());
        }

        /** Refuses objects that a world would refuse. */
        private void check(List<GeometryObject> all) {
            WorldBounds worldBounds = new WorldBounds(width, height, length, dimension);
            LeafColumn leaves = new LeafColumn(1);
            Set<String> names = new HashSet<>();
            for (GeometryObject object : all) {
                String name = object.name();
                if (name != null && !names.add(name)) {
                    throw new IllegalArgumentException(
                            "name must be unique in its world (got: \"" + name + "\" again)");
                }
                if (Attachments.carries(object)) {
                    Attachments.forEachPart(object, (part, pose) -> {
                        if (!part.equals(name) && !names.add(part)) {
                            throw new IllegalArgumentException(
                                    "the names of loads must be unique in their world (got: \"" + part + "\" again)");
                        }
                    });
                }
                LocalLeaves.placed(object, leaves);
                if (!worldBounds.holds(leaves, 0, leaves.size())) {
                    throw new IllegalArgumentException("every object must be within the world (got: " + object + ")");
                }
            }
        }

        private static int[] ids(List<GeometryObject> all, boolean moveable) {
            return IntStream.range(0, all.size())
                    .filter(k -> all.get(k).isMoveable() == moveable)
                    .toArray();
        }

        private static GeometryObject[] at(List<GeometryObject> all, int[] ids) {
            return Arrays.stream(ids).mapToObj(all::get).toArray(GeometryObject[]::new);
        }

        private static long[] times(int[] ids) {
            return Arrays.stream(ids).asLongStream().toArray();
        }
    }

    @Serial
    private Object writeReplace() {
        return new Form(width(), height(), length(), dimension(), accuracy(), ObjectRows.of(objects()));
    }

    @Serial
    private void readObject(ObjectInputStream in) throws InvalidObjectException {
        throw new InvalidObjectException("a snapshot must come as its serial form (got: its own class)");
    }
}
