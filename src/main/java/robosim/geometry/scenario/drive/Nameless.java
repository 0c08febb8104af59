package robosim.geometry.scenario.drive;

import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.NearObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.motion.ContactAnswer;

/** What a contact does not name: an object without a name, or the border of the world, whose lower side is the ground. */
public final class Nameless {
    private Nameless() {}

    /** The object without a name that is met at a point; null if the border of the world is nearer. */
    public static @Nullable GeometryObject at(Geometry world, Point point) {
        double border = Math.max(0, toBorder(world, point));
        for (NearObject near : world.search().nearest(point, Integer.MAX_VALUE, border)) {
            if (near.object().name() == null && near.distance() < border) {
                return near.object();
            }
        }
        return null;
    }

    /** Whether a body stands on the lower border of the world. */
    public static boolean isGround(Geometry world, ContactAnswer contact) {
        Point point = contact.point();
        return contact.other() == null
                && contact.normal().y() > 0
                && point.y() + 0.5 * world.height() == toBorder(world, point)
                && at(world, point) == null;
    }

    private static double toBorder(Geometry world, Point point) {
        double aside = Math.min(0.5 * world.width() - Math.abs(point.x()), 0.5 * world.length() - Math.abs(point.z()));
        return world.dimension() == Dimension.PLANAR
                ? aside
                : Math.min(aside, 0.5 * world.height() - Math.abs(point.y()));
    }
}
