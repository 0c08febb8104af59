package robosim.geometry.scenario;

import java.util.BitSet;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;

/**
 * A step whose answer differs from the expected one. Answers are the same if the same moves were made, in the same
 * order, and each distance has the same bits; NaN equals NaN; and each bit and number of the answers to a batch or a step is the same. If an answer says which moves were refused, these are
 * compared too, which tells equal moves apart. The words that say why something was refused are not compared.
 *
 * @param step     number of the step in the conversation, from 1
 * @param line     line of its request in the file, from 1; 0 if there is none
 * @param index    index of the first request in the step whose answer differs, from 0; -1 for the whole step
 * @param request  that request, as text for people
 * @param expected the expected answer, as text for people
 * @param got      the actual answer, as text for people
 * @param others   number of further requests of the step whose answers differ
 */
public record Mismatch(long step, long line, int index, String request, String expected, String got, int others) {
    /** Refuses null. */
    public Mismatch {
        Checks.present("request", request);
        Checks.present("expected", expected);
        Checks.present("got", got);
    }

    /** Compares an answer with what its step expects; returns null if they are the same, or nothing is expected. */
    static @Nullable Mismatch of(long number, Step step, @Nullable Reply got) {
        Reply expected = step.expected();
        if (expected == null) {
            return null;
        }
        if (got == null) {
            return whole(number, step, "an answer", "none");
        }
        if (got.bundle().equals(expected.bundle())) { // doubles are equal if their bits are, or both are NaN
            return step.request() instanceof MoveBundle asked
                    ? refusals(number, step, asked.moves(), expected, got)
                    : null;
        }
        if (step.request() instanceof SonarRequestBundle sonars) {
            return distances(number, step, sonars.requests(), expected, got);
        }
        if (step.request() instanceof BatchRequestBundle batch) {
            return BatchMismatch.of(number, step, batch.requests(), expected, got);
        }
        if (step.request() instanceof StepBundle) {
            return steps(number, step, (StepBundle.Answer) expected.bundle(), (StepBundle.Answer) got.bundle());
        }
        return moves(number, step, ((MoveBundle) step.request()).moves(), expected, got);
    }

    /** The mismatch of the first of the requests whose answers differ. */
    static Mismatch first(long number, Step step, BitSet different, String request, String expected, String got) {
        int first = different.nextSetBit(0);
        return new Mismatch(number, step.line(), first, request, expected, got, different.cardinality() - 1);
    }

    /** The indices at which two lists of one length differ. */
    static BitSet differing(List<?> wanted, List<?> answered) {
        BitSet different = new BitSet();
        for (int k = 0; k < wanted.size(); k++) {
            different.set(k, !wanted.get(k).equals(answered.get(k)));
        }
        return different;
    }

    static Mismatch whole(long number, Step step, String expected, String got) {
        return new Mismatch(number, step.line(), -1, kind(step.request()), expected, got, 0);
    }

    private static String kind(Bundle request) {
        if (request instanceof MoveBundle moves) {
            return moves.moves().size() + " moves";
        }
        if (request instanceof BatchRequestBundle batch) {
            return "a batch of " + batch.size();
        }
        if (request instanceof StepBundle stepped) {
            return "a step of " + stepped.seconds() + " s";
        }
        return request instanceof SonarRequestBundle sonars ? sonars.requests().size() + " distances" : "a new world";
    }

    /** Compares two answers that are not equal; null if they differ only in reasons that the expected one does not give. */
    private static @Nullable Mismatch steps(long number, Step step, StepBundle.Answer expected, StepBundle.Answer got) {
        if (!expected.bodies().equals(got.bodies())) {
            return differ(number, step, "bodies", expected.bodies(), got.bodies());
        }
        if (!expected.contacts().equals(got.contacts())) {
            return differ(number, step, "contacts", expected.contacts(), got.contacts());
        }
        if (!expected.stopped().equals(got.stopped())) {
            return differ(number, step, "stopped", expected.stopped(), got.stopped());
        }
        return expected.stops().isEmpty() ? null : differ(number, step, "stops", expected.stops(), got.stops());
    }

    private static Mismatch differ(long number, Step step, String what, List<?> wanted, List<?> answered) {
        int first = 0;
        while (first < wanted.size()
                && first < answered.size()
                && wanted.get(first).equals(answered.get(first))) {
            first++;
        }
        String place = what + "[" + first + "]: ";
        return Mismatch.whole(number, step, place + at(wanted, first), at(answered, first));
    }

    private static String at(List<?> items, int index) {
        return index < items.size() ? Text.line(String.valueOf(items.get(index))) : "no more";
    }

    private static Mismatch distances(long number, Step step, List<SonarRequest> asked, Reply expected, Reply got) {
        List<Double> wanted = ((DistanceBundle) expected.bundle()).distances();
        List<Double> answered = ((DistanceBundle) got.bundle()).distances();
        BitSet different = differing(wanted, answered);
        int first = different.nextSetBit(0);
        double before = wanted.get(first);
        double now = answered.get(first);
        String error = reason(got, first);
        String found = distance(now) + (error.isEmpty() ? off(before, now) : ", " + error);
        return first(number, step, different, words(asked.get(first)), distance(before), found);
    }

    private static Mismatch moves(long number, Step step, List<MoveRequest> asked, Reply expected, Reply got) {
        List<MoveRequest> wanted = ((MoveBundle) expected.bundle()).moves();
        List<MoveRequest> made = ((MoveBundle) got.bundle()).moves();
        BitSet different = new BitSet();
        boolean firstMade = false;
        int nextWanted = 0;
        int nextMade = 0;
        for (int k = 0; k < asked.size(); k++) {
            MoveRequest move = asked.get(k);
            boolean isWanted =
                    nextWanted < wanted.size() && wanted.get(nextWanted).equals(move);
            boolean isMade = nextMade < made.size() && made.get(nextMade).equals(move);
            nextWanted += isWanted ? 1 : 0;
            nextMade += isMade ? 1 : 0;
            firstMade = different.isEmpty() ? isMade : firstMade;
            different.set(k, isWanted != isMade);
        }
        if (nextWanted < wanted.size()) {
            MoveRequest stray = wanted.get(nextWanted);
            return whole(number, step, "among those made a " + words(stray), "no such request in its place");
        }
        int first = different.nextSetBit(0);
        String words = words(asked.get(first));
        return firstMade
                ? first(number, step, different, words, "refused", "made")
                : first(number, step, different, words, "made", refusal(got, first));
    }

    /**
     * Compares the refused moves when the moves made are the same; returns null if the refused are the same too, or are
     * unknown, as in Java serialization.
     */
    private static @Nullable Mismatch refusals(
            long number, Step step, List<MoveRequest> asked, Reply expected, Reply got) {
        BitSet wanted = refused(expected);
        BitSet answered = refused(got);
        boolean someWere = ((MoveBundle) got.bundle()).moves().size() < asked.size();
        if (wanted.isEmpty() || wanted.equals(answered) || (answered.isEmpty() && someWere)) {
            return null;
        }
        BitSet different = (BitSet) wanted.clone();
        different.xor(answered);
        int first = different.nextSetBit(0);
        if (first >= asked.size()) {
            return whole(number, step, "move " + first + " refused", "no such move");
        }
        return first(
                number,
                step,
                different,
                words(asked.get(first)),
                wanted.get(first) ? "refused" : "made",
                answered.get(first) ? refusal(got, first) : "made");
    }

    private static BitSet refused(Reply reply) {
        BitSet indices = new BitSet();
        for (Problem problem : reply.problems()) {
            indices.set(problem.index());
        }
        return indices;
    }

    private static String refusal(Reply reply, int index) {
        String reason = reason(reply, index);
        return reason.isEmpty() ? "refused" : "refused, " + reason;
    }

    static String reason(Reply reply, int index) {
        for (Problem problem : reply.problems()) {
            if (problem.index() == index) {
                return Text.line(problem.reason());
            }
        }
        return "";
    }

    private static String words(MoveRequest move) {
        String turns = move.rx() == 0 && move.ry() == 0
                ? ""
                : ", turned by ry " + move.ry() + (move.rx() == 0 ? "" : ", rx " + move.rx());
        return "move of " + Text.quoted(move.objectName()) + " by (" + move.x() + ", " + move.y() + ", " + move.z()
                + ")" + turns;
    }

    private static String words(SonarRequest request) {
        Beam beam = request.beam();
        return "sonar of " + Text.quoted(request.objectName()) + " towards (" + request.xOffset() + ", 0, "
                + request.zOffset() + ")"
                + (beam == null
                        ? ""
                        : " in [" + beam.min() + ", " + beam.max() + "]"
                                + (beam.width() == 0 ? "" : ", " + beam.width() + " wide"));
    }

    static String distance(double distance) {
        if (Double.isNaN(distance)) {
            return "no such object (NaN)";
        }
        return Double.isInfinite(distance) ? "no echo" : distance + " (" + Double.toHexString(distance) + ")";
    }

    static String off(double before, double now) {
        if (!(Math.abs(now - before) > 0 && Double.isFinite(now - before))) {
            return "";
        }
        return ", " + (now > before ? "longer" : "shorter") + " by " + Math.abs(now - before);
    }

    /** One line. */
    @Override
    public String toString() {
        return "step " + step + (line > 0 ? " (line " + line + ")" : "") + ", "
                + (index < 0 ? "" : "request " + index + ", a ") + request + ": expected " + expected + ", got " + got
                + (others > 0 ? "; and " + others + " more of this step" : "");
    }
}
