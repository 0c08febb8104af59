package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.io.Serializable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * An object that is in the way, told so that the peer knows which it is even if it has no name.
 *
 * @param index  in the list of the init, from 0; objects that were added later are counted on from the end of that list, in
 *               the order in which they were added
 * @param name   empty for an object without one
 * @param kind   its shape
 * @param center where it is now
 */
public record Obstacle(long index, String name, GeometryObject.Kind kind, Point center) implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** About the memory of one within an answer: itself, its points, and those of a contact with it. */
    static final long BYTES = 256;

    /** Refuses null, and an index that is negative or above 2<sup>53</sup> - 1. */
    public Obstacle {
        ListedObject.checkIndex("index", index);
        Checks.present("name", name);
        Checks.present("kind", kind);
        Checks.present("center", center);
    }
}
