package robosim.geometry.collision;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.MeshObject;
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
}
