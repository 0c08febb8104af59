package robosim.geometry.viewer.playback;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.MoveResult;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/**
 * The state history of a conversation: frames by number, from 0, and the world at any of them without replaying from
 * the beginning. May be used by one thread at a time.
 */
public final class StateHistory {
    /** Number of frames whose trails a scene has. */
    private static final int TRAIL = 400;

    /** Number of frames for which a refused move counts as recent. */
    static final int FRESH = 8;

    /** Maximum number of places and distances kept, some 400 MB; of a longer history the oldest quarter is dropped. */
    private static final int MOST = 4_000_000;

    private final List<Frame> frames = new ArrayList<>();
    private final Column<Chapter> chapters = new Column<>();

    private final int most;
    private int first;
    private long weight;

    public StateHistory() {
        this(MOST);
    }

    /** A history with another maximum number of places and distances. */
    public StateHistory(int most) {
        this.most = most;
    }

    /** A world as its file has it, with what the sonars of its robots measure there. */
    public static StateHistory of(World world) {
        Map<String, List<Scene.Ping>> heard = WorldSonars.of(world).measure(world.toGeometry(outside -> {}));
        StateHistory film = new StateHistory();
        List<WorldObject> shown = new ArrayList<>(world.objects());
        world.scenery().forEach(each -> shown.add(new WorldObject(each)));
        Frame.Setting setting = Frame.Setting.of(world.withObjects(shown));
        film.append(new Frame(setting, Map.of(), List.of(), heard, Pictures.contents(world), List.of(), null));
        return film;
    }

    /**
     * How much of the past to show.
     *
     * @param trail    number of frames of trails, {@code Integer.MAX_VALUE} for all
     * @param refusals number of frames of refused moves
     * @param most     maximum number of points of a trail and of marks, at least 4; the older part of a longer trail is
     *     thinned out
     */
    public record Look(int trail, int refusals, int most) {
        static final Look WHOLE = new Look(Integer.MAX_VALUE, Integer.MAX_VALUE);

        /** Without a maximum. */
        Look(int trail, int refusals) {
            this(trail, refusals, Integer.MAX_VALUE);
        }
    }

    /**
     * Appends what the next message changed: as a part of the last frame if both are of one control step, in which robots
     * measure and then move, and otherwise as a frame of its own.
     */
    public void add(Frame message) {
        Frame last = frames.isEmpty() ? null : frames.get(frames.size() - 1);
        Frame whole = last == null ? null : last.with(message);
        if (last == null || whole == null) {
            append(message);
            return;
        }
        int number = size() - 1;
        frames.set(frames.size() - 1, whole);
        weight += whole.weight() - last.weight();
        happen(number, message);
    }

    public void append(Frame frame) {
        int number = size();
        frames.add(frame);
        weight += frame.weight();
        if (frame.opening() != null) {
            chapters.add(number, new Chapter(number, frame.opening()));
        }
        happen(number, frame);
        while (weight > most && frames.size() > 1) {
            forget(first + Math.max(1, frames.size() / 4));
        }
    }

    private void happen(int number, Frame frame) {
        Chapter chapter = chapters.at(number);
        if (chapter != null) {
            chapter.append(number, frame);
        }
    }

    /** Drops all frames before a given one. */
    private void forget(int before) {
        List<Frame> past = frames.subList(0, before - first);
        for (Frame frame : past) {
            weight -= frame.weight();
        }
        past.clear();
        first = before;
        chapters.forget(before);
        Chapter chapter = chapters.at(before);
        if (chapter != null) {
            chapter.forget(before);
        }
    }

    /** The number of the last frame plus one. */
    public int size() {
        return first + frames.size();
    }

    /** The number of the first frame kept. */
    public int first() {
        return first;
    }

    public Frame frame(int number) {
        return frames.get(number - first);
    }

    /** The world of a frame; null before the first. */
    public Frame.@Nullable Setting setting(int number) {
        Chapter chapter = chapters.at(number);
        return chapter == null ? null : chapter.setting;
    }

    /** Identifies the world of a frame by the number of the frame with which it began; -1 before the first. */
    public int world(int number) {
        Chapter chapter = chapters.at(number);
        return chapter == null ? -1 : chapter.begin;
    }

    /** The moveable objects at their places after a frame. */
    public List<Scene.Thing> movers(int number) {
        Chapter chapter = chapters.at(number);
        return chapter == null ? List.of() : chapter.movers(number);
    }

    /** The complete scene after a frame; empty before the first world. */
    Scene at(int number, Look look) {
        Chapter chapter = chapters.at(number);
        if (chapter == null) {
            return Scene.of("", new Scene.View(-0.5, -0.5, 0.5, 0.5, false), List.of());
        }
        List<Scene.Thing> things = new ArrayList<>(chapter.setting.statics());
        things.addAll(chapter.movers(number));
        Scene.View view = Scene.View.of(chapter.setting.width(), chapter.setting.length(), things);
        return happened(chapter, number, look, Scene.of("", view, things)).described(moment(number), "");
    }

    /** The scene after a frame, with the trails of the steps just before it; empty before the first world. */
    public Scene scene(int number) {
        return at(number, new Look(TRAIL, FRESH));
    }

    /** Adds everything that happened up to a frame to the scene of a world, whose objects move to their places. */
    Scene over(Scene world, int number) {
        Chapter chapter = chapters.at(number);
        if (chapter == null) {
            return world;
        }
        Map<String, Pose> places = new LinkedHashMap<>();
        for (Scene.Thing mover : chapter.movers(number)) {
            places.put(String.valueOf(mover.object().name()), mover.object().pose());
        }
        List<Scene.Thing> things = new ArrayList<>();
        for (Scene.Thing thing : world.things()) {
            String name = thing.object().name();
            Pose pose = name == null ? null : places.get(name);
            things.add(pose == null ? thing : new Scene.Thing(thing.object().at(pose), thing.colour()));
        }
        Scene placed = Scene.of(world.title(), world.view(), things).described(world.subtitle(), world.unit());
        return happened(chapter, number, Look.WHOLE, placed).blocked(List.of());
    }

    /** Adds trails, distances, refused moves and what blocked recent ones to a scene. */
    private static Scene happened(Chapter chapter, int number, Look look, Scene scene) {
        List<Scene.Trail> trails = new ArrayList<>();
        List<Scene.Ping> pings = new ArrayList<>();
        for (Map.Entry<String, Track> each : chapter.tracks.entrySet()) {
            List<Point> path = each.getValue().path(earliest(number, look.trail()), number, look.most());
            trails.add(new Scene.Trail(each.getKey(), path));
            pings.addAll(each.getValue().heard(number));
        }
        List<Scene.Refusal> refusals = new ArrayList<>();
        List<Scene.Blocked> blocked = new ArrayList<>();
        int from = earliest(number, Math.max(look.refusals(), FRESH));
        for (int k = chapter.bumpsUpTo(number) - 1; k >= 0 && refusals.size() < look.most(); k--) {
            NumberedBump numbered = chapter.bumps.get(k);
            if (numbered.number < from) {
                break;
            }
            Frame.Bump bump = numbered.bump;
            if (numbered.number >= earliest(number, look.refusals())) {
                refusals.add(new Scene.Refusal(bump.mover().center(), bump.heading(), bump.kind()));
            }
            int age = number - numbered.number;
            if (age < FRESH && bump.result() != null) {
                blocked.add(blocked(bump, bump.result(), 1 - (double) age / FRESH));
            }
        }
        return scene.with(trails, pings, refusals).blocked(blocked);
    }

    /** The first of {@code count} frames up to a number. */
    private static int earliest(int number, int count) {
        return (int) Math.max(0, (long) number + 1 - count);
    }

    /** The frame's number and what happened, as text for people. */
    public String moment(int number) {
        return "step " + (number + 1) + " of " + size() + ": " + story(number);
    }

    /** What happened in a frame; if nothing was refused there, also the last refusal while it is recent. */
    private String story(int number) {
        Frame frame = frame(number);
        StringBuilder story = new StringBuilder(frame.words());
        for (int k = number - 1; frame.bumps().isEmpty() && k >= first && k > number - FRESH; k--) {
            if (!frame(k).bumps().isEmpty()) {
                return story.append("; before, ").append(frame(k).words()).toString();
            }
        }
        return story.toString();
    }

    private static Scene.Blocked blocked(Frame.Bump bump, MoveResult result, double strength) {
        Pose aim = bump.aim();
        return new Scene.Blocked(
                bump.mover(),
                result.obstacle(),
                strength,
                aim == null ? null : bump.mover().at(aim),
                result.contact());
    }

    private record NumberedBump(int number, Frame.Bump bump) {}

    /** One world, and what happened in it. */
    private static final class Chapter {
        private final int begin;
        private final Frame.Setting setting;
        private final Map<String, Track> tracks = new LinkedHashMap<>();
        private final List<NumberedBump> bumps = new ArrayList<>();
        private double farthest;

        Chapter(int begin, Frame.Setting setting) {
            this.begin = begin;
            this.setting = setting;
            for (Scene.Thing mover : setting.movers()) {
                GeometryObject object = mover.object();
                tracks.put(String.valueOf(object.name()), new Track(begin, object.pose()));
            }
        }

        void append(int number, Frame frame) {
            frame.placed().forEach((name, pose) -> {
                Track track = tracks.get(name);
                if (track != null) {
                    track.poses.add(number, pose);
                }
            });
            frame.heard().forEach((name, pings) -> {
                Track track = tracks.get(name);
                if (track != null) {
                    track.pings.add(number, pings);
                    farthest = Math.max(farthest, longest(pings));
                }
            });
            frame.bumps().forEach(bump -> bumps.add(new NumberedBump(number, bump)));
        }

        private static double longest(List<Scene.Ping> pings) {
            double longest = 0;
            for (Scene.Ping ping : pings) {
                longest = Double.isFinite(ping.distance()) ? Math.max(longest, ping.distance()) : longest;
            }
            return longest;
        }

        void forget(int before) {
            bumps.removeIf(bump -> bump.number < before);
            for (Track track : tracks.values()) {
                track.poses.forget(before);
                track.pings.forget(before);
            }
        }

        int bumpsUpTo(int number) {
            int from = 0;
            int to = bumps.size();
            while (from < to) {
                int middle = (from + to) >>> 1;
                if (bumps.get(middle).number <= number) {
                    from = middle + 1;
                } else {
                    to = middle;
                }
            }
            return from;
        }

        List<Scene.Thing> movers(int number) {
            List<Scene.Thing> movers = new ArrayList<>();
            for (Scene.Thing mover : setting.movers()) {
                Track track = tracks.get(String.valueOf(mover.object().name()));
                Pose pose = track == null ? null : track.poses.at(number);
                movers.add(pose == null ? mover : new Scene.Thing(mover.object().at(pose), mover.colour()));
            }
            return movers;
        }
    }

    private static final class Track {
        private final Column<Pose> poses = new Column<>();
        private final Column<List<Scene.Ping>> pings = new Column<>();

        Track(int begin, Pose pose) {
            poses.add(begin, pose);
        }

        /**
         * Its places from before one frame to another. If there are more than {@code most}, the newer half is complete,
         * and of the older ones only the first and those whose number is divisible by a power of two are kept, so that
         * the selection is stable as the trail grows.
         */
        List<Point> path(int from, int to, int most) {
            List<Point> path = new ArrayList<>();
            int first = Math.max(0, poses.index(from - 1));
            int last = poses.index(to);
            int whole = last - first < most ? first : last - most / 2 + 1;
            int stride = 1;
            while ((long) stride * (most - most / 2 - 1) < (long) whole - first) {
                stride *= 2;
            }
            for (int k = first; k < whole; k += stride - k % stride) {
                path.add(poses.value(k).center());
            }
            for (int k = whole; k <= last; k++) {
                path.add(poses.value(k).center());
            }
            return path;
        }

        /** The distances that it measured last. */
        List<Scene.Ping> heard(int number) {
            List<Scene.Ping> heard = pings.at(number);
            return heard == null ? List.of() : heard;
        }
    }
}
