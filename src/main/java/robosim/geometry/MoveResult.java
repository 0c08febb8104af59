package robosim.geometry;

import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * The outcome of a move.
 *
 * <pre>{@code
 * Geometry geometry = new Geometry();
 * geometry.addObject(new BoxObject(new Point(4, 0, 0), 2, 2, 2).named("crate"));
 * geometry.addObject(new SphereObject(new Point(0, 0, 0), 1).moveable("ball"));
 * MoveResult result = geometry.move("ball", new Move(4, 0, 0, 0, 0));
 * result.allowed();         // false
 * result.fraction();        // 0.5: it is 2 to the crate, of 4
 * result.obstacle().name(); // "crate"
 * result.contact().x();     // 3.0
 * result.normal().x();      // -1: the crate pushes back
 * }</pre>
 *
 * <p>Places are checked as they are stored: each coordinate along the move is rounded to the nearest double, and the
 * place of these doubles is what is found free. So if a whole move is of the size of an ulp of the coordinates, many
 * fractions lead to the same place. The fraction returned then leads to the last free <em>stored</em> place, often the
 * start itself; larger fractions may round to a free place too. A fraction is below 1 whenever its part of the move is
 * refused, however close to the end.
 *
 * <p>A fraction can be used. Multiply the move by it, in doubles, in the frame and units in which the move was given, and
 * call again: every call accepts the product, because the fraction is what has been verified by that question, or is
 * smaller by more than the rounding of it. That is why it is slightly below the last free one, by 2<sup>-50</sup> of the
 * coordinates where the sweep is exact and 2<sup>-46</sup> where it is certified. If {@code fraction} is below 1, the product is a translation alone. Otherwise it is the whole
 * translation, then the share of the turn: {@code turnFraction} times a turn about one axis. Of a move that turns about
 * both, below 0.5 it is {@code 2 * turnFraction * ry} alone; from 0.5 on it is all of {@code ry}, and
 * {@code (2 * turnFraction - 1) * rx}.
 *
 * <p>The sum of a coordinate and such a product is rounded again. If the product is not much larger than an ulp of the
 * coordinate, the sum leads in another direction, and a pose or an edge that ends there may not be free. Neither may one be at
 * an accuracy below EXACT.
 *
 * @param allowed      whether the move was made; a move is all or nothing, a refused one leaves the object where it was
 * @param fraction     the fraction of the translation that is free, from 0 to 1: strictly before contact, rounded down,
 *                     with that place verified free. It is the minimum over the obstacles taken one by one, and 1 only
 *                     if the whole translation is free
 * @param turnFraction the fraction of the turns that is free after the whole translation, from 0 to 1; 0 if the
 *                     translation is not free, and 1 only if the move is allowed. If a move turns about both axes, the
 *                     turn about Y is the first half of this fraction and the turn about X the second
 * @param obstacle     the object that blocks the move, at its present place; of several that block at the same fraction
 *                     the one added first; null if nothing blocks, or if the world's bounds block before any object
 * @param contact      where the moved object touches what blocks it: a point on the blocking face of a mesh or member
 *                     of a group; of several contacts at the same fraction, that whose normal opposes the motion most,
 *                     which may be on another object than the one added first; null if nothing blocks
 * @param normal       the unit normal at the contact, from what blocks towards the moved object; it never points along
 *                     the motion (of a turn, the motion of the contact point). Where tiles or faces meet without an edge,
 *                     it is the normal of the surface that they form. Null if nothing blocks
 */
public record MoveResult(
        boolean allowed,
        double fraction,
        double turnFraction,
        @Nullable GeometryObject obstacle,
        @Nullable Point contact,
        @Nullable Point normal) {}
