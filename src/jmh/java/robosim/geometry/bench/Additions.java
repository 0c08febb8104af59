package robosim.geometry.bench;

import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.function.LongSupplier;
import org.dyn4j.collision.broadphase.AABBProducer;
import org.dyn4j.collision.broadphase.DynamicAABBTree;
import org.dyn4j.collision.broadphase.NullAABBExpansionMethod;
import org.dyn4j.geometry.AABB;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.index.quadtree.Quadtree;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.narrow.Overlap;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;

/**
 * Sequential checked additions, the 2005 report's own measure: each new object is tested against those that are in, and
 * comes in where it touches none. The same objects and the same narrow phase behind a {@link Geometry}, a plain list that
 * asks the narrow phase of each, a list that compares bounds first, JTS's quadtree and dyn4j's dynamic AABB tree, in turn,
 * which {@link Benchmarks} can not: ratios of interleaved rounds.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test
 * -Dexec.mainClass=robosim.geometry.bench.Additions}
 */
@State(Scope.Thread)
public class Additions {
    /** How many objects; the trees of all fit the third cache. */
    @Param({"100", "1000", "10000"})
    public int objects;

    private List<GeometryObject> candidates;
    private double world;

    /** Makes the objects, the same from run to run. */
    @Setup
    public void make() {
        Scene scene = new Scene(objects, 1);
        candidates = scene.objects(objects);
        world = scene.side() + 20;
    }

    /** All of them into a new world of the module, through its public call. */
    @Benchmark
    public long module() {
        return geometry(candidates, world);
    }

    /** To subtract: the leaf and the bounds of each. */
    @Benchmark
    public double loop() {
        Store store = new Store();
        double sum = 0;
        for (GeometryObject object : candidates) {
            store.ask(object);
            sum += store.box[0];
        }
        return sum;
    }

    /** JTS's quadtree before the same narrow phase. */
    @Benchmark
    public long jts() {
        return jts(candidates);
    }

    /** dyn4j's dynamic tree before the same narrow phase. */
    @Benchmark
    public long dyn4j() {
        return dyn4j(candidates);
    }

    /** Asks the question for 1,000 and 10,000 objects. */
    public static void main(String[] args) {
        Timing.print("nanoseconds an addition; x: how many times the module's time, median of the rounds");
        Timing.print(
                "%8s %6s %8s | %8s %8s | %8s %8s | %8s %8s | %8s %8s",
                "objects", "in", "module", "list", "x", "bounds", "x", "JTS", "x", "dyn4j", "x");
        for (int n : new int[] {100, 1_000, 10_000}) {
            row(n);
        }
    }

    private static void row(int n) {
        Scene scene = new Scene(n, 1);
        List<GeometryObject> objects = scene.objects(n);
        double world = scene.side() + 20;
        boolean large = n >= 10_000;
        double[][] nanos = Timing.inTurn(
                large ? 8 : 300,
                large ? 11 : 101,
                () -> geometry(objects, world),
                () -> plainList(objects),
                () -> listOfBounds(objects),
                () -> jts(objects),
                () -> dyn4j(objects));
        long in = geometry(objects, world);
        boolean same =
                in == plainList(objects) && in == listOfBounds(objects) && in == jts(objects) && in == dyn4j(objects);
        if (!same) {
            throw new IllegalStateException("all must let the same objects in");
        }
        Timing.print(
                "%8d %6d %8.0f | %8.0f %8.1f | %8.0f %8.1f | %8.0f %8.1f | %8.0f %8.1f",
                n,
                in,
                Timing.median(nanos[0]) / n,
                Timing.median(nanos[1]) / n,
                Timing.ratio(nanos[1], nanos[0]),
                Timing.median(nanos[2]) / n,
                Timing.ratio(nanos[2], nanos[0]),
                Timing.median(nanos[3]) / n,
                Timing.ratio(nanos[3], nanos[0]),
                Timing.median(nanos[4]) / n,
                Timing.ratio(nanos[4], nanos[0]));
    }

    /** The module's additions of these objects and those behind the same narrow phase in a list and in both trees. */
    static void addTo(List<Workload> all, String size, List<GeometryObject> objects, double world) {
        add(all, Workload.MODULE, size, objects, () -> geometry(objects, world));
        add(all, "plain-list", size, objects, () -> plainList(objects));
        add(all, "jts-quadtree", size, objects, () -> jts(objects));
        add(all, "dyn4j-tree", size, objects, () -> dyn4j(objects));
    }

    private static void add(
            List<Workload> all, String peer, String size, List<GeometryObject> objects, LongSupplier task) {
        Workload.Task<Integer> timed = new Workload.Task<>(() -> 0, none -> {
            long in = task.getAsLong();
            return new Workload.Answer(in, in);
        });
        Workload.Answer truth = all.isEmpty() || peer.equals(Workload.MODULE)
                ? null
                : all.get(all.size() - 1).truth();
        all.add(new Workload(new Workload.Title(peer, "W1c", size), objects.size(), 0, timed, truth));
    }

    private static long geometry(List<GeometryObject> objects, double world) {
        Geometry geometry = new Geometry(world, 10, world, Dimension.PLANAR, Accuracy.EXACT);
        long in = 0;
        for (GeometryObject object : objects) {
            in += geometry.addObject(object) ? 1 : 0;
        }
        return in;
    }

    /** What is in, as flat leaves and bounds: the plain list, and the exact test behind each tree. */
    private static final class Store {
        private final Scratch scratch = new Scratch();
        private final LeafColumn leaves = new LeafColumn(16);
        private double[] bounds = new double[6 * 16];
        private final double[] box = new double[6];
        private LeafColumn candidate = new LeafColumn(1);

        /** Makes an object the one that is asked about. */
        void ask(GeometryObject object) {
            candidate = LocalLeaves.placed(object);
            LeafBounds.of(candidate.kind(0), candidate.rows(), 0, box);
        }

        boolean hits(int k) {
            return Overlap.test(Dimension.PLANAR, candidate, 0, leaves, k, scratch);
        }

        boolean hitsAny() {
            for (int k = 0; k < leaves.size(); k++) {
                if (hits(k)) {
                    return true;
                }
            }
            return false;
        }

        boolean hitsAnyByBounds() {
            for (int k = 0; k < leaves.size(); k++) {
                int b = 6 * k;
                boolean near = bounds[b] <= box[3]
                        && box[0] <= bounds[b + 3]
                        && bounds[b + 2] <= box[5]
                        && box[2] <= bounds[b + 5];
                if (near && hits(k)) {
                    return true;
                }
            }
            return false;
        }

        int add() {
            int k = leaves.appendWhole(candidate, 0, 1);
            if (6 * k + 6 > bounds.length) {
                bounds = Arrays.copyOf(bounds, 2 * bounds.length);
            }
            System.arraycopy(box, 0, bounds, 6 * k, 6);
            return k;
        }
    }

    private static long plainList(List<GeometryObject> objects) {
        Store store = new Store();
        for (GeometryObject object : objects) {
            store.ask(object);
            if (!store.hitsAny()) {
                store.add();
            }
        }
        return store.leaves.size();
    }

    /** A list that compares bounds first, in one flat array: as fast as a list can be. */
    private static long listOfBounds(List<GeometryObject> objects) {
        Store store = new Store();
        for (GeometryObject object : objects) {
            store.ask(object);
            if (!store.hitsAnyByBounds()) {
                store.add();
            }
        }
        return store.leaves.size();
    }

    private static long jts(List<GeometryObject> objects) {
        Store store = new Store();
        Quadtree tree = new Quadtree();
        for (GeometryObject object : objects) {
            store.ask(object);
            Envelope envelope = new Envelope(store.box[0], store.box[3], store.box[2], store.box[5]);
            boolean free = true;
            for (Object found : tree.query(envelope)) {
                if (store.hits((Integer) found)) {
                    free = false;
                    break;
                }
            }
            if (free) {
                tree.insert(envelope, store.add());
            }
        }
        return store.leaves.size();
    }

    private record Item(int index, AABB box) {}

    private static long dyn4j(List<GeometryObject> objects) {
        Store store = new Store();
        DynamicAABBTree<Item> tree =
                new DynamicAABBTree<>((x, y) -> true, new ItemBox(), new NullAABBExpansionMethod<>());
        for (GeometryObject object : objects) {
            store.ask(object);
            AABB box = new AABB(store.box[0], store.box[2], store.box[3], store.box[5]);
            boolean free = true;
            for (Iterator<Item> found = tree.detectIterator(box); found.hasNext() && free; ) {
                free = !store.hits(found.next().index());
            }
            if (free) {
                tree.add(new Item(store.add(), box));
            }
        }
        return store.leaves.size();
    }

    /** An item's box, as dyn4j asks for it. */
    private static final class ItemBox implements AABBProducer<Item> {
        @Override
        public AABB compute(Item item) {
            return item.box().copy();
        }

        @Override
        public void compute(Item item, AABB out) {
            out.set(item.box());
        }
    }
}
