package robosim.geometry.net.session;

import java.util.List;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;

/** The size of a world of which only the objects are known. */
public final class Extent {
    /**
     * The margin beyond the farthest object, as a fraction of its distance; and the smallest margin, in world units.
     */
    private static final double ROOM = 0.25;

    private static final double LEAST_ROOM = 1;
    private static final double MOST = 0x1p101;

    private Extent() {}

    /**
     * Width, height and length of a world, centred at the origin, that holds all objects with a margin: a quarter of
     * the distance of the farthest one, at least 1 world unit.
     */
    public static double[] worldFor(List<GeometryObject> objects) {
        double[] sizes = Bounds.reach(objects);
        double room = Math.max(LEAST_ROOM, ROOM * Math.max(sizes[0], Math.max(sizes[1], sizes[2])));
        for (int k = 0; k < 3; k++) {
            sizes[k] = Math.min(MOST, 2 * (sizes[k] + room));
        }
        return sizes;
    }
}
