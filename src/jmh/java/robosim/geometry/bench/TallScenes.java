package robosim.geometry.bench;

import java.util.SplittableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/**
 * Shelves: 100,000 boards and drums in columns of so many levels, a unit from one to the next, so that higher is narrower.
 * What is asked at any height should cost as much as on the ground. All fits the third cache, more or less.
 */
@State(Scope.Thread)
public class TallScenes {
    private static final int OBJECTS = 100_000;
    private static final int QUESTIONS = 4096;
    private static final double RANGE = 100;
    private static final double SPACING = 8;

    /** Levels to a column. */
    @Param({"1", "10", "100", "1000"})
    public int levels;

    private final SplittableRandom random = new SplittableRandom(8);
    private final Ray[] level = new Ray[QUESTIONS];
    private final Ray[] aslant = new Ray[QUESTIONS];
    private final GeometryObject[] probes = new GeometryObject[QUESTIONS];
    private Geometry geometry;
    private double side;
    private int next;

    /** Builds them, the same from run to run. */
    @Setup
    public void build() {
        int row = (int) Math.ceil(Math.sqrt((double) OBJECTS / levels));
        side = row * SPACING;
        geometry = new Geometry(side + 20, levels + 20, side + 20);
        for (int k = 0; k < OBJECTS; k++) {
            int column = k / levels;
            double x = (column % row + 0.5) * SPACING - side / 2;
            double z = (column / row + 0.5) * SPACING - side / 2;
            Point place = new Point(x, k % levels + 0.5 - levels / 2.0, z);
            geometry.addObjectUnchecked(
                    random.nextInt(3) > 0
                            ? new BoxObject(place, random.nextDouble(2, 6), 0.2, random.nextDouble(1, 4))
                                    .turned(0, column % 2 * 17.0)
                            : new CylinderObject(place, random.nextDouble(0.5, 2), 0.6));
        }
        for (int k = 0; k < QUESTIONS; k++) {
            double angle = random.nextDouble(2 * Math.PI);
            double x = StrictMath.cos(angle);
            double z = StrictMath.sin(angle);
            level[k] = new Ray(place(), new Point(x, 0, z));
            aslant[k] = new Ray(place(), new Point(x, random.nextDouble(-1, 1), z));
            probes[k] = new SphereObject(place(), 0.3);
        }
        for (int k = 0; k < 16; k++) {
            geometry.addObjectUnchecked(new CylinderObject(place(), 0.2, 0.1).moveable("robot " + k));
        }
    }

    private Point place() {
        return new Point(
                random.nextDouble(-side / 2, side / 2),
                random.nextDouble(-levels / 2.0, levels / 2.0),
                random.nextDouble(-side / 2, side / 2));
    }

    private int next() {
        return next++ & (QUESTIONS - 1);
    }

    /** A level ray. */
    @Benchmark
    public double levelRay() {
        return geometry.getRayDistance(level[next()], 0, RANGE, 0);
    }

    /** A ray that climbs or falls by up to 45 degrees. */
    @Benchmark
    public double ray() {
        return geometry.getRayDistance(aslant[next()], 0, RANGE, 0);
    }

    /** A sonar's cone of 15 degrees. */
    @Benchmark
    public double cone() {
        return geometry.getRayDistance(aslant[next()], 0, 30, 15);
    }

    /** Whether a ball would touch anything. */
    @Benchmark
    public boolean overlap() {
        return geometry.testObject(probes[next()]);
    }

    /** A robot's step, there or back. */
    @Benchmark
    public boolean move() {
        int k = next();
        return geometry.simpleMove("robot " + (k & 15), (k & 16) == 0 ? 0.1 : -0.1, 0, 0);
    }
}
