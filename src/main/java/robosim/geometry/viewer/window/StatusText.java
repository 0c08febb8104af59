package robosim.geometry.viewer.window;

import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.NumberText;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.scenario.Timing;
import robosim.geometry.viewer.playback.Feed;
import robosim.geometry.viewer.playback.Player;
import robosim.geometry.viewer.playback.Sandbox;
import robosim.geometry.viewer.playback.StateHistory;
import robosim.geometry.world.shared.ObjectNames;

/** What the line below the views says. */
final class StatusText {
    private StatusText() {}

    /** Of a world whose robots can be dragged; a copy of a step of a conversation, or of none (-1). */
    static String ofCopy(Sandbox world, int step) {
        Sandbox.Refused refused = world.refused();
        String words = refused == null
                ? "drag what moves" + outside(world.outside())
                : ObjectNames.of(refused.ghost()) + " may not be there: " + refused.words() + " is in the way";
        return step < 0 ? words : "a local copy of step " + (step + 1) + ", Esc goes back: " + words;
    }

    static String ofStep(StateHistory film, int position, @Nullable Feed feed, String end) {
        if (film.size() == 0) {
            return (feed != null && feed.isEnded() ? "nothing was recorded" : "waiting for a world") + end;
        }
        List<String> notes = film.frame(position).notes();
        String note = notes.isEmpty() ? "" : " (" + String.join("; ", notes) + ")";
        return film.moment(position) + seconds(film.frame(position).timing()) + note + end;
    }

    /** When a recorded step was; empty where that was not recorded. */
    private static String seconds(@Nullable Timing timing) {
        return timing == null ? "" : String.format(Locale.ROOT, ", at %.3f s", timing.at() / 1e9);
    }

    private static String outside(List<GeometryObject> robots) {
        if (robots.isEmpty()) {
            return "; H lists the keys";
        }
        String first = ObjectNames.of(robots.get(0));
        return robots.size() == 1
                ? "; " + first + " is not in the world, it stands beyond its border: drag it in"
                : "; " + first + " and " + (robots.size() - 1)
                        + " more are not in the world, they stand beyond its border: drag them in";
    }

    /** The speed of playback. */
    static String pace(Player player, boolean isLive) {
        if (isLive) {
            return player.isFollowing() ? "live" : "paused";
        }
        return NumberText.digits(player.speed(), 3) + " steps/s";
    }

    /** Why no more steps come; empty where some may. */
    static String end(@Nullable Feed feed, boolean isLive) {
        String problem = feed == null ? "" : feed.problem();
        if (!problem.isEmpty()) {
            return "; " + problem;
        }
        return isLive && feed != null && feed.isEnded() ? "; the session is over" : "";
    }
}
