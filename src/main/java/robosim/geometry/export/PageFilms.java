package robosim.geometry.export;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.LongConsumer;
import robosim.geometry.Geometry;
import robosim.geometry.check.NumberText;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.Step;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.viewer.playback.Colours;
import robosim.geometry.viewer.playback.Frame;
import robosim.geometry.viewer.playback.Replayer;
import robosim.geometry.viewer.playback.StateHistory;
import robosim.geometry.viewer.playback.WorldSonars;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** Histories of what a page can show. */
public final class PageFilms {
    private PageFilms() {}

    /** A conversation. */
    static StateHistory of(Scenario scenario) {
        return of(scenario, Colours.NONE);
    }

    /** A conversation, in the colours of a world file's objects. */
    static StateHistory of(Scenario scenario, Colours colours) {
        StateHistory film = new StateHistory();
        Replayer stage = new Replayer(scenario.header().options(), colours);
        for (Step step : scenario.steps()) {
            film.add(stage.play(step));
        }
        return film;
    }

    /**
     * A recorded conversation, of which the oldest part may be dropped where it is very long.
     *
     * @param colours  of a world file's objects
     * @param progress called with the number of steps so far
     */
    public static StateHistory of(StepReader conversation, Colours colours, LongConsumer progress) throws IOException {
        StateHistory film = new StateHistory();
        ScenarioHeader header = conversation.header();
        Replayer stage = new Replayer(header.options(), colours);
        for (Step step = conversation.next(); step != null; step = conversation.next()) {
            film.add(stage.play(step));
            progress.accept(film.size());
        }
        return film;
    }

    /** A world as its file has it, with what the sonars of its robots measure there. */
    public static StateHistory of(World world) {
        Geometry geometry = world.toGeometry(outside -> {});
        Map<String, List<Scene.Ping>> heard = WorldSonars.of(world).measure(geometry);
        String words = NumberText.count(world.objects().size(), "object") + ", "
                + world.dimension().name().toLowerCase(Locale.ROOT);
        StateHistory film = new StateHistory();
        List<WorldObject> shown = new ArrayList<>(world.objects());
        world.scenery().forEach(each -> shown.add(new WorldObject(each)));
        film.append(new Frame(
                Frame.Setting.of(world.withObjects(shown)), Map.of(), List.of(), heard, words, List.of(), null));
        return film;
    }
}
