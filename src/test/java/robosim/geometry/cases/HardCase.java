package robosim.geometry.cases;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;

/**
 * A question that was answered wrongly somewhere.
 *
 * @param id        short, unique: a letter for the family and a number
 * @param source    project and issue, or who measured it
 * @param link      address of the source; empty where there is none
 * @param version   in which it was wrong; empty where the source does not say
 * @param there     the wrong answer that was given there
 * @param today     what is known of the same question there today
 * @param numbers   where the numbers come from
 * @param hard      why the question is hard
 * @param meaning   where a difference may be one of meaning; empty where there is none
 * @param reach     how many binary orders of magnitude the case may be scaled up and down
 * @param objects   by their names in the file, in its order
 * @param questions at least one
 */
public record HardCase(
        String id,
        String title,
        String source,
        String link,
        String version,
        String there,
        String today,
        String numbers,
        String hard,
        String meaning,
        int reach,
        Map<String, GeometryObject> objects,
        List<Question> questions) {

    /** How a truth is established where a file does not say otherwise. */
    public static final String RECOMPUTED = "recomputed exactly";

    /** The objects of some names. */
    public List<GeometryObject> objects(List<String> names) {
        return names.stream().map(this::object).toList();
    }

    /** The object of a name. */
    public GeometryObject object(String name) {
        GeometryObject object = objects.get(name);
        if (object == null) {
            throw new IllegalArgumentException(id + " must have an object of that name (got: " + name + ")");
        }
        return object;
    }

    /** What is asked about the objects, and what is true. */
    public sealed interface Question {
        /** The truth as the file states it: a verdict or a number. */
        String truth();

        /** How the truth was established. */
        String how();

        /** The truth of the projections as the file states it; null where it is only recomputed, "no" where it is not asked. */
        @Nullable
        String planar();
    }

    /** Do two objects touch or overlap? Truth: collide, touch (which is to collide) or apart. */
    public record Overlap(
            String a,
            String b,
            String truth,
            String how,
            @Nullable String planar) implements Question {}

    /**
     * How far is the nearest surface in a beam? Truth: a distance, or miss.
     *
     * @param of     the objects that there are
     * @param within how exactly the file states its number
     * @param scan   where not null, the beam is that of a scan by a moveable object: degrees from its forward
     */
    public record Beam(
            double[] from,
            double[] direction,
            List<String> of,
            double min,
            double max,
            double width,
            String truth,
            double within,
            String how,
            @Nullable String planar)
            implements Question {}

    /**
     * How far may an object go and then turn about the vertical? Truth: free, refused (at once), or the share that is
     * free of the translation and then of the turn: 0.25, or turn 0.25.
     */
    public record Drive(
            String mover,
            double[] way,
            double turn,
            List<String> of,
            String truth,
            double within,
            String how,
            @Nullable String planar)
            implements Question {}

    /** How far apart are two objects? Truth: a distance, 0 in contact. */
    public record Gap(
            String a,
            String b,
            String truth,
            double within,
            String how,
            @Nullable String planar) implements Question {}

    /** Is a bad value refused by name? Truth: what the message must name. */
    public record Refusal(Map<String, Object> shape, String truth, String how) implements Question {
        @Override
        public String planar() {
            return "no";
        }
    }

    /** What is an object's heading after so many turns? Truth: degrees. */
    public record Spin(double start, double degrees, int times, String truth, double within, String how)
            implements Question {
        @Override
        public String planar() {
            return "no";
        }
    }

    /** What does a scan of single rays see? Truth: a distance for each ray. */
    public record Scan(
            String scanner,
            double first,
            double step,
            int count,
            double max,
            List<String> of,
            String truth,
            double within,
            String how,
            @Nullable String planar)
            implements Question {}

    @Override
    public String toString() {
        return id + " " + title;
    }
}
