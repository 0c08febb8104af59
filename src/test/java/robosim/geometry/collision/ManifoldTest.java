package robosim.geometry.collision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** The points of a contact with their depths, against rectangles and corners that are known. */
class ManifoldTest {
    private static final BoxObject FLOOR = new BoxObject(new Point(0, -0.5, 0), 20, 1, 20);

    private final SplittableRandom random = new SplittableRandom(31);

    private static List<Contact.Spot> only(GeometryObject a, GeometryObject b) {
        List<Contact> contacts = ContactQuery.contacts(a, b);
        assertThat(contacts).hasSize(1);
        return ContactQuery.manifold(a, b, contacts.get(0));
    }

    private static Point turned(Point p, double[] r) {
        return new Point(
                r[0] * p.x() + r[1] * p.y() + r[2] * p.z(),
                r[3] * p.x() + r[4] * p.y() + r[5] * p.z(),
                r[6] * p.x() + r[7] * p.y() + r[8] * p.z());
    }

    @Test
    void aBoxOnAFloor() {
        for (int k = 0; k < 300; k++) {
            double width = random.nextDouble(0.5, 2);
            double length = random.nextDouble(0.5, 2);
            BoxObject flat = new BoxObject(
                            new Point(random.nextDouble(-5, 5), 0.95, random.nextDouble(-5, 5)), width, 2, length)
                    .turned(random.nextDouble(-1, 1), random.nextDouble(360));
            List<Contact.Spot> spots = only(flat, FLOOR);
            int below = 0;
            for (int corner = 0; corner < 4; corner++) {
                Point at = turned(
                        new Point(
                                (corner & 1) == 0 ? -width / 2 : width / 2,
                                -1,
                                (corner & 2) == 0 ? -length / 2 : length / 2),
                        flat.rotation());
                double depth = -(flat.center().y() + at.y());
                below += depth > 0 ? 1 : 0;
                assertThat(spots.stream()
                                .filter(spot -> Math.abs(spot.depth() - depth) < 1e-9
                                        && Math.abs(spot.point().x()
                                                        - flat.center().x()
                                                        - at.x())
                                                < 1e-9
                                        && Math.abs(spot.point().z()
                                                        - flat.center().z()
                                                        - at.z())
                                                < 1e-9
                                        && Math.abs(spot.point().y() + depth / 2) < 1e-9)
                                .count())
                        .as("corner %s of %s in %s", at, flat, spots)
                        .isEqualTo(depth > 0 ? 1 : 0);
            }
            assertThat(spots).hasSize(below);
            assertThat(below).isEqualTo(4);
            assertThat(spots).isSortedAccordingTo((one, other) -> Double.compare(other.depth(), one.depth()));
        }
    }

    @Test
    void whatTwoBoxesShare() {
        for (int k = 0; k < 300; k++) {
            double x = random.nextDouble(0.1, 1.9);
            double z = random.nextDouble(-0.9, 0.9);
            double length = random.nextDouble(0.2, 3);
            BoxObject low = new BoxObject(new Point(0, 0, 0), 2, 2, 2);
            BoxObject high = new BoxObject(new Point(x, 1.99, z), 2, 2, length);
            double least = Math.max(-1, z - length / 2);
            double most = Math.min(1, z + length / 2);
            List<Contact.Spot> spots = only(high, low);
            if (Math.min(2 - x, most - least) < 0.02) {
                continue; // another way out may be shorter
            }
            assertThat(spots).hasSize(4).allSatisfy(spot -> {
                assertThat(spot.depth()).isCloseTo(0.01, within(1e-12));
                assertThat(Math.min(
                                Math.abs(spot.point().x() - 1),
                                Math.abs(spot.point().x() - (x - 1))))
                        .isLessThan(1e-12);
                assertThat(Math.min(
                                Math.abs(spot.point().z() - least),
                                Math.abs(spot.point().z() - most)))
                        .isLessThan(1e-12);
            });
            assertThat(spots.stream().map(Contact.Spot::point).distinct()).hasSize(4);
        }
    }

    @Test
    void roundShapesAndEdges() {
        assertThat(only(new SphereObject(new Point(1, 0.4, 2), 0.5), FLOOR))
                .singleElement()
                .satisfies(spot -> {
                    assertThat(spot.depth()).isCloseTo(0.1, within(1e-9));
                    assertThat(spot.point().x()).isCloseTo(1, within(1e-9));
                    assertThat(spot.point().y()).isCloseTo(-0.05, within(1e-9));
                });
        assertThat(only(new CapsuleObject(new Point(0, 0.4, 0), 0.5, 3).turned(90, 0), FLOOR))
                .hasSize(2)
                .allSatisfy(spot -> {
                    assertThat(Math.abs(spot.point().z())).isCloseTo(1.5, within(1e-9));
                    assertThat(spot.depth()).isCloseTo(0.1, within(1e-9));
                });
        assertThat(only(new CylinderObject(new Point(0, 0.9, 0), 1, 2), FLOOR))
                .hasSize(4)
                .allSatisfy(spot -> {
                    assertThat(Math.hypot(spot.point().x(), spot.point().z())).isCloseTo(1, within(1e-9));
                    assertThat(spot.depth()).isCloseTo(0.1, within(1e-9));
                });
        assertThat(only(new CylinderObject(new Point(0, 0.9, 0), 1, 2).turned(90, 0), FLOOR))
                .hasSize(2);
        // Two edges that cross, and a corner that points down.
        BoxObject roof = new BoxObject(new Point(0, 0, 0), 1, 1, 8).oriented(quarter(0));
        BoxObject across = new BoxObject(new Point(0, 1.4, 0), 8, 1, 1).oriented(quarter(1));
        assertThat(only(across, roof)).singleElement().satisfies(spot -> {
            assertThat(spot.point().x()).isCloseTo(0, within(1e-9));
            assertThat(spot.point().z()).isCloseTo(0, within(1e-9));
            assertThat(spot.depth()).isCloseTo(Math.sqrt(2) - 1.4, within(1e-9));
        });
    }

    /** Turned by 45 degrees about the world's Z, or about X. */
    private static double[] quarter(int way) {
        double h = Math.sqrt(0.5);
        return way == 0 ? new double[] {h, -h, 0, h, h, 0, 0, 0, 1} : new double[] {1, 0, 0, 0, h, -h, 0, h, h};
    }

    @Test
    void piecesOfMeshesGroupsAndGrids() {
        MeshObject sheet = new MeshObject(
                List.of(new Point(-9, 0, -9), new Point(-9, 0, 9), new Point(9, 0, 9), new Point(9, 0, -9)),
                new int[][] {{0, 1, 2, 3}});
        BoxObject crate = new BoxObject(new Point(4, 0.9, -2), 2, 2, 2);
        List<Contact> contacts = ContactQuery.contacts(crate, sheet);
        assertThat(contacts).hasSize(1);
        assertThat(ContactQuery.manifold(crate, sheet, contacts.get(0)))
                .hasSize(4)
                .allSatisfy(spot -> {
                    assertThat(spot.depth()).isCloseTo(0.1, within(1e-9));
                    assertThat(Math.abs(spot.point().x() - 4)).isCloseTo(1, within(1e-9));
                });
        ObjectGroup group = new ObjectGroup(List.of(new SphereObject(new Point(0, 5, 0), 1), crate));
        assertThat(only(group, FLOOR)).hasSize(4);
        BitSet cells = new BitSet();
        cells.set(1);
        GridObject grid = new GridObject(new Point(0, 0, 0), 1, 2, 2, 1, cells);
        assertThat(only(new BoxObject(new Point(0.5, 1.45, 0), 3, 1, 3), grid))
                .hasSize(4)
                .allSatisfy(spot -> {
                    assertThat(spot.depth()).isCloseTo(0.05, within(1e-9));
                    assertThat(Math.abs(spot.point().x() - 0.5)).isCloseTo(0.5, within(1e-9));
                });
    }

    @Test
    void beams() {
        int hits = 0;
        for (int k = 0; k < 400; k++) {
            GeometryObject object = k % 2 == 0
                    ? new CylinderObject(new Point(0, 0, 0), 1, 2)
                            .turned(random.nextDouble(360), random.nextDouble(360))
                    : new BoxObject(new Point(0, 0, 0), 1, 2, 3).turned(30, 20);
            Point from = new Point(random.nextDouble(-6, 6), random.nextDouble(-6, 6), random.nextDouble(-6, 6));
            Ray ray = new Ray(
                    from,
                    new Point(
                            random.nextDouble(-2, 2) - from.x(),
                            random.nextDouble(-2, 2) - from.y(),
                            random.nextDouble(-2, 2) - from.z()));
            Geometry world = new Geometry(30, 30, 30);
            world.addObject(object);
            for (double width : new double[] {0, 25}) {
                double found = ContactQuery.beamDistance(ray, width, object);
                assertThat(found).isEqualTo(world.getRayDistance(ray, 0, Double.POSITIVE_INFINITY, width));
                hits += found < Double.POSITIVE_INFINITY ? 1 : 0;
            }
        }
        assertThat(hits).isBetween(80, 720);
    }
}
