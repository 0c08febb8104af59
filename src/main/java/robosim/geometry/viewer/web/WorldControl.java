package robosim.geometry.viewer.web;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.MoveResult;
import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.viewer.playback.Frame;
import robosim.geometry.viewer.playback.Sandbox;
import robosim.geometry.viewer.playback.WorldSonars;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.World;

/** The world of a file, whose robots can be dragged and measure where they are; nothing but the pages sees it. */
public final class WorldControl implements Control {
    private final LiveFilm film;
    private final Frame.Setting setting;
    private final WorldSonars sonars;
    private Sandbox sandbox;

    /** Begins with the world as its file has it. */
    public WorldControl(World world, LiveFilm film) {
        this.film = Checks.present("film", film);
        setting = Frame.Setting.of(world);
        sonars = WorldSonars.of(world);
        sandbox = Sandbox.of(setting, setting.movers(), sonars);
        film.add(frame(setting, Map.of(), List.of(), "as in the file"));
    }

    private Frame frame(
            Frame.@Nullable Setting opening, Map<String, Pose> placed, List<Frame.Bump> bumps, String words) {
        return new Frame(opening, placed, bumps, sandbox.measured(), words, List.of(), null);
    }

    @Override
    public List<String> commands() {
        return List.of("drag", "turn", "reset");
    }

    @Override
    public Map<String, @Nullable Object> state() {
        return Map.of();
    }

    @Override
    public synchronized String carryOut(Map<?, ?> command) {
        switch (Control.text(command, "do")) {
            case "reset" -> {
                sandbox = Sandbox.of(setting, setting.movers(), sonars);
                Map<String, Pose> placed = new LinkedHashMap<>();
                for (Scene.Thing mover : setting.movers()) {
                    placed.put(
                            String.valueOf(mover.object().name()),
                            mover.object().pose());
                }
                film.add(frame(null, placed, List.of(), "all where they began"));
                return "";
            }
            case "drag" -> {
                boolean isLifted = Boolean.TRUE.equals(command.get("lift"));
                GeometryObject before = mover(command);
                Sandbox.Push push = isLifted ? Sandbox.Push.PLACE : Sandbox.Push.MOVE;
                sandbox.push(name(before), Control.number(command, "x"), Control.number(command, "z"), push);
                return changed(before);
            }
            case "turn" -> {
                GeometryObject before = mover(command);
                sandbox.turn(name(before), Control.number(command, "degrees"));
                return changed(before);
            }
            default ->
                throw new IllegalArgumentException(
                        "do must be one of " + commands() + " (got: " + command.get("do") + ")");
        }
    }

    private GeometryObject mover(Map<?, ?> command) {
        String name = Control.text(command, "name");
        return sandbox.movers().stream()
                .map(Scene.Thing::object)
                .filter(object -> name.equals(object.name()))
                .findAny()
                .orElseThrow(
                        () -> new IllegalArgumentException("name must be of a moveable object (got: " + name + ")"));
    }

    private static String name(GeometryObject mover) {
        return String.valueOf(mover.name());
    }

    /** Shows where a robot is now, and what was in its way if it was refused. */
    private String changed(GeometryObject before) {
        Sandbox.Refused refused = sandbox.refused();
        if (refused == null) {
            Pose there = mover(Map.of("name", name(before))).pose();
            film.add(frame(null, Map.of(name(before), there), List.of(), ""));
            return "";
        }
        Point from = before.center();
        Point to = refused.ghost().center();
        boolean isTurn = from.x() == to.x() && from.z() == to.z();
        double heading = isTurn
                ? before.heading()
                : StrictMath.toDegrees(StrictMath.atan2(from.z() - to.z(), to.x() - from.x()));
        GeometryObject obstacle =
                refused.obstacles().isEmpty() ? null : refused.obstacles().get(0);
        MoveResult result = new MoveResult(false, 0, 0, obstacle, null, null);
        film.add(frame(null, Map.of(), List.of(new Frame.Bump(before, heading, result)), "refused"));
        return "blocked by " + refused.words();
    }
}
