package robosim.geometry.protocol.json;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.FreeAnswer;
import robosim.geometry.protocol.batch.Integers;
import robosim.geometry.protocol.batch.NoAnswer;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.PictureAnswer;
import robosim.geometry.protocol.batch.SenseAnswer;

/** Reads answers with packed numbers from JSON. */
final class JsonAnswers {
    private static final Fields ANSWERS = Fields.of("type answers", "");
    private static final Fields ANSWER =
            Fields.of("", "distances normals count free error names objects labels width height rgb");
    private static final int DISTANCES = 1;
    private static final int NORMALS = 2;
    private static final int COUNT = 4;
    private static final int FREE = 8;
    private static final int ERROR = 16;
    private static final int NAMES = 32;
    private static final int OBJECTS = 64;
    private static final int LABELS = 128;
    private static final int PICTURE = 256 + 512 + 1024; // width, height and rgb
    private static final int SEEN = NAMES + OBJECTS + LABELS;

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
        int[] size = new int[2];
        byte[][] bytes = {new byte[0]};
        int seen = 0;
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
                case 8, 9 -> size[field - 8] = (int) in.whole(1, MessageLimits.MAX_PICTURE_PIXELS);
                default -> bytes[0] = in.base64(3, MessageLimits.MAX_PICTURE_PIXELS);
            }
        }
        return switch (seen) {
            case DISTANCES, DISTANCES + NORMALS, DISTANCES + SEEN, DISTANCES + NORMALS + SEEN ->
                in.make(() -> new SenseAnswer(numbers[0], numbers[1], names, integers[0], integers[1]));
            case PICTURE -> in.make(() -> new PictureAnswer(size[0], size[1], bytes[0]));
            case COUNT + FREE -> in.make(() -> new FreeAnswer(count[0], bytes[0]));
            case ERROR -> new NoAnswer();
            default ->
                throw in.refused(
                        "an answer must have distances, perhaps with normals and with names, objects and labels,"
                                + " or count and free, or width, height and rgb, or an error (got: other fields)");
        };
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
