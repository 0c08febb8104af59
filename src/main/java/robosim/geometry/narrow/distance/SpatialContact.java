package robosim.geometry.narrow.distance;

import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.gjk.Penetration;
import robosim.geometry.narrow.leaf.Leaf;

/** The contact point and normal of two leaves in space. */
public final class SpatialContact {
    private SpatialContact() {}

    /**
     * Writes a contact point and the unit normal from b towards a: the direction of separation if the two are apart
     * (the point is then half-way between the nearest points), of least penetration if they overlap (the point is then
     * common to both).
     *
     * <p>A witness in plain doubles, for leaves that touch or nearly do; no decision depends on it. The normal is
     * opposite for (b, a).
     */
    public static void between(Leaf a, Leaf b, double[] out, DistanceScratch s) {
        Penetration penetration = s.gjk.penetration();
        penetration.spatial(a, b);
        point(penetration.bracket(), out);
        out[3] = penetration.nx(0);
        out[4] = penetration.ny(0);
        out[5] = penetration.nz(0);
    }

    /** Writes the point alone. */
    public static void point(Leaf a, Leaf b, double[] out, DistanceScratch s) {
        s.gjk.pair.spatial(a, b);
        point(s.gjk.pair, out);
    }

    private static void point(Gjk gjk, double[] out) {
        if (!gjk.isClosed()) {
            gjk.close(); // a simplex too thin for doubles, as at rims that touch, has nearest points that are not near
        }
        out[0] = 0.5 * gjk.ax() + 0.5 * gjk.bx();
        out[1] = 0.5 * gjk.ay() + 0.5 * gjk.by();
        out[2] = 0.5 * gjk.az() + 0.5 * gjk.bz();
    }
}
