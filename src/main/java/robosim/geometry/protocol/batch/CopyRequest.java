package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.util.List;
import robosim.geometry.check.Checks;

/** A request about copies of the session's world, which live side by side and go on together; for learning, mostly. */
public sealed interface CopyRequest extends BatchRequest {
    /** Most copies: the largest vectors of environments tried have a few hundred. */
    int MOST = 1024;

    @Override
    default boolean isAboutMover() {
        return false; // of the copies, which have to have it
    }

    /**
     * Makes a copy of the world as it is now, in place of an earlier one or as the next one. Its bodies are those that were given
     * to the world, given again; it has no commands. Answered by a {@link WorldAnswer.Changed}.
     *
     * @param index of the copy, from 0
     */
    record Make(int index) implements CopyRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses an index out of range. */
        public Make {
            Checks.refuse(index < 0 || index >= MOST, "index must be from 0 to " + (MOST - 1), index);
        }

        @Override
        public String objectName() {
            return "";
        }

        @Override
        public int size() {
            return 1;
        }
    }

    /**
     * Lets time pass in all copies, and measures in each; answered by a {@link TickAnswer}.
     *
     * @param objectName of the object that is commanded in each copy
     * @param commands   four numbers for each copy, in order: seconds, from 0 to 3600, where 0 leaves the copy as it is; then
     *     forward, right and turn as in a step
     * @param bodies     the names of bodies whose states are wanted
     * @param senses     sensors, whose distances are wanted
     * @param single     whether the distances are rounded to single precision, which halves the answer
     */
    record Tick(String objectName, Numbers commands, List<String> bodies, List<SenseRequest> senses, boolean single)
            implements CopyRequest {
        @Serial
        private static final long serialVersionUID = 1;

        /** How many numbers belong to a command. */
        public static final int STRIDE = 4;

        /** Most bodies and most sensors: those of one robot and what it handles. */
        public static final int MOST_NAMED = 64;

        private static final double LONGEST = 3600;

        /** Most states of bodies and beams of all copies: as many as a batch may have beams. */
        private static final int MOST_ITEMS = 1 << 20;

        /** Refuses null, too many bodies or sensors, numbers that are out of range, and sensors that want more than distances. */
        public Tick {
            Checks.present("objectName", objectName);
            FreePosesRequest.check("commands", Checks.present("commands", commands), STRIDE);
            bodies = Checks.copy("bodies", bodies, String.class);
            senses = Checks.copy("senses", senses, SenseRequest.class);
            int copies = commands.size() / STRIDE;
            Checks.refuse(copies > MOST, "commands must be for at most " + MOST + " copies", copies);
            Checks.refuse(bodies.size() > MOST_NAMED, "bodies must be at most " + MOST_NAMED, bodies.size());
            Checks.refuse(senses.size() > MOST_NAMED, "senses must be at most " + MOST_NAMED, senses.size());
            for (int k = 0; k < copies; k++) {
                double seconds = commands.get(STRIDE * k);
                Checks.refuse(!(seconds >= 0 && seconds <= LONGEST), "seconds must be from 0 to 3600", seconds);
            }
            for (SenseRequest sense : senses) {
                Checks.refuse(
                        sense.normals() || sense.objects(), "senses must want distances alone", "normals or objects");
            }
            long size = (long) copies * (bodies.size() + beams(senses));
            Checks.refuse(size > MOST_ITEMS, "bodies and beams of all copies must be at most " + MOST_ITEMS, size);
        }

        private static long beams(List<SenseRequest> senses) {
            long beams = 0;
            for (SenseRequest sense : senses) {
                beams += sense.size();
            }
            return beams;
        }

        /** How many copies are commanded. */
        public int copies() {
            return commands.size() / STRIDE;
        }

        @Override
        public int size() {
            return copies() * (int) (bodies.size() + beams(senses));
        }
    }
}
