package robosim.geometry.net;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import robosim.geometry.net.FaultProxy.Fault;
import robosim.geometry.net.FaultProxy.Plan;
import robosim.geometry.protocol.Bundle;

/** One conversation over one bad network, and what of it must have come through. */
final class FaultRun {
    private final int port;
    private final FaultTable table;

    FaultRun(int port, FaultTable table) {
        this.port = port;
        this.table = table;
    }

    /** Each fault in each direction, at a place drawn from the seed; JSON lines where that is odd. */
    void all(long seed, int bundles) throws IOException, InterruptedException {
        SplittableRandom random = new SplittableRandom(seed);
        for (Fault fault : Fault.values()) {
            for (boolean ofAnswers : new boolean[] {false, true}) {
                Conversation conversation = Conversation.of(random.nextLong(), bundles);
                Tongue tongue = seed % 2 == 0 ? Tongue.JAVA : Tongue.JSON;
                long[] ends = ofAnswers ? conversation.answerEnds(tongue) : conversation.requestEnds(tongue);
                one(
                        tongue,
                        conversation,
                        new Plan(fault, ofAnswers, random.nextLong(ends[ends.length - 1]), seed),
                        ends);
            }
        }
    }

    private void one(Tongue tongue, Conversation conversation, Plan plan, long[] ends)
            throws IOException, InterruptedException {
        List<Bundle> heard;
        try (FaultProxy proxy = new FaultProxy(port, plan)) {
            heard = new Talker(proxy.port(), 1 + (int) (plan.at() % 8), conversation)
                    .in(tongue)
                    .talk();
        }
        table.enter(
                tongue + ": " + plan.fault().name().toLowerCase(Locale.ROOT).replace('_', ' ')
                        + (plan.ofAnswers() ? ", of answers" : ", of requests"),
                verdict(conversation.answers(), heard, plan, whole(ends, plan.at())));
    }

    /** How many messages have wholly passed before the fault. */
    private static int whole(long[] ends, long at) {
        int count = 0;
        while (count < ends.length && ends[count] <= at) {
            count++;
        }
        return count;
    }

    /** Empty where nothing was lost, doubled or reordered that the fault did not take itself. */
    private static String verdict(List<Bundle> truth, List<Bundle> heard, Plan plan, int whole) {
        int least = switch (plan.fault()) {
            case NONE, DELAY, SINGLE_BYTES -> truth.size();
            // What passed before the fault was answered, and the answers came through.
            case HALF_CLOSE, DUPLICATE, CORRUPT -> whole;
            // What was under way in the other direction went with the connection.
            case CUT, RESET -> 0;
        };
        int most = switch (plan.fault()) {
            case NONE, DELAY, SINGLE_BYTES -> truth.size();
            case HALF_CLOSE, CUT, RESET -> whole;
            // What a garbled message says may be a message too.
            case DUPLICATE, CORRUPT -> Integer.MAX_VALUE;
        };
        if (heard.size() < least || heard.size() > most) {
            return "heard " + heard.size() + " answers, not " + least + " to " + most + " (" + plan + ")";
        }
        int same =
                Math.min(plan.fault() == Fault.DUPLICATE || plan.fault() == Fault.CORRUPT ? whole : most, heard.size());
        for (int k = 0; k < same; k++) {
            if (!truth.get(k).equals(heard.get(k))) {
                return "answer " + k + " is another (" + plan + ")";
            }
        }
        return "";
    }
}
