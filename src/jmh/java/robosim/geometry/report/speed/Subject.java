package robosim.geometry.report.speed;

import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/**
 * Whoever answers.
 *
 * @param engine    this module or another
 * @param level     an accuracy of this module; empty where there is no choice
 * @param dimension PLANAR or SPATIAL
 * @param filter    {@code on}, or {@code alone} where this module believes the signs of its filters; empty for others
 */
record Subject(String engine, String level, String dimension, String filter) {
    static final String MODULE = "robosim";
    static final String JTS = "JTS";
    static final String DYN4J = "dyn4j";

    /** This module as it is in this JVM. */
    static Subject module(Accuracy level, Dimension dimension) {
        return new Subject(MODULE, level.name(), dimension.name(), mode());
    }

    static Subject peer(String engine) {
        return new Subject(engine, "", Dimension.PLANAR.name(), "");
    }

    private static String mode() {
        return System.getProperty(robosim.geometry.exact.FilterBound.PROPERTY, "on");
    }

    boolean isModule() {
        return engine.equals(MODULE);
    }

    boolean isAlone() {
        return filter.equals("alone");
    }

    /** This module, all of it: EXACT in a dimension, filters and exact paths. */
    static Subject exact(Dimension dimension) {
        return new Subject(MODULE, Accuracy.EXACT.name(), dimension.name(), "on");
    }

    /** What it is called in a table. */
    String text() {
        if (!isModule()) {
            return engine;
        }
        return level + ", " + dimension + (isAlone() ? ", filter alone" : "");
    }
}
