package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** A world that is asked at another accuracy than its own, now and then, answers about objects as they stand then. */
class LateViewsTest {
    private static final int MOVERS = 24;

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void seeObjectsWhereTheyStand(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(5);
        RandomObjects objects = new RandomObjects(random, 6);
        int hits = 0;
        int asked = 0;
        for (int trial = 0; trial < Effort.cases(12); trial++) {
            Geometry geometry = new Geometry(30, 30, 30, dimension, Accuracy.values()[trial % 5]);
            for (int k = 0; k < MOVERS; k++) {
                geometry.addObjectUnchecked(objects.next().moveable("mover " + k));
            }
            for (int step = 0; step < 40; step++) {
                change(geometry, "mover " + random.nextInt(MOVERS), objects, random);
                if (random.nextInt(3) == 0) {
                    GeometryObject probe = objects.next();
                    Ray ray = new Ray(objects.place(), new Point(random.nextDouble(-1, 1), 0, 1));
                    Accuracy level = Accuracy.values()[random.nextInt(5)];
                    Geometry fresh = new Geometry(30, 30, 30, dimension, level);
                    geometry.objects().forEach(fresh::addObjectUnchecked);
                    boolean isHit = geometry.testObject(probe, level);
                    assertThat(isHit).as("%s %s", level, probe).isEqualTo(fresh.testObject(probe));
                    assertThat(geometry.getRayDistance(ray, 0, 20, 0, level))
                            .as("%s %s", level, ray)
                            .isEqualTo(fresh.getRayDistance(ray, 0, 20, 0));
                    hits += isHit ? 1 : 0;
                    asked++;
                }
            }
        }
        assertThat(hits).isBetween(asked / 10, asked * 9 / 10);
    }

    private static void change(Geometry geometry, String name, RandomObjects objects, SplittableRandom random) {
        if (!geometry.hasObject(name)) {
            geometry.addObjectUnchecked(objects.next().moveable(name));
        } else if (random.nextInt(8) == 0) {
            geometry.removeObject(name);
        } else if (random.nextInt(3) == 0) {
            geometry.simpleTurn(name, random.nextDouble(-60, 60));
        } else {
            geometry.simpleMove(name, random.nextDouble(-2, 2), 0, random.nextDouble(-2, 2));
        }
    }
}
