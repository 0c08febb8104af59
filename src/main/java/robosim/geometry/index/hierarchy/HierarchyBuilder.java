package robosim.geometry.index.hierarchy;

import robosim.geometry.index.boxes.SurfaceAreaSplits;

/** Builds the nodes of a {@link Hierarchy} from the top by the surface area heuristic. */
final class HierarchyBuilder {
    /** Ranges of at most so many objects are split along the best of all axes. */
    private static final int FEW = 1 << 12;

    private static final int PART = Hierarchy.PART;

    private final Hierarchy tree;
    private final SurfaceAreaSplits splits;

    /**
     * Takes the objects.
     *
     * @param boxes six floats for each, which are reordered
     * @param ids reordered likewise
     */
    HierarchyBuilder(Hierarchy tree, float[] boxes, int[] ids) {
        this.tree = tree;
        splits = new SurfaceAreaSplits(boxes, ids, FEW);
    }

    /** Fills an empty node with the items of a range: divides the parts with the greatest areas until there are enough. */
    void fill(int node, int from, int to, int depth) {
        int[] starts = {from, to, 0, 0, 0};
        splits.measure(from, to);
        double[] areas = {to - from > 1 ? splits.area() : -1, -1, -1, -1};
        float[] bounds = new float[Hierarchy.LINKS];
        splits.copyBounds(bounds, 0);
        int parts = 1;
        while (parts < Hierarchy.WIDTH) {
            int largest = 0;
            for (int k = 1; k < parts; k++) {
                largest = areas[k] > areas[largest] ? k : largest;
            }
            if (areas[largest] < 0) {
                break;
            }
            int middle = splits.split(starts[largest], starts[largest + 1], depth);
            System.arraycopy(starts, largest + 1, starts, largest + 2, parts - largest);
            System.arraycopy(areas, largest + 1, areas, largest + 2, parts - largest - 1);
            System.arraycopy(bounds, PART * (largest + 1), bounds, PART * (largest + 2), PART * (parts - largest - 1));
            starts[largest + 1] = middle;
            parts++;
            for (int k = largest; k < largest + 2; k++) {
                splits.measure(starts[k], starts[k + 1]);
                areas[k] = starts[k + 1] - starts[k] > 1 ? splits.area() : -1;
                splits.copyBounds(bounds, PART * k);
            }
        }
        for (int k = 0; k < parts; k++) {
            int slot = Hierarchy.WIDTH * node + k;
            System.arraycopy(bounds, PART * k, tree.nodes, Hierarchy.at(slot), PART);
            if (starts[k + 1] - starts[k] == 1) {
                tree.link(slot, Integer.MIN_VALUE | splits.item(starts[k]));
            } else {
                int child = tree.claim();
                tree.link(slot, child);
                fill(child, starts[k], starts[k + 1], depth + 1);
            }
        }
    }
}
