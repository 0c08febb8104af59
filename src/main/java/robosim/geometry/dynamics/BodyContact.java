package robosim.geometry.dynamics;

import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;

/**
 * A body and what it touches or has collided with in a step.
 *
 * <p>Two of which one has several convex parts (a mesh, a group, a grid, the world's bounds) may touch along several normals at
 * once, as a robot does that stands on the floor of a room and leans on its wall. That is one contact for each of these normals.
 * A normal that turns by less than 30 degrees from one time to the next stays one contact.
 *
 * @param body    the name of a body
 * @param other   the name of what it met: another body or another object; null for an object without a name and for the
 *                world's bounds
 * @param point   where they met, in a PLANAR world at the height of the body's centre; of several touches in the step, that
 *                of the greatest impulse
 * @param normal  unit normal at the contact, towards {@code body}
 * @param impulse what {@code body} was given along the normals, newton seconds, the sum over the step; 0 where they only
 *                touch
 * @param phase   whether the contact has begun in this step, goes on since the one before, or has ended
 */
public record BodyContact(String body, @Nullable String other, Point point, Point normal, double impulse, Phase phase) {
    /** How a contact stands to the step before. */
    public enum Phase {
        /** There was none in the step before. */
        BEGIN,
        /** It lasts: there was one in the step before, and it goes on. Not the final one, which is {@link #END}. */
        LAST,
        /** There was one in the step before, and is none any more. */
        END
    }

    /** A contact that has begun. */
    public BodyContact(String body, @Nullable String other, Point point, Point normal, double impulse) {
        this(body, other, point, normal, impulse, Phase.BEGIN);
    }
}
