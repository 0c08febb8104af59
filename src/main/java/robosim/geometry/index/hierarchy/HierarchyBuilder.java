package robosim.geometry.index.hierarchy;

import robosim.geometry.index.meshes.SurfaceAreaSplits;

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

    /** Fills the empty root with all items. */
    void fill(int root, int size) {
        Parts all = new Parts();
        all.starts[1] = size;
        measure(all, 0);
        fill(root, all, 0, 0);
    }

    /** Fills an empty node with one of the parts of the node above: divides the greatest until there are enough. */
    private void fill(int node, Parts above, int part, int depth) {
        Parts parts = new Parts(above, part);
        int largest = 0;
        while (parts.count < Hierarchy.WIDTH && parts.areas[largest] >= 0) {
            int middle = splits.split(
                    parts.starts[largest],
                    parts.starts[largest + 1],
                    depth,
                    parts.bounds,
                    parts.middles,
                    PART * largest);
            parts.divide(largest, middle);
            measure(parts, largest);
            measure(parts, largest + 1);
            largest = parts.largest();
        }
        for (int k = 0; k < parts.count; k++) {
            int slot = Hierarchy.WIDTH * node + k;
            System.arraycopy(parts.bounds, PART * k, tree.nodes, Hierarchy.at(slot), PART);
            if (parts.size(k) == 1) {
                tree.link(slot, Integer.MIN_VALUE | splits.item(parts.starts[k]));
            } else {
                int child = tree.claim();
                tree.link(slot, child);
                fill(child, parts, k, depth + 1);
            }
        }
    }

    private void measure(Parts parts, int k) {
        splits.measure(parts.starts[k], parts.starts[k + 1]);
        splits.copyBounds(parts.bounds, PART * k);
        splits.copyMiddles(parts.middles, PART * k);
        parts.areas[k] = parts.size(k) > 1 ? splits.area() : -1;
    }

    /** Ranges of items that become the children of a node, and what has been measured of each. */
    private static final class Parts {
        /** Where each begins, and where the last one ends. */
        final int[] starts = new int[Hierarchy.WIDTH + 1];

        /** Half the surface area of the bounds; -1 of a single item. */
        final double[] areas = new double[Hierarchy.WIDTH];

        final float[] bounds = new float[Hierarchy.LINKS];

        /** The bounds of twice the centres. */
        final float[] middles = new float[Hierarchy.LINKS];

        int count = 1;

        Parts() {}

        /** One of the parts of another node. */
        Parts(Parts of, int k) {
            starts[0] = of.starts[k];
            starts[1] = of.starts[k + 1];
            areas[0] = of.areas[k];
            System.arraycopy(of.bounds, PART * k, bounds, 0, PART);
            System.arraycopy(of.middles, PART * k, middles, 0, PART);
        }

        int size(int k) {
            return starts[k + 1] - starts[k];
        }

        int largest() {
            int largest = 0;
            for (int k = 1; k < count; k++) {
                largest = areas[k] > areas[largest] ? k : largest;
            }
            return largest;
        }

        /** Makes room for a part after another one, which then ends where the new one begins. */
        void divide(int k, int middle) {
            int after = count - k - 1;
            System.arraycopy(starts, k + 1, starts, k + 2, after + 1);
            System.arraycopy(areas, k + 1, areas, k + 2, after);
            System.arraycopy(bounds, PART * (k + 1), bounds, PART * (k + 2), PART * after);
            System.arraycopy(middles, PART * (k + 1), middles, PART * (k + 2), PART * after);
            starts[k + 1] = middle;
            count++;
        }
    }
}
