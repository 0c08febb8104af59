package robosim.geometry.cli.studies;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import robosim.geometry.Geometry;
import robosim.geometry.check.Text;
import robosim.geometry.model.Dimension;
import robosim.geometry.world.World;
import robosim.geometry.world.shared.ObjectNames;

/**
 * What bodies of a PLANAR world stand on or in from the beginning: the most frequent reason that they cannot move is a floor
 * that is an object, which is in the way of all that stands on it where heights do not count.
 */
final class PlanOverlaps {
    /** How many objects are named of each body. */
    private static final int NAMED = 3;

    private PlanOverlaps() {}

    /** A line for each body that overlaps anything where it begins, with what else to do than to take it out. */
    static List<String> of(World world, Collection<String> bodies, String remedy) {
        List<String> lines = new ArrayList<>();
        if (world.dimension() != Dimension.PLANAR) {
            return lines;
        }
        Geometry geometry = world.toGeometry(refused -> {});
        for (String name : bodies) {
            List<String> others = !geometry.hasObject(name) || geometry.carrierOf(name) != null
                    ? List.of()
                    : geometry.search().touching(geometry.getObject(name)).stream()
                            .filter(other -> !name.equals(other.name()))
                            .map(ObjectNames::kindAndName)
                            .toList();
            if (!others.isEmpty()) {
                int more = others.size() - NAMED;
                lines.add(Text.quoted(name) + " overlaps "
                        + String.join(", ", others.subList(0, Math.min(NAMED, others.size())))
                        + (more > 0 ? " and " + more + " more" : "")
                        + " in plan, where heights do not count: take " + (others.size() == 1 ? "it" : "them")
                        + " out of the world, put the robot elsewhere, or " + remedy);
            }
        }
        return lines;
    }
}
