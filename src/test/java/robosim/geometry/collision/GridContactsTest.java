package robosim.geometry.collision;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Effort;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** A grid beside an object is the group of its cells' boxes. */
class GridContactsTest {
    private static final int PAIRS = Effort.cases(600);

    private static GridObject grid(SplittableRandom random, double heading) {
        int columns = random.nextInt(1, 9);
        int rows = random.nextInt(1, 9);
        BitSet occupied = new BitSet();
        for (int k = random.nextInt(1, 12); k > 0; k--) {
            occupied.set(random.nextInt(columns * rows));
        }
        Point center = new Point(random.nextInt(-4, 5) / 4.0, random.nextDouble(-1, 1), random.nextInt(-4, 5) / 4.0);
        return new GridObject(center, random.nextInt(1, 5) / 4.0, random.nextInt(0, 3), columns, rows, occupied)
                .turned(0, heading);
    }

    private static ObjectGroup group(GridObject grid) {
        return new ObjectGroup(grid.occupied().stream()
                .mapToObj(cell -> (GeometryObject) grid.box(cell % grid.columns(), cell / grid.columns()))
                .toList());
    }

    private static GeometryObject other(int kind, SplittableRandom random) {
        double size = random.nextBoolean() ? random.nextInt(1, 5) / 4.0 : random.nextDouble(0.1, 1.5);
        BoxObject box = new BoxObject(new Point(), size, 2, 0.5);
        GeometryObject object = switch (kind % 7) {
            case 0 -> box;
            case 1 -> new CylinderObject(new Point(), size, 1);
            case 2 -> new SphereObject(new Point(), size);
            case 3 -> new CapsuleObject(new Point(), size, 1).turned(random.nextDouble(-90, 90), 20);
            case 4 -> box.turned(random.nextDouble(-90, 90), 0);
            case 5 -> new ObjectGroup(List.of(box, new SphereObject(new Point(1, 0, 0), 0.5)));
            default ->
                new MeshObject(
                        List.of(
                                new Point(-1, -1, 0),
                                new Point(1, -1, 0.2),
                                new Point(1, 1, 0),
                                new Point(-1, 1, size)),
                        new int[][] {{0, 1, 2, 3}});
        };
        Point place = random.nextBoolean()
                ? new Point(random.nextInt(-12, 13) / 4.0, 0, random.nextInt(-12, 13) / 4.0)
                : new Point(random.nextDouble(-3, 3), random.nextDouble(-1, 1), random.nextDouble(-3, 3));
        return object.movedTo(place);
    }

    /** The cell that a member of the group stands for. */
    private static ContactPart cell(ContactPart member, GridObject grid) {
        int cell = grid.occupied().stream().skip(member.part()).findFirst().orElseThrow();
        return new ContactPart(cell, member.face(), member.half());
    }

    private static List<Contact> inCells(List<Contact> contacts, @Nullable GridObject ofA, @Nullable GridObject ofB) {
        List<Contact> inCells = new ArrayList<>();
        for (Contact c : contacts) {
            inCells.add(new Contact(
                    ofA == null ? c.a() : cell(c.a(), ofA),
                    ofB == null ? c.b() : cell(c.b(), ofB),
                    c.point(),
                    c.normal(),
                    c.error(),
                    c.certainty()));
        }
        return inCells;
    }

    @ParameterizedTest
    @CsvSource({"PLANAR, 0", "PLANAR, 90", "PLANAR, 33", "SPATIAL, 0", "SPATIAL, 180", "SPATIAL, -71.3"})
    void contactsNameCells(Dimension dimension, double heading) {
        SplittableRandom random = new SplittableRandom(81 + (long) heading + dimension.ordinal());
        int meeting = 0;
        int several = 0;
        for (int k = 0; k < PAIRS; k++) {
            GridObject grid = grid(random, heading);
            ObjectGroup group = group(grid);
            GeometryObject other = other(k, random);
            String as = "%s, %s, %s beside %s".formatted(dimension, grid, grid.occupied(), other);
            int most = Integer.MAX_VALUE;
            List<Contact> truth = ContactQuery.contacts(group, other, dimension, most);
            assertThat(ContactQuery.contacts(grid, other, dimension, most))
                    .as(as)
                    .isEqualTo(inCells(truth, grid, null));
            assertThat(ContactQuery.contacts(other, grid, dimension, most))
                    .as("%s, swapped", as)
                    .isEqualTo(inCells(ContactQuery.contacts(other, group, dimension, most), null, grid));
            List<Contact> one = ContactQuery.contacts(grid, other, dimension, 1);
            assertThat(one).as(as).hasSize(Math.min(1, truth.size()));
            assertThat(inCells(truth, grid, null)).as(as).containsAll(one);
            Verdict verdict = ContactQuery.decide(grid, other, dimension, Budget.UNLIMITED);
            assertThat(verdict.answer())
                    .as(as)
                    .isEqualTo(ContactQuery.decide(group, other, dimension, Budget.UNLIMITED)
                            .answer());
            checkDistance(as, grid, group, other, dimension);
            meeting += truth.isEmpty() ? 0 : 1;
            several += truth.size() > 1 ? 1 : 0;
        }
        assertThat(meeting).isBetween(PAIRS / 10, PAIRS * 9 / 10);
        assertThat(several).isGreaterThan(PAIRS / 20);
    }

    private static void checkDistance(
            String as, GridObject grid, ObjectGroup group, GeometryObject other, Dimension dimension) {
        Verdict of = ContactQuery.distance(grid, other, dimension, Budget.UNLIMITED);
        Verdict twin = ContactQuery.distance(group, other, dimension, Budget.UNLIMITED);
        assertThat(of.low()).as("%s, distance", as).isLessThanOrEqualTo(twin.high());
        assertThat(twin.low()).as("%s, distance", as).isLessThanOrEqualTo(of.high());
        Verdict swapped = ContactQuery.distance(other, grid, dimension, Budget.UNLIMITED);
        assertThat(swapped.low()).as("%s, distance swapped", as).isLessThanOrEqualTo(twin.high());
        assertThat(swapped.high()).as("%s, distance swapped", as).isGreaterThanOrEqualTo(twin.low());
    }

    @ParameterizedTest
    @CsvSource({"PLANAR, 0, 90", "SPATIAL, 0, 33", "SPATIAL, 45, -90", "PLANAR, 12, 13"})
    void twoGrids(Dimension dimension, double heading, double another) {
        SplittableRandom random = new SplittableRandom(91 + (long) heading);
        int meeting = 0;
        for (int k = 0; k < PAIRS; k++) {
            GridObject a = grid(random, heading);
            GridObject b = grid(random, another)
                    .movedTo(new Point(random.nextInt(-8, 9) / 2.0, 0, random.nextInt(-8, 9) / 2.0));
            List<Contact> truth =
                    inCells(ContactQuery.contacts(group(a), group(b), dimension, Integer.MAX_VALUE), a, b);
            assertThat(ContactQuery.contacts(a, b, dimension, Integer.MAX_VALUE))
                    .as("%s, %s, %s, %s", a, a.occupied(), b, b.occupied())
                    .isEqualTo(truth);
            meeting += truth.isEmpty() ? 0 : 1;
        }
        assertThat(meeting).isBetween(PAIRS / 10, PAIRS * 9 / 10);
    }

    @ParameterizedTest
    @CsvSource({"0", "90", "33"})
    void decisionsAndRays(double heading) {
        SplittableRandom random = new SplittableRandom(101 + (long) heading);
        int hits = 0;
        int rays = 0;
        for (int k = 0; k < PAIRS; k++) {
            GridObject grid = grid(random, heading);
            ObjectGroup group = group(grid);
            GeometryObject other = other(k, random);
            String as = "%s, %s beside %s".formatted(grid, grid.occupied(), other);
            boolean truth = CollisionDetection.intersects(group, other);
            assertThat(CollisionDetection.intersects(grid, other)).as(as).isEqualTo(truth);
            assertThat(CollisionDetection.intersects(other, grid)).as(as).isEqualTo(truth);
            hits += truth ? 1 : 0;
            Point start = new Point(random.nextInt(-12, 13) / 4.0, random.nextDouble(-1, 1), random.nextDouble(-4, 4));
            Ray ray = new Ray(start, new Point(random.nextInt(-2, 3), random.nextDouble(-0.3, 0.3), 1));
            double distance = CollisionDetection.rayDistance(ray, group);
            assertThat(CollisionDetection.rayDistance(ray, grid))
                    .as("%s from %s", ray, grid)
                    .isEqualTo(distance);
            rays += distance < Double.POSITIVE_INFINITY ? 1 : 0;
        }
        assertThat(hits).isBetween(PAIRS / 10, PAIRS * 9 / 10);
        assertThat(rays).isBetween(PAIRS / 20, PAIRS * 9 / 10);
    }
}
