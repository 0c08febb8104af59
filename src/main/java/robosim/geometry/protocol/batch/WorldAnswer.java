package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.io.Serializable;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/** The answer to a {@link WorldRequest}. */
public sealed interface WorldAnswer extends BatchAnswer {
    /** The most characters of all reasons of one {@link Described}; what is beyond is left out. */
    int MOST_CHARACTERS = 1 << 20;

    /**
     * An object of an init that is not in the world.
     *
     * @param index  in the list of the init, from 0
     * @param name   of the object; empty for one without a name
     * @param reason as text for people
     */
    record LeftOut(int index, String name, String reason) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null and a negative index. */
        public LeftOut {
            Checks.count(index);
            Checks.present("name", name);
            Checks.present("reason", reason);
        }
    }

    /**
     * What became of an init.
     *
     * @param added     how many objects were added; 0 if the world could not be made
     * @param leftOut   the others, in the order of the init
     * @param width     extent of the world along X, world units
     * @param height    extent along Y
     * @param length    extent along Z
     * @param dimension whether heights count
     * @param accuracy  what stands for an object
     */
    record Described(
            int added,
            List<LeftOut> leftOut,
            double width,
            double height,
            double length,
            Dimension dimension,
            Accuracy accuracy)
            implements WorldAnswer {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null, and sizes that no world has. */
        public Described {
            Checks.count(added);
            leftOut = Checks.copy("leftOut", leftOut, LeftOut.class);
            Checks.worldSize("width", width);
            Checks.worldSize("height", height);
            Checks.worldSize("length", length);
            Checks.present("dimension", dimension);
            Checks.present("accuracy", accuracy);
        }

        @Override
        public boolean fits(BatchRequest request) {
            return Checks.present("request", request) instanceof WorldRequest.Describe;
        }
    }

    /**
     * Objects of the world, in the order of their indices.
     *
     * @param objects as many as were asked for; fewer at the end, and where their names are long
     * @param next    the index from which to go on; -1 at the end
     */
    record Listed(List<ListedObject> objects, long next) implements WorldAnswer {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null, objects in another order, and a next that is none of theirs. */
        public Listed {
            objects = Checks.copy("objects", objects, ListedObject.class);
            long last = -1;
            for (ListedObject object : objects) {
                if (object.index() <= last) {
                    throw new IllegalArgumentException("objects must be in the order of their indices (got: "
                            + object.index() + " after " + last + ")");
                }
                last = object.index();
            }
            if (next != -1) {
                ListedObject.checkIndex("next", next);
            }
            if (next != -1 && (next <= last || objects.isEmpty())) {
                throw new IllegalArgumentException(
                        "next must be -1, or above the last index of some objects (got: " + next + ")");
            }
        }

        @Override
        public boolean fits(BatchRequest request) {
            return Checks.present("request", request) instanceof WorldRequest.ListObjects asked
                    && objects.size() <= asked.count()
                    && (objects.isEmpty() || objects.get(0).index() >= asked.first());
        }
    }

    /**
     * Where an object is.
     *
     * @param rotation nine numbers, row by row, whose columns are the object's axes in the world
     * @param heading  <b>radians</b> about the vertical from the world's X to forward, counter-clockwise seen from above,
     *                 above -pi and up to pi
     */
    record Located(Point center, Numbers rotation, double heading) implements WorldAnswer {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null, numbers that are not a rotation, and a heading that is NaN. */
        public Located {
            Checks.present("center", center);
            Pose.ORIGIN.oriented(Checks.present("rotation", rotation).values());
            if (!(Math.abs(heading) <= Math.PI)) {
                throw new IllegalArgumentException("heading must be from -pi to pi (got: " + heading + ")");
            }
        }

        @Override
        public boolean fits(BatchRequest request) {
            return Checks.present("request", request) instanceof WorldRequest.Locate;
        }
    }

    /**
     * Whether a change was made.
     *
     * @param done     whether it was; else nothing has changed
     * @param obstacle the name of the object that is in the way, of several the one added first, empty for one without a
     *                 name; null if none is: it was done, the world's border is in the way, or there is no object of that
     *                 name to remove
     */
    record Changed(boolean done, @Nullable String obstacle) implements WorldAnswer {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses an obstacle of what was done. */
        public Changed {
            if (done && obstacle != null) {
                throw new IllegalArgumentException(
                        "obstacle must be left out of what was done (got: \"" + obstacle + "\")");
            }
        }

        @Override
        public boolean fits(BatchRequest request) {
            return Checks.present("request", request) instanceof WorldRequest.Place
                    || request instanceof WorldRequest.Add
                    || request instanceof WorldRequest.Remove
                    || request instanceof WorldRequest.Attach
                    || request instanceof WorldRequest.Detach
                    || (request instanceof WorldRequest.Separate && !done);
        }
    }

    /**
     * What became of a move.
     *
     * @param made         whether it was made; a refused one leaves the object where it was
     * @param fraction     the share of the translation that is free, from 0 to 1
     * @param turnFraction the share of the turns after it that is free, from 0 to 1
     * @param obstacle     the name of the object that blocks, empty for one without a name; null if none does: it was
     *                     made, or the world's border blocks
     * @param contact      where the object touches what blocks it; null if it was made
     * @param normal       unit normal there, from what blocks towards the object; null if it was made
     */
    record Went(
            boolean made,
            double fraction,
            double turnFraction,
            @Nullable String obstacle,
            @Nullable Point contact,
            @Nullable Point normal)
            implements WorldAnswer {
        @Serial
        private static final long serialVersionUID = 1;

        /** A move that was made. */
        public static final Went MADE = new Went(true, 1, 1, null, null, null);

        /** Refuses fractions outside 0 to 1, and what does not fit together. */
        public Went {
            fraction = Checks.share("fraction", fraction);
            turnFraction = Checks.share("turnFraction", turnFraction);
            if (made && (fraction < 1 || turnFraction < 1)) {
                throw new IllegalArgumentException("fraction and turnFraction must be 1 if the move was made (got: "
                        + fraction + " and " + turnFraction + ")");
            }
            if (made == (contact != null) || made == (normal != null) || (made && obstacle != null)) {
                throw new IllegalArgumentException(
                        "contact and normal must be given if the move was not made, and with obstacle left out if it was"
                                + " (got: made " + made + ", " + obstacle + ", " + contact + ", " + normal + ")");
            }
        }

        @Override
        public boolean fits(BatchRequest request) {
            return Checks.present("request", request) instanceof WorldRequest.Go;
        }
    }

    /**
     * An answer that says which objects are in the way.
     *
     * @param answer    a {@link Changed} or a {@link Went}; of a {@link WorldRequest.GoToContact} or a {@link WorldRequest.Drive}
     *                  with a clearance the shares that were made, with a contact in the gap that is left
     * @param obstacles empty if none is, or the world's border; of a move the one that blocks, of a place or an addition
     *                  all that are touched there, at most {@link #MOST_OBSTACLES}, in the order in which they were added
     */
    record Identified(WorldAnswer answer, List<Obstacle> obstacles) implements WorldAnswer {
        @Serial
        private static final long serialVersionUID = 1;

        /** The most objects that are told. */
        public static final int MOST_OBSTACLES = 16;

        /** Refuses null, any other answer, and obstacles that do not fit to it. */
        public Identified {
            obstacles = Checks.copy("obstacles", obstacles, Obstacle.class);
            String first = obstacles.isEmpty() ? null : obstacles.get(0).name();
            int most = answer instanceof Changed ? MOST_OBSTACLES : 1;
            if (obstacles.size() > most || !Objects.equals(first, nameOf(answer))) {
                throw new IllegalArgumentException("obstacles must be at most " + most
                        + ", the first of them the obstacle of the answer (got: " + obstacles.size() + " and "
                        + answer + ")");
            }
        }

        private static @Nullable String nameOf(WorldAnswer answer) {
            if (answer instanceof Changed change) {
                return change.obstacle();
            }
            if (answer instanceof Went went) {
                return went.obstacle();
            }
            throw new IllegalArgumentException("answer must be a Changed or a Went (got: "
                    + (answer == null ? "null" : answer.getClass().getSimpleName()) + ")");
        }

        @Override
        public boolean fits(BatchRequest request) {
            return Checks.present("request", request) instanceof WorldRequest.Identify asked
                    ? answer.fits(asked.request())
                    : answer instanceof Went
                            && (request instanceof WorldRequest.GoToContact || request instanceof WorldRequest.Drive);
        }
    }

    /**
     * An object was freed.
     *
     * @param displacement of the object along the world's axes; zero if it touched nothing
     */
    record Separated(Point displacement) implements WorldAnswer {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null. */
        public Separated {
            Checks.present("displacement", displacement);
        }

        @Override
        public boolean fits(BatchRequest request) {
            return Checks.present("request", request) instanceof WorldRequest.Separate;
        }
    }

    /**
     * What became of a move that slides.
     *
     * @param displacement of the centre along the world's axes, from start to end
     * @param length       the length of the way made, world units
     * @param left         the displacement along the world's axes that was still to go where the object stopped, as it was
     *                     when the last contact was met; zero if the way was made to its end
     * @param turnFraction the share of the turns that was made, from 0 to 1
     * @param contacts     what was met, in order; empty if and only if nothing blocked
     */
    record Slid(Point displacement, double length, Point left, double turnFraction, List<Contact> contacts)
            implements WorldAnswer {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null, a length that is negative or NaN, and a share outside 0 to 1. */
        public Slid {
            Checks.present("displacement", displacement);
            if (!(length >= 0 && length < Double.POSITIVE_INFINITY)) { // written so that NaN fails it
                throw new IllegalArgumentException("length must be a number of at least 0 (got: " + length + ")");
            }
            Checks.present("left", left);
            turnFraction = Checks.share("turnFraction", turnFraction);
            contacts = Checks.copy("contacts", contacts, Contact.class);
        }

        @Override
        public boolean fits(BatchRequest request) {
            return Checks.present("request", request) instanceof WorldRequest.GoAndSlide slide
                    && contacts.size() <= slide.bends() + 1;
        }
    }

    /**
     * The objects that proofs are about.
     *
     * @param scene JSON as {@code docs/proofs.md} describes it, in parts that are to be joined: a text of a message has a limit
     */
    record SceneText(List<String> scene) implements WorldAnswer {
        @Serial
        private static final long serialVersionUID = 1;

        /** The most characters of a scene: that of some 20,000 boxes. */
        public static final int MOST_CHARACTERS = 1 << 22;

        /** Refuses null. */
        public SceneText {
            scene = Checks.copy("scene", scene, String.class);
        }

        @Override
        public boolean fits(BatchRequest request) {
            return Checks.present("request", request) instanceof WorldRequest.DescribeScene;
        }
    }

    /**
     * A proof, or why there is none.
     *
     * @param proof  JSON as {@code docs/proofs.md} describes it, in parts that are to be joined; empty if there is none
     * @param reason why there is none; empty if there is one
     */
    record Evidence(List<String> proof, String reason) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null, and both a proof and a reason, or neither. */
        public Evidence {
            proof = Checks.copy("proof", proof, String.class);
            Checks.present("reason", reason);
            if (proof.isEmpty() == reason.isEmpty()) {
                throw new IllegalArgumentException("either a proof or a reason must be given (got: "
                        + (proof.isEmpty() ? "neither" : "both") + ")");
            }
        }
    }

    /**
     * Proofs of an answer.
     *
     * @param proofs in the order of what they prove
     */
    record Proved(List<Evidence> proofs) implements WorldAnswer {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null. */
        public Proved {
            proofs = Checks.copy("proofs", proofs, Evidence.class);
        }

        @Override
        public boolean fits(BatchRequest request) {
            return Checks.present("request", request) instanceof WorldRequest.Prove asked
                    && (asked.request() instanceof SenseRequest
                            ? proofs.size() == asked.size()
                            : !proofs.isEmpty() && proofs.size() <= 4);
        }
    }

    /**
     * A contact of a move that slides.
     *
     * @param obstacle what was met; null for the world's border
     * @param point    where the object touches it, at the place where it was stopped
     * @param normal   unit normal there, from what blocks towards the object
     */
    record Contact(@Nullable Obstacle obstacle, Point point, Point normal) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null, but for the border. */
        public Contact {
            Checks.present("point", point);
            Checks.present("normal", normal);
        }
    }
}
