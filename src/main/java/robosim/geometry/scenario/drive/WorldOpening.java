package robosim.geometry.scenario.drive;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.net.Session;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.world.World;

/** A world as the requests that make it. */
public final class WorldOpening {
    private WorldOpening() {}

    /** The init of a world: its settings, and its objects in their order. */
    public static InitBundle init(World world) {
        Checks.present("world", world);
        WorldSettings settings =
                new WorldSettings(world.width(), world.height(), world.length(), world.dimension(), world.accuracy());
        return new InitBundle(world.joined(), settings);
    }

    /**
     * The init, and a step of no time that gives the world's bodies if it has any.
     *
     * @throws IllegalArgumentException if an object or a body is refused
     */
    public static List<Bundle> of(World world) {
        List<Bundle> requests = new ArrayList<>(List.of(init(world)));
        List<BodyRequest> bodies = WorldBodies.of(world);
        if (!bodies.isEmpty()) {
            requests.add(new StepBundle(0, bodies, List.of()));
        }
        check(requests);
        return List.copyOf(requests);
    }

    /** Carries them out once, as each session will. */
    private static void check(List<Bundle> requests) {
        Session session = new Session();
        InitBundle init = (InitBundle) requests.get(0);
        Reply told = Objects.requireNonNull(session.reply(new InitBundle.Answered(init)));
        if (!told.problems().isEmpty()) {
            throw new IllegalArgumentException(told.problems().get(0).reason());
        }
        WorldAnswer.Described world = (WorldAnswer.Described)
                ((BatchAnswerBundle) told.bundle()).answers().get(0);
        if (!world.leftOut().isEmpty()) {
            WorldAnswer.LeftOut first = world.leftOut().get(0);
            throw new IllegalArgumentException("object " + first.index() + ", " + Text.quoted(first.name())
                    + ", was not added: " + first.reason());
        }
        for (Bundle request : requests.subList(1, requests.size())) {
            Reply reply = Objects.requireNonNull(session.reply(request));
            if (!reply.problems().isEmpty()) {
                throw new IllegalArgumentException(reply.problems().get(0).reason());
            }
        }
    }
}
