package robosim.geometry.world.check;

import java.util.List;

/**
 * A part of the world that robots share.
 *
 * @param robots their names, in the world's order
 * @param minX   lower bound of the places that the centre of one of them reaches, extended by half of its smaller side;
 *               the other three likewise
 * @param area   area of the places that the centre of one of them reaches, world units squared: their number times the
 *               square of the step, and no more than {@code most}. More may be reachable by ways that the grid does not
 *               contain
 * @param most   upper bound of the area that the same centre can reach at its height, by any motion and at any heading; that
 *               of the world's floor for a robot that is tilted, a mesh or a group, or if there are too many places to look at
 * @param places number of these places of the grid; 1 if the robot cannot make a step
 * @param step   step of the grid, world units: narrower passages may have been missed
 * @param isTold whether the step was at most half of the robot's smaller extent, if it has any; otherwise nothing
 *               follows for what was not reached
 */
public record Room(
        List<String> robots,
        double minX,
        double minZ,
        double maxX,
        double maxZ,
        double area,
        double most,
        int places,
        double step,
        boolean isTold) {
    /** Copies the list. */
    public Room {
        robots = List.copyOf(robots);
    }
}
