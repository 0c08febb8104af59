package robosim.geometry.world.check;

import java.util.List;

/**
 * A part of the world that robots share.
 *
 * @param robots their names, in the world's order
 * @param minX   of the places that the centre of one of them gets to, and half of its smaller side around them; so are
 *               the other three
 * @param area   of the places that the centre of one of them gets to, world units squared: their number times the
 *               square of the step
 * @param places how many places of the grid that are; 1 where the robot cannot make a step
 * @param step   the grid's, world units: finer ways may have been missed
 * @param isTold whether the step was as fine as half of the robot's smaller extent, where it has any; else what was not reached tells
 *               nothing
 */
public record Room(
        List<String> robots,
        double minX,
        double minZ,
        double maxX,
        double maxZ,
        double area,
        int places,
        double step,
        boolean isTold) {
    /** Copies the list. */
    public Room {
        robots = List.copyOf(robots);
    }
}
