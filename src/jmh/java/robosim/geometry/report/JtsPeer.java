package robosim.geometry.report;

import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.JTSVersion;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LineString;
import robosim.geometry.cases.HardCase;

/** JTS: closed sets of the plane; a disc is a point and a distance. */
public final class JtsPeer implements Peer {
    private static final GeometryFactory FACTORY = new GeometryFactory();

    @Override
    public String name() {
        return "JTS";
    }

    @Override
    public String version() {
        return JTSVersion.CURRENT_VERSION.toString();
    }

    @Override
    public boolean hasOpenSets() {
        return false;
    }

    @Override
    public double tolerance() {
        return 0;
    }

    private static Coordinate at(double[] p) {
        return new Coordinate(p[0], p[1]);
    }

    public static Geometry geometry(Outline.Piece piece) {
        if (piece.isDisc()) {
            return FACTORY.createPoint(at(piece.corners().get(0)));
        }
        List<Coordinate> ring =
                new ArrayList<>(piece.corners().stream().map(JtsPeer::at).toList());
        if (piece.ordered()) {
            ring.add(ring.get(0));
            return FACTORY.createPolygon(ring.toArray(Coordinate[]::new));
        }
        return FACTORY.createMultiPointFromCoords(ring.toArray(Coordinate[]::new))
                .convexHull();
    }

    @Override
    public boolean overlap(Outline a, Outline b) {
        for (Outline.Piece one : a.pieces()) {
            for (Outline.Piece other : b.pieces()) {
                double reach = Math.max(0, one.radius()) + Math.max(0, other.radius());
                boolean meet = one.isDisc() || other.isDisc()
                        ? geometry(one).isWithinDistance(geometry(other), reach)
                        : geometry(one).intersects(geometry(other));
                if (meet) {
                    return true;
                }
            }
        }
        return false;
    }

    @Override
    public double ray(double[] from, double[] direction, double length, Outline of) throws CannotException {
        double scale = length / Math.hypot(direction[0], direction[1]);
        Coordinate start = at(from);
        Coordinate end = new Coordinate(from[0] + direction[0] * scale, from[1] + direction[1] * scale);
        LineString line = FACTORY.createLineString(new Coordinate[] {start, end});
        double nearest = Double.POSITIVE_INFINITY;
        for (Outline.Piece piece : of.pieces()) {
            if (piece.isDisc()) {
                throw new CannotException("no line with a disc");
            }
            for (Coordinate meeting : line.intersection(geometry(piece)).getCoordinates()) {
                nearest = Math.min(nearest, start.distance(meeting));
            }
        }
        return nearest;
    }

    @Override
    public double gap(Outline a, Outline b) {
        double least = Double.POSITIVE_INFINITY;
        for (Outline.Piece one : a.pieces()) {
            for (Outline.Piece other : b.pieces()) {
                double reach = Math.max(0, one.radius()) + Math.max(0, other.radius());
                least = Math.min(least, Math.max(0, geometry(one).distance(geometry(other)) - reach));
            }
        }
        return least;
    }

    @Override
    public double move(Outline mover, HardCase.Drive drive, Outline other) throws CannotException {
        throw new CannotException("no moves");
    }
}
