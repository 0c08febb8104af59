package robosim.geometry.narrow.distance;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.UnderflowScaling;

/** Where two convex leaves touch or are nearest. */
public final class ConvexContact {
    private ConvexContact() {}

    /**
     * Writes a point of contact, or between the two, and the unit normal from b towards a.
     *
     * @param out six numbers: point, normal
     */
    public static void between(Dimension dimension, Leaf a, Leaf b, double[] out, DistanceScratch s) {
        UnderflowScaling m = s.leaf.scaling;
        if (m.take(dimension, a, b)) {
            storedContact(dimension, m.first, m.second, out, s);
            for (int axis = 0; axis < 3; axis++) {
                out[axis] = m.down(out[axis]);
            }
        } else {
            storedContact(dimension, a, b, out, s);
        }
    }

    /**
     * Writes the contact point alone, for a known unit normal from b towards a, the last three of six numbers: half-way
     * between nearest points, or common to both.
     *
     * @param isLevel whether the two meet side to side, so that the point's height does not matter
     */
    public static void along(Dimension dimension, boolean isLevel, Leaf a, Leaf b, double[] out, DistanceScratch s) {
        UnderflowScaling m = s.leaf.scaling;
        boolean isFlat = isLevel || dimension == Dimension.PLANAR;
        if (m.take(dimension, a, b)) {
            storedPoint(isFlat, m.first, m.second, out, s);
            for (int axis = 0; axis < 3; axis++) {
                out[axis] = m.down(out[axis]);
            }
        } else {
            storedPoint(isFlat, a, b, out, s);
        }
    }

    private static void storedPoint(boolean isFlat, Leaf a, Leaf b, double[] out, DistanceScratch s) {
        if (isFlat) {
            PlanarContact.point(a, b, out, s);
        } else {
            SpatialContact.point(a, b, out, s);
        }
    }

    private static void storedContact(Dimension dimension, Leaf a, Leaf b, double[] out, DistanceScratch s) {
        if (dimension == Dimension.PLANAR) {
            PlanarContact.between(a, b, out, s);
        } else {
            SpatialContact.between(a, b, out, s);
        }
    }
}
