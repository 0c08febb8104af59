package robosim.geometry.engine.motion;

import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.BoxQuery;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.engine.objects.ObjectLeaves;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.engine.objects.WorldBounds;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.Sweep;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.planar.DiscSweepFilter;
import robosim.geometry.narrow.planar.PlainCells;

/**
 * Whether an edge, a straight way from a pose and then a turn in place, is free, as far as doubles tell: most edges of a
 * planner end in the open, or deep in a wall of a grid. The verdict is that of {@link Motion}, which is asked about all others.
 */
final class EdgeFastPath {
    /** More than a place loses when it is stored, as a share of its coordinates. */
    private static final double STORED = 0x1p-46;

    /** Above the root of two. */
    private static final double CORNER = 1.415;

    private final BoxQuery query;
    private final WorldBounds worldBounds;
    private final Sweep sweep;
    private final LeafColumn leaves = new LeafColumn(1);
    private final double[] box = new double[6];

    /** A disc that holds the object however it is turned in place. */
    private final LeafColumn disc = new LeafColumn(1);

    private double middleX;
    private double middleZ;
    private double radius;

    /** More than a place loses, or at a coarser level more than a sweep of the objects in the enclosures may stop early. */
    private double margin;

    EdgeFastPath(ObjectTable objects, WorldBounds worldBounds, Scratch scratch) {
        query = new BoxQuery(objects);
        this.worldBounds = worldBounds;
        sweep = new Sweep(scratch);
        disc.append(1);
        disc.setKind(0, LeafKind.UPRIGHT_CYLINDER);
    }

    /**
     * Whether an edge is free.
     *
     * @param place where it begins, laid out as in the table of objects; upright
     * @return {@link PlainCells#PAST} where it is, {@link PlainCells#MET} where it is not
     */
    int find(AccuracyView view, int id, double[] place, double dx, double dy, double dz, double degrees) {
        boolean isCoarse = view.accuracy != Accuracy.EXACT;
        if (!isCoarse && !view.keepsShape(id)) {
            return PlainCells.UNSURE;
        }
        margin = isCoarse ? MotionSegment.EARLY : STORED;
        ObjectLeaves form = view.form(id);
        leaves.clear();
        leaves.append(form.size());
        form.place(view.dimension, place[0], place[1], place[2], place, 3, leaves, 0);
        leaves.bounds(0, leaves.size(), box);
        boolean turns = degrees != 0 && !(leaves.size() == 1 && isCentredDisc(place));
        enclose(place, turns);
        if (turns && (view.accuracy == Accuracy.AABB || view.accuracy == Accuracy.DOP)) {
            radius *= CORNER; // it holds the object in any attitude, and so the box around it holds what encloses that
        }
        widen(place, dx, dy, dz, turns);
        if (!worldBounds.clearlyHolds(box)) {
            return PlainCells.UNSURE;
        }
        sweep.translation(view.dimension, dx, dy, dz);
        int count = query.gather(view, box, id);
        int found = PlainCells.PAST;
        for (int k = 0; k < count; k++) {
            int other = query.gathered(k);
            LeafTable table = view.table(other);
            boolean isGrid = table.leaves().kind(table.first(other)).isGrid();
            int one = !isGrid
                    ? bounds(table, other, dx, dz)
                    : isCoarse ? PlainCells.UNSURE : grid(view.dimension, table, other, dx, dy, dz, turns);
            if (one == PlainCells.MET) {
                return PlainCells.MET;
            }
            found = one == PlainCells.PAST ? found : PlainCells.UNSURE;
        }
        return found;
    }

    private boolean isCentredDisc(double[] place) {
        double[] row = leaves.rows();
        return leaves.kind(0).isDisc() && row[0] == place[0] && row[2] == place[2];
    }

    /** The disc around the object, or around all places of it on a turn about its centre. */
    private void enclose(double[] place, boolean turns) {
        double halfX = box[3] / 2 - box[0] / 2;
        double halfZ = box[5] / 2 - box[2] / 2;
        middleX = box[0] / 2 + box[3] / 2;
        middleZ = box[2] / 2 + box[5] / 2;
        boolean isDisc = leaves.size() == 1 && leaves.kind(0).isDisc();
        radius = isDisc ? Math.max(halfX, halfZ) : Math.sqrt(halfX * halfX + halfZ * halfZ);
        if (turns) {
            double offX = middleX - place[0];
            double offZ = middleZ - place[2];
            radius += Math.sqrt(offX * offX + offZ * offZ);
            middleX = place[0];
            middleZ = place[2];
        }
        radius *= 1 + 0x1p-45;
    }

    /** Makes the box hold all of the way, and of the turn at its end, however places are rounded. */
    private void widen(double[] place, double dx, double dy, double dz, boolean turns) {
        if (turns) {
            box[0] = Math.min(box[0], middleX - radius);
            box[2] = Math.min(box[2], middleZ - radius);
            box[3] = Math.max(box[3], middleX + radius);
            box[5] = Math.max(box[5], middleZ + radius);
        }
        double size = Math.abs(place[0]) + Math.abs(place[1]) + Math.abs(place[2]);
        size += 2 * (Math.abs(dx) + Math.abs(dy) + Math.abs(dz));
        for (double bound : box) {
            size += Math.abs(bound);
        }
        double slack = margin * size + Double.MIN_NORMAL;
        box[0] += Math.min(0, dx) - slack;
        box[1] += Math.min(0, dy) - slack;
        box[2] += Math.min(0, dz) - slack;
        box[3] += Math.max(0, dx) + slack;
        box[4] += Math.max(0, dy) + slack;
        box[5] += Math.max(0, dz) + slack;
    }

    private int grid(Dimension dimension, LeafTable table, int other, double dx, double dy, double dz, boolean turns) {
        LeafColumn cells = table.leaves();
        int leaf = table.first(other);
        int found = PlainCells.PAST;
        for (int i = 0; i < leaves.size() && found == PlainCells.PAST; i++) {
            found = sweep.passesCells(leaves, i, cells, leaf);
        }
        if (found != PlainCells.PAST || !turns) {
            return found;
        }
        double[] row = disc.rows();
        row[0] = middleX + dx;
        row[1] = box[1] / 2 + box[4] / 2;
        row[2] = middleZ + dz;
        row[3] = radius;
        row[4] = (box[4] / 2 - box[1] / 2) * (1 + 0x1p-45);
        sweep.translation(dimension, 0, 0, 0);
        int around = sweep.passesCells(disc, 0, cells, leaf);
        sweep.translation(dimension, dx, dy, dz);
        return around == PlainCells.PAST ? PlainCells.PAST : PlainCells.UNSURE;
    }

    /** Whether the disc passes by the one around another object's bounds. */
    private int bounds(LeafTable table, int other, double dx, double dz) {
        double[] b = table.bounds();
        int at = table.boundsAt(other);
        double halfX = b[at + 3] / 2 - b[at] / 2;
        double halfZ = b[at + 5] / 2 - b[at + 2] / 2;
        double around = table.isDisc(other) ? Math.max(halfX, halfZ) : Math.sqrt(halfX * halfX + halfZ * halfZ);
        double qx = b[at] / 2 + b[at + 3] / 2 - middleX;
        double qz = b[at + 2] / 2 + b[at + 5] / 2 - middleZ;
        double reach = radius + around;
        double slack = margin
                * (Math.abs(b[at])
                        + Math.abs(b[at + 2])
                        + halfX
                        + halfZ
                        + Math.abs(middleX)
                        + Math.abs(middleZ)
                        + radius);
        // Clear of a disc that it overlaps at the start is not enough: the start must be free too.
        boolean isApart =
                qx * qx + qz * qz > (reach + 2 * slack) * (reach + 2 * slack) * (1 + 0x1p-45) + VectorMath.UNDERFLOW;
        boolean isOnSpot = dx == 0 && dz == 0;
        return isApart
                        && (isOnSpot
                                || DiscSweepFilter.past(qx, qz, dx, dz, reach, slack, false) == DiscSweepFilter.CLEAR)
                ? PlainCells.PAST
                : PlainCells.UNSURE;
    }
}
