package robosim.geometry.export;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.viewer.playback.Frame;
import robosim.geometry.viewer.scene.Scene;

/** The numbers that the objects of one world have on a page: moveable ones first, in the order in which they are written. */
final class PagePlaces {
    /** Refused moves that name what was in the way: nothing known, the border of the world, an object from here on. */
    private static final int UNKNOWN = 0;

    private static final int BORDER = 1;
    private static final int OBSTACLES = 2;

    private final int movers;
    private final Map<String, Integer> places = new HashMap<>();
    private final Map<GeometryObject, Integer> nameless = new HashMap<>();

    PagePlaces(List<Scene.Thing> movers, List<Scene.Thing> statics) {
        this.movers = movers.size();
        for (Scene.Thing mover : movers) {
            places.put(String.valueOf(mover.object().name()), places.size());
        }
        for (int k = 0; k < statics.size(); k++) {
            GeometryObject object = statics.get(k).object();
            String name = object.name();
            if (name == null) {
                nameless.putIfAbsent(object, this.movers + k);
            } else {
                places.put(name, this.movers + k);
            }
        }
    }

    /** The number of a moveable object; negative if the page has none of that name. */
    int mover(String name) {
        int found = places.getOrDefault(name, movers);
        return found < movers ? found : -1;
    }

    /** What was in the way of a move, as a number. */
    int obstacle(Frame.Bump bump) {
        if (bump.result() == null) {
            return UNKNOWN;
        }
        GeometryObject obstacle = bump.result().obstacle();
        if (obstacle == null) {
            return BORDER;
        }
        String name = obstacle.name();
        Integer number = name == null ? nameless.get(obstacle) : places.get(name);
        return number == null ? UNKNOWN : OBSTACLES + number;
    }
}
