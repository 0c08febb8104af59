package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.RayHit;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** The normal of what a ray meets looks back along the ray, however far the ray came and however thin what it meets is. */
class HitNormalsTest {
    private final SplittableRandom random = new SplittableRandom(240605);

    /** A plate turned in any way near the origin, from a million away: the side that is met is the near one. */
    @Test
    void aPlateThinnerThanAnUlpOfTheDistanceShowsItsNearSide() {
        int hits = 0;
        for (int k = 0; k < Effort.cases(4_000); k++) {
            double thick = StrictMath.pow(10, random.nextDouble(-13, k % 2 == 0 ? -10 : 0));
            GeometryObject plate = new BoxObject(place(), 2, thick, 2)
                    .turned(random.nextDouble(-180, 180), random.nextDouble(-180, 180));
            RayHit hit = hit(Dimension.SPATIAL, plate, 1e6);
            if (hit == null) {
                continue;
            }
            double[] r = plate.rotation();
            Point n = hit.normal();
            double along = n.x() * r[1] + n.y() * r[4] + n.z() * r[7];
            double aside = Math.sqrt(Math.max(0, 1 - along * along));
            assertThat(Math.abs(along) > 0.999_999 || aside > 0.999_999)
                    .as(plate + " " + hit)
                    .isTrue();
            hits++;
        }
        assertThat(hits).isGreaterThan(Effort.cases(3_000));
    }

    @Test
    void whatIsSmallBesideTheDistanceFacesTheRay() {
        int hits = 0;
        for (int k = 0; k < Effort.cases(20_000); k++) {
            double p = StrictMath.pow(10, random.nextDouble(-13, 1));
            double q = StrictMath.pow(10, random.nextDouble(-13, 1));
            double turn = random.nextInt(3) == 0 ? 0 : random.nextDouble(-180, 180);
            GeometryObject shape = switch (k % 3) {
                case 0 -> new SphereObject(place(), p);
                case 1 -> new CylinderObject(place(), p, q).turned(turn, random.nextInt(4) * 45);
                default -> new BoxObject(place(), p, q, p).turned(turn, random.nextInt(4) * 45);
            };
            Dimension dimension = Dimension.values()[random.nextInt(2)];
            if (hit(dimension, shape, StrictMath.pow(10, random.nextDouble(2, 8))) != null) {
                hits++;
            }
        }
        assertThat(hits).isGreaterThan(Effort.cases(10_000));
    }

    /** Shapes without thickness, hit at any slant down to that of rounding: the product with the direction is never above 0. */
    @Test
    void flatShapesFaceTheRayToTheBit() {
        int hits = 0;
        int grazed = 0;
        for (int k = 0; k < Effort.cases(30_000); k++) {
            GeometryObject flat = switch (k % 5) {
                case 0 -> new BoxObject(place(), 2, 0, 2);
                case 1 -> new BoxObject(place(), 0, 1, 2);
                case 2 -> new CylinderObject(place(), 1, 0);
                case 3 -> new CylinderObject(place(), 0, 2);
                default -> new MeshObject(List.of(place(), place(), place()), new int[][] {{0, 1, 2}});
            };
            if (k % 3 > 0) {
                flat = flat instanceof MeshObject ? flat : turned(flat);
            }
            double[] r = flat.rotation();
            Point along = new Point(r[0], r[3], r[6]);
            if (flat instanceof MeshObject mesh) {
                Point a = mesh.vertices().get(0);
                Point b = mesh.vertices().get(1);
                along = new Point(b.x() - a.x(), b.y() - a.y(), b.z() - a.z());
            }
            double slant =
                    k % 7 == 0 ? 0 : StrictMath.pow(10, random.nextDouble(-18, 0)) * (random.nextBoolean() ? 1 : -1);
            Point way = new Point(
                    along.x() + slant * random.nextDouble(),
                    along.y() + slant * random.nextDouble(),
                    along.z() + slant * random.nextDouble());
            Point to = flat instanceof MeshObject mesh ? mesh.vertices().get(2) : flat.center();
            Point start = new Point(to.x() - 3 * way.x(), to.y() - 3 * way.y(), to.z() - 3 * way.z());
            Dimension dimension = Dimension.values()[random.nextInt(2)];
            if (dimension == Dimension.PLANAR && way.x() == 0 && way.z() == 0) {
                continue;
            }
            Geometry geometry = new Geometry(1e3, 1e3, 1e3, dimension, Accuracy.EXACT);
            assertThat(geometry.addObjectUnchecked(flat)).isTrue();
            RayHit hit = geometry.castRay(new Ray(start, way), Double.POSITIVE_INFINITY);
            if (hit != null && hit.distance() > 0) {
                Point n = hit.normal();
                double up = dimension == Dimension.PLANAR ? 0 : n.y() * way.y();
                double ahead = n.x() * way.x() + up + n.z() * way.z();
                assertThat(ahead)
                        .as(dimension + " " + flat + " from " + start + " to " + way + ": " + hit)
                        .isLessThanOrEqualTo(0);
                assertThat(Math.sqrt(n.x() * n.x() + n.y() * n.y() + n.z() * n.z()))
                        .isCloseTo(1, within(1e-14));
                hits++;
                grazed += ahead > -1e-12 ? 1 : 0;
            }
        }
        assertThat(hits).isGreaterThan(Effort.cases(10_000));
        assertThat(grazed).isGreaterThan(Effort.cases(1_000));
    }

    private GeometryObject turned(GeometryObject flat) {
        double ry = random.nextInt(2) == 0 ? 30 * random.nextInt(12) : random.nextDouble(-180, 180);
        double rx = random.nextInt(3) == 0 ? 0 : random.nextDouble(-180, 180);
        return flat instanceof BoxObject box ? box.turned(rx, ry) : ((CylinderObject) flat).turned(rx, ry);
    }

    private Point place() {
        return new Point(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    /** From so far away towards some place of the object; every normal has length 1 and looks back. */
    private RayHit hit(Dimension dimension, GeometryObject object, double away) {
        Point c = object.center();
        double[] from = new double[3];
        double length = 0;
        while (!(length > 0.1)) {
            for (int k = 0; k < 3; k++) {
                from[k] = random.nextDouble(-1, 1);
            }
            length = Math.sqrt(from[0] * from[0] + from[1] * from[1] + from[2] * from[2]);
        }
        Point start = new Point(
                c.x() + away * from[0] / length, c.y() + away * from[1] / length, c.z() + away * from[2] / length);
        double off = object instanceof BoxObject ? 0.4 * random.nextDouble(-1, 1) * ((BoxObject) object).height() : 0;
        Point to = new Point(c.x() - start.x() + off, c.y() - start.y(), c.z() - start.z());
        Geometry geometry = new Geometry(1e9, 1e9, 1e9, dimension, Accuracy.EXACT);
        assertThat(geometry.addObjectUnchecked(object)).isTrue();
        RayHit hit = geometry.castRay(new Ray(start, to), Double.POSITIVE_INFINITY);
        if (hit != null) {
            boolean flat = dimension == Dimension.PLANAR;
            Point n = hit.normal();
            double up = flat ? 0 : n.y() * to.y();
            double way = Math.sqrt(to.x() * to.x() + (flat ? 0 : to.y() * to.y()) + to.z() * to.z());
            String what = dimension + " " + object + " from " + start + " to " + to + ": " + hit;
            assertThat(Math.sqrt(n.x() * n.x() + n.y() * n.y() + n.z() * n.z()))
                    .as(what)
                    .isCloseTo(1, within(1e-14));
            assertThat((n.x() * to.x() + up + n.z() * to.z()) / way).as(what).isLessThan(1e-12);
        }
        return hit;
    }
}
