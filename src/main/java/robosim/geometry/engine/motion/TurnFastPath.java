package robosim.geometry.engine.motion;

import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.BoxQuery;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Attitude;
import robosim.geometry.model.Accuracy;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * Decides turns of upright objects about the vertical through their centre where no sweep is needed for that: what turns in
 * itself, and enclosures with nothing around them.
 */
final class TurnFastPath {
    /** More than rounding adds to a radius, as a share of it. */
    private static final double ROUNDING = 1 + 0x1p-40;

    private final ObjectRegistry registry;
    private final ObjectTable objects;
    private final BoxQuery query;
    private final double[] box = new double[6];

    TurnFastPath(ObjectRegistry registry) {
        this.registry = registry;
        objects = registry.objects;
        query = new BoxQuery(objects);
    }

    /**
     * Whether any turn is free. One disc about its centre stays where it is to the bit, and so do its enclosures, except for
     * boxes that turn with it.
     */
    boolean isFree(AccuracyView view, int mover) {
        return Attitude.isUpright(objects.places(), objects.place(mover) + ObjectTable.ROTATION)
                && ((view.accuracy != Accuracy.OBB
                                && objects.value(mover).kind().isRound())
                        || (view.accuracy != Accuracy.EXACT && hasRoom(view, mover)));
    }

    /**
     * The view in which a turn is decided: that of the objects themselves where the enclosure is a ball about the centre,
     * which stays where it is.
     */
    AccuracyView deciding(AccuracyView view, int mover) {
        return view.accuracy == Accuracy.SPHERE && isBallAboutCentre(view.table(mover), mover)
                ? registry.at(Accuracy.EXACT)
                : view;
    }

    private boolean isBallAboutCentre(LeafTable own, int mover) {
        int leaf = own.first(mover);
        double[] row = own.leaves().rows(leaf);
        int at = own.leaves().at(leaf);
        double[] places = objects.places();
        int place = objects.place(mover);
        return own.leaves().kind(leaf) == LeafKind.SPHERE
                && row[at] == places[place]
                && row[at + 1] == places[place + 1]
                && row[at + 2] == places[place + 2];
    }

    /** Whether nothing is in the box around all places of the enclosure, whatever the turn. */
    private boolean hasRoom(AccuracyView view, int mover) {
        LeafTable own = view.table(mover);
        double[] b = own.bounds();
        int at = own.boundsAt(mover);
        double[] places = objects.places();
        int place = objects.place(mover);
        double x = places[place];
        double z = places[place + 2];
        double halfX = Math.max(Math.abs(b[at] - x), Math.abs(b[at + 3] - x));
        double halfZ = Math.max(Math.abs(b[at + 2] - z), Math.abs(b[at + 5] - z));
        double radius = Math.sqrt(halfX * halfX + halfZ * halfZ) * ROUNDING;
        double size = Math.abs(x) + Math.abs(z) + Math.abs(places[place + 1]) + 4 * radius;
        double slack = MotionSegment.EARLY * (size + Math.abs(b[at + 1]) + Math.abs(b[at + 4])) + Double.MIN_NORMAL;
        box[0] = x - radius - slack;
        box[1] = b[at + 1] - slack;
        box[2] = z - radius - slack;
        box[3] = x + radius + slack;
        box[4] = b[at + 4] + slack;
        box[5] = z + radius + slack;
        if (!registry.worldBounds.clearlyHoldsSides(box)) {
            return false;
        }
        int count = query.gather(view, box, mover);
        for (int k = 0; k < count; k++) {
            int other = query.gathered(k);
            if (view.table(other).overlaps(other, box)) {
                return false;
            }
        }
        return true;
    }
}
