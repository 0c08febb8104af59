package robosim.geometry.net.session;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.BodyContact;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.model.Bounds;

/**
 * Notices bodies that fall in a world where heights count. One that falls onto the lower border of the world mostly lacks the
 * floor that it should have stood on, and drives on below all walls. A fall is a drop of more than the body's own height, from
 * where something last carried it, or from where it began, onto something static.
 */
public final class FallDetector {
    /**
     * A fall that has ended.
     *
     * @param drop     by how much the body's centre is lower, world units
     * @param isBorder whether it ended on the lower border of the world
     */
    public record Fall(double drop, boolean isBorder) {}

    /** Of the height of the world: how far from the lower border a contact with it may seem to be. */
    private static final double NEAR = 1e-6;

    /** The least upward part of the normal of a contact that carries a body. */
    private static final double CARRIES = 0.1;

    private final Geometry world;

    private final Map<String, Level> levels = new HashMap<>();

    /**
     * Where a body was carried.
     *
     * @param size   its own height when it began
     * @param height that of its centre where something last carried it
     */
    private record Level(double size, double height) {
        Level at(double other) {
            return new Level(size, other);
        }
    }

    /** The falls that ended in the last step. */
    private final Map<String, Fall> last = new LinkedHashMap<>();

    FallDetector(Geometry world) {
        this.world = world;
    }

    /** Begins to watch a body, from where it is. */
    void watch(String name) {
        Bounds bounds = world.getObject(name).bounds();
        levels.put(name, new Level(bounds.maxY() - bounds.minY(), height(name)));
    }

    /** Before a step, and where there is none. */
    void begin() {
        last.clear();
    }

    /** After a step. */
    void end(StepResult step) {
        for (BodyContact contact : step.contacts()) {
            if (contact.normal().y() > CARRIES && isStatic(contact.other())) {
                land(contact);
            }
        }
        for (BodyContact contact : step.contacts()) {
            double up = contact.normal().y();
            String other = contact.other();
            if (up > CARRIES) {
                carry(contact.body());
            } else if (up < -CARRIES && other != null) {
                carry(other);
            }
        }
    }

    private void carry(String name) {
        levels.computeIfPresent(name, (body, level) -> level.at(height(body)));
    }

    /** The border, or what has no name, does not move. */
    private boolean isStatic(@Nullable String other) {
        return other == null || !world.getObject(other).isMoveable();
    }

    /** The drop of the fall that a contact of the last step has ended; 0 if it ended none. */
    double endedBy(BodyContact contact) {
        Fall fall = contact.normal().y() > CARRIES && isStatic(contact.other()) ? last.get(contact.body()) : null;
        return fall == null || contact.phase() == BodyContact.Phase.END ? 0 : fall.drop();
    }

    private void land(BodyContact contact) {
        String name = contact.body();
        Level level = levels.get(name);
        if (level != null) {
            double drop = level.height - height(name);
            if (drop > level.size) {
                boolean isBorder =
                        contact.other() == null && contact.point().y() + world.height() / 2 <= NEAR * world.height();
                last.put(name, new Fall(drop, isBorder));
            }
        }
    }

    private double height(String name) {
        return world.getObject(name).center().y();
    }

    /** By body, the fall that ended in the last step. */
    Map<String, Fall> last() {
        return last;
    }
}
