package robosim.geometry.viewer.playback;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Pose;
import robosim.geometry.scenario.Timing;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.World;
import robosim.geometry.world.shared.ObjectNames;

/**
 * What one step of a conversation changed.
 *
 * @param opening the new world; null if it has not changed
 * @param placed  the new places of moveable objects, by name, in the order of their moves
 * @param bumps   moves that were refused
 * @param heard   measured distances by the name of the measuring object; empty for other steps
 * @param words   what happened, as text for people
 * @param notes   the step's notes
 * @param timing  the timing; null if it was not recorded
 */
public record Frame(
        @Nullable Setting opening,
        Map<String, Pose> placed,
        List<Bump> bumps,
        Map<String, List<Scene.Ping>> heard,
        String words,
        List<String> notes,
        @Nullable Timing timing) {
    /** Letters of a step's words up to which commands without any time are added to it. */
    private static final int MOST_WORDS = 200;

    /** Whether nothing has moved yet: robots measured, or were given commands. */
    private boolean isBeforeMoves() {
        return opening == null && placed.isEmpty() && bumps.isEmpty();
    }

    /**
     * This frame and the next one as one control step: robots measure, others measure too, they are given commands, and then
     * they move. Null if they are two: one that measures again has begun another step, and so have ever more commands.
     */
    @Nullable
    Frame with(Frame next) {
        if (!isBeforeMoves() || next.opening != null) {
            return null;
        }
        boolean isCommand = next.isBeforeMoves() && next.heard.isEmpty();
        boolean isAct = next.heard.isEmpty() && !isCommand;
        boolean isMore = next.isBeforeMoves() && Collections.disjoint(heard.keySet(), next.heard.keySet());
        boolean isShort = !isCommand || words.length() + next.words.length() < MOST_WORDS;
        if (!isAct && (heard.isEmpty() || !isMore || !isShort)) {
            return null;
        }
        Map<String, List<Scene.Ping>> all = new LinkedHashMap<>(heard);
        all.putAll(next.heard);
        List<String> both = new ArrayList<>(notes);
        both.addAll(next.notes);
        Timing whole = timing == null || next.timing == null
                ? null
                : new Timing(timing.at(), timing.took() + next.timing.took());
        return new Frame(null, next.placed, next.bumps, all, words + "; " + next.words, both, whole);
    }

    /**
     * An estimate of its memory: the number of places, distances, and objects of its world with their vertices and
     * triangles.
     */
    long weight() {
        long weight = 1L + placed.size() + bumps.size();
        if (opening != null) {
            weight += opening.weight();
        }
        for (List<Scene.Ping> pings : heard.values()) {
            weight += pings.size();
        }
        return weight;
    }

    /**
     * A move that was refused, or a driven robot that ran into something.
     *
     * @param mover   the object, where it stayed
     * @param heading direction of what is in the way, degrees about the vertical from the world's X
     * @param result  what blocked it; null if unknown
     * @param aim     where the move would have led; null if unknown
     */
    public record Bump(
            GeometryObject mover,
            double heading,
            @Nullable MoveResult result,
            @Nullable Pose aim,
            Scene.Refusal.Kind kind) {
        /** A refused move of which only the direction is known. */
        public Bump(GeometryObject mover, double heading, @Nullable MoveResult result) {
            this(mover, heading, result, null, Scene.Refusal.Kind.MOVE);
        }

        /** What was in the way, in words. */
        String obstacle() {
            if (result == null) {
                return "something";
            }
            GeometryObject obstacle = result.obstacle();
            return obstacle == null ? "the border of the world" : ObjectNames.of(obstacle);
        }
    }

    /**
     * A world as it begins.
     *
     * @param width   of the world, along X
     * @param height  along Y
     * @param length  along Z
     * @param statics the static objects
     * @param movers  the moveable objects, at their first places
     */
    public record Setting(
            double width,
            double height,
            double length,
            Dimension dimension,
            Accuracy accuracy,
            List<Scene.Thing> statics,
            List<Scene.Thing> movers) {

        /** The setting of a world in its present state, with the colours that a world file has for its objects. */
        public static Setting of(Geometry world, Colours colours) {
            return new Setting(world.width(), world.height(), world.length(), world.dimension(), world.accuracy())
                    .with(world.objects().stream()
                            .map(object -> new Scene.Thing(object, colours.of(object)))
                            .toList());
        }

        public static Setting of(World world) {
            return new Setting(world.width(), world.height(), world.length(), world.dimension(), world.accuracy())
                    .with(Colours.things(world));
        }

        private Setting(double width, double height, double length, Dimension dimension, Accuracy accuracy) {
            this(width, height, length, dimension, accuracy, List.of(), List.of());
        }

        private Setting with(List<Scene.Thing> things) {
            return new Setting(
                    width,
                    height,
                    length,
                    dimension,
                    accuracy,
                    things.stream().filter(each -> !each.object().isMoveable()).toList(),
                    things.stream().filter(each -> each.object().isMoveable()).toList());
        }

        /** The number of its objects with their members, vertices and triangles. */
        private long weight() {
            Deque<GeometryObject> left = new ArrayDeque<>();
            things().forEach(thing -> left.push(thing.object()));
            long weight = 0;
            while (!left.isEmpty()) {
                GeometryObject object = left.pop();
                weight++;
                if (object instanceof ObjectGroup group) {
                    group.members().forEach(left::push);
                } else if (object instanceof MeshObject mesh) {
                    weight += (long) mesh.triangles().vertices()
                            + mesh.triangles().size();
                }
            }
            return weight;
        }

        /** All objects, moveable ones last. */
        public List<Scene.Thing> things() {
            List<Scene.Thing> things = new ArrayList<>(statics);
            things.addAll(movers);
            return things;
        }
    }
}
