package robosim.geometry.protocol.batch;

import java.io.Serial;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * A request of a batch about the world's objects rather than what they see: what became of the last init, where an object
 * is, and changes of the world, which the requests after them in the batch find made. Each is answered by a {@link
 * WorldAnswer}.
 */
public sealed interface WorldRequest extends BatchRequest {
    @Override
    default int size() {
        return 1;
    }

    /** What became of the last init: how many objects were added, which were left out and why, and the settings in use. */
    record Describe() implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        @Override
        public String objectName() {
            return "";
        }
    }

    /**
     * Where an object is now; it need not be moveable.
     *
     * @param objectName the name of an object
     */
    record Locate(String objectName) implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null. */
        public Locate {
            Checks.present("objectName", objectName);
        }
    }

    /**
     * Puts a moveable object upright at a place, without checking a way to it; only where it touches nothing there.
     *
     * @param objectName the name of a moveable object
     * @param heading    <b>radians</b> about the vertical, counter-clockwise seen from above
     */
    record Place(String objectName, Point center, double heading) implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null, and a heading that is NaN or beyond 2<sup>100</sup>. */
        public Place {
            Checks.present("objectName", objectName);
            Checks.present("center", center);
            Checks.radians("heading", heading);
        }
    }

    /**
     * Adds an object.
     *
     * @param overlapping whether it is added even where it touches or overlaps others, as the objects of an init are
     */
    record Add(GeometryObject object, boolean overlapping) implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null. */
        public Add {
            Checks.present("object", object);
        }

        @Override
        public String objectName() {
            String name = object.name();
            return name == null ? "" : name;
        }
    }

    /**
     * Removes an object; it need not be moveable.
     *
     * @param objectName the name of an object
     */
    record Remove(String objectName) implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null. */
        public Remove {
            Checks.present("objectName", objectName);
        }
    }

    /**
     * A move, as in a MoveBundle, whose answer says what blocks it.
     *
     * @param objectName the name of a moveable object
     * @param x          world units forward
     * @param y          world units up
     * @param z          world units to the right of forward
     * @param rx         <b>radians</b> about the own X, after the turn by {@code ry}
     * @param ry         <b>radians</b> about the own Y
     */
    record Go(String objectName, double x, double y, double z, double rx, double ry) implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null, and numbers that are NaN or beyond 2<sup>100</sup>. */
        public Go {
            Checks.present("objectName", objectName);
            Checks.coordinate("x", x);
            Checks.coordinate("y", y);
            Checks.coordinate("z", z);
            Checks.radians("rx", rx);
            Checks.radians("ry", ry);
        }
    }
}
