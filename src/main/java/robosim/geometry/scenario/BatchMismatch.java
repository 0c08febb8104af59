package robosim.geometry.scenario;

import java.util.BitSet;
import java.util.List;
import robosim.geometry.check.Text;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.CopyRequest;
import robosim.geometry.protocol.batch.FreeAnswer;
import robosim.geometry.protocol.batch.FreePosesRequest;
import robosim.geometry.protocol.batch.MeasureRequest;
import robosim.geometry.protocol.batch.PictureAnswer;
import robosim.geometry.protocol.batch.PictureRequest;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.batch.TickAnswer;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/** Says where the answers to a batch differ. */
final class BatchMismatch {
    private BatchMismatch() {}

    /** The mismatch of two bundles of answers that are not equal. */
    static Mismatch of(long number, Step step, List<BatchRequest> asked, Reply expected, Reply got) {
        List<BatchAnswer> wanted = ((BatchAnswerBundle) expected.bundle()).answers();
        List<BatchAnswer> answered = ((BatchAnswerBundle) got.bundle()).answers();
        BitSet different = Mismatch.differing(wanted, answered);
        int first = different.nextSetBit(0);
        BatchAnswer before = wanted.get(first);
        BatchAnswer now = answered.get(first);
        int item = item(before, now);
        String reason = Mismatch.reason(got, first);
        String found = words(now, item) + (reason.isEmpty() ? off(before, now, item) : ", " + reason);
        return Mismatch.first(number, step, different, words(asked.get(first)), words(before, item), found);
    }

    /** The first beam, pose or edge whose answers differ; -1 if one of the two has none. */
    private static int item(BatchAnswer before, BatchAnswer now) {
        if (before instanceof SenseAnswer one && now instanceof SenseAnswer two) {
            int beam = 0;
            while (isSame(one, two, beam)) {
                beam++;
            }
            return beam;
        }
        if (before instanceof FreeAnswer one && now instanceof FreeAnswer two) {
            int place = 0;
            while (one.isFree(place) == two.isFree(place)) {
                place++;
            }
            return place;
        }
        if (before instanceof MeasureRequest.Answer one && now instanceof MeasureRequest.Answer two) {
            int number = 0;
            while (Double.compare(one.numbers().get(number), two.numbers().get(number)) == 0) {
                number++;
            }
            return number;
        }
        if (before instanceof PictureAnswer one && now instanceof PictureAnswer two) {
            int pixel = 0;
            while (color(one, pixel) == color(two, pixel)) {
                pixel++;
            }
            return pixel;
        }
        return -1;
    }

    private static int color(PictureAnswer picture, int pixel) {
        return picture.pixel(pixel % picture.width(), pixel / picture.width());
    }

    private static boolean isSame(SenseAnswer one, SenseAnswer two, int beam) {
        if (Double.compare(one.distances().get(beam), two.distances().get(beam)) != 0) {
            return false;
        }
        if (!seen(one, beam).equals(seen(two, beam))) {
            return false;
        }
        for (int k = 3 * beam; k < 3 * beam + 3 && k < one.normals().size(); k++) {
            if (Double.compare(one.normals().get(k), two.normals().get(k)) != 0) {
                return false;
            }
        }
        return true;
    }

    private static String words(BatchRequest request) {
        if (request instanceof PictureRequest picture) {
            return "picture of " + picture.camera().width() + " x "
                    + picture.camera().height() + " pixels "
                    + (picture.isCarried() ? "by " + Text.quoted(picture.objectName()) : "in the world");
        }
        if (request instanceof WorldRequest || request instanceof CopyRequest) {
            return "request for " + Text.line(request.toString());
        }
        if (request instanceof MeasureRequest measure) {
            return "batch of " + measure.size() + " " + measure.question() + " of " + Text.quoted(measure.objectName());
        }
        String what =
                request instanceof SenseRequest ? "beams" : request instanceof FreePosesRequest ? "poses" : "edges";
        boolean isCarried = request.isAboutMover(); // a sensor may stand in the world
        return "batch of " + request.size() + " " + what
                + (isCarried ? " of " + Text.quoted(request.objectName()) : " in the world");
    }

    private static String words(BatchAnswer answer, int item) {
        if (answer instanceof SenseAnswer sense) {
            return item < 0
                    ? "distances"
                    : "for beam " + item + " "
                            + Mismatch.distance(sense.distances().get(item)) + normal(sense, item) + seen(sense, item);
        }
        if (answer instanceof FreeAnswer free) {
            return item < 0 ? "bits" : (free.isFree(item) ? "free" : "not free") + " at " + item;
        }
        if (answer instanceof MeasureRequest.Answer measure) {
            return item < 0
                    ? "numbers"
                    : "number " + item + ": " + measure.numbers().get(item);
        }
        if (answer instanceof PictureAnswer picture) {
            return item < 0
                    ? "pixels"
                    : "#%06x at column %d of row %d"
                            .formatted(color(picture, item), item % picture.width(), item / picture.width());
        }
        return answer instanceof WorldAnswer || answer instanceof TickAnswer
                ? Text.line(answer.toString())
                : "no answer";
    }

    private static String normal(SenseAnswer answer, int beam) {
        return answer.normals().size() == 0
                ? ""
                : " off (" + answer.normals().get(3 * beam) + ", "
                        + answer.normals().get(3 * beam + 1) + ", "
                        + answer.normals().get(3 * beam + 2) + ")";
    }

    /** What a beam met, as words. */
    private static String seen(SenseAnswer answer, int beam) {
        if (answer.objects().size() == 0) {
            return "";
        }
        int object = answer.objects().get(beam);
        return object < 0
                ? ""
                : " at "
                        + (answer.names().get(object).isEmpty()
                                ? "an object without a name"
                                : Text.quoted(answer.names().get(object)))
                        + ", label " + answer.labels().get(beam);
    }

    private static String off(BatchAnswer before, BatchAnswer now, int item) {
        return before instanceof SenseAnswer one && now instanceof SenseAnswer two
                ? Mismatch.off(one.distances().get(item), two.distances().get(item))
                : "";
    }
}
