package robosim.geometry.viewer.playback;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.check.NumberText;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.viewer.draw.Painter;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.Unit;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** Makes scenes for the painter from world files and conversations. */
public final class Pictures {
    /** Number of steps in a picture of the last moments of a conversation. */
    private static final int MOMENTS = 60;

    /** How many times as large as the part where something happened a world is whose picture shows only that part. */
    private static final double LEAST_CROP = 3;

    private Pictures() {}

    public static Scene of(World world, String title) {
        Checks.present("world", world);
        Checks.present("title", title);
        List<Scene.Thing> things = Colours.things(world);
        Scene.View view = Scene.View.of(world.width(), world.length(), things);
        return Scene.of(title, view, things).described(contents(world), unit(world));
    }

    /** What is in a world, in words. */
    static String contents(World world) {
        return NumberText.count(world.objects().size(), "object") + ", "
                + world.dimension().name().toLowerCase(Locale.ROOT);
    }

    /** The scene of a world, with what the sonars of its robots measure there. */
    public static Scene sensed(World world, String title) {
        List<Scene.Ping> pings = WorldSonars.of(world).measure(world.toGeometry(outside -> {})).values().stream()
                .flatMap(List::stream)
                .toList();
        return of(world, title).with(List.of(), pings, List.of());
    }

    /** The name of the world unit for the scale bar; empty if unspecified, or without a world. */
    public static String unit(@Nullable World world) {
        Unit unit = world == null ? null : world.unit();
        return unit == null ? "" : unit.symbol();
    }

    /** The world of a conversation at one moment, as a world file has it. */
    public static World world(Frame.Setting setting, List<Scene.Thing> movers) {
        List<Scene.Thing> things = new ArrayList<>(setting.statics());
        things.addAll(movers);
        List<WorldObject> objects = new ArrayList<>();
        for (Scene.Thing each : things) {
            Integer colour = each.colour();
            String color = colour == null ? null : String.format(Locale.ROOT, "#%06x", colour);
            objects.add(new WorldObject(each.object(), color, List.of()));
        }
        return new World(
                setting.width(),
                setting.height(),
                setting.length(),
                null,
                setting.dimension(),
                setting.accuracy(),
                objects);
    }

    /** The name of a file without its folder and endings. */
    public static String title(Path file) {
        Path name = file.getFileName();
        return name == null ? file.toString() : name.toString().replaceFirst("(\\.scenario)?\\.[^.]*$", "");
    }

    /**
     * Adds a whole conversation to the scene of its world: its trails, its last distances, its refused moves.
     *
     * @param world the scene, whose objects move to their final places
     */
    public static Scene whole(StepReader conversation, Scene world) throws IOException {
        StateHistory film = Replayer.film(conversation, Colours.NONE, steps -> {});
        return film.over(world, film.size() - 1);
    }

    /**
     * The end of a conversation: the robots at their final places, with the trails of their last steps, their last
     * distances and what blocked their last moves. The same conversation gives the same picture.
     */
    static Scene lastMoments(Scenario scenario, Colours colours) {
        StateHistory film = Replayer.film(scenario, colours);
        return film.at(film.size() - 1, new StateHistory.Look(MOMENTS, MOMENTS))
                .titled(scenario.header().title());
    }

    /** The part of a scene where things happened, if that is much less than all of it. */
    private static Scene.View nearby(Scene scene) {
        List<Bounds> seen = new ArrayList<>();
        for (Scene.Trail trail : scene.trails()) {
            if (trail.path().size() > 1) {
                trail.path().forEach(place -> seen.add(at(place)));
            }
        }
        for (Scene.Blocked each : scene.blocked()) {
            seen.add(each.mover().bounds());
            if (each.aim() != null) {
                seen.add(each.aim().bounds());
            }
        }
        Scene.View all = scene.view();
        return seen.stream()
                .reduce(Bounds::and)
                .map(found -> around(found, scene))
                .filter(near -> area(near) * LEAST_CROP < area(all))
                .orElse(all);
    }

    private static Bounds at(Point place) {
        return new Bounds(place.x(), place.y(), place.z(), place.x(), place.y(), place.z());
    }

    /** What happened, with as much again around it, and room for any of the robots. */
    private static Scene.View around(Bounds found, Scene scene) {
        double robot = scene.things().stream()
                .map(Scene.Thing::object)
                .filter(GeometryObject::isMoveable)
                .mapToDouble(
                        each -> Math.max(each.bounds().width(), each.bounds().length()))
                .max()
                .orElse(0);
        double margin = Math.max(Math.max(found.width(), found.length()) / 2, 3 * robot);
        return Scene.View.around(new Bounds(
                found.minX() - margin, 0, found.minZ() - margin, found.maxX() + margin, 0, found.maxZ() + margin));
    }

    private static double area(Scene.View view) {
        return (view.maxX() - view.minX()) * (view.maxZ() - view.minZ());
    }

    /** The end of a conversation as a picture that is drawn to one file or several. */
    public static final class Moments {
        private final Scene scene;

        private Moments(Scene scene) {
            this.scene = scene;
        }

        /** Draws it to a file whose name ends in {@code .svg} or {@code .png}. */
        public void write(Path file) throws IOException {
            Painter.write(scene, Theme.LIGHT, file);
        }
    }

    /**
     * The end of a conversation, as in {@link #lastMoments(Scenario, Colours)}; of a large world only the part where it happened.
     *
     * @param goals goals of robots, which the picture includes
     * @param world lends colours and a unit; null for none
     */
    public static Moments lastMoments(Scenario scenario, List<GeometryObject> goals, @Nullable World world) {
        Scene scene = lastMoments(scenario, Colours.of(world));
        if (world != null) {
            scene = scene.described(scene.subtitle(), unit(world));
        }
        Scene.View view = nearby(scene);
        for (GeometryObject goal : goals) {
            view = view.with(goal);
        }
        List<Scene.Mark> marks = goals.stream()
                .map(goal -> new Scene.Mark(goal, Scene.Mark.Why.GOAL))
                .toList();
        return new Moments(scene.viewed(view).marked(marks, scene.farthest()));
    }
}
