package robosim.geometry.net;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;

/**
 * A world and what is asked about it, both drawn from a seed, with the answers of an undisturbed run: those of a session
 * in process, without bytes and sockets. Robots move, so that an answer depends on every move before it.
 */
record Conversation(InitBundle world, List<Bundle> requests, List<Reply> replies) {
    private static final int ROBOTS = 6;

    static Conversation of(long seed, int bundles) {
        SplittableRandom random = new SplittableRandom(seed);
        InitBundle world = new InitBundle(objects(random));
        List<Bundle> requests = new ArrayList<>();
        List<Reply> replies = new ArrayList<>();
        Session session = new Session();
        session.answer(world);
        for (int k = 0; k < bundles; k++) {
            Bundle request = random.nextInt(3) == 0 ? sonars(random) : moves(random);
            requests.add(request);
            replies.add(session.reply(request));
        }
        return new Conversation(world, requests, replies);
    }

    private static List<GeometryObject> objects(SplittableRandom random) {
        List<GeometryObject> objects = new ArrayList<>();
        for (int side = 0; side < 4; side++) {
            Point middle = new Point(side % 2 == 0 ? 0 : 20 * side - 40, 0, side % 2 == 1 ? 0 : 20 * side - 20);
            objects.add(new BoxObject(middle, 40, 2, 0.5).turned(0, side % 2 == 0 ? 0 : 90));
        }
        for (int k = 0; k < 20; k++) {
            Point at = new Point(random.nextDouble(-18, 18), 0, random.nextDouble(-18, 18));
            objects.add(new CylinderObject(at, random.nextDouble(0.2, 1), 2));
        }
        for (int k = 0; k < ROBOTS; k++) {
            Point at = new Point(random.nextDouble(-18, 18), 0, random.nextDouble(-18, 18));
            objects.add(new CylinderObject(at, 0.25, 1).moveable("robot " + k));
        }
        return objects;
    }

    private static Bundle moves(SplittableRandom random) {
        List<MoveRequest> moves = new ArrayList<>();
        for (int k = random.nextInt(1, 12); k > 0; k--) {
            boolean turn = random.nextBoolean();
            moves.add(new MoveRequest(
                    name(random), turn ? 0 : random.nextDouble(-0.5, 2), 0, 0, 0, turn ? random.nextDouble(-1, 1) : 0));
        }
        return new MoveBundle(moves);
    }

    private static Bundle sonars(SplittableRandom random) {
        List<SonarRequest> requests = new ArrayList<>();
        for (int k = random.nextInt(1, 30); k > 0; k--) {
            Beam beam = random.nextBoolean() ? null : new Beam(0.1, 12, 0.3);
            requests.add(new SonarRequest(name(random), random.nextDouble(-1, 1), random.nextDouble(0.1, 1), beam));
        }
        return new SonarRequestBundle(requests);
    }

    /** Now and then of nobody. */
    private static String name(SplittableRandom random) {
        return "robot " + random.nextInt(random.nextInt(50) == 0 ? ROBOTS + 1 : ROBOTS);
    }

    /** Empty where the same was heard, to the bit and in order; else the first difference. */
    String difference(List<Bundle> heard) {
        List<Bundle> answers = answers();
        for (int k = 0; k < Math.min(heard.size(), answers.size()); k++) {
            if (!answers.get(k).equals(heard.get(k))) {
                return "answer " + k + " must be " + answers.get(k) + " (got: " + heard.get(k) + ")";
            }
        }
        return heard.size() == answers.size()
                ? ""
                : "there must be " + answers.size() + " answers (got: " + heard.size() + ")";
    }

    /** Without what was refused and why. */
    List<Bundle> answers() {
        return replies.stream().map(Reply::bundle).toList();
    }

    /** Its first so many requests. */
    Conversation first(int count) {
        return new Conversation(world, requests.subList(0, count), replies.subList(0, count));
    }

    /** Where each request ends in the environment's stream, after its world. */
    long[] requestEnds(Tongue tongue) throws IOException {
        List<Bundle> all = new ArrayList<>(requests);
        all.add(0, world);
        long[] ends = Tongue.ends(tongue, all);
        return Arrays.copyOfRange(ends, 1, ends.length);
    }

    /** Where each answer ends in the module's stream. */
    long[] answerEnds(Tongue tongue) throws IOException {
        return tongue.answerEnds(replies);
    }
}
