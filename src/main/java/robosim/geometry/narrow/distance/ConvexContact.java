package robosim.geometry.narrow.distance;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.UnderflowScaling;

/** Where two convex leaves touch or are nearest. */
public final class ConvexContact {
    private ConvexContact() {}

    /**
     * Writes a point of contact, or between the two, and the unit normal from b towards a.
     *
     * @param out six numbers: point, normal
     */
    public static void between(
            Dimension dimension,
            LeafKind kindA,
            double[] a,
            int i,
            LeafKind kindB,
            double[] b,
            int j,
            double[] out,
            DistanceScratch s) {
        UnderflowScaling m = s.leaf.scaling;
        if (m.take(dimension, kindA, a, i, kindB, b, j)) {
            storedContact(dimension, kindA, m.a, 0, kindB, m.b, 0, out, s);
            for (int axis = 0; axis < 3; axis++) {
                out[axis] = m.down(out[axis]);
            }
        } else {
            storedContact(dimension, kindA, a, i, kindB, b, j, out, s);
        }
    }

    /**
     * Writes the contact point alone, for a known unit normal from b towards a, the last three of six numbers: half-way
     * between nearest points, or common to both.
     *
     * @param isLevel whether the two meet side to side, so that the point's height does not matter
     */
    public static void along(
            Dimension dimension,
            boolean isLevel,
            LeafKind kindA,
            double[] a,
            int i,
            LeafKind kindB,
            double[] b,
            int j,
            double[] out,
            DistanceScratch s) {
        UnderflowScaling m = s.leaf.scaling;
        boolean isFlat = isLevel || dimension == Dimension.PLANAR;
        if (m.take(dimension, kindA, a, i, kindB, b, j)) {
            storedPoint(isFlat, kindA, m.a, 0, kindB, m.b, 0, out, s);
            for (int axis = 0; axis < 3; axis++) {
                out[axis] = m.down(out[axis]);
            }
        } else {
            storedPoint(isFlat, kindA, a, i, kindB, b, j, out, s);
        }
    }

    private static void storedPoint(
            boolean isFlat,
            LeafKind kindA,
            double[] a,
            int i,
            LeafKind kindB,
            double[] b,
            int j,
            double[] out,
            DistanceScratch s) {
        if (isFlat) {
            PlanarContact.point(kindA, a, i, kindB, b, j, out, s);
        } else {
            SpatialContact.point(kindA, a, i, kindB, b, j, out, s);
        }
    }

    private static void storedContact(
            Dimension dimension,
            LeafKind kindA,
            double[] a,
            int i,
            LeafKind kindB,
            double[] b,
            int j,
            double[] out,
            DistanceScratch s) {
        if (dimension == Dimension.PLANAR) {
            PlanarContact.between(kindA, a, i, kindB, b, j, out, s);
        } else {
            SpatialContact.between(kindA, a, i, kindB, b, j, out, s);
        }
    }
}
