package robosim.geometry.sweep;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.ContactAnswer;

/** Collects the results of a conversation. */
final class ScenarioTally {
    private int made;
    private int refused;
    private double way;
    private int echoes;
    private int silent;
    private int unanswered;
    private double nearest = Double.POSITIVE_INFINITY;
    private double sum;
    private int changed;

    /** Whether there were steps of bodies. */
    private boolean isDriven;

    private int contacts;
    private int stopped;
    private final Map<String, Point> places = new HashMap<>();

    /** Adds a step: the recorded request, the request made now, and the outcomes of both. */
    void take(Bundle recorded, Bundle request, Reply reply, @Nullable Bundle answer, ScenarioSweep.Noise noise) {
        if (reply.bundle() instanceof StepBundle.Answer step) {
            takeStep(step, answer);
        } else if (request instanceof MoveBundle moves) {
            takeMoves(((MoveBundle) recorded).moves(), moves.moves(), reply, (MoveBundle) answer);
        } else {
            takeDistances(((SonarRequestBundle) request).requests(), reply, (DistanceBundle) answer, noise);
        }
    }

    private void takeStep(StepBundle.Answer now, @Nullable Bundle answer) {
        isDriven = true;
        for (ContactAnswer contact : now.contacts()) {
            contacts += contact.phase() == ContactAnswer.Phase.BEGIN ? 1 : 0;
        }
        stopped += now.stopped().size();
        for (BodyAnswer body : now.bodies()) {
            Point to = body.center();
            Point from = places.put(body.objectName(), to);
            if (from != null) {
                double dx = to.x() - from.x();
                double dz = to.z() - from.z();
                way += Math.sqrt(dx * dx + dz * dz);
            }
        }
        changed += answer == null || answer.equals(now) ? 0 : 1;
    }

    private void takeMoves(
            List<MoveRequest> recorded, List<MoveRequest> moves, Reply reply, @Nullable MoveBundle answer) {
        Set<Integer> problems = new HashSet<>();
        for (Problem problem : reply.problems()) {
            problems.add(problem.index());
        }
        int before = 0;
        for (int k = 0; k < moves.size(); k++) {
            MoveRequest move = moves.get(k);
            boolean isMade = !problems.contains(k);
            made += isMade ? 1 : 0;
            refused += isMade ? 0 : 1;
            way += isMade ? Math.sqrt(move.x() * move.x() + move.y() * move.y() + move.z() * move.z()) : 0;
            if (answer != null) {
                boolean wasMade = before < answer.moves().size()
                        && answer.moves().get(before).equals(recorded.get(k));
                before += wasMade ? 1 : 0;
                changed += wasMade == isMade ? 0 : 1;
            }
        }
    }

    private void takeDistances(
            List<SonarRequest> sonars, Reply reply, @Nullable DistanceBundle answer, ScenarioSweep.Noise noise) {
        List<Double> distances = ((DistanceBundle) reply.bundle()).distances();
        for (int k = 0; k < distances.size(); k++) {
            double read = noise.read(sonars.get(k), distances.get(k));
            if (Double.isNaN(read)) {
                unanswered++;
            } else if (Double.isInfinite(read)) {
                silent++;
            } else {
                echoes++;
                sum += read;
                nearest = Math.min(nearest, read);
            }
            changed += answer == null || answer.distances().get(k).equals(read) ? 0 : 1;
        }
    }

    /** The result; {@code stuck} is the number of objects that found no free start. */
    Result result(int stuck) {
        Result result = Result.of("moves made", made)
                .and("moves refused", refused)
                .and("way [world units]", way)
                .and("echoes", echoes)
                .and("no echo", silent)
                .and("nearest [world units]", nearest)
                .and("mean distance [world units]", echoes == 0 ? Double.POSITIVE_INFINITY : sum / echoes)
                .and("not answered", unanswered)
                .and("other than recorded", changed)
                .and("no free start", stuck);
        return isDriven ? result.and("contacts", contacts).and("stopped", stopped) : result;
    }
}
