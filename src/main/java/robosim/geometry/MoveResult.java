package robosim.geometry;

import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * What became of a move.
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
 * <p>A place is free where it is stored: the share leads to the double nearest to each coordinate, and it is the place of these
 * doubles that is free. So where a whole move is of the size of an ulp of the coordinates, many shares lead to one place: the
 * share answered is one that leads to the last free <em>stored</em> place, often the start itself, and of shares beyond it
 * that are rounded to a free place too nothing is said. A share is below 1 where its part of the move is refused, however
 * close to the end that is.
 *
 * @param allowed      whether it was made; a move is all or nothing, a refused one leaves the object where it was
 * @param fraction     the share of the translation that is free, from 0 to 1: strictly before contact, rounded down, and
 *                     that place has been verified free; the least of those beside each obstacle alone; 1 only where all of
 *                     the translation is free
 * @param turnFraction the share of the turns that is free after the whole translation, from 0 to 1; 0 where the
 *                     translation is not free, and 1 only where the move is allowed. Where a move turns about both axes, the
 *                     turn about Y is the first half of this share and the turn about X the second
 * @param obstacle     what blocks the move, as it is, and of several that block at the same share the one added first; null
 *                     where nothing does, or the world's border before all of them
 * @param contact      where the moved object meets what blocks it, with the face of a mesh or the member of a group that
 *                     blocks; null where nothing blocks
 * @param normal       the unit normal there, from what blocks towards the moved object; null where nothing blocks
 */
public record MoveResult(
        boolean allowed,
        double fraction,
        double turnFraction,
        @Nullable GeometryObject obstacle,
        @Nullable Point contact,
        @Nullable Point normal) {}
