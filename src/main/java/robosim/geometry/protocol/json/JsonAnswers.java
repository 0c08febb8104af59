package robosim.geometry.protocol.json;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.FreeAnswer;
import robosim.geometry.protocol.batch.Integers;
import robosim.geometry.protocol.batch.ListedObject;
import robosim.geometry.protocol.batch.MeasureRequest;
import robosim.geometry.protocol.batch.NoAnswer;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.Obstacle;
import robosim.geometry.protocol.batch.PictureAnswer;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.TickAnswer;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/** Answers to the requests of a batch as JSON. */
final class JsonAnswers {
    private static final JsonObject<Obstacle> OBSTACLE =
            JsonObject.of(Obstacle.class).omitting("", "name");

    private static final JsonObject<SenseAnswer> SEEN = JsonObject.of(SenseAnswer.class)
            .form("distances", JsonForm.packed(1, MessageLimits.MAX_BEAMS))
            .form("normals", JsonForm.packed(3, MessageLimits.MAX_BEAMS))
            .omitting(Numbers.NONE, "normals")
            .form("names", JsonForm.list(JsonForm.TEXT, MessageLimits.MAX_BEAMS))
            .form("objects labels", JsonForm.packedIntegers(MessageLimits.MAX_BEAMS));

    private static final JsonForm<Number> PIXELS =
            JsonForm.of(JsonInput::number, (out, count) -> out.writeNumber(count.intValue()));

    private static final JsonObject<WorldAnswer.Changed> CHANGED =
            JsonObject.of(WorldAnswer.Changed.class).omitting(null, "obstacle");

    private static final JsonObject<WorldAnswer.Went> BLOCKED =
            JsonObject.of(WorldAnswer.Went.class).omitting(null, "obstacle");

    private static final JsonObject<WorldAnswer.Went> MADE =
            BLOCKED.omitting(1.0, "fraction turnFraction").without("fraction turnFraction obstacle contact normal");

    private static final JsonObject<WorldAnswer.Identified> IDENTIFIED = JsonObject.of(WorldAnswer.Identified.class)
            .form("obstacles", JsonForm.list(OBSTACLE, WorldAnswer.Identified.MOST_OBSTACLES));

    /** Answers, and {@link Failed}. */
    private static final int MEASURED = MeasureRequest.Question.CLEARANCES.answered * MessageLimits.MAX_POSES;

    private static final JsonKinds<Object> ANSWER = JsonKinds.untagged(
            "an answer must have distances, perhaps with normals and with names, objects and labels, or count and free,"
                    + " or numbers,"
                    + " or width, height and rgb, or the fields of an answer about the world, or an error (got: other"
                    + " fields)",
            JsonKinds.kind(
                    "",
                    answer -> answer instanceof SenseAnswer sense
                            && sense.objects().size() == 0,
                    SEEN.without("names objects labels")),
            JsonKinds.kind("", SEEN),
            JsonKinds.kind(
                    "",
                    PictureAnswer.class,
                    JsonObject.of(Picture.class)
                            .form("width height", PIXELS)
                            .form("rgb", JsonForm.bytes(3, MessageLimits.MAX_PICTURE_PIXELS))
                            .as(Picture::answer, told -> new Picture(told.width(), told.height(), told.rgb()))),
            JsonKinds.kind(
                    "",
                    JsonObject.of(FreeAnswer.class)
                            .form("count", JsonForm.whole(0, MessageLimits.MAX_POSES))
                            .form("free", JsonForm.bytes(1, MessageLimits.MAX_POSES / 8))),
            JsonKinds.kind(
                    "", JsonObject.of(MeasureRequest.Answer.class).form("numbers", JsonForm.packed(1, MEASURED))),
            JsonKinds.kind(
                    "",
                    JsonObject.of(WorldAnswer.Described.class)
                            .form(
                                    "leftOut",
                                    JsonForm.list(JsonObject.of(WorldAnswer.LeftOut.class)
                                            .omitting("", "name")))),
            JsonKinds.kind("", JsonObject.of(WorldAnswer.Located.class).form("rotation", JsonForm.ROTATION)),
            JsonKinds.kind("", CHANGED),
            JsonKinds.kind("", JsonAnswers::isMade, MADE),
            JsonKinds.kind("", BLOCKED),
            identified(WorldAnswer.Changed.class::isInstance, CHANGED),
            identified(JsonAnswers::isMade, MADE),
            identified(WorldAnswer.Went.class::isInstance, BLOCKED),
            JsonKinds.kind(
                    "",
                    WorldAnswer.Separated.class,
                    JsonObject.of(Freed.class).as(Freed::answer, freed -> new Freed(true, freed.displacement()))),
            JsonKinds.kind(
                    "",
                    JsonObject.of(WorldAnswer.Slid.class)
                            .form(
                                    "contacts",
                                    JsonForm.list(
                                            JsonObject.of(WorldAnswer.Contact.class)
                                                    .form("obstacle", OBSTACLE)
                                                    .omitting(null, "obstacle"),
                                            WorldRequest.GoAndSlide.MOST_BENDS + 1))),
            JsonKinds.kind(
                    "",
                    JsonObject.of(WorldAnswer.Listed.class)
                            .named("objects", "listed")
                            .form(
                                    "listed",
                                    JsonForm.list(
                                            JsonObject.of(ListedObject.class).omitting("", "name"),
                                            WorldRequest.ListObjects.MOST_LISTED))
                            .omitting(-1L, "next")),
            JsonKinds.kind(
                    "",
                    JsonObject.of(TickAnswer.class)
                            .form("states", JsonForm.packed(TickAnswer.STRIDE, MessageLimits.MAX_BEAMS))
                            .form("touches singles", JsonForm.packedIntegers(MessageLimits.MAX_BEAMS))
                            .form("distances", JsonForm.packed(1, MessageLimits.MAX_BEAMS))
                            .omitting(Numbers.NONE, "distances")
                            .omitting(Integers.NONE, "singles")),
            JsonKinds.kind("", JsonObject.of(WorldAnswer.SceneText.class)),
            JsonKinds.kind(
                    "",
                    JsonObject.of(WorldAnswer.Proved.class)
                            .form(
                                    "proofs",
                                    JsonForm.list(JsonObject.of(WorldAnswer.Evidence.class)
                                            .omitting(List.of(), "proof")
                                            .omitting("", "reason")))),
            JsonKinds.kind("", JsonObject.of(Failed.class)));

    static final JsonForm<List<Problem>> REFUSED = JsonForm.list(JsonObject.of(Refused.class)
            .form("index", JsonForm.whole(0, MessageLimits.MAX_LIST_LENGTH))
            .as(
                    refused -> Problem.of(refused.index, refused.reason),
                    problem -> new Refused(problem.index(), problem.reason())));

    static final JsonObject<Reply> ANSWERS =
            JsonObject.of(Answers.class).form("answers", JsonForm.list(ANSWER)).as(Answers::reply, Answers::of);

    private JsonAnswers() {}

    private static boolean isMade(Object answer) {
        return answer instanceof WorldAnswer.Went went && went.made();
    }

    private static JsonKinds.Kind<Object> identified(Predicate<Object> has, JsonObject<? extends WorldAnswer> of) {
        return JsonKinds.kind(
                "",
                answer -> answer instanceof WorldAnswer.Identified identified && has.test(identified.answer()),
                IDENTIFIED.inline("answer", of));
    }

    /** In place of an answer or a distance that there is not. */
    record Failed(String error) {
        /** Values with a reason in place of each that is missing. */
        static List<Object> in(List<?> values, Object missing, List<Problem> problems, String unknown) {
            List<Object> told = new ArrayList<>(values);
            for (int k = 0; k < told.size(); k++) {
                if (missing.equals(told.get(k))) {
                    told.set(k, new Failed(unknown));
                }
            }
            for (int k = problems.size() - 1; k >= 0; k--) { // of two reasons the first one counts
                Problem problem = problems.get(k);
                if (problem.index() < told.size() && told.get(problem.index()) instanceof Failed) {
                    told.set(problem.index(), new Failed(problem.reason()));
                }
            }
            return told;
        }

        /** The values, with one that is missing in place of each reason, and these reasons. */
        static <T> List<Problem> out(List<Object> told, T missing, Class<T> type, List<T> values) {
            List<Problem> problems = new ArrayList<>();
            for (Object each : told) {
                if (each instanceof Failed failed) {
                    problems.add(Problem.of(values.size(), failed.error));
                }
                values.add(each instanceof Failed ? missing : type.cast(each));
            }
            return problems;
        }
    }

    record Refused(int index, String reason) {}

    record Answers(List<Object> answers) {
        static Answers of(Reply reply) {
            return new Answers(Failed.in(
                    ((BatchAnswerBundle) reply.bundle()).answers(), new NoAnswer(), reply.problems(), "no answer"));
        }

        Reply reply() {
            List<BatchAnswer> all = new ArrayList<>();
            List<Problem> problems = Failed.out(answers, new NoAnswer(), BatchAnswer.class, all);
            return new Reply(new BatchAnswerBundle(all), problems);
        }
    }

    @SuppressWarnings("ArrayRecordComponent") // is never compared
    record Picture(Number width, Number height, byte[] rgb) {
        PictureAnswer answer() {
            return new PictureAnswer(pixels("width", width.doubleValue()), pixels("height", height.doubleValue()), rgb);
        }

        /** A number of pixels; unlike the size of a world it is a whole one. */
        private static int pixels(String name, double value) {
            if (!(value >= 1 && value <= MessageLimits.MAX_PICTURE_PIXELS && value == Math.rint(value))) {
                throw new IllegalArgumentException(name + " must be a whole number of pixels from 1 to "
                        + MessageLimits.MAX_PICTURE_PIXELS + " (got: " + value + ")");
            }
            return (int) value;
        }
    }

    record Freed(boolean done, Point displacement) {
        WorldAnswer.Separated answer() {
            if (!done) {
                throw new IllegalArgumentException("done must be true with a displacement (got: false)");
            }
            return new WorldAnswer.Separated(displacement);
        }
    }
}
