package robosim.geometry.engine.motion;

import robosim.geometry.engine.broadphase.Candidates;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.objects.IgnoredPairs;
import robosim.geometry.engine.objects.ObjectLeaves;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.GridWalk;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.MeshWalk;

/** Puts objects of a world at places of any attitude, and shows what is around them: for rooms that find a way themselves. */
public final class Placer {
    /** Takes the convex pieces near an object. */
    public interface Pieces {
        /**
         * Takes a piece; the row is valid until this method returns.
         *
         * @param object the id of the object of which it is a piece
         */
        void piece(int object, LeafKind kind, double[] row, int at);
    }

    public final ObjectTable objects;

    /** What passes through each other, and so is not around each other. */
    public final IgnoredPairs passing;

    private final ObjectRegistry registry;
    private final Motion motion;
    private final Candidates candidates;
    private final MeshWalk meshes;
    private final GridWalk grids;
    private final double[] triangle = new double[9];
    private final double[] bounds = new double[6];

    public Placer(ObjectRegistry registry, Motion motion) {
        meshes = new MeshWalk(registry.work);
        grids = new GridWalk(registry.work);
        this.registry = registry;
        this.motion = motion;
        objects = registry.objects;
        passing = new IgnoredPairs(objects, registry.attachments);
        candidates = new Candidates(objects);
    }

    /** Whether objects are met as they are, and not as what stands for them. */
    public boolean isExact() {
        return registry.view.accuracy == Accuracy.EXACT;
    }

    /** Writes the leaves of a moveable object at a place, laid out as in the table of objects. */
    public void leaves(int id, double[] place, LeafColumn out) {
        ObjectLeaves form = registry.view.form(id);
        out.clear();
        out.append(form.size());
        form.place(Dimension.SPATIAL, place[0], place[1], place[2], place, 3, out, 0);
    }

    /** Whether a moveable object would touch nothing at a place, and be within the world; exact. */
    public boolean isFree(int id, double[] place) {
        passing.begin(id);
        try {
            return registry.fitsAt(id, place) && !registry.collidesAt(registry.view, id, place);
        } finally {
            passing.end();
        }
    }

    /** Puts a moveable object at a place that is known to be free. */
    public void put(int id, double[] place) {
        registry.move(id, place);
    }

    /**
     * Goes by a displacement as far as it is free; exact.
     *
     * @param gap how far to stay from what blocks
     * @return the share that was made: 1 for all
     */
    public double toContact(int id, double dx, double dy, double dz, double gap) {
        passing.begin(id);
        try {
            boolean all = motion.attemptBeside(registry.view, id, dx, dy, dz, 0, gap);
            motion.commit();
            return all ? 1 : motion.fraction();
        } finally {
            passing.end();
        }
    }

    /** Shows all pieces of other objects whose bounds meet a box. */
    public void around(int id, double[] box, Pieces out) {
        passing.begin(id);
        try {
            candidates.find(registry.view, box, id);
            candidates.sort(); // so that sums over contacts do not depend on the shape of a tree
        } finally {
            passing.end();
        }
        for (int k = 0; k < candidates.count(); k++) {
            int other = candidates.id(k);
            LeafTable table = registry.view.table(other);
            LeafColumn leaves = table.leaves();
            int first = table.first(other);
            for (int leaf = first; leaf < first + table.count(other); leaf++) {
                registry.work.take();
                pieces(other, leaves, leaf, box, out);
            }
        }
    }

    private void pieces(int other, LeafColumn leaves, int leaf, double[] box, Pieces out) {
        LeafKind kind = leaves.kind(leaf);
        if (kind.isMesh()) {
            meshes.startBox(leaves, leaf, box);
            for (int t = meshes.next(0); t >= 0; t = meshes.next(0)) {
                meshes.corners(t, triangle, 0);
                LeafBounds.of(LeafKind.TRIANGLE, triangle, 0, bounds);
                if (overlaps(box)) {
                    out.piece(other, LeafKind.TRIANGLE, triangle, 0);
                }
            }
        } else if (kind.isGrid()) {
            grids.startBox(leaves, leaf, box);
            for (int cell = grids.nextInBox(); cell >= 0; cell = grids.nextInBox()) {
                LeafColumn piece = grids.piece(cell, LeafKind.BOX);
                out.piece(other, piece.kind(0), piece.rows(), 0);
            }
        } else {
            leaves.bounds(leaf, bounds);
            if (overlaps(box)) {
                out.piece(other, kind, leaves.rows(leaf), leaves.at(leaf));
            }
        }
    }

    private boolean overlaps(double[] box) {
        for (int k = 0; k < 3; k++) {
            if (bounds[k] > box[3 + k] || bounds[3 + k] < box[k]) {
                return false;
            }
        }
        return true;
    }
}
