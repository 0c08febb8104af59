package robosim.geometry.engine.broadphase;

import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.index.QuadCursor;
import robosim.geometry.index.hierarchy.NearestCursor;
import robosim.geometry.narrow.Distance;

/** Shows a target the objects around a box, nearest first, and none farther than the target still looks. */
public final class NearestSearch {
    /** More than what a square may lose by underflow. */
    private static final double UNDERFLOW = 0x1p-1000;

    private final ObjectTable objects;
    private final NearestTarget target;

    public NearestSearch(ObjectTable objects, NearestTarget target) {
        this.objects = objects;
        this.target = target;
    }

    /**
     * Searches a world.
     *
     * @param box the bounds of an object, six numbers
     * @param limit how far the target looks before it has found anything
     * @param ignored an object that is left out, as the one whose bounds these are
     */
    public void search(AccuracyView view, double[] box, double limit, int ignored) {
        LeafTable shared = view.shared;
        double reach = shared == null ? limit : searchTable(shared, box, limit, ignored);
        searchTable(view.own, box, reach, ignored);
    }

    private double searchTable(LeafTable table, double[] box, double limit, int ignored) {
        double reach = searchTrees(table, box, limit, ignored);
        for (int k = 0; k < table.gridCount(); k++) {
            if (table.grid(k) != ignored) {
                reach = target.visit(table, table.grid(k), reach);
            }
        }
        for (int k = 0; k < table.moversBesideTree(); k++) {
            if (objects.mover(k) != ignored) {
                reach = target.visit(table, objects.mover(k), reach);
            }
        }
        return reach;
    }

    private double searchTrees(LeafTable table, double[] box, double limit, int ignored) {
        double sizes = Distance.sides(box) + table.widest();
        double x = box[0] / 2 + box[3] / 2;
        double z = box[2] / 2 + box[5] / 2;
        double hx = Math.max(box[3] - x, x - box[0]);
        double hz = Math.max(box[5] - z, z - box[2]);
        SpaceIndex space = table.space;
        if (space == null) {
            double radius = Math.sqrt(hx * hx + hz * hz + UNDERFLOW) * (1 + 0x1p-50);
            return searchPlane(table, x, z, radius, sizes, limit, ignored);
        }
        double y = box[1] / 2 + box[4] / 2;
        double hy = Math.max(box[4] - y, y - box[1]);
        double radius = Math.sqrt(hx * hx + hy * hy + hz * hz + UNDERFLOW) * (1 + 0x1p-50);
        space.nearest.around(x, y, z);
        space.nearest.start(space.still, space.moving);
        return searchSpace(table, space.nearest, radius, sizes, limit, ignored);
    }

    private double searchPlane(
            LeafTable table, double x, double z, double radius, double sizes, double limit, int ignored) {
        double reach = limit;
        QuadCursor cursor = table.cursor;
        cursor.startPoint(x, z);
        for (int local = cursor.next(Distance.reach(reach, sizes) + radius);
                local >= 0;
                local = cursor.next(Distance.reach(reach, sizes) + radius)) {
            if ((local | table.mark) != ignored) {
                reach = target.visit(table, local | table.mark, reach);
            }
        }
        return reach;
    }

    private double searchSpace(
            LeafTable table, NearestCursor cursor, double radius, double sizes, double limit, int ignored) {
        double reach = limit;
        for (int local = cursor.next(Distance.reach(reach, sizes) + radius);
                local >= 0;
                local = cursor.next(Distance.reach(reach, sizes) + radius)) {
            if ((local | table.mark) != ignored) {
                reach = target.visit(table, local | table.mark, reach);
            }
        }
        return reach;
    }
}
