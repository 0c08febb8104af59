package robosim.geometry.scenario;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.WorldRequest;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.SurfaceMixing;
import robosim.geometry.protocol.motion.Velocity;

/**
 * What a watcher that joins late needs of a world with bodies, beside the places of its objects. Up to a limit that is the
 * world before the first step of bodies and each change since, so that a replay goes on with the same bits. Beyond it, it is
 * the world as it is, and one step of 0 seconds with all bodies, drives, commands and velocities: the velocities are rounded,
 * and contacts that last begin anew.
 */
final class BodyHistory {
    /** Most steps that are kept: three minutes at 10 a second. */
    static final int MOST_STEPS = 2_000;

    /** Maximum total weight of them, some 6 MB. */
    static final long MOST_WEIGHT = 100_000;

    private final Map<String, BodyRequest> bodies = new LinkedHashMap<>();
    private final Map<String, DriveCommand> commands = new LinkedHashMap<>();
    private final Map<String, Velocity> velocities = new LinkedHashMap<>();
    private @Nullable SurfaceMixing mixing;

    /** The world before the first step of bodies; null if there was none, or too much came after it. */
    private @Nullable Step base;

    private final List<Step> changes = new ArrayList<>();
    private long weight;
    private boolean isTooLong;

    /** Forgets everything: there is a new world. */
    void clear() {
        bodies.clear();
        commands.clear();
        mixing = null;
        velocities.clear();
        forget();
        isTooLong = false;
    }

    private void forget() {
        base = null;
        changes.clear();
        weight = 0;
    }

    /** Whether the first step of bodies is still to come. */
    boolean isEmpty() {
        return base == null && !isTooLong;
    }

    /** Begins with the world before the first step of bodies. */
    void begin(Step world) {
        base = world;
    }

    /** Follows a request that was carried out. */
    void follow(Geometry world, Step step) {
        if (!isEmpty() && isChange(step.request())) {
            keep(step);
        }
        Reply reply = step.expected();
        if (reply != null
                && step.request() instanceof StepBundle asked
                && reply.bundle() instanceof StepBundle.Answer answer) {
            follow(asked, answer, reply.problems());
        } else if (step.request() instanceof BatchRequestBundle) {
            bodies.keySet().removeIf(name -> !world.hasObject(name));
            commands.keySet().removeIf(name -> !world.hasObject(name));
        }
    }

    private void keep(Step step) {
        weight += StepWeight.of(step);
        changes.add(step);
        if (changes.size() > MOST_STEPS || weight > MOST_WEIGHT) {
            forget();
            isTooLong = true;
        }
    }

    private static boolean isChange(Bundle request) {
        return request instanceof StepBundle
                || request instanceof MoveBundle
                || (request instanceof BatchRequestBundle batch
                        && batch.requests().stream().anyMatch(WorldRequest.class::isInstance));
    }

    private void follow(StepBundle asked, StepBundle.Answer answer, List<Problem> problems) {
        Set<Integer> refused = new HashSet<>();
        problems.forEach(problem -> refused.add(problem.index()));
        mixing = asked.mixing() == null ? mixing : asked.mixing();
        int index = 0;
        for (BodyRequest body : asked.bodies()) {
            if (!refused.contains(index++)) {
                BodyRequest before = bodies.get(body.objectName());
                bodies.put(
                        body.objectName(),
                        body.drive() == null && before != null && before.drive() != null
                                ? body.withDrive(before.drive())
                                : body);
                if (body.drive() != null) {
                    commands.remove(body.objectName());
                }
            }
        }
        for (DriveCommand command : asked.commands()) {
            if (!refused.contains(index++)) {
                bodies.putIfAbsent(command.objectName(), BodyRequest.of(command.objectName()));
                commands.put(command.objectName(), command);
            }
        }
        velocities.clear();
        for (BodyAnswer body : answer.bodies()) {
            velocities.put(body.objectName(), body.velocity());
        }
    }

    /** The steps with which a watcher begins, given the present world as a step that makes it. */
    List<Step> present(Step now) {
        if (base != null) {
            List<Step> all = new ArrayList<>();
            all.add(base);
            all.addAll(changes);
            return all;
        }
        if (bodies.isEmpty() && mixing == null) {
            return List.of(now);
        }
        List<BodyRequest> moving = new ArrayList<>();
        for (BodyRequest body : bodies.values()) {
            Velocity velocity = velocities.get(body.objectName());
            moving.add(velocity == null ? body : body.withVelocity(velocity));
        }
        StepBundle told = new StepBundle(0, moving, List.copyOf(commands.values()), mixing, List.of());
        return List.of(now, new Step(0, List.of("the bodies as they are"), told, null, now.timing()));
    }
}
