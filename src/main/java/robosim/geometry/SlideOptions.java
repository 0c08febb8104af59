package robosim.geometry;

import robosim.geometry.check.Checks;

/**
 * How an object slides along what blocks it: how far it stays from everything, and how it walks on ground.
 *
 * <p>With the defaults an object slides along every surface in three dimensions. A step height, a greatest slope below 90 degrees
 * or a snap makes it a walker, in SPATIAL, on moves with a y of 0: ground is every surface that slopes by at most
 * {@link #maxSlope()}, and the lower border of the world; a steeper surface, or an overhang, is a wall, along which the walker
 * moves without rising or sinking. In PLANAR heights do not count, and neither do these three.
 *
 * <pre>{@code
 * SlideOptions rover = SlideOptions.clearance(0.01).stepHeight(0.15).maxSlope(30).snap(0.2);
 * rover.bends();  // 4
 * }</pre>
 *
 * @param clearance  distance to keep from everything, world units; at least 0
 * @param bends      number of contacts after which the motion may go on; from 0 to 64
 * @param stepHeight world units, at least 0: a sill up to this height is climbed. 0 for an object that climbs none
 * @param maxSlope   degrees from 0 (only level ground is walked on) to 90
 * @param snap       world units, at least 0: where there is ground within this distance below the object after the motion, it is
 *                   put down on it, with the clearance. 0 for an object that stays at its height
 */
public record SlideOptions(double clearance, int bends, double stepHeight, double maxSlope, double snap) {
    /** Most contacts at which a motion may go on, so that no call takes forever. */
    private static final int MOST_BENDS = 64;

    /** Checks the ranges. */
    public SlideOptions {
        Checks.clearance(clearance);
        if (bends < 0 || bends > MOST_BENDS) {
            throw new IllegalArgumentException("bends must be from 0 to " + MOST_BENDS + " (got: " + bends + ")");
        }
        Checks.size("stepHeight", stepHeight);
        if (!(maxSlope >= 0 && maxSlope <= 90)) {
            throw new IllegalArgumentException("maxSlope must be from 0 to 90 degrees (got: " + maxSlope + ")");
        }
        Checks.size("snap", snap);
    }

    /** Whether an object walks on ground. */
    public boolean isWalker() {
        return stepHeight > 0 || maxSlope < 90 || snap > 0;
    }

    /** Options for an object that neither steps nor snaps, takes every slope and goes on at up to four contacts. */
    public static SlideOptions clearance(double clearance) {
        return new SlideOptions(clearance, 4, 0, 90, 0);
    }

    /** The same with another number of contacts after which the motion may go on. */
    public SlideOptions bends(int bends) {
        return new SlideOptions(clearance, bends, stepHeight, maxSlope, snap);
    }

    /** The same with another step height. */
    public SlideOptions stepHeight(double stepHeight) {
        return new SlideOptions(clearance, bends, stepHeight, maxSlope, snap);
    }

    /** The same with another greatest slope. */
    public SlideOptions maxSlope(double maxSlope) {
        return new SlideOptions(clearance, bends, stepHeight, maxSlope, snap);
    }

    /** The same with another distance to the ground. */
    public SlideOptions snap(double snap) {
        return new SlideOptions(clearance, bends, stepHeight, maxSlope, snap);
    }
}
