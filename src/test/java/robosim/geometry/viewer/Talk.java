package robosim.geometry.viewer;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.Step;
import robosim.geometry.viewer.playback.Replayer;
import robosim.geometry.viewer.playback.StateHistory;

/** A small conversation to be looked at: a world of 20 by 10, a wall in its middle, a drum left of it. */
public final class Talk {
    public static final GeometryObject WALL = new BoxObject(new Point(2, 0, 0), 1, 1, 4).named("wall");
    public static final GeometryObject DRUM = new CylinderObject(new Point(-5, 0, 0), 0.5, 1).moveable("drum");

    private final List<Step> steps = new ArrayList<>();

    public static Talk begun() {
        return new Talk().world(WALL, DRUM);
    }

    public Talk world(GeometryObject... objects) {
        WorldSettings settings = new WorldSettings(20, 5, 10, Dimension.PLANAR, Accuracy.EXACT);
        return step(new InitBundle(List.of(objects), settings), null);
    }

    /** A step by the drum forward, which the record says was made or not; null where it does not say. */
    public Talk drives(double x, @Nullable Boolean made) {
        return moves(move(x, 0), made);
    }

    /** A turn in degrees. */
    public Talk turns(double degrees, @Nullable Boolean made) {
        return moves(move(0, degrees), made);
    }

    public static MoveRequest move(double x, double degrees) {
        return new MoveRequest("drum", x, 0, 0, 0, Math.toRadians(degrees));
    }

    private Talk moves(MoveRequest request, @Nullable Boolean made) {
        MoveBundle asked = new MoveBundle(List.of(request));
        Reply reply = made == null ? null : new Reply(made ? asked : new MoveBundle(List.of()));
        return step(asked, reply);
    }

    /** Looks forward in a cone of 20 degrees up to 6 units. */
    public Talk looks(@Nullable Double heard) {
        return looks("drum", heard);
    }

    public Talk looks(String name, @Nullable Double heard) {
        Bundle request =
                new SonarRequestBundle(List.of(new SonarRequest(name, 1, 0, new Beam(0, 6, StrictMath.toRadians(20)))));
        return step(request, heard == null ? null : new Reply(new DistanceBundle(List.of(heard))));
    }

    public Talk step(Bundle request, @Nullable Reply reply) {
        steps.add(new Step(request, reply));
        return this;
    }

    public List<Step> steps() {
        return Collections.unmodifiableList(steps);
    }

    public Scenario scenario() {
        return new Scenario(new ScenarioHeader("a talk", SessionOptions.ROBOSIM), steps);
    }

    public StateHistory film() {
        StateHistory film = new StateHistory();
        Replayer stage = new Replayer(SessionOptions.ROBOSIM);
        steps.forEach(step -> film.append(stage.play(step)));
        return film;
    }
}
