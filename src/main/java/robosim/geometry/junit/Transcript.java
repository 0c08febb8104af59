package robosim.geometry.junit;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.Step;

/**
 * Records what was done in a world as an equivalent conversation. If the world has been changed by other means in
 * between, a new world is recorded.
 */
final class Transcript {
    private final Geometry geometry;
    private final List<Step> steps = new ArrayList<>();
    private @Nullable List<GeometryObject> known;

    Transcript(Geometry geometry) {
        this.geometry = geometry;
    }

    /** Whether the world was changed by other means since the last request. */
    boolean isBehind() {
        return !geometry.objects().equals(known);
    }

    /** Called before the next request is carried out. */
    void catchUp() {
        List<GeometryObject> present = geometry.objects();
        if (!present.equals(known)) {
            WorldSettings settings = new WorldSettings(
                    geometry.width(), geometry.height(), geometry.length(), geometry.dimension(), geometry.accuracy());
            List<String> notes = known == null ? List.of() : List.of("the test changed the world by other means");
            steps.add(new Step(0, notes, new InitBundle(present, settings), null, null));
            known = present;
        }
    }

    /** Called after a step was carried out. */
    void stepped(StepBundle step, Reply reply, long clock) {
        add(step, reply, clock);
        known = geometry.objects();
    }

    /** Called after a move was carried out. */
    void moved(MoveRequest request, @Nullable String refusal, long clock) {
        Reply reply = refusal == null
                ? new Reply(new MoveBundle(List.of(request)))
                : new Reply(new MoveBundle(List.of()), List.of(Problem.of(0, refusal)));
        add(new MoveBundle(List.of(request)), reply, clock);
        known = geometry.objects();
    }

    void measured(String name, double x, double z, Beam beam, double distance, long clock) {
        add(
                new SonarRequestBundle(List.of(new SonarRequest(name, x, z, beam))),
                new Reply(new DistanceBundle(List.of(distance))),
                clock);
    }

    private void add(Bundle request, Reply reply, long clock) {
        List<String> notes = clock == 0 ? List.of() : List.of("step " + clock + " of the clock");
        steps.add(new Step(0, notes, request, reply, null));
    }

    /** The whole conversation, up to the present world. */
    Scenario scenario(String title) {
        catchUp();
        return new Scenario(new ScenarioHeader(title, SessionOptions.ROBOSIM), steps);
    }
}
