package robosim.geometry.report.speed;

import java.util.List;
import robosim.geometry.chart.Marker;
import robosim.geometry.chart.Series;
import robosim.geometry.chart.Series.Dot;
import robosim.geometry.chart.Series.Line;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/** Colour and shape of whoever answers: the same in all plots. */
record Look(int colour, Marker marker, boolean hollow) {
    static Look of(Subject subject) {
        boolean planar = subject.dimension().equals(Dimension.PLANAR.name());
        return switch (subject.engine()) {
            case Subject.MODULE ->
                subject.isAlone()
                        ? new Look(planar ? 0 : 3, planar ? Marker.CIRCLE : Marker.SQUARE, true)
                        : new Look(planar ? 0 : 3, planar ? Marker.CIRCLE : Marker.SQUARE, false);
            case Subject.JTS -> new Look(6, Marker.TRIANGLE, false);
            case Subject.DYN4J -> new Look(7, Marker.DIAMOND, false);
            default -> new Look(4, Marker.DOWN, false);
        };
    }

    /** A colour and shape for each level. */
    static Look of(Accuracy level) {
        return switch (level) {
            case EXACT -> new Look(0, Marker.CIRCLE, false);
            case DOP -> new Look(5, Marker.DIAMOND, false);
            case OBB -> new Look(2, Marker.TRIANGLE, false);
            case AABB -> new Look(1, Marker.SQUARE, false);
            case SPHERE -> new Look(4, Marker.DOWN, false);
        };
    }

    Series series(String name, Line line, List<Dot> dots) {
        return new Series(name, colour, marker, line, hollow, dots);
    }
}
