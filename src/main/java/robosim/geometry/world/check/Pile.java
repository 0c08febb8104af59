package robosim.geometry.world.check;

import robosim.geometry.model.Point;

/**
 * Many objects in one place, of which not all pairs were compared.
 *
 * @param at      a point that all of them contain
 * @param objects their number
 */
public record Pile(Point at, int objects) {}
