package robosim.geometry.viewer.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.viewer.scene.Scene;

class PickerTest {
    private static Scene.Thing thing(GeometryObject object) {
        return new Scene.Thing(object, null);
    }

    private static boolean hits(GeometryObject object, double x, double z) {
        return Picker.at(List.of(thing(object)), x, z, 0) != null;
    }

    /** A map lies under everything and over most of the floor, which is free. */
    @Test
    void aGridIsPickedAtItsCellsAlone() {
        BitSet cells = new BitSet();
        cells.set(1, 3); // of the first row of three
        cells.set(8);
        GeometryObject map = new GridObject(new Point(), 1, 2, 3, 3, cells).named("map");
        GeometryObject robot = new CylinderObject(new Point(1, 0, -1), 0.2, 1).moveable("robot");
        List<Scene.Thing> things = List.of(thing(map), thing(robot));
        assertThat(Picker.at(things, 0, -1, 0)).isEqualTo(map);
        assertThat(Picker.at(things, 1, -1, 0)).isEqualTo(robot);
        assertThat(Picker.at(things, 1.4, 1.4, 0)).isEqualTo(map);
        assertThat(Picker.at(things, 0, 0, 0)).isNull();
        assertThat(Picker.at(things, 0, -0.4, 0.2)).isEqualTo(map);
        assertThat(Picker.at(things, 0, -0.2, 0.2)).isNull();
    }

    @Test
    void aHitIsWhatTheEngineSaysToo() {
        SplittableRandom random = new SplittableRandom(4);
        List<GeometryObject> shapes = List.of(
                new BoxObject(new Point(), 3, 1, 1).turned(0, 30),
                new BoxObject(new Point(), 3, 2, 1).turned(40, 20),
                new CylinderObject(new Point(), 1.5, 1),
                new CylinderObject(new Point(), 0.5, 3).turned(90, 45),
                new SphereObject(new Point(1, 0, 1), 0.8),
                new ObjectGroup(List.of(
                        new BoxObject(new Point(-1, 0, 0), 1, 1, 1), new SphereObject(new Point(1, 0, 0), 0.7))));
        int hit = 0;
        for (GeometryObject shape : shapes) {
            Geometry geometry = new Geometry(20, 20, 20, Dimension.PLANAR, robosim.geometry.model.Accuracy.EXACT);
            geometry.addObject(shape);
            for (int k = 0; k < 400; k++) {
                double x = random.nextDouble(-2.5, 2.5);
                double z = random.nextDouble(-2.5, 2.5);
                boolean inside = geometry.testObject(new SphereObject(new Point(x, 0, z), 1e-3));
                boolean outside = !geometry.testObject(new SphereObject(new Point(x, 0, z), 2e-2));
                if (outside) {
                    assertThat(hits(shape, x, z))
                            .as("%s at %s, %s", shape, x, z)
                            .isFalse();
                } else if (geometry.testObject(new SphereObject(new Point(x, 0, z), 0)) && inside) {
                    assertThat(hits(shape, x, z))
                            .as("%s at %s, %s", shape, x, z)
                            .isTrue();
                    hit++;
                }
            }
        }
        assertThat(hit).isBetween(300, 1500);
    }

    @Test
    void robotsAreOnTop() {
        GeometryObject floor = new BoxObject(new Point(), 4, 1, 4).named("floor");
        GeometryObject table = new BoxObject(new Point(), 2, 1, 2).named("table");
        GeometryObject robot = new CylinderObject(new Point(0.5, 0, 0), 0.5, 1).moveable("robot");
        List<Scene.Thing> things = List.of(thing(robot), thing(floor), thing(table));
        assertThat(Picker.at(things, 0.5, 0, 0.1)).isEqualTo(robot);
        assertThat(Picker.at(things, -0.5, 0, 0.1)).isEqualTo(table);
        assertThat(Picker.at(things, -1.8, 0, 0.1)).isEqualTo(floor);
        assertThat(Picker.at(things, 2.05, 0, 0.1)).isEqualTo(floor);
        assertThat(Picker.at(things, 2.2, 0, 0.1)).isNull();
        // A miss of the robot by little is a hit of what is below it.
        assertThat(Picker.at(things, 1.05, 0, 0.1)).isEqualTo(floor);
    }

    @Test
    void whatIsThinIsFoundNearby() {
        GeometryObject line = new BoxObject(new Point(), 0, 1, 5).named("line");
        GeometryObject robot = new CylinderObject(new Point(0.3, 0, 0), 0.2, 1).moveable("robot");
        List<Scene.Thing> things = List.of(thing(line), thing(robot));
        assertThat(Picker.at(things, -0.05, 1, 0.1)).isEqualTo(line);
        assertThat(Picker.at(things, -0.2, 1, 0.1)).isNull();
        // Between two that are missed, the one that moves goes first where it is not much farther.
        assertThat(Picker.at(things, 0.05, 0, 0.1)).isEqualTo(robot);
    }
}
