package robosim.geometry.viewer.window;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.viewer.draw.Card;
import robosim.geometry.viewer.playback.Feed;
import robosim.geometry.viewer.playback.Frame;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.viewer.playback.Player;
import robosim.geometry.viewer.playback.Sandbox;
import robosim.geometry.viewer.playback.StateHistory;
import robosim.geometry.viewer.playback.WorldSonars;
import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.viewer.space.Moment;
import robosim.geometry.world.World;

/**
 * The state of a viewer: a history or a world, a camera, a selected object, a robot being dragged. Independent of any
 * window: pixels and time are passed in. May be used by one thread at a time.
 */
final class ViewerModel {
    /** Maximum number of frames read at a time, so that the window stays responsive. */
    private static final int AT_ONCE = 500;

    /** Pixels within which a press is not a drag, and a near miss counts as a hit. */
    private static final double SLACK = 4;

    /** Maximum number of points of all trails together, so that a long conversation is drawn as fast as a short one. */
    private static final int MARKS = 20_000;

    /** Minimum number of points of the trail of one of many robots. */
    private static final int LEAST_MARKS = 100;

    /** The maximum size of the view, in sizes of the world, to include objects outside the world. */
    private static final double FAR = 3;

    final StateHistory film = new StateHistory();
    final Player player;
    final Camera camera = new Camera();
    private final String title;
    private final String unit;
    private final @Nullable Feed feed;
    private final boolean live;

    /** The last text about the end of the feed. */
    private String told = "";

    private Frame.@Nullable Setting shown;
    private Scene.View border = new Scene.View(-0.5, -0.5, 0.5, 0.5, false);
    private int world = -1;
    private @Nullable Sandbox sandbox;

    private final Selection selection = new Selection();
    private final Layers layers = new Layers();

    /** The world file that is shown; null for a conversation. */
    private @Nullable World file;

    /** Whether the plan follows the selected robot. */
    private boolean isFollowing;

    /** What was saved last, as a sentence; empty if nothing since the last step. */
    private String saved = "";

    private @Nullable Grip grip;

    private ViewerModel(String title, String unit, @Nullable Feed feed, boolean live) {
        this.title = title;
        this.unit = unit;
        this.feed = feed;
        this.live = live;
        this.player = live ? Player.ofLive(film) : Player.ofRecording(film);
    }

    /** A model of a world, whose robots can be dragged. */
    static ViewerModel ofWorld(World world, String title) {
        ViewerModel viewing = new ViewerModel(title, Pictures.unit(world), null, false);
        Frame.Setting setting = Frame.Setting.of(world);
        viewing.film.append(Frame.of(setting, "as in the file"));
        viewing.file = world;
        viewing.sandbox = Sandbox.of(setting, setting.movers(), WorldSonars.of(world));
        viewing.player.pause();
        viewing.tick(0);
        return viewing;
    }

    static ViewerModel ofRecording(Feed feed, String title, String unit) {
        return new ViewerModel(title, unit, feed, false);
    }

    static ViewerModel ofLive(Feed feed, String title, String unit) {
        return new ViewerModel(title, unit, feed, true);
    }

    String title() {
        return title;
    }

    /** Whether there are steps to go back and forth in. */
    boolean hasSteps() {
        return feed != null;
    }

    /** Advances the time; returns whether anything visible has changed. */
    boolean tick(long nanos) {
        int before = player.position();
        int drained = feed == null ? 0 : feed.drain(film, AT_ONCE);
        if (sandbox == null || feed == null) {
            player.tick(nanos);
        }
        Frame.Setting setting = film.setting(player.position());
        int now = film.world(player.position());
        if (setting != null && now != world) {
            border = seen(setting);
            camera.look(border);
            shown = setting;
            world = now;
        }
        follow();
        String end = end();
        boolean changed = before != player.position() || drained > 0 || !end.equals(told);
        told = end;
        if (before != player.position()) {
            saved = "";
        }
        return changed;
    }

    /** Keeps the robot that the plan follows in its middle. */
    private void follow() {
        GeometryObject robot = isFollowing ? picked() : null;
        if (robot != null && grip == null) {
            camera.center(robot.center().x(), robot.center().z());
        }
    }

    /** Lets the plan follow the selected robot, or no longer, and returns which. */
    boolean toggleFollowing() {
        isFollowing = !isFollowing;
        follow();
        return isFollowing;
    }

    /**
     * The view of a world including robots outside its bounds, unless they are so far away that the world would be too
     * small.
     */
    private Scene.View seen(Frame.Setting setting) {
        Scene.View view = Scene.View.of(setting.width(), setting.length(), setting.things());
        if (sandbox == null || sandbox.outside().isEmpty()) {
            return view;
        }
        Bounds bounds = setting.border()
                .bounds()
                .and(Scene.View.around(sandbox.outside()).bounds());
        boolean near = bounds.width() <= FAR * setting.width() && bounds.length() <= FAR * setting.length();
        return near ? Scene.View.around(bounds) : view;
    }

    /** A number that identifies the world shown; -1 for none. */
    int world() {
        return world;
    }

    /** What a picture in three dimensions shows; null before the first world. */
    @Nullable
    Moment moment() {
        Frame.Setting setting = shown;
        return setting == null ? null : new Moment(world, setting.dimension(), border, setting.statics(), life());
    }

    /** The floor and the static objects. */
    Scene ground() {
        Frame.Setting setting = shown;
        return setting == null
                ? Scene.of("", border, List.of())
                : Scene.of("", setting.border(), setting.statics()).described("", unit);
    }

    /** The moveable objects at their present places, with what happened to them. */
    Scene life() {
        Scene scene;
        if (sandbox != null && shown != null) {
            scene = sandbox.life();
        } else {
            int trail = layers.trail();
            int robots = shown == null ? 1 : Math.max(1, shown.movers().size());
            StateHistory.Look look = new StateHistory.Look(trail, trail, Math.max(LEAST_MARKS, MARKS / robots));
            scene = film.life(player.position(), look);
        }
        scene = scene.blocked(Layers.blocked(scene, sandbox)).marked(marks(), scene.farthest());
        return layers.of(scene).described("", unit);
    }

    private List<Scene.Mark> marks() {
        List<Scene.Mark> marks = new ArrayList<>();
        Sandbox.Refused refused = sandbox == null ? null : sandbox.refused();
        if (sandbox != null) {
            sandbox.outside().forEach(each -> marks.add(new Scene.Mark(each, Scene.Mark.Why.REFUSED)));
        }
        if (refused != null) {
            marks.add(new Scene.Mark(refused.ghost(), Scene.Mark.Why.REFUSED));
        }
        GeometryObject object = picked();
        if (object != null) {
            marks.add(new Scene.Mark(object, Scene.Mark.Why.PICKED));
        }
        return marks;
    }

    private List<Scene.Thing> movers() {
        return sandbox != null ? sandbox.movers() : film.movers(player.position());
    }

    /** The selected object at its present place; null if nothing is selected or it no longer exists. */
    @Nullable
    GeometryObject picked() {
        return selection.present(movers(), world);
    }

    /** The card of the selected object; null if nothing is selected. */
    @Nullable
    Card card() {
        GeometryObject object = picked();
        return object == null ? null : Card.of(object, unit);
    }

    /** A status line about what is shown. */
    String status() {
        return saved.isEmpty() ? state() : saved;
    }

    private String state() {
        Sandbox own = sandbox;
        return own != null
                ? StatusText.ofCopy(own, feed == null ? -1 : player.position())
                : StatusText.ofStep(film, player.position(), feed, end());
    }

    /** The speed as text for people. */
    String pace() {
        return StatusText.pace(player, live);
    }

    private String end() {
        return StatusText.end(feed, live);
    }

    /** Handles the mouse wheel at a pixel; up zooms in. */
    void wheel(double x, double y, double notches) {
        camera.zoom(x, y, StrictMath.pow(Camera.STEP, -notches));
    }

    /** Handles a button press at a pixel: selects the object there. */
    void press(double x, double y) {
        saved = "";
        MapFrame frame = camera.frame();
        double worldX = frame.worldX(x);
        double worldZ = frame.worldZ(y);
        List<Scene.Thing> things = new ArrayList<>(shown == null ? List.of() : shown.statics());
        things.addAll(movers());
        GeometryObject object = Picker.at(things, worldX, worldZ, SLACK / camera.scale());
        Grip held = new Grip(x, y, object != null && object.isMoveable() ? object.name() : null);
        if (object != null) {
            held.offsetX = object.center().x() - worldX;
            held.offsetZ = object.center().z() - worldZ;
            select(object);
        }
        grip = held;
    }

    void select(@Nullable GeometryObject object) {
        selection.select(object, world);
    }

    /** Handles a mouse drag: pushes a robot or moves the view. */
    void drag(double x, double y, Sandbox.Push push) {
        Grip held = grip;
        if (held == null) {
            return;
        }
        held.moved |= StrictMath.hypot(x - held.beginX, y - held.beginY) > SLACK;
        if (!held.moved) {
            return;
        }
        if (held.robot == null) {
            camera.pan(x - held.x, y - held.y);
        } else {
            MapFrame frame = camera.frame();
            push(held.robot, frame.worldX(x) + held.offsetX, frame.worldZ(y) + held.offsetZ, push);
        }
        held.x = x;
        held.y = y;
    }

    /** Pushes a robot to a place; if that is refused it stays, and the refusal is shown. */
    void push(String robot, double x, double z, Sandbox.Push push) {
        Sandbox own = own();
        if (own != null) {
            own.push(robot, x, z, push);
        }
    }

    /** Handles the release of the button; if nothing was hit or dragged, clears the selection. */
    void release() {
        Grip held = grip;
        grip = null;
        if (sandbox != null) {
            sandbox.release();
        }
        MapFrame frame = camera.frame();
        if (held != null && !held.moved && pickedAt(frame.worldX(held.x), frame.worldZ(held.y)) == null) {
            selection.select(null, world);
        }
    }

    private @Nullable GeometryObject pickedAt(double x, double z) {
        GeometryObject object = picked();
        return object == null ? null : Picker.at(List.of(new Scene.Thing(object, null)), x, z, SLACK / camera.scale());
    }

    /** Turns the selected robot in place. */
    void turnPicked(double degrees) {
        GeometryObject object = picked();
        Sandbox own = object == null || !object.isMoveable() ? null : own();
        if (own != null && object != null) {
            own.turn(String.valueOf(object.name()), degrees);
        }
    }

    /** The world in which robots can be pushed; for a conversation, a copy of the moment shown. */
    private @Nullable Sandbox own() {
        if (sandbox == null && shown != null) {
            player.pause();
            sandbox = Sandbox.of(shown, film.movers(player.position()));
        }
        return sandbox;
    }

    /** Leaves the local copy; if there is none, clears the selection. */
    void escape() {
        if (sandbox != null && feed != null) {
            sandbox = null;
        } else {
            selection.select(null, world);
        }
    }

    /** Leaves the local copy, before going elsewhere in a conversation. */
    void leaveCopy() {
        if (feed != null) {
            sandbox = null;
        }
    }

    /** What is drawn over the objects. */
    Layers layers() {
        return layers;
    }

    /** Saves the world with its robots at their present places. */
    void save(Saving saving) {
        Frame.Setting setting = shown;
        if (setting != null) {
            tell(() -> saving.world(file, setting, movers(), title + "-moved"));
        }
    }

    /** Saves something, and lets the status line name the file or say why there is none. */
    void tell(Callable<Path> saving) {
        try {
            saved = "saved " + saving.call().toAbsolutePath();
        } catch (Exception e) {
            saved = "not saved: " + e.getMessage();
        }
    }
}
