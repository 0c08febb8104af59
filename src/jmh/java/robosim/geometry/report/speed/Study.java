package robosim.geometry.report.speed;

import java.io.IOException;

/** A part of the report, measured in a JVM of its own. */
interface Study {
    /** Where figures go. */
    interface Sink {
        void put(Subject subject, String scene, String query, String metric, double value);
    }

    /** Hears how far a study is, from 0 to 1. */
    interface Progress {
        void at(double share);
    }

    void run(Form form, Sink sink, Progress progress) throws IOException;

    /** The studies by name. */
    static Study of(String name) {
        return switch (name) {
            case "verdicts" -> new Verdicts();
            case "distances" -> new Distances();
            case "moves" -> new Moves();
            case "worlds" -> new Worlds(true);
            case "filter" -> new Worlds(false);
            case "sizes" -> new Sizes();
            case "cones" -> new Cones();
            case "robots" -> new Robots();
            case "sensors" -> new Sensors();
            default -> throw new IllegalArgumentException("no such study (got: " + name + ")");
        };
    }
}
