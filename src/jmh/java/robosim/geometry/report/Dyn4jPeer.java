package robosim.geometry.report;

import org.dyn4j.Version;
import org.dyn4j.collision.continuous.ConservativeAdvancement;
import org.dyn4j.collision.continuous.TimeOfImpact;
import org.dyn4j.collision.narrowphase.Gjk;
import org.dyn4j.collision.narrowphase.Raycast;
import org.dyn4j.collision.narrowphase.Separation;
import org.dyn4j.geometry.Circle;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Polygon;
import org.dyn4j.geometry.Ray;
import org.dyn4j.geometry.Segment;
import org.dyn4j.geometry.Transform;
import org.dyn4j.geometry.Vector2;
import org.locationtech.jts.algorithm.ConvexHull;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import robosim.geometry.cases.HardCase;

/** dyn4j: open convex sets of the plane, tested by its default, Gjk, and moved by ConservativeAdvancement. */
public final class Dyn4jPeer implements Peer {
    private final Gjk gjk = new Gjk();

    @Override
    public String name() {
        return "dyn4j";
    }

    @Override
    public String version() {
        return Version.getVersion();
    }

    @Override
    public boolean hasOpenSets() {
        return true;
    }

    @Override
    public double tolerance() {
        return Math.max(
                Math.max(Gjk.DEFAULT_DISTANCE_EPSILON, Gjk.DEFAULT_RAYCAST_EPSILON),
                ConservativeAdvancement.DEFAULT_DISTANCE_EPSILON);
    }

    /** A shape about a centre, which dyn4j turns about. */
    public static Convex shape(Outline.Piece piece, double[] pivot) throws CannotException {
        try {
            if (piece.isDisc()) {
                Circle circle = new Circle(piece.radius());
                double[] c = piece.corners().get(0);
                circle.translate(c[0] - pivot[0], c[1] - pivot[1]);
                return circle;
            }
            Coordinate[] corners = piece.corners().stream()
                    .map(p -> new Coordinate(p[0] - pivot[0], p[1] - pivot[1]))
                    .toArray(Coordinate[]::new);
            Coordinate[] hull = new ConvexHull(corners, new GeometryFactory())
                    .getConvexHull()
                    .getCoordinates();
            if (hull.length == 2) {
                return new Segment(new Vector2(hull[0].x, hull[0].y), new Vector2(hull[1].x, hull[1].y));
            }
            if (hull.length < 4) {
                throw new CannotException("no shape that is a point");
            }
            // JTS goes clockwise about a hull and closes it; dyn4j goes the other way.
            Vector2[] around = new Vector2[hull.length - 1];
            for (int k = 0; k < around.length; k++) {
                around[k] = new Vector2(hull[around.length - 1 - k].x, hull[around.length - 1 - k].y);
            }
            return new Polygon(around);
        } catch (IllegalArgumentException e) {
            throw new CannotException("refuses the shape: " + e.getMessage());
        }
    }

    private static Transform at(double[] pivot) {
        Transform transform = new Transform();
        transform.translate(pivot[0], pivot[1]);
        return transform;
    }

    @Override
    public boolean overlap(Outline a, Outline b) throws CannotException {
        for (Outline.Piece one : a.pieces()) {
            for (Outline.Piece other : b.pieces()) {
                if (gjk.detect(shape(one, a.pivot()), at(a.pivot()), shape(other, b.pivot()), at(b.pivot()))) {
                    return true;
                }
            }
        }
        return false;
    }

    @Override
    public double ray(double[] from, double[] direction, double length, Outline of) throws CannotException {
        double nearest = Double.POSITIVE_INFINITY;
        Ray ray = new Ray(new Vector2(from[0], from[1]), new Vector2(direction[0], direction[1]).getNormalized());
        for (Outline.Piece piece : of.pieces()) {
            Raycast cast = new Raycast();
            if (gjk.raycast(ray, length, shape(piece, of.pivot()), at(of.pivot()), cast)) {
                nearest = Math.min(nearest, cast.getDistance());
            }
        }
        return nearest;
    }

    @Override
    public double gap(Outline a, Outline b) throws CannotException {
        double least = Double.POSITIVE_INFINITY;
        for (Outline.Piece one : a.pieces()) {
            for (Outline.Piece other : b.pieces()) {
                Separation apart = new Separation();
                Convex first = shape(one, a.pivot());
                Convex second = shape(other, b.pivot());
                boolean is = gjk.distance(first, at(a.pivot()), second, at(b.pivot()), apart);
                least = Math.min(least, is ? apart.getDistance() : 0);
            }
        }
        return least;
    }

    @Override
    public double move(Outline mover, HardCase.Drive drive, Outline other) throws CannotException {
        Vector2 way = new Vector2(drive.way()[0], drive.way()[2]);
        if (drive.turn() != 0 && !way.isZero()) {
            throw new CannotException("moves and turns at once");
        }
        double first = Double.POSITIVE_INFINITY;
        // Our headings go the other way round in the plane of X and Z.
        double turn = -Math.toRadians(drive.turn());
        for (Outline.Piece one : mover.pieces()) {
            for (Outline.Piece obstacle : other.pieces()) {
                TimeOfImpact impact = new TimeOfImpact();
                boolean hits = new ConservativeAdvancement()
                        .getTimeOfImpact(
                                shape(one, mover.pivot()),
                                at(mover.pivot()),
                                way,
                                turn,
                                shape(obstacle, other.pivot()),
                                at(other.pivot()),
                                new Vector2(),
                                0,
                                impact);
                if (hits) {
                    first = Math.min(first, impact.getTime());
                }
            }
        }
        return first;
    }
}
