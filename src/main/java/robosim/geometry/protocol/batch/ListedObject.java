package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.io.Serializable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * An object of the world, as a list of what is there tells it.
 *
 * @param index    in the list of the init, from 0; objects that were added later are counted on from the end of that list, in
 *                 the order in which they were added
 * @param name     empty for an object without one
 * @param kind     its shape
 * @param center   where it is now; of a mesh or a group the origin of its own frame
 * @param heading  <b>radians</b> about the vertical from the world's X to forward, counter-clockwise seen from above, above -pi
 *                 and up to pi
 * @param moveable whether it can be moved
 * @param low      the lower corner of the box along the world's axes that holds it where it is, rounded outward
 * @param high     the upper corner
 */
public record ListedObject(
        long index,
        String name,
        GeometryObject.Kind kind,
        Point center,
        double heading,
        boolean moveable,
        Point low,
        Point high)
        implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** About the memory of one within an answer: itself and its points. */
    static final long BYTES = 256;

    /** The largest index: up to it all whole numbers are doubles, which is what many programs read from JSON. */
    private static final long LAST = (1L << 53) - 1;

    /** Refuses null, an index that is out of range, a heading that is NaN, and corners in the wrong order. */
    public ListedObject {
        checkIndex("index", index);
        Checks.present("name", name);
        Checks.present("kind", kind);
        Checks.present("center", center);
        if (!(Math.abs(heading) <= Math.PI)) {
            throw new IllegalArgumentException("heading must be from -pi to pi (got: " + heading + ")");
        }
        Checks.present("low", low);
        Checks.present("high", high);
        if (low.x() > high.x() || low.y() > high.y() || low.z() > high.z()) {
            throw new IllegalArgumentException("low must not be above high (got: " + low + " and " + high + ")");
        }
    }

    static void checkIndex(String argument, long index) {
        if (index < 0 || index > LAST) {
            throw new IllegalArgumentException(argument + " must be from 0 to 2^53 - 1 (got: " + index + ")");
        }
    }
}
