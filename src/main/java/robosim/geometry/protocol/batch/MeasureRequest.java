package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.util.HashSet;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;

/**
 * Asks for numbers about many places or motions of a moveable object, with a margin and without the objects that do not count;
 * answered by an {@link Answer}. Nothing is moved.
 *
 * @param objectName the name of a moveable object
 * @param question   what to measure
 * @param numbers    {@link Question#given} for each: poses as in a {@link FreePosesRequest}, edges as in a {@link FreeEdgesRequest},
 *                   or drives: a pose, a velocity along the own X, Y and Z in world units a second, one about the own Y in radians a
 *                   second, and seconds
 * @param max        range of clearances, world units; may be infinite. Not used for motions
 * @param margin     world units that motions keep from everything; at least 0. Not used for clearances
 * @param ignored    names of objects that do not count, or of layers of which none does
 * @param other      the name of the object to which a {@link Question#SIGNED} distance is measured; null for other questions
 */
public record MeasureRequest(
        String objectName,
        Question question,
        Numbers numbers,
        double max,
        double margin,
        List<String> ignored,
        @Nullable String other)
        implements BatchRequest {
    @Serial
    private static final long serialVersionUID = 1;

    /** What is measured. */
    public enum Question {
        /** The signed distance of a pose; {@code +Infinity} if nothing is within {@code max}. */
        DISTANCES(4, 1),
        /** The same, with the nearest points of the object and of the other, and the direction from that. */
        CLEARANCES(4, 10),
        /** The fractions of an edge's translation and turn that are free. */
        EDGES(8, 2),
        /** The fraction of a drive's time that is free. */
        DRIVES(9, 1),
        /**
         * The signed distance of two objects where they are, either of which may be static: a lower bound, an upper bound, the
         * nearest points of the object and of the other, and the direction from that. No numbers are given.
         */
        SIGNED(0, 11);

        /** How many numbers each question has. */
        public final int given;

        /** How many numbers each answer has. */
        public final int answered;

        Question(int given, int answered) {
            this.given = given;
            this.answered = answered;
        }
    }

    /** Refuses null, a wrong number of numbers, coordinates that are NaN or out of range, and names given twice. */
    public MeasureRequest {
        Checks.present("objectName", objectName);
        Checks.present("numbers", numbers);
        if (Checks.present("question", question) == Question.DRIVES) {
            checkDrives(numbers);
        } else if (question == Question.SIGNED) {
            if (numbers.size() > 0 || margin != 0 || !ignored.isEmpty()) {
                throw new IllegalArgumentException("numbers, margin and ignored must be left out for SIGNED (got: "
                        + numbers.size() + " numbers, a margin of " + margin + " and " + ignored + ")");
            }
        } else {
            FreePosesRequest.check("numbers", numbers, question.given);
        }
        Checks.range(0, max);
        margin = Checks.clearance(margin);
        ignored = names(ignored);
        if ((other != null) != (question == Question.SIGNED)) {
            throw new IllegalArgumentException(
                    "other must be a name for SIGNED, and be left out for other questions (got: " + other + " for "
                            + question + ")");
        }
    }

    /** A question about places or motions. */
    public MeasureRequest(
            String objectName, Question question, Numbers numbers, double max, double margin, List<String> ignored) {
        this(objectName, question, numbers, max, margin, ignored, null);
    }

    /** The signed distance of two objects where they are. */
    public static MeasureRequest signed(String objectName, String other) {
        return new MeasureRequest(
                objectName, Question.SIGNED, Numbers.NONE, Double.POSITIVE_INFINITY, 0, List.of(), other);
    }

    /** A checked copy of a list of names to be ignored, each of which comes once. */
    static List<String> names(List<String> ignored) {
        List<String> names = Checks.copy("ignored", ignored, String.class);
        if (new HashSet<>(names).size() < names.size()) {
            throw new IllegalArgumentException("ignored must have each name once (got: " + names + ")");
        }
        return names;
    }

    private static void checkDrives(Numbers drives) {
        int stride = Question.DRIVES.given;
        if (drives.size() % stride != 0) {
            throw new IllegalArgumentException(
                    "numbers must have " + stride + " numbers each (got: " + drives.size() + " numbers)");
        }
        for (int k = 0; k < drives.size(); k++) {
            String argument = "numbers[" + k + "]";
            switch (k % stride) {
                case 3, 7 -> Checks.radians(argument, drives.get(k));
                case 8 -> Checks.size(argument, drives.get(k));
                default -> Checks.coordinate(argument, drives.get(k));
            }
        }
    }

    @Override
    public boolean isAboutMover() {
        return question != Question.SIGNED;
    }

    @Override
    public int size() {
        return question == Question.SIGNED ? 1 : numbers.size() / question.given;
    }

    /**
     * What was measured.
     *
     * @param numbers those of each place or motion, one after the other, as {@link Question} lists them
     */
    public record Answer(Numbers numbers) implements BatchAnswer {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null. */
        public Answer {
            Checks.present("numbers", numbers);
        }

        @Override
        public boolean fits(BatchRequest request) {
            return request instanceof MeasureRequest measure
                    && numbers.size() == measure.size() * measure.question().answered;
        }
    }
}
