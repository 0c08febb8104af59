package robosim.geometry.collision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.collision.Meshes.Family;
import robosim.geometry.collision.Verdict.Answer;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.Reference;

class ContactQueryTest {
    private record Triangle(ContactPart name, MeshObject mesh) {}

    /** Each triangle of a mesh as a mesh of its own, in the same place. */
    private static List<Triangle> triangles(MeshObject mesh) {
        List<Triangle> triangles = new ArrayList<>();
        int[][] faces = mesh.faces();
        for (int f = 0; f < faces.length; f++) {
            for (int k = 2; k < faces[f].length; k++) {
                int[][] one = {{faces[f][0], faces[f][k - 1], faces[f][k]}};
                triangles.add(new Triangle(
                        new ContactPart(0, f, k - 2), new MeshObject(mesh.vertices(), one).at(mesh.pose())));
            }
        }
        return triangles;
    }

    @ParameterizedTest
    @EnumSource
    void facesNamedAreThoseThatMeet(Family family) {
        SplittableRandom random = new SplittableRandom(41 + family.ordinal());
        int meeting = 0;
        int asked = 0;
        double worst = 0;
        for (int k = 0; k < 9; k++) {
            MeshObject a = family.mesh(random, 7, k % 2);
            MeshObject b = family.mesh(random, 7, k % 3);
            List<Contact> contacts = ContactQuery.contacts(a, b);
            List<Contact> expected = new ArrayList<>();
            for (Triangle p : triangles(a)) {
                for (Triangle q : triangles(b)) {
                    String pair = "%s %d: %s of %s %s, %s of %s %s"
                            .formatted(family, k, p.name, a, a.vertices(), q.name, b, b.vertices());
                    Contact contact = contacts.stream()
                            .filter(c -> c.a().equals(p.name) && c.b().equals(q.name))
                            .findAny()
                            .orElse(null);
                    boolean truth = Reference.overlap(p.mesh, q.mesh, Dimension.SPATIAL);
                    assertThat(contact != null).as(pair).isEqualTo(truth);
                    asked++;
                    if (contact != null) {
                        SphereObject around = new SphereObject(contact.point(), contact.error());
                        assertThat(Reference.overlap(around, p.mesh, Dimension.SPATIAL))
                                .as(pair)
                                .isTrue();
                        assertThat(Reference.overlap(around, q.mesh, Dimension.SPATIAL))
                                .as(pair)
                                .isTrue();
                        assertThat(contact.certainty()).isEqualTo(Certainty.EXACT);
                        worst = Math.max(worst, contact.error());
                        expected.add(contact);
                        meeting++;
                    }
                }
            }
            assertThat(contacts).containsExactlyElementsOf(expected);
        }
        assertThat(meeting).as("of " + asked).isBetween(asked / 20, asked * 9 / 10);
        assertThat(worst).isLessThan(0x1p-40);
    }

    /** Needles on which an iteration in doubles comes to no end: the point is found with exact numbers there. */
    @Test
    void pointsOnNeedlesAreGoodToo() {
        SplittableRandom random = new SplittableRandom(43);
        int meeting = 0;
        for (int k = 0; k < 1000; k++) {
            double rx = random.nextDouble(-180, 180);
            double ry = random.nextDouble(-180, 180);
            GeometryObject p = needle(random).turned(rx, ry);
            GeometryObject q = k % 4 == 0
                    ? new BoxObject(new Point(), 0x1p-44, random.nextInt(3), 1).turned(rx, ry)
                    : needle(random).turned(rx, ry);
            Contact contact = ContactQuery.first(p, q);
            Contact again = ContactQuery.first(q, p);
            if (contact == null || again == null) {
                assertThat(again).isEqualTo(contact);
                continue;
            }
            assertThat(contact.error()).isLessThan(0x1p-42);
            assertThat(again.point()).isEqualTo(contact.point());
            assertThat(again.error()).isEqualTo(contact.error());
            if (k % 8 < 2) {
                SphereObject around = new SphereObject(contact.point(), contact.error());
                assertThat(Reference.overlap(around, p, Dimension.SPATIAL)).isTrue();
                assertThat(Reference.overlap(around, q, Dimension.SPATIAL)).isTrue();
            }
            meeting++;
        }
        assertThat(meeting).isBetween(200, 800);
    }

    private static MeshObject needle(SplittableRandom random) {
        List<Point> corners = new ArrayList<>();
        for (int k = 0; k < 3; k++) {
            double y = random.nextInt(4) * (random.nextBoolean() ? 0x1p-50 : 1);
            corners.add(new Point(random.nextInt(4) * 0x1p-45, y, random.nextInt(4) / 3.0));
        }
        return new MeshObject(corners, new int[][] {{0, 1, 2}});
    }

    /** What is scaled by a power of two has the same contacts, to the bit where nothing underflows. */
    @Test
    void scaleDoesNotCount() {
        SplittableRandom random = new SplittableRandom(44);
        int seen = 0;
        for (int k = 0; k < 40; k++) {
            Family family = Family.values()[k % 5];
            MeshObject a = family.mesh(random, 4, k % 2);
            MeshObject b = family.mesh(random, 4, k % 3);
            List<Contact> contacts = ContactQuery.contacts(a, b);
            for (double scale : new double[] {0x1p-40, 0x1p40, 0x1p-200, 0x1p90}) {
                List<Contact> scaled = ContactQuery.contacts(scaled(a, scale), scaled(b, scale));
                assertThat(scaled)
                        .extracting(Contact::a)
                        .isEqualTo(contacts.stream().map(Contact::a).toList());
                assertThat(scaled)
                        .extracting(Contact::b)
                        .isEqualTo(contacts.stream().map(Contact::b).toList());
                Verdict verdict = ContactQuery.distance(a, b, Budget.UNLIMITED);
                Verdict there = ContactQuery.distance(scaled(a, scale), scaled(b, scale), Budget.UNLIMITED);
                assertThat(there.answer()).isEqualTo(verdict.answer());
                assertThat(there.high()).isBetween(verdict.low() * scale, (verdict.high() + 0x1p-40) * scale);
            }
            seen += contacts.size();
        }
        assertThat(seen).isGreaterThan(100);
    }

    private static MeshObject scaled(MeshObject mesh, double scale) {
        List<Point> corners = mesh.vertices().stream()
                .map(p -> new Point(p.x() * scale, p.y() * scale, p.z() * scale))
                .toList();
        return new MeshObject(corners, mesh.faces()).at(mesh.pose());
    }

    @Test
    void aQuadIsNamedByItsHalf() {
        MeshObject bent = new MeshObject(
                List.of(new Point(0, 0, 0), new Point(4, 1, 0), new Point(4, 0, 4), new Point(0, 1, 4)),
                new int[][] {{0, 1, 2, 3}});
        Contact low = ContactQuery.first(bent, new SphereObject(new Point(3.5, 0.75, 0.5), 0.125));
        assertThat(low).isNotNull();
        assertThat(low.a()).isEqualTo(new ContactPart(0, 0, 0));
        assertThat(low.b()).isEqualTo(new ContactPart(0, -1, -1));
        assertThat(low.a().isFace()).isTrue();
        assertThat(low.b().isFace()).isFalse();
        List<Contact> both = ContactQuery.contacts(bent, new SphereObject(new Point(2, 0, 2), 0));
        assertThat(both).extracting(Contact::a).containsExactly(new ContactPart(0, 0, 0), new ContactPart(0, 0, 1));
        assertThat(both).allSatisfy(c -> assertThat(c.point()).isEqualTo(new Point(2, 0, 2)));
    }

    @Test
    void partsAreCountedAsTheMembersStand() {
        ObjectGroup inner = new ObjectGroup(List.of(
                new SphereObject(new Point(10, 0, 0), 1),
                Meshes.finely(2, 2, 2, 1, false).movedTo(new Point(20, 0, 0))));
        ObjectGroup group = new ObjectGroup(
                List.of(new BoxObject(new Point(), 2, 2, 2), inner, new CylinderObject(new Point(30, 0, 0), 1, 2)));
        for (int part = 0; part < 4; part++) {
            SphereObject probe = new SphereObject(new Point(10 * part - 1, 0, 0), 0.0625);
            Contact contact = ContactQuery.first(probe, group);
            assertThat(contact).isNotNull();
            assertThat(contact.b().part()).isEqualTo(part);
            assertThat(contact.b().isFace()).isEqualTo(part == 2);
            assertThat(contact.a()).isEqualTo(new ContactPart(0, -1, -1));
        }
        assertThat(ContactQuery.contacts(group, group))
                .hasSizeGreaterThan(4)
                .allSatisfy(c -> assertThat(c.a().part()).isEqualTo(c.b().part()));
    }

    @Test
    void whatASolidHoldsInsideIsOneContact() {
        MeshObject solid = Meshes.finely(8, 8, 8, 3, true).solid();
        MeshObject cube = Meshes.finely(1, 1, 1, 1, false).movedTo(new Point(1, 1, 1));
        SphereObject ball = new SphereObject(new Point(1, 2, 1), 0.5);
        ContactPart whole = new ContactPart(0, -1, -1);
        assertThat(ContactQuery.contacts(solid, ball))
                .containsExactly(
                        new Contact(whole, whole, new Point(1, 2, 1), new Point(0, -1, 0), 0, Certainty.EXACT));
        Contact held = ContactQuery.first(cube, solid);
        assertThat(held).isNotNull();
        assertThat(held.a()).isEqualTo(new ContactPart(0, 0, 0));
        assertThat(held.b()).isEqualTo(whole);
        assertThat(held.normal()).isEqualTo(new Point(0, 1, 0));
        assertThat(held.error()).isZero();
        assertThat(CollisionDetection.intersects(cube, new SphereObject(held.point(), 0)))
                .isTrue();
        assertThat(ContactQuery.decide(solid, ball, Budget.UNLIMITED).answer()).isEqualTo(Answer.YES);
        // A surface has no inside.
        MeshObject surface = Meshes.finely(8, 8, 8, 3, true);
        assertThat(ContactQuery.contacts(surface, cube)).isEmpty();
        Verdict apart = ContactQuery.distance(surface, cube, Budget.UNLIMITED);
        assertThat(apart.answer()).isEqualTo(Answer.NO);
        assertThat(apart.low()).isBetween(2.5 - 1e-12, 2.5);
        assertThat(apart.high()).isBetween(2.5, 2.5 + 1e-12);
    }

    @Test
    void aPieceInsideCountsThoughAnotherIsOutside() {
        List<Point> corners = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        for (int piece = 0; piece < 2; piece++) {
            MeshObject cube = Meshes.finely(1, 1, 1, 1, false);
            int first = corners.size();
            for (Point p : cube.vertices()) {
                corners.add(new Point(p.x() + 20 * (1 - piece), p.y(), p.z()));
            }
            for (int[] face : cube.faces()) {
                faces.add(new int[] {face[0] + first, face[1] + first, face[2] + first});
            }
        }
        MeshObject two = new MeshObject(corners, faces.toArray(new int[0][]));
        MeshObject solid = Meshes.finely(8, 8, 8, 2, false).solid();
        assertThat(ContactQuery.contacts(two, solid)).singleElement().satisfies(c -> {
            assertThat(c.a()).isEqualTo(new ContactPart(0, 12, 0));
            assertThat(c.b()).isEqualTo(new ContactPart(0, -1, -1));
        });
        assertThat(ContactQuery.decide(two, solid, Budget.UNLIMITED).answer()).isEqualTo(Answer.YES);
        assertThat(ContactQuery.contacts(two.movedTo(new Point(0, 20, 0)), solid))
                .isEmpty();
    }

    @Test
    void whatIsFarOutHasContactsToo() {
        MeshObject edge = new MeshObject(
                List.of(new Point(0x1p100, 0, 0), new Point(0x1p100, 1, 0), new Point(0x1p100, 0, 0x1p99)),
                new int[][] {{0, 1, 2}});
        MeshObject beyond = edge.movedTo(new Point(0x1p99, 0, 0));
        assertThat(ContactQuery.contacts(edge, edge)).hasSize(1);
        Contact out = ContactQuery.first(beyond, beyond);
        assertThat(out).isNotNull();
        assertThat(out.point().x()).isEqualTo(0x1p100);
        assertThat(out.error()).isGreaterThanOrEqualTo(0x1p99);
    }

    @Test
    void badArgumentsAreNamed() {
        SphereObject ball = new SphereObject(new Point(), 1);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> ContactQuery.contacts(ball, ball, Dimension.SPATIAL, 0))
                .withMessage("limit must be at least 1 (got: 0)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Budget.steps(-1))
                .withMessage("steps must be at least 0 (got: -1)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Budget.time(Duration.ofNanos(-1)))
                .withMessage("time must be at least 0 (got: PT-0.000000001S)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> ContactQuery.first(nothing(), ball))
                .withMessage("a must be given (got: null)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> ContactQuery.decide(ball, nothing(), Budget.UNLIMITED))
                .withMessage("b must be given (got: null)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> ContactQuery.decide(ball, ball, nothing()))
                .withMessage("budget must be given (got: null)");
    }

    @SuppressWarnings({"NullAway", "TypeParameterUnusedInFormals"}) // what a caller without the checks may pass
    private static <T> T nothing() {
        return null;
    }

    /** A triangle across a segment, as seen from above: the middle of the shortest way out is in neither. */
    @Test
    void aPointSeenFromAboveIsOneOfBoth() {
        MeshObject triangle = new MeshObject(
                List.of(new Point(-4, 0, 2), new Point(0, 0, -2), new Point(-1, 0, 1)), new int[][] {{0, 1, 2}});
        MeshObject segment = new MeshObject(List.of(new Point(-4, 5, 0), new Point(1, 4, 5)), new int[][] {{0, 1, 0}});
        List<Contact> found = ContactQuery.contacts(triangle, segment, Dimension.PLANAR, 9);
        assertThat(found).hasSize(1);
        Contact contact = found.get(0);
        assertThat(contact.error()).isLessThan(1e-13);
        assertThat(contact.point().z() - contact.point().x()).isCloseTo(4, within(1e-13));
        assertThat(contact.point().x()).isBetween(-3 - 1e-13, -1.0);
    }

    /** Two that overlap by 5e-11: the simplex is about the origin, and its normal leads out of the plane. */
    @Test
    void aThinCylinderTouchesATriangleInThePlane() {
        double[] rotation = {
            -0.41753447481425976,
            -0.8670625286457093,
            -0.2717858233243388,
            -0.6814355904366474,
            0.4966507705294097,
            -0.5375719005108075,
            0.6010910899587834,
            -0.039250268165352376,
            -0.7982160847922759
        };
        Point center = new Point(-0.27211512296964324, -0.6475845345630291, 0.9978318772131993);
        GeometryObject cylinder =
                new CylinderObject(center, 3.3786961201828306E-7, 2 * 0.7957065008933693).oriented(rotation);
        GeometryObject triangle = new MeshObject(
                List.of(
                        new Point(-0.2721151382464034, -0.8960870818549764, 0.9978322146862126),
                        new Point(0.28366739445176886, 0.40810098198233624, 1.646609524513796),
                        new Point(0.47222689716729355, 0.8587851623657385, 1.4996420647711934)),
                new int[][] {{0, 1, 2}});
        Verdict verdict = ContactQuery.distance(cylinder, triangle, Dimension.PLANAR, Budget.UNLIMITED);
        assertThat(verdict.low()).isZero();
        assertThat(verdict.answer()).isNotEqualTo(Answer.NO);
    }
}
