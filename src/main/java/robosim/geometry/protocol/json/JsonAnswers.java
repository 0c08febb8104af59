package robosim.geometry.protocol.json;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.FreeAnswer;
import robosim.geometry.protocol.batch.Integers;
import robosim.geometry.protocol.batch.ListedObject;
import robosim.geometry.protocol.batch.NoAnswer;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.Obstacle;
import robosim.geometry.protocol.batch.PictureAnswer;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/** Reads answers with packed numbers from JSON. */
final class JsonAnswers {
    private static final Fields ANSWERS = Fields.of("type answers", "");
    private static final Fields ANSWER = Fields.of(
            "",
            "distances normals count free error names objects labels added leftOut width height length dimension"
                    + " accuracy center rotation heading done obstacle made fraction turnFraction contact normal rgb"
                    + " obstacles displacement left contacts listed next");
    private static final Fields OBSTACLE_FIELDS = Fields.of("index kind center", "name");
    private static final Fields LISTED_FIELDS = Fields.of("index kind center heading moveable low high", "name");
    private static final Fields CONTACT = Fields.of("point normal", "obstacle");
    private static final Fields LEFT_OUT = Fields.of("index reason", "name");
    private static final int DISTANCES = 1;
    private static final int NORMALS = 2;
    private static final int COUNT = 4;
    private static final int FREE = 8;
    private static final int ERROR = 16;
    private static final int NAMES = 32;
    private static final int OBJECTS = 64;
    private static final int LABELS = 128;
    private static final int SEEN = NAMES + OBJECTS + LABELS;
    private static final int DESCRIBED = 0x7f << 8;
    private static final int LOCATED = 7 << 15;
    private static final int DONE = 1 << 18;
    private static final int OBSTACLE = 1 << 19;
    private static final int MADE = 1 << 20;
    private static final int WENT = 31 << 20;
    private static final int RGB = 25;
    private static final int OBSTACLES = 1 << 26;
    private static final int DISPLACEMENT = 1 << 27;
    private static final int SLID =
            7 << 27 | 1 << 12 | 1 << 22; // displacement, left, contacts; length and turnFraction
    private static final int LISTED = 1 << 30;
    private static final int NEXT = 1 << 31;
    private static final int PICTURE = 3 << 10 | 1 << RGB; // width, height and rgb

    private final JsonInput in;

    JsonAnswers(JsonInput in) {
        this.in = in;
    }

    Reply answers() throws IOException {
        List<BatchAnswer> answers = new ArrayList<>();
        List<Problem> problems = new ArrayList<>();
        var message = in.message(ANSWERS);
        for (int field = message.next(); field >= 0; field = message.next()) {
            if (field == 0) {
                in.text();
                continue;
            }
            in.list();
            while (in.more(answers.size(), MessageLimits.MAX_LIST_LENGTH)) {
                answers.add(answer(answers.size(), problems));
            }
        }
        in.end();
        return in.make(() -> new Reply(new BatchAnswerBundle(answers), problems));
    }

    private BatchAnswer answer(int index, List<Problem> problems) throws IOException {
        Numbers[] numbers = {Numbers.NONE, Numbers.NONE};
        Integers[] integers = {Integers.NONE, Integers.NONE};
        List<String> names = new ArrayList<>();
        int[] count = new int[1];
        byte[][] bytes = {new byte[0]};
        int seen = 0;
        WorldDraft world = new WorldDraft();
        var members = in.object(ANSWER);
        for (int field = members.next(); field >= 0; field = members.next()) {
            seen |= 1 << field;
            switch (field) {
                case 0 -> numbers[0] = PackedNumbers.numbers(in.base64(Double.BYTES, MessageLimits.MAX_BEAMS));
                case 1 -> numbers[1] = PackedNumbers.numbers(in.base64(3 * Double.BYTES, MessageLimits.MAX_BEAMS));
                case 2 -> count[0] = (int) in.whole(0, MessageLimits.MAX_POSES);
                case 3 -> bytes[0] = in.base64(1, MessageLimits.MAX_POSES / 8);
                case 4 -> problems.add(Problem.of(index, in.text()));
                case 5 -> names(names);
                case 6 -> integers[0] = integers();
                case 7 -> integers[1] = integers();
                case RGB -> bytes[0] = in.base64(3, MessageLimits.MAX_PICTURE_PIXELS);
                default -> world.read(field);
            }
        }
        return switch (seen) {
            case DISTANCES, DISTANCES + NORMALS, DISTANCES + SEEN, DISTANCES + NORMALS + SEEN ->
                in.make(() -> new SenseAnswer(numbers[0], numbers[1], names, integers[0], integers[1]));
            case PICTURE -> in.make(() -> world.picture(bytes[0]));
            case COUNT + FREE -> in.make(() -> new FreeAnswer(count[0], bytes[0]));
            case DESCRIBED -> in.make(world::described);
            case LOCATED -> in.make(world::located);
            case DONE, DONE + OBSTACLE -> in.make(world::changed);
            case MADE, WENT, WENT + OBSTACLE -> in.make(world::went);
            case DONE + OBSTACLES, DONE + OBSTACLE + OBSTACLES -> in.make(() -> world.identified(world.changed()));
            case MADE + OBSTACLES, WENT + OBSTACLES, WENT + OBSTACLE + OBSTACLES ->
                in.make(() -> world.identified(world.went()));
            case DONE + DISPLACEMENT -> in.make(world::separated);
            case SLID -> in.make(world::slid);
            case LISTED, LISTED + NEXT -> in.make(world::listed);
            case ERROR -> new NoAnswer();
            default ->
                throw in.refused(
                        "an answer must have distances, perhaps with normals and with names, objects and labels,"
                                + " or count and free, or width, height and rgb, or the fields of an answer about the world, or an error (got: other"
                                + " fields)");
        };
    }

    /** The fields of an answer about the world's objects. */
    private final class WorldDraft {
        private final double[] numbers = new double[ANSWER.count()];
        private final List<WorldAnswer.LeftOut> leftOut = new ArrayList<>();
        private Dimension dimension = Dimension.PLANAR;
        private Accuracy accuracy = Accuracy.EXACT;
        private Point center = new Point();
        private Numbers rotation = Numbers.NONE;
        private boolean flag;
        private @Nullable String obstacle;
        private @Nullable Point contact;
        private @Nullable Point normal;
        private final List<Obstacle> obstacles = new ArrayList<>();
        private Point displacement = new Point();
        private Point left = new Point();
        private final List<WorldAnswer.Contact> contacts = new ArrayList<>();
        private final List<ListedObject> listed = new ArrayList<>();
        private long next = -1;

        void read(int field) throws IOException {
            switch (field) {
                case 8 -> numbers[field] = in.whole(0, Integer.MAX_VALUE);
                case 9 -> leftOut();
                case 13 -> dimension = in.constant(Dimension.class);
                case 14 -> accuracy = in.constant(Accuracy.class);
                case 15 -> center = point();
                case 16 -> rotation = new Numbers(in.numbers(9));
                case 18, 20 -> flag = in.flag();
                case 19 -> obstacle = in.text();
                case 23 -> contact = point();
                case 24 -> normal = point();
                case 26 -> obstacles();
                case 27 -> displacement = point();
                case 28 -> left = point();
                case 29 -> contacts();
                case 30 -> list();
                case 31 -> next = in.whole(0, JsonInput.MAX_ID);
                default -> numbers[field] = in.number();
            }
        }

        private Point point() throws IOException {
            double[] at = in.numbers(3);
            return in.make(() -> new Point(at[0], at[1], at[2]));
        }

        private void obstacles() throws IOException {
            in.list();
            while (in.more(obstacles.size(), WorldAnswer.Identified.MOST_OBSTACLES)) {
                obstacles.add(object());
            }
        }

        private Obstacle object() throws IOException {
            long index = 0;
            String name = "";
            GeometryObject.Kind kind = GeometryObject.Kind.BOX;
            Point at = new Point();
            var members = in.object(OBSTACLE_FIELDS);
            for (int field = members.next(); field >= 0; field = members.next()) {
                switch (field) {
                    case 0 -> index = in.whole(0, JsonInput.MAX_ID);
                    case 1 -> kind = kind();
                    case 2 -> at = point();
                    default -> name = in.text();
                }
            }
            return new Obstacle(index, name, kind, at);
        }

        private void list() throws IOException {
            in.list();
            while (in.more(listed.size(), WorldRequest.ListObjects.MOST_LISTED)) {
                listed.add(listedObject());
            }
        }

        private ListedObject listedObject() throws IOException {
            long index = 0;
            String name = "";
            GeometryObject.Kind kind = GeometryObject.Kind.BOX;
            double heading = 0;
            boolean isMoveable = false;
            Point[] points = {new Point(), new Point(), new Point()};
            var members = in.object(LISTED_FIELDS);
            for (int field = members.next(); field >= 0; field = members.next()) {
                switch (field) {
                    case 0 -> index = in.whole(0, JsonInput.MAX_ID);
                    case 1 -> kind = kind();
                    case 2 -> points[0] = point();
                    case 3 -> heading = in.number();
                    case 4 -> isMoveable = in.flag();
                    case 5, 6 -> points[field - 4] = point();
                    default -> name = in.text();
                }
            }
            long at = index;
            String named = name;
            GeometryObject.Kind shape = kind;
            double turned = heading;
            boolean moves = isMoveable;
            return in.make(() -> new ListedObject(at, named, shape, points[0], turned, moves, points[1], points[2]));
        }

        private GeometryObject.Kind kind() throws IOException {
            String word = in.text();
            for (GeometryObject.Kind kind : GeometryObject.Kind.values()) {
                if (kind.word().equals(word)) {
                    return kind;
                }
            }
            throw in.refused("must be the kind of an object, as in \"box\" (got: " + in.told(word) + ")");
        }

        private void contacts() throws IOException {
            in.list();
            while (in.more(contacts.size(), WorldRequest.GoAndSlide.MOST_BENDS + 1)) {
                Obstacle met = null;
                Point[] points = {new Point(), new Point()};
                var members = in.object(CONTACT);
                for (int field = members.next(); field >= 0; field = members.next()) {
                    if (field < points.length) {
                        points[field] = point();
                    } else {
                        met = object();
                    }
                }
                contacts.add(new WorldAnswer.Contact(met, points[0], points[1]));
            }
        }

        private void leftOut() throws IOException {
            in.list();
            while (in.more(leftOut.size(), MessageLimits.MAX_LIST_LENGTH)) {
                int index = 0;
                String reason = "";
                String name = "";
                var members = in.object(LEFT_OUT);
                for (int field = members.next(); field >= 0; field = members.next()) {
                    switch (field) {
                        case 0 -> index = (int) in.whole(0, MessageLimits.MAX_LIST_LENGTH);
                        case 1 -> reason = in.text();
                        default -> name = in.text();
                    }
                }
                leftOut.add(new WorldAnswer.LeftOut(index, name, reason));
            }
        }

        WorldAnswer described() {
            return new WorldAnswer.Described(
                    (int) numbers[8], leftOut, numbers[10], numbers[11], numbers[12], dimension, accuracy);
        }

        PictureAnswer picture(byte[] rgb) {
            return new PictureAnswer(pixels("width", numbers[10]), pixels("height", numbers[11]), rgb);
        }

        /** A number of pixels; unlike the size of a world it is a whole one. */
        private static int pixels(String name, double value) {
            if (!(value >= 1 && value <= MessageLimits.MAX_PICTURE_PIXELS && value == Math.rint(value))) {
                throw new IllegalArgumentException(name + " of a picture must be a whole number from 1 to "
                        + MessageLimits.MAX_PICTURE_PIXELS + " (got: " + value + ")");
            }
            return (int) value;
        }

        WorldAnswer located() {
            return new WorldAnswer.Located(center, rotation, numbers[17]);
        }

        WorldAnswer changed() {
            return new WorldAnswer.Changed(flag, obstacle);
        }

        WorldAnswer went() {
            boolean isBlocked = contact != null;
            double fraction = isBlocked ? numbers[21] : 1;
            double turnFraction = isBlocked ? numbers[22] : 1;
            return new WorldAnswer.Went(flag, fraction, turnFraction, obstacle, contact, normal);
        }

        WorldAnswer identified(WorldAnswer answer) {
            return new WorldAnswer.Identified(answer, obstacles);
        }

        WorldAnswer listed() {
            return new WorldAnswer.Listed(listed, next);
        }

        WorldAnswer separated() {
            if (!flag) {
                throw new IllegalArgumentException("done must be true with a displacement (got: false)");
            }
            return new WorldAnswer.Separated(displacement);
        }

        WorldAnswer slid() {
            return new WorldAnswer.Slid(displacement, numbers[12], left, numbers[22], contacts);
        }
    }

    private void names(List<String> names) throws IOException {
        in.list();
        while (in.more(names.size(), MessageLimits.MAX_BEAMS)) {
            names.add(in.text());
        }
    }

    private Integers integers() throws IOException {
        return PackedNumbers.integers(in.base64(Integer.BYTES, MessageLimits.MAX_BEAMS));
    }
}
