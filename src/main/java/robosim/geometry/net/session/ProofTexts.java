package robosim.geometry.net.session;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.Geometry;
import robosim.geometry.WorldProver;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.proof.Attempt;
import robosim.geometry.proof.Proof;
import robosim.geometry.proof.Scene;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.ScanMotion;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/** Proofs of the answers to requests, as texts for a message. */
final class ProofTexts {
    /** Letters of a part of a text, all of them ASCII: a message may have texts of 65,535 bytes. */
    private static final int PART = 1 << 15;

    /** About the least letters of a piece. */
    private static final long LETTERS = 50;

    /** The objects of a world. */
    WorldAnswer.SceneText scene(Geometry world) {
        Scene scene = world.prove().scene();
        long pieces = scene.objects().stream().mapToLong(ProofTexts::pieces).sum();
        String text = LETTERS * pieces > WorldAnswer.SceneText.MOST_CHARACTERS ? null : Proof.jsonOf(scene);
        if (text == null || text.length() > WorldAnswer.SceneText.MOST_CHARACTERS) {
            throw new IllegalArgumentException("the scene is too large for a message: its text must have at most "
                    + WorldAnswer.SceneText.MOST_CHARACTERS + " characters; check proofs about it in Java (got: "
                    + pieces + " pieces)");
        }
        return new WorldAnswer.SceneText(parts(text));
    }

    private static long pieces(GeometryObject object) {
        if (object instanceof ObjectGroup group) {
            return group.parts().stream().mapToLong(ProofTexts::pieces).sum();
        }
        return object instanceof MeshObject mesh
                ? mesh.faces().length
                : object instanceof GridObject grid ? MessageLimits.parts(grid) : 1;
    }

    /** Proofs of the answer to a request. */
    WorldAnswer.Proved of(Geometry world, BatchRequest request) {
        List<WorldAnswer.Evidence> proofs = new ArrayList<>();
        int left = WorldAnswer.MOST_CHARACTERS;
        for (Attempt attempt : attempts(world.prove(), world.dimension(), request)) {
            Proof proof = attempt.proof();
            String text = proof == null ? "" : proof.json();
            left -= text.length();
            proofs.add(
                    proof == null
                            ? new WorldAnswer.Evidence(List.of(), attempt.reason())
                            : left < 0
                                    ? new WorldAnswer.Evidence(
                                            List.of(), "the texts of all proofs of an answer would be too long")
                                    : new WorldAnswer.Evidence(parts(text), ""));
        }
        return new WorldAnswer.Proved(proofs);
    }

    private static List<Attempt> attempts(WorldProver prover, Dimension dimension, BatchRequest request) {
        if (request instanceof WorldRequest.Go go) {
            Move move = new Move(go.x(), go.y(), go.z(), Degrees.toDegrees(go.rx()), Degrees.toDegrees(go.ry()));
            return prover.move(go.objectName(), move);
        }
        return request instanceof SenseRequest sense
                ? beams(prover, dimension, sense)
                : List.of(prover.apart(request.objectName()));
    }

    private static List<Attempt> beams(WorldProver prover, Dimension dimension, SenseRequest request) {
        if (!request.ignored().isEmpty()
                || request.seesCarrier()
                || !request.motion().equals(ScanMotion.NONE)) {
            throw new IllegalArgumentException(
                    "a sensor must ignore nothing, not see what carries it and be at rest for a proof; leave out"
                            + " ignored, seesCarrier and motion");
        }
        RayPattern pattern = RayPatterns.make(request.pattern());
        if (dimension == Dimension.PLANAR && request.width() == 0 && !pattern.isLevel()) {
            throw new IllegalArgumentException(
                    "pattern must be level for a proof in a PLANAR world, whose proofs know no heights");
        }
        Pose mount = request.mount().pose();
        double width = Degrees.toDegrees(request.width());
        double[] directions = new double[3 * pattern.size()];
        pattern.directions(0, pattern.size(), directions, 0);
        List<Attempt> attempts = new ArrayList<>();
        for (int at = 0; at < directions.length; at += 3) {
            Ray ray = new Ray(mount.center(), turned(mount, directions, at));
            attempts.add(
                    request.isCarried()
                            ? prover.sonar(request.objectName(), ray, request.max(), width)
                            : width > 0 ? prover.cone(ray, request.max(), width) : prover.ray(ray, request.max()));
        }
        return attempts;
    }

    private static Point turned(Pose by, double[] directions, int at) {
        double[] turned = new double[3];
        for (int row = 0; row < 3; row++) {
            turned[row] = by.rotation(3 * row) * directions[at]
                    + by.rotation(3 * row + 1) * directions[at + 1]
                    + by.rotation(3 * row + 2) * directions[at + 2];
        }
        return new Point(turned[0], turned[1], turned[2]);
    }

    private static List<String> parts(String text) {
        List<String> parts = new ArrayList<>();
        for (int from = 0; from < text.length(); from += PART) {
            parts.add(text.substring(from, Math.min(from + PART, text.length())));
        }
        return parts;
    }
}
