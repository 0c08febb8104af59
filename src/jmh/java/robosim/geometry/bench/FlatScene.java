package robosim.geometry.bench;

import java.util.List;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/**
 * A {@link Scene} in a planar world, and questions that are asked in turn. An object takes about 250
 * bytes: 100 fit the first cache, 1,000 the second, 10,000 and mostly 100,000 the third, 1,000,000 none; the questions, a
 * third of a megabyte, come in order.
 */
@State(Scope.Thread)
public class FlatScene {
    static final double RANGE = 100;
    private static final int QUESTIONS = 4096;

    /** How many static objects. */
    @Param({"100", "1000", "10000", "100000", "1000000"})
    public int objects;

    Geometry geometry;
    List<GeometryObject> things;
    private final Ray[] rays = new Ray[QUESTIONS];
    private final GeometryObject[] probes = new GeometryObject[QUESTIONS];
    int next;

    /** Builds it, the same from run to run. */
    @Setup
    public void build() {
        Scene scene = new Scene(objects, 2);
        things = scene.objects(objects);
        double world = scene.side() + 20;
        geometry = new Geometry(world, 10, world, Dimension.PLANAR, Accuracy.EXACT);
        things.forEach(geometry::addObjectUnchecked);
        for (int k = 0; k < QUESTIONS; k++) {
            double angle = scene.random().nextDouble(2 * Math.PI);
            rays[k] = new Ray(place(scene), new Point(StrictMath.cos(angle), 0, StrictMath.sin(angle)));
            probes[k] = new CylinderObject(place(scene), 0.5, 1);
        }
    }

    static Point place(Scene scene) {
        return new Point(scene.coordinate(), 0, scene.coordinate());
    }

    Ray ray() {
        return rays[next++ & (QUESTIONS - 1)];
    }

    GeometryObject probe() {
        return probes[next++ & (QUESTIONS - 1)];
    }
}
