package robosim.geometry.dynamics;

import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;

/**
 * A collision during a step.
 *
 * @param body    the name of a body
 * @param other   the name of what it met: another body or another object; null for an object without a name and for the
 *                world's bounds
 * @param point   where they met
 * @param normal  unit normal at the contact, towards {@code body}
 * @param impulse what {@code body} was given along the normal, newton seconds; 0 if a turn was stopped
 */
public record BodyContact(String body, @Nullable String other, Point point, Point normal, double impulse) {}
