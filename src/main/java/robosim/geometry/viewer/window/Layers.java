package robosim.geometry.viewer.window;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.viewer.playback.Sandbox;
import robosim.geometry.viewer.scene.Scene;

/** What is drawn over the objects, part by part. */
final class Layers {
    /** A part that can be left out. */
    enum Layer {
        /** Measured distances. */
        SONARS,
        /** Refused moves, and what was in their way. */
        REFUSALS
    }

    private static final int[] TRAILS = {400, Integer.MAX_VALUE, 0};

    private final Set<Layer> shown = EnumSet.allOf(Layer.class);
    private int trails;

    /** The number of steps of which the trails are drawn. */
    int trail() {
        return TRAILS[trails];
    }

    /** Switches to the next length of trails: longer, all, none, and so on. */
    void nextTrails() {
        trails = (trails + 1) % TRAILS.length;
    }

    void toggle(Layer layer) {
        if (!shown.remove(layer)) {
            shown.add(layer);
        }
    }

    boolean shows(Layer layer) {
        return shown.contains(layer);
    }

    /** A scene without the parts that are left out. */
    Scene of(Scene scene) {
        boolean isRefused = shows(Layer.REFUSALS);
        return scene.with(
                        scene.trails(),
                        shows(Layer.SONARS) ? scene.pings() : List.of(),
                        isRefused ? scene.refusals() : List.of())
                .blocked(isRefused ? scene.blocked() : List.of());
    }

    /** What blocked recent moves; in a world whose robots are dragged, what is in the way of the last of them. */
    static List<Scene.Blocked> blocked(Scene scene, @Nullable Sandbox world) {
        Sandbox.Refused refused = world == null ? null : world.refused();
        if (refused == null) {
            return scene.blocked();
        }
        List<Scene.Blocked> blocked = new ArrayList<>();
        if (refused.obstacles().isEmpty()) {
            blocked.add(new Scene.Blocked(refused.ghost(), null, 1));
        }
        refused.obstacles().forEach(each -> blocked.add(new Scene.Blocked(refused.ghost(), each, 1)));
        return blocked;
    }
}
