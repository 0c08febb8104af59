package robosim.geometry.net.session;

import java.util.List;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.WorldSettings;

/** The size of a world of which only the objects are known. */
public final class WorldExtent {
    /**
     * The margin beyond the farthest object, as a fraction of its distance; and the smallest margin, in world units.
     */
    private static final double ROOM = 0.25;

    private static final double LEAST_ROOM = 1;
    private static final double MOST = 0x1p101;

    private WorldExtent() {}

    /** The settings of a bundle's world; where it gives none, those of a session and the size that its objects need. */
    public static WorldSettings settings(InitBundle init, Dimension dimension, Accuracy accuracy) {
        WorldSettings given = init.settings() == null ? WorldSettings.NONE : init.settings();
        if (given.isComplete()) {
            return given;
        }
        double[] sizes = worldFor(init.objects());
        return new WorldSettings(
                given.width() > 0 ? given.width() : sizes[0],
                given.height() > 0 ? given.height() : sizes[1],
                given.length() > 0 ? given.length() : sizes[2],
                given.dimension() == null ? dimension : given.dimension(),
                given.accuracy() == null ? accuracy : given.accuracy());
    }

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
