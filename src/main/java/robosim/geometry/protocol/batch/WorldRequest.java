package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.io.Serializable;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
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

    @Override
    default boolean isAboutMover() {
        return false;
    }

    /** The object that it adds; null if it adds none. */
    default @Nullable GeometryObject addition() {
        return null;
    }

    /** Whether it may change which objects there are in the world. */
    default boolean isAboutObjects() {
        return addition() != null;
    }

    /** About how many bytes of memory its answer takes, where that is more than a few. */
    default long answerBytes() {
        return 1;
    }

    private static void checkMove(String objectName, double x, double y, double z, double rx, double ry) {
        Checks.present("objectName", objectName);
        Checks.coordinate("x", x);
        Checks.coordinate("y", y);
        Checks.coordinate("z", z);
        Checks.radians("rx", rx);
        Checks.radians("ry", ry);
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
     * What is in the world, in the order of the indices. Answered by a {@link WorldAnswer.Listed}, which says where to go on: a
     * large world is read page by page.
     *
     * @param first the least index that is asked for; at first 0, then {@link WorldAnswer.Listed#next}
     * @param count how many objects at most, from 1 to {@link #MOST_LISTED}
     */
    record ListObjects(long first, int count) implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** The most objects of one answer. */
        public static final int MOST_LISTED = 1 << 16;

        /** How many there are in JSON unless a request says so: an answer of some 200 kB. */
        public static final int USUAL_LISTED = 1000;

        /** Refuses numbers that are out of range. */
        public ListObjects {
            ListedObject.checkIndex("first", first);
            if (count < 1 || count > MOST_LISTED) {
                throw new IllegalArgumentException("count must be from 1 to " + MOST_LISTED + " (got: " + count + ")");
            }
        }

        @Override
        public String objectName() {
            return "";
        }

        @Override
        public int size() {
            return count;
        }

        @Override
        public long answerBytes() {
            return ListedObject.BYTES * count;
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

        @Override
        public boolean isAboutMover() {
            return true;
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

        @Override
        public GeometryObject addition() {
            return object;
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

        @Override
        public boolean isAboutObjects() {
            return true;
        }
    }

    /**
     * Attaches a moveable object to another one: from then on it is a part of that, and moves with it. Answered by a
     * {@link WorldAnswer.Changed}.
     *
     * @param objectName the name of the load
     * @param carrier    the name of the object that carries it, which may be attached itself
     * @param mount      where it is held, in the frame of the carrier, if nothing else is there; null for where it is now
     */
    record Attach(
            String objectName, String carrier, @Nullable Mount mount) implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null names. */
        public Attach {
            Checks.present("objectName", objectName);
            Checks.present("carrier", carrier);
        }

        @Override
        public boolean isAboutMover() {
            return true;
        }

        @Override
        public boolean isAboutObjects() {
            return true;
        }
    }

    /**
     * Detaches an object from what carries it; it stays where it is. Answered by a {@link WorldAnswer.Changed}.
     *
     * @param objectName the name of an attached object
     */
    record Detach(String objectName) implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null. */
        public Detach {
            Checks.present("objectName", objectName);
        }

        @Override
        public boolean isAboutMover() {
            return true;
        }

        @Override
        public boolean isAboutObjects() {
            return true;
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
            checkMove(objectName, x, y, z, rx, ry);
        }

        @Override
        public boolean isAboutMover() {
            return true;
        }
    }

    /**
     * A move as far as the way is free, and so far from what blocks it as asked. Answered by a {@link
     * WorldAnswer.Identified}, whose shares are what was made of the move.
     *
     * @param objectName the name of a moveable object
     * @param x          world units forward
     * @param y          world units up
     * @param z          world units to the right of forward
     * @param rx         <b>radians</b> about the own X, after the turn by {@code ry}
     * @param ry         <b>radians</b> about the own Y
     * @param clearance  world units between the object and every piece that the whole move would meet; at least 0
     */
    record GoToContact(String objectName, double x, double y, double z, double rx, double ry, double clearance)
            implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null, and numbers that are NaN or out of range. */
        public GoToContact {
            checkMove(objectName, x, y, z, rx, ry);
            Checks.size("clearance", clearance);
        }

        @Override
        public boolean isAboutMover() {
            return true;
        }

        @Override
        public long answerBytes() {
            return Obstacle.BYTES;
        }
    }

    /**
     * A motion that turns while it translates: a velocity that stays constant in the object's own frame, for a time. Answered by
     * a {@link WorldAnswer.Identified}.
     *
     * @param objectName the name of a moveable object
     * @param x          world units a second forward
     * @param y          world units a second up
     * @param z          world units a second to the right
     * @param ry         <b>radians</b> a second about its own Y, counter-clockwise seen from above
     * @param seconds    at least 0
     * @param clearance  world units that it stops short of what blocks it, at least 0; null if it is all or nothing
     */
    record Drive(
            String objectName,
            double x,
            double y,
            double z,
            double ry,
            double seconds,
            @Nullable Double clearance) implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null, and numbers that are NaN or out of range. */
        public Drive {
            checkMove(objectName, x, y, z, 0, ry);
            Checks.size("seconds", seconds);
            if (clearance != null) {
                Checks.size("clearance", clearance);
            }
        }

        @Override
        public boolean isAboutMover() {
            return true;
        }

        @Override
        public long answerBytes() {
            return Obstacle.BYTES;
        }
    }

    /**
     * A move that goes on along what blocks it. Answered by a {@link WorldAnswer.Slid}.
     *
     * @param objectName the name of a moveable object
     * @param x          world units forward
     * @param y          world units up
     * @param z          world units to the right of forward
     * @param rx         <b>radians</b> about the own X, after the turn by {@code ry}
     * @param ry         <b>radians</b> about the own Y
     * @param clearance  world units between the object and what it meets; at least 0
     * @param bends      at how many contacts the way may go on; it ends at the next. From 0 to {@link #MOST_BENDS}
     * @param walk       how the object walks on ground, in a SPATIAL world; null for one that slides along everything
     */
    record GoAndSlide(
            String objectName,
            double x,
            double y,
            double z,
            double rx,
            double ry,
            double clearance,
            int bends,
            @Nullable Walk walk)
            implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** The most contacts at which a way goes on. */
        public static final int MOST_BENDS = 64;

        /** How many there are in JSON unless a request says so: a corner takes two, and round objects some more. */
        public static final int USUAL_BENDS = 4;

        /** Refuses null, and numbers that are NaN or out of range. */
        public GoAndSlide {
            checkMove(objectName, x, y, z, rx, ry);
            Checks.size("clearance", clearance);
            if (bends < 0 || bends > MOST_BENDS) {
                throw new IllegalArgumentException("bends must be from 0 to " + MOST_BENDS + " (got: " + bends + ")");
            }
        }

        @Override
        public boolean isAboutMover() {
            return true;
        }

        /** A move of an object that slides along everything. */
        public GoAndSlide(
                String objectName, double x, double y, double z, double rx, double ry, double clearance, int bends) {
            this(objectName, x, y, z, rx, ry, clearance, bends, null);
        }

        @Override
        public long answerBytes() {
            return Obstacle.BYTES * (bends + 1L);
        }
    }

    /**
     * How an object walks on ground, as {@link robosim.geometry.SlideOptions} describes it.
     *
     * @param stepHeight world units, at least 0: a sill up to this height is climbed
     * @param maxSlope   <b>radians</b> from 0 to pi/2: steeper surfaces are walls
     * @param snap       world units, at least 0: where there is ground within this distance below the object after the
     *                   motion, it is put down on it
     */
    record Walk(double stepHeight, double maxSlope, double snap) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        /** What an object does that does not walk. */
        public static final Walk NONE = new Walk(0, Math.PI / 2, 0);

        /** Refuses numbers that are NaN or out of range. */
        public Walk {
            Checks.size("stepHeight", stepHeight);
            if (!(maxSlope >= 0 && maxSlope <= Math.PI / 2)) {
                throw new IllegalArgumentException(
                        "maxSlope must be from 0 to pi / 2, in radians (got: " + maxSlope + ")");
            }
            Checks.size("snap", snap);
        }
    }

    /**
     * Frees an object that touches or overlaps others: moves it, without turning it, by the smallest displacement found to a
     * place where it touches nothing. Answered by a {@link WorldAnswer.Separated}, or if there is none by a {@link
     * WorldAnswer.Changed} that is not done.
     *
     * @param objectName the name of a moveable object
     * @param max        world units, at least 0: the longest displacement
     */
    record Separate(String objectName, double max) implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null, and a length that is NaN or out of range. */
        public Separate {
            Checks.present("objectName", objectName);
            Checks.size("max", max);
        }

        @Override
        public boolean isAboutMover() {
            return true;
        }
    }

    /** The objects that proofs about the world are about, as it is now. Answered by a {@link WorldAnswer.SceneText}. */
    record DescribeScene() implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        @Override
        public String objectName() {
            return "";
        }

        @Override
        public long answerBytes() {
            return 4L * WorldAnswer.SceneText.MOST_CHARACTERS;
        }
    }

    /**
     * Proofs of the answer that a request would have now; nothing is moved. Answered by a {@link WorldAnswer.Proved}, in which a
     * {@link Locate} has one proof, that the object touches no other; a {@link Go} one for each part of the move, and one for its end;
     * and a {@link SenseRequest} one for each beam, as if its blind range were 0.
     *
     * @param request a {@link Locate}, a {@link Go} or a {@link SenseRequest} of {@value #MOST_BEAMS} beams at most
     */
    record Prove(BatchRequest request) implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** The most beams of one request: a proof of one takes a millisecond in a world of 10,000 objects. */
        public static final int MOST_BEAMS = 1024;

        /** Refuses null and any other request. */
        public Prove {
            if (!(request instanceof Locate || request instanceof Go || request instanceof SenseRequest)) {
                throw new IllegalArgumentException("request must be a Locate, a Go or a SenseRequest (got: "
                        + (request == null ? "null" : request.getClass().getSimpleName()) + ")");
            }
            if (request.size() > MOST_BEAMS) {
                throw new IllegalArgumentException("request must have at most " + MOST_BEAMS
                        + " beams; divide it into several (got: " + request.size() + ")");
            }
        }

        @Override
        public String objectName() {
            return request.objectName();
        }

        @Override
        public int size() {
            return request.size();
        }

        @Override
        public boolean isAboutMover() {
            return request.isAboutMover();
        }

        @Override
        public long answerBytes() {
            return 4L * WorldAnswer.MOST_CHARACTERS;
        }
    }

    /**
     * A request whose answer says which objects are in the way, also those without a name. Answered by a {@link
     * WorldAnswer.Identified}.
     *
     * @param request a {@link Place}, an {@link Add} or a {@link Go}
     */
    record Identify(WorldRequest request) implements WorldRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null and any other request. */
        public Identify {
            if (!(request instanceof Place || request instanceof Add || request instanceof Go)) {
                throw new IllegalArgumentException("request must be a Place, an Add or a Go (got: "
                        + (request == null ? "null" : request.getClass().getSimpleName()) + ")");
            }
        }

        @Override
        public String objectName() {
            return request.objectName();
        }

        @Override
        public boolean isAboutMover() {
            return request.isAboutMover();
        }

        @Override
        public @Nullable GeometryObject addition() {
            return request.addition();
        }

        @Override
        public long answerBytes() {
            return Obstacle.BYTES * WorldAnswer.Identified.MOST_OBSTACLES;
        }
    }
}
