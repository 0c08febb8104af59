package robosim.geometry.world.check;

import robosim.geometry.model.Point;
import robosim.geometry.world.WorldObject;

/**
 * Two objects in contact.
 *
 * @param first   the moveable one, or the earlier of two static ones
 * @param second  the object that it touches or overlaps
 * @param contact a point of both
 * @param normal  of length 1, from the second towards the first
 * @param depth   how far the first must move along {@code normal} to be clear of the second, to within a hundredth,
 *                world units; 0 if they only touch, {@code +Infinity} if that direction does not lead out
 */
public record Overlap(WorldObject first, WorldObject second, Point contact, Point normal, double depth) {
    /** Whether a moveable object starts in this contact. */
    public boolean isStart() {
        return first.object().isMoveable();
    }
}
