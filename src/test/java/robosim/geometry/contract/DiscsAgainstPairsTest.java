package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Geometry;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/**
 * An upright cylinder in a flat world, which is asked about more quickly than all else, against the same question about each
 * pair. All are of one height, so that pairs meet in space where they meet on the plane.
 */
class DiscsAgainstPairsTest {
    private static final double WORLD = 0x1p22;

    private final List<GeometryObject> objects = new ArrayList<>();
    private double middle;
    private double spread;

    @ParameterizedTest
    @CsvSource({
        // A single tile, tiles with short lists, crowds in divided tiles, and what moves beside the tree and in it.
        "4, 0, 0, 6",
        "100, 0, 0, 40",
        "100, 1e6, 0, 40",
        "2000, 0, 0, 160",
        "600, 0, 0, 30",
        "100, 0, 3, 40",
        "100, -1e6, 40, 40"
    })
    void touchesWhatPairsTouch(int count, double place, int movers, double width) {
        SplittableRandom random = new SplittableRandom(count + movers + (long) place);
        middle = place;
        spread = width;
        Geometry world = new Geometry(WORLD, 4, WORLD, Dimension.PLANAR, Accuracy.EXACT);
        for (int k = 0; k < count; k++) {
            GeometryObject object = k < movers ? disc(random, 0.5).moveable("mover " + k) : object(random, k);
            assertThat(world.addObjectUnchecked(object)).isTrue();
            objects.add(object);
        }
        int hits = 0;
        int questions = 3000;
        for (int k = 0; k < questions; k++) {
            GeometryObject disc = random.nextInt(3) == 0 ? touching(random) : disc(random, radius(random));
            boolean truth = meetsAny(disc, -1);
            assertThat(world.testObject(disc)).as("%s among %d", disc, count).isEqualTo(truth);
            hits += truth ? 1 : 0;
        }
        assertThat(hits).isBetween(questions / 10, questions * 9 / 10);
        int placed = 0;
        for (int k = 0; k < movers; k++) {
            Point to = objects.get(k).center();
            Point near = new Point(to.x() + random.nextInt(-1, 2) * 0.125, 0, to.z());
            boolean isFree = !meetsAny(objects.get(k).movedTo(near), k);
            boolean isPlaced = world.placeObject("mover " + k, near, 0);
            // What it touches where it is may spare what it touches there.
            if (isFree || !meetsAny(objects.get(k), k)) {
                assertThat(isPlaced).as("mover %d", k).isEqualTo(isFree);
            }
            if (isPlaced) {
                objects.set(k, objects.get(k).movedTo(near));
                placed++;
            }
        }
        assertThat(placed).isBetween(Math.min(1, movers), movers);
    }

    /** The square about a disc meets the box, the disc does not: it counts as what stands for it at the level that is asked. */
    @Test
    void isCoarseWhereTheQuestionIs() {
        Geometry world = new Geometry(64, 4, 64, Dimension.PLANAR, Accuracy.EXACT);
        assertThat(world.addObject(new BoxObject(new Point(1, 0, 1), 0.5, 1, 0.5)))
                .isTrue();
        CylinderObject disc = new CylinderObject(new Point(), 0.875, 1);
        assertThat(world.testObject(disc)).isFalse();
        assertThat(world.testObject(disc, Accuracy.EXACT)).isFalse();
        assertThat(world.testObject(disc, Accuracy.AABB)).isTrue();
    }

    private boolean meetsAny(GeometryObject object, int but) {
        for (int k = 0; k < objects.size(); k++) {
            if (k != but && CollisionDetection.intersects(object, objects.get(k))) {
                return true;
            }
        }
        return false;
    }

    private double radius(SplittableRandom random) {
        int kind = random.nextInt(40);
        return kind == 0 ? 1e5 : kind < 3 ? spread / 5 : random.nextInt(3) * 0.25;
    }

    /** Half of them on a grid, where they touch exactly. */
    private double place(SplittableRandom random, double width) {
        double place = random.nextDouble(-width / 2, width / 2);
        return random.nextBoolean() ? Math.rint(4 * place) / 4 : place;
    }

    private CylinderObject disc(SplittableRandom random, double radius) {
        // Some of the largest end among the others.
        double aside = radius > spread && random.nextBoolean() ? radius + place(random, spread) : 0;
        return new CylinderObject(
                new Point(middle + aside + place(random, 1.5 * spread), 0, place(random, 1.5 * spread)), radius, 1);
    }

    private GeometryObject object(SplittableRandom random, int k) {
        // Crowds, and one in 30 much larger than the others.
        double width = random.nextInt(3) == 0 ? spread / 8 : spread;
        Point center = new Point(middle + place(random, width), 0, place(random, width));
        if (random.nextInt(3) == 0) {
            return new CylinderObject(center, random.nextInt(4) * 0.25, 1);
        }
        double heading = random.nextBoolean() ? 90 * random.nextInt(4) : random.nextDouble(-180, 180);
        double length = k % 30 == 0 ? spread / 2 : random.nextInt(5) * 0.5;
        return new BoxObject(center, length, 1, random.nextInt(3) * 0.5).at(Pose.of(center, heading));
    }

    /** A disc that touches an object's corner or side, or nearly. */
    private GeometryObject touching(SplittableRandom random) {
        GeometryObject object = objects.get(random.nextInt(objects.size()));
        double reach = object instanceof BoxObject box ? box.width() / 2 : ((CylinderObject) object).radius();
        double radius = random.nextInt(1, 4) * 0.25;
        Point c = object.center();
        double x = c.x() + reach + radius;
        x = random.nextBoolean() ? x : random.nextBoolean() ? Math.nextUp(x) : Math.nextDown(x);
        return new CylinderObject(new Point(x, 0, c.z()), radius, 1);
    }
}
