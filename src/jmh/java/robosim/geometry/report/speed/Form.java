package robosim.geometry.report.speed;

import java.util.Locale;

/**
 * How much of everything.
 *
 * @param warmMillis  how long a task runs before it is measured
 * @param batchMillis how long one round of a task takes, about
 * @param rounds      how often tasks take turns
 * @param sample      how many queries a round asks at least, however slow they are
 * @param cases       how many pairs, rays and moves of each family are judged against exact arithmetic
 * @param objects     the greatest generated scene
 * @param forks       how many pairs of JVMs compare filters and exact paths
 */
record Form(double warmMillis, double batchMillis, int rounds, int sample, int cases, int objects, int forks) {
    static final long SEED = 20261121;

    /** By name: {@code full}, {@code quick}, or {@code tiny} for a test. */
    static Form of(String name) {
        return switch (name.toLowerCase(Locale.ROOT)) {
            case "full" -> new Form(200, 10, 11, 256, 2500, 1_000_000, 3);
            case "quick" -> new Form(10, 1, 3, 32, 120, 10_000, 1);
            case "tiny" -> new Form(1, 0.1, 2, 8, 12, 100, 1);
            default -> throw new IllegalArgumentException("form must be full, quick or tiny (got: " + name + ")");
        };
    }
}
