package robosim.geometry.bench;

import java.util.Iterator;
import java.util.List;
import java.util.SplittableRandom;
import org.dyn4j.collision.broadphase.AABBProducer;
import org.dyn4j.collision.broadphase.DynamicAABBTree;
import org.dyn4j.collision.broadphase.NullAABBExpansionMethod;
import org.dyn4j.geometry.AABB;
import robosim.geometry.Geometry;
import robosim.geometry.bench.Workload.Answer;
import robosim.geometry.bench.Workload.Task;
import robosim.geometry.bench.Workload.Title;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.Sweep;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;

/**
 * Attempted moves in a swarm at constant density: n discs of radius 0.5 in a square of side 3 sqrt(n), each of which tries
 * to go forward by up to one unit in a direction of its own and is refused where anything blocks the way. Hits are the
 * moves that were made. Beside the module: dyn4j's dynamic AABB tree and a plain list of bounds before the same sweep.
 */
final class Swarm {
    private static final double RADIUS = 0.5;

    private final int count;
    private final int passes;
    private final String[] names;
    private final double[] x;
    private final double[] z;
    private final double[] wayX;
    private final double[] wayZ;
    private final double world;

    Swarm(int count) {
        this.count = count;
        passes = Math.max(1, 10_000 / count);
        double side = 3 * Math.sqrt(count);
        world = side + 2;
        SplittableRandom random = new SplittableRandom(count);
        names = new String[count];
        x = new double[count];
        z = new double[count];
        wayX = new double[count];
        wayZ = new double[count];
        for (int k = 0; k < count; k++) {
            names[k] = "robot " + k;
            x[k] = random.nextDouble(-side / 2, side / 2);
            z[k] = random.nextDouble(-side / 2, side / 2);
            wayX[k] = random.nextDouble(-0.7, 0.7);
            wayZ[k] = random.nextDouble(-0.7, 0.7);
        }
    }

    static void addTo(List<Workload> all, int count) {
        Swarm swarm = new Swarm(count);
        long moves = 2L * count * swarm.passes;
        Task<Geometry> module = new Task<>(swarm::geometry, swarm::moveAll);
        Workload own = new Workload(new Title(Workload.MODULE, "W4", "" + count), moves, 0, module, null);
        all.add(own);
        Task<Flock> tree = new Task<>(() -> swarm.new Flock(true), Flock::moveAll);
        all.add(new Workload(new Title("dyn4j-tree", "W4", "" + count), moves, 0, tree, own.truth()));
        if (count <= 1000) {
            Task<Flock> list = new Task<>(() -> swarm.new Flock(false), Flock::moveAll);
            all.add(new Workload(new Title("list-of-bounds", "W4", "" + count), moves, 0, list, own.truth()));
        }
    }

    Geometry geometry() {
        Geometry geometry = new Geometry(world, 10, world, Dimension.PLANAR, Accuracy.EXACT);
        for (int k = 0; k < count; k++) {
            geometry.addObjectUnchecked(new CylinderObject(new Point(x[k], 0, z[k]), RADIUS, 2).moveable(names[k]));
        }
        return geometry;
    }

    /** All there and all back again, as far as they can. */
    private Answer moveAll(Geometry geometry) {
        long made = 0;
        for (int pass = 0; pass < passes; pass++) {
            for (int k = 0; k < count; k++) {
                made += geometry.simpleMove(names[k], wayX[k], 0, wayZ[k]) ? 1 : 0;
            }
            for (int k = count - 1; k >= 0; k--) {
                made += geometry.simpleMove(names[k], -wayX[k], 0, -wayZ[k]) ? 1 : 0;
            }
        }
        return new Answer(made, made);
    }

    /** One of the moves of a pass, numbered from 0 to twice the count: all there, then all back again. */
    boolean move(Geometry geometry, int step) {
        int k = robot(step);
        double sign = step < count ? 1 : -1;
        return geometry.simpleMove(names[k], sign * wayX[k], 0, sign * wayZ[k]);
    }

    private int robot(int step) {
        return step < count ? step : 2 * count - 1 - step;
    }

    double wayX(int step) {
        return wayX[robot(step)];
    }

    private record Item(int index) {}

    /** The same discs behind dyn4j's tree or none, before the module's own sweep. */
    final class Flock implements AABBProducer<Item> {
        private final boolean hasTree;
        private final DynamicAABBTree<Item> tree =
                new DynamicAABBTree<>((a, b) -> true, this, new NullAABBExpansionMethod<>());
        private final Item[] items = new Item[count];
        private final Sweep sweep = new Sweep(new Scratch());
        private final LeafColumn leaves = new LeafColumn(count);
        private AABB swept = new AABB(0, 0, 0, 0);

        Flock(boolean hasTree) {
            this.hasTree = hasTree;
            for (int k = 0; k < count; k++) {
                items[k] = new Item(k);
                leaves.appendWhole(LocalLeaves.placed(new CylinderObject(new Point(x[k], 0, z[k]), RADIUS, 2)), 0, 1);
                if (hasTree) {
                    tree.add(items[k]);
                }
            }
        }

        Answer moveAll() {
            long made = 0;
            for (int pass = 0; pass < passes; pass++) {
                for (int k = 0; k < count; k++) {
                    made += move(k, wayX[k], wayZ[k]) ? 1 : 0;
                }
                for (int k = count - 1; k >= 0; k--) {
                    made += move(k, -wayX[k], -wayZ[k]) ? 1 : 0;
                }
            }
            return new Answer(made, made);
        }

        boolean move(int step) {
            int k = robot(step);
            double sign = step < count ? 1 : -1;
            return move(k, sign * wayX[k], sign * wayZ[k]);
        }

        private boolean move(int k, double dx, double dz) {
            double[] rows = leaves.rows();
            double px = rows[16 * k];
            double pz = rows[16 * k + 2];
            if (Math.abs(px + dx) + RADIUS > world / 2 || Math.abs(pz + dz) + RADIUS > world / 2) {
                return false;
            }
            sweep.translation(Dimension.PLANAR, dx, 0, dz);
            swept = new AABB(
                    Math.min(px, px + dx) - RADIUS,
                    Math.min(pz, pz + dz) - RADIUS,
                    Math.max(px, px + dx) + RADIUS,
                    Math.max(pz, pz + dz) + RADIUS);
            if (hasTree ? isBlockedInTree(k) : isBlockedInList(k)) {
                return false;
            }
            rows[16 * k] = px + dx;
            rows[16 * k + 2] = pz + dz;
            if (hasTree) {
                tree.update(items[k]);
            }
            return true;
        }

        private boolean isBlockedInTree(int k) {
            for (Iterator<Item> found = tree.detectIterator(swept); found.hasNext(); ) {
                if (blocks(k, found.next().index)) {
                    return true;
                }
            }
            return false;
        }

        private boolean isBlockedInList(int k) {
            double[] rows = leaves.rows();
            for (int other = 0; other < count; other++) {
                double ox = rows[16 * other];
                double oz = rows[16 * other + 2];
                boolean near = ox - RADIUS <= swept.getMaxX()
                        && swept.getMinX() <= ox + RADIUS
                        && oz - RADIUS <= swept.getMaxY()
                        && swept.getMinY() <= oz + RADIUS;
                if (near && blocks(k, other)) {
                    return true;
                }
            }
            return false;
        }

        private boolean blocks(int k, int other) {
            return k != other && sweep.free(leaves, k, leaves, other) != Double.POSITIVE_INFINITY;
        }

        @Override
        public AABB compute(Item item) {
            double[] rows = leaves.rows();
            double px = rows[16 * item.index];
            double pz = rows[16 * item.index + 2];
            return new AABB(px - RADIUS, pz - RADIUS, px + RADIUS, pz + RADIUS);
        }

        @Override
        public void compute(Item item, AABB out) {
            out.set(compute(item));
        }
    }
}
