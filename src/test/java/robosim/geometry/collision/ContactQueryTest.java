package robosim.geometry.collision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
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
    /** Where the corners of the meshes come from, and how the meshes stand. */
    enum Family {
        /** Anywhere. */
        RANDOM(1000, 0.001, 0),
        /** Few places: faces in one plane, shared corners and edges, faces without area. */
        GRID(3, 1, 90),
        /** In a plane, all of them. */
        COPLANAR(6, 1, 0),
        /** Long and thin. */
        SLIVERS(4, 0x1p-30, 0),
        /** Few places, then turned: what met in them meets or not by roundings alone. */
        TURNED_GRID(3, 1, 31);

        private final int places;
        private final double unit;
        private final double turn;

        Family(int places, double unit, double turn) {
            this.places = places;
            this.unit = unit;
            this.turn = turn;
        }

        private Point corner(SplittableRandom random) {
            double x = random.nextInt(places) * unit;
            double y = this == COPLANAR ? 0 : random.nextInt(places) * unit;
            double z = random.nextInt(places) * (this == SLIVERS ? 1 : unit);
            return new Point(x, y, z);
        }

        MeshObject mesh(SplittableRandom random, int faces, double turns) {
            List<Point> corners = new ArrayList<>();
            for (int k = 0; k < faces + 3; k++) {
                corners.add(corner(random));
            }
            int[][] given = new int[faces][];
            for (int k = 0; k < faces; k++) {
                given[k] = k % 3 == 0 ? new int[] {k, k + 1, k + 2, k + 3} : new int[] {k, k + 1, k + 2};
            }
            return new MeshObject(corners, given).turned(turns * turn, turns * turn);
        }
    }

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

    /** A box's surface of 12 n n triangles, or of as many halves of quads. */
    private static MeshObject finely(double width, double height, double length, int n, boolean quads) {
        List<Point> corners = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        double[] half = {width / 2, height / 2, length / 2};
        for (int side = 0; side < 6; side++) {
            int axis = side % 3;
            int first = corners.size();
            for (int k = 0; k < (n + 1) * (n + 1); k++) {
                double[] p = new double[3];
                p[axis] = side < 3 ? -half[axis] : half[axis];
                p[(axis + 1) % 3] = half[(axis + 1) % 3] * (2 * (k % (n + 1)) - n) / n;
                p[(axis + 2) % 3] = half[(axis + 2) % 3] * (2 * (k / (n + 1)) - n) / n;
                corners.add(new Point(p[0], p[1], p[2]));
            }
            for (int k = 0; k < n * n; k++) {
                int c = first + k / n * (n + 1) + k % n;
                if (quads) {
                    faces.add(new int[] {c, c + 1, c + n + 2, c + n + 1});
                } else {
                    faces.add(new int[] {c, c + 1, c + n + 2});
                    faces.add(new int[] {c, c + n + 2, c + n + 1});
                }
            }
        }
        return new MeshObject(corners, faces.toArray(new int[0][]));
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
                finely(2, 2, 2, 1, false).movedTo(new Point(20, 0, 0))));
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
        MeshObject solid = finely(8, 8, 8, 3, true).solid();
        MeshObject cube = finely(1, 1, 1, 1, false).movedTo(new Point(1, 1, 1));
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
        assertThat(ContactQuery.ask(solid, ball, Budget.UNLIMITED).answer()).isEqualTo(Answer.YES);
        // A surface has no inside.
        MeshObject surface = finely(8, 8, 8, 3, true);
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
            MeshObject cube = finely(1, 1, 1, 1, false);
            int first = corners.size();
            for (Point p : cube.vertices()) {
                corners.add(new Point(p.x() + 20 * (1 - piece), p.y(), p.z()));
            }
            for (int[] face : cube.faces()) {
                faces.add(new int[] {face[0] + first, face[1] + first, face[2] + first});
            }
        }
        MeshObject two = new MeshObject(corners, faces.toArray(new int[0][]));
        MeshObject solid = finely(8, 8, 8, 2, false).solid();
        assertThat(ContactQuery.contacts(two, solid)).singleElement().satisfies(c -> {
            assertThat(c.a()).isEqualTo(new ContactPart(0, 12, 0));
            assertThat(c.b()).isEqualTo(new ContactPart(0, -1, -1));
        });
        assertThat(ContactQuery.ask(two, solid, Budget.UNLIMITED).answer()).isEqualTo(Answer.YES);
        assertThat(ContactQuery.contacts(two.movedTo(new Point(0, 20, 0)), solid))
                .isEmpty();
    }

    /** Reference knows exactly whether a ball of a radius around a point reaches a surface. */
    @Test
    void theBracketHoldsTheDistanceAfterAnyNumberOfSteps() {
        SplittableRandom random = new SplittableRandom(51);
        int apart = 0;
        for (int k = 0; k < 12; k++) {
            MeshObject mesh = Family.RANDOM.mesh(random, 5, k % 2);
            Point place = new Point(random.nextDouble(-1, 2), random.nextDouble(-1, 2), random.nextDouble(-1, 2));
            SphereObject point = new SphereObject(place, 0);
            Verdict last = ContactQuery.distance(mesh, point, Budget.UNLIMITED);
            for (int steps = 0; steps <= last.steps(); steps += 1 + steps / 4) {
                Verdict verdict = ContactQuery.distance(point, mesh, Budget.steps(steps));
                String what = "point %s, mesh %s %s: %s".formatted(place, mesh, mesh.vertices(), verdict);
                assertThat(Reference.overlap(new SphereObject(place, verdict.high()), mesh, Dimension.SPATIAL))
                        .as(what)
                        .isTrue();
                if (verdict.low() > 0) {
                    double below = Math.nextDown(verdict.low());
                    assertThat(Reference.overlap(new SphereObject(place, below), mesh, Dimension.SPATIAL))
                            .as(what)
                            .isFalse();
                    apart++;
                }
            }
            assertThat(last.high() - last.low()).isLessThan(0x1p-44);
        }
        assertThat(apart).isGreaterThan(30);
    }

    @Test
    void distancesOfFineMeshesAreThoseOfTheirBoxes() {
        MeshObject a = finely(4, 2, 6, 8, false);
        MeshObject b = finely(2, 2, 2, 10, true).movedTo(new Point(6, 6, 16));
        Verdict verdict = ContactQuery.distance(a, b, Budget.UNLIMITED); // gaps 3, 4 and 12
        assertThat(verdict.answer()).isEqualTo(Answer.NO);
        assertThat(verdict.low()).isBetween(13 - 1e-11, 13.0);
        assertThat(verdict.high()).isBetween(13.0, 13 + 1e-11);
        assertThat(verdict.steps()).isLessThan(2000);
        Verdict asked = ContactQuery.ask(a, b, Budget.UNLIMITED);
        assertThat(asked.answer()).isEqualTo(Answer.NO);
        assertThat(asked.steps()).isLessThan(10);
        Verdict flat = ContactQuery.distance(a, b, Dimension.PLANAR, Budget.UNLIMITED);
        assertThat(flat.low()).isBetween(Math.sqrt(153) - 1e-11, Math.sqrt(153));
        assertThat(flat.high()).isBetween(Math.sqrt(153), Math.sqrt(153) + 1e-11);
    }

    @Test
    void aSpentBudgetLeavesATrueBracket() {
        MeshObject a = finely(4, 4, 4, 12, false);
        MeshObject b = finely(2, 2, 2, 12, false).movedTo(new Point()); // a surface inside a surface: 1 apart
        for (Budget none : List.of(Budget.steps(0), Budget.time(Duration.ZERO), new Budget(0, Duration.ofDays(1)))) {
            Verdict verdict = ContactQuery.ask(a, b, none);
            assertThat(verdict.answer()).isEqualTo(Answer.UNDECIDED);
            assertThat(verdict.certainty()).isEqualTo(Certainty.UNCERTAIN);
            assertThat(verdict.steps()).isZero();
            assertThat(verdict.low()).isZero();
            assertThat(verdict.high()).isBetween(1.0, 20.0);
        }
        Verdict early = ContactQuery.ask(a, b, Budget.steps(12));
        assertThat(early.answer()).isEqualTo(Answer.UNDECIDED);
        assertThat(early.high()).isBetween(1.0, 10.0);
        Verdict end = ContactQuery.ask(a, b, new Budget(Long.MAX_VALUE, Duration.ofDays(1_000_000)));
        assertThat(end.answer()).isEqualTo(Answer.NO);
        assertThat(end.certainty()).isEqualTo(Certainty.EXACT);
        assertThat(ContactQuery.distance(a, b, Budget.UNLIMITED).high()).isBetween(1.0, 1 + 1e-12);
    }

    /** Two cylinders askew that touch side to side as nearly as doubles say. */
    @Test
    void doubtIsToldOfAndNeverSaidToBeProof() {
        int doubts = 0;
        int proofs = 0;
        for (int k = 1; k <= 200; k++) {
            CylinderObject upright = new CylinderObject(new Point(), 1, 10);
            GeometryObject tilted = new CylinderObject(new Point(0, 0, 2.0 - (k % 3 - 1) * 1e-9 * (k % 2)), 1, 10)
                    .oriented(tilt(Math.toRadians(10 + k / 4.0)));
            Contact contact = ContactQuery.first(upright, tilted);
            Verdict verdict = ContactQuery.ask(tilted, upright, Budget.UNLIMITED);
            assertThat(contact != null).isEqualTo(CollisionDetection.intersects(upright, tilted));
            assertThat(verdict.answer()).isEqualTo(contact == null ? Answer.NO : Answer.YES);
            if (contact == null) {
                assertThat(verdict.certainty()).isEqualTo(Certainty.EXACT);
                assertThat(verdict.low()).isNotNegative();
                continue;
            }
            assertThat(verdict.certainty()).isEqualTo(contact.certainty());
            assertThat(verdict.low()).isZero();
            if (contact.certainty() == Certainty.EXACT) {
                assertThat(verdict.high()).isZero();
                proofs++;
            } else {
                assertThat(verdict.high()).isBetween(0.0, 1e-9);
                doubts++;
            }
        }
        assertThat(doubts).isPositive();
        assertThat(proofs).isPositive();
    }

    /** About Z, so that the axis stays square to it. */
    private static double[] tilt(double angle) {
        double c = StrictMath.cos(angle);
        double s = StrictMath.sin(angle);
        return new double[] {c, -s, 0, s, c, 0, 0, 0, 1};
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
                .isThrownBy(() -> ContactQuery.ask(ball, nothing(), Budget.UNLIMITED))
                .withMessage("b must be given (got: null)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> ContactQuery.ask(ball, ball, nothing()))
                .withMessage("budget must be given (got: null)");
    }

    @SuppressWarnings({"NullAway", "TypeParameterUnusedInFormals"}) // what a caller without the checks may pass
    private static <T> T nothing() {
        return null;
    }
}
