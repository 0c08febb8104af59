package robosim.geometry.report.speed;

import java.util.List;
import org.locationtech.jts.algorithm.RobustLineIntersector;
import org.locationtech.jts.algorithm.locate.SimplePointInAreaLocator;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Location;
import org.locationtech.jts.geom.Point;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.index.strtree.STRtree;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Ray;
import robosim.geometry.report.JtsPeer;
import robosim.geometry.report.Outline;
import robosim.geometry.report.Peer.CannotException;

/**
 * Objects in projection behind a packed R-tree of JTS. Overlaps of discs are distances of their centres; where a ray meets
 * a disc JTS has no words, so that it meets the polygon of 32 corners that {@code buffer} makes of it.
 */
final class JtsScene {
    private final STRtree tree = new STRtree();
    private final GeometryFactory factory = new GeometryFactory();

    /** An object: its exact words for overlaps, and the polygon that rays meet. */
    private record Item(Geometry shape, double reach, Polygon polygon) {}

    JtsScene(List<GeometryObject> objects) {
        for (GeometryObject object : objects) {
            add(object);
        }
        tree.build();
    }

    private void add(GeometryObject object) {
        try {
            for (Outline.Piece piece : Outline.of(object).pieces()) {
                Geometry shape = JtsPeer.geometry(piece);
                double reach = Math.max(0, piece.radius());
                Envelope box = shape.getEnvelopeInternal();
                box.expandBy(reach);
                Polygon polygon = (Polygon) (piece.isDisc() ? shape.buffer(reach) : shape);
                tree.insert(box, new Item(shape, reach, polygon));
            }
        } catch (CannotException e) {
            throw new IllegalStateException(e);
        }
    }

    InTurn.Batch probes(CylinderObject[] probes) {
        return (from, count) -> {
            int hits = 0;
            for (int k = from; k < from + count; k++) {
                hits += isHit(probes[k]) ? 1 : 0;
            }
            return hits;
        };
    }

    private boolean isHit(CylinderObject probe) {
        double r = probe.radius();
        Point center = factory.createPoint(
                new Coordinate(probe.center().x(), probe.center().z()));
        Envelope box = new Envelope(center.getCoordinate());
        box.expandBy(r);
        boolean[] hit = {false};
        tree.query(box, found -> {
            Item item = (Item) found;
            hit[0] = hit[0] || item.shape.isWithinDistance(center, item.reach + r);
        });
        return hit[0];
    }

    InTurn.Batch rays(Ray[] rays, double range) {
        return (from, count) -> {
            double sum = 0;
            for (int k = from; k < from + count; k++) {
                sum += Math.min(range, distance(rays[k], range));
            }
            return sum;
        };
    }

    /** Of all that the box around the ray meets, the nearest crossing; JTS has no order along a ray. */
    private double distance(Ray ray, double range) {
        double dx = ray.direction().x();
        double dz = ray.direction().z();
        double scale = range / Math.hypot(dx, dz);
        Coordinate start = new Coordinate(ray.start().x(), ray.start().z());
        Coordinate end = new Coordinate(start.x + dx * scale, start.y + dz * scale);
        Envelope way = new Envelope(start, end);
        double[] nearest = {Double.POSITIVE_INFINITY};
        RobustLineIntersector crossing = new RobustLineIntersector();
        tree.query(way, found -> {
            Polygon polygon = ((Item) found).polygon;
            if (SimplePointInAreaLocator.locate(start, polygon) != Location.EXTERIOR) {
                nearest[0] = 0;
                return;
            }
            Coordinate[] corners = polygon.getExteriorRing().getCoordinates();
            for (int k = 1; k < corners.length; k++) {
                crossing.computeIntersection(start, end, corners[k - 1], corners[k]);
                for (int m = 0; m < crossing.getIntersectionNum(); m++) {
                    nearest[0] = Math.min(nearest[0], start.distance(crossing.getIntersection(m)));
                }
            }
        });
        return nearest[0];
    }
}
