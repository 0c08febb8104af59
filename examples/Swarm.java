import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * A thousand robots in a hall with pillars: each drives on, and turns where something is in its way. No two ever touch,
 * since a move that would make them is refused. At the end that is checked by asking every pair, in exact arithmetic and
 * without the module.
 *
 * <pre>
 * java -cp target/classes examples/Swarm.java
 * java -cp target/classes examples/Swarm.java ROBOTS STEPS SEED
 * </pre>
 */
public final class Swarm {
    private static final double STRIDE = 0.1;

    private Swarm() {}

    /** Moves the swarm; ends with exit code 1 where two robots overlap at the end. */
    public static void main(String[] args) {
        int robots = args.length > 0 ? Integer.parseInt(args[0]) : 1000;
        int steps = args.length > 1 ? Integer.parseInt(args[1]) : 1000;
        SplittableRandom random = new SplittableRandom(args.length > 2 ? Long.parseLong(args[2]) : 1);

        // About one robot on two square units; half as many more robots make it a crowd.
        double side = Math.max(10, Math.sqrt(2.0 * robots));
        Geometry geometry = new Geometry(side, 10, side, Dimension.PLANAR, Accuracy.EXACT);
        fill(geometry, robots / 20, 0.4, side, random, null);
        fill(geometry, robots, 0.25, side, random, "robot ");
        String[] names = new String[robots];
        for (int k = 0; k < robots; k++) {
            names[k] = "robot " + k;
        }
        List<GeometryObject> before = geometry.objects();

        long made = 0;
        long refused = 0;
        long start = System.nanoTime();
        for (int step = 0; step < steps; step++) {
            for (String name : names) {
                if (geometry.simpleMove(name, STRIDE, 0, 0)) {
                    made++;
                } else {
                    refused++;
                    geometry.simpleTurn(name, random.nextDouble(-180, 180));
                }
            }
        }
        double seconds = (System.nanoTime() - start) * 1e-9;
        System.out.printf(
                Locale.ROOT,
                "%,d robots, %,d steps: %,d moves made, %,d refused; in a second %,.0f made and %,.0f refused%n",
                robots,
                steps,
                made,
                refused,
                made / seconds,
                refused / seconds);

        List<GeometryObject> after = geometry.objects();
        double way = 0;
        for (int k = 0; k < after.size(); k++) {
            Point a = before.get(k).center();
            Point b = after.get(k).center();
            way += Math.hypot(b.x() - a.x(), b.z() - a.z());
        }
        int overlaps = overlaps(after);
        System.out.printf(
                Locale.ROOT,
                "checked: of %,d pairs %d touch or overlap; a robot is %.1f from where it began, on average%n",
                (long) after.size() * (after.size() - 1) / 2,
                overlaps,
                way / robots);
        if (overlaps > 0) {
            System.exit(1);
        }
    }

    /** Tries places until so many cylinders stand; moveable ones where they are given a name. */
    private static void fill(
            Geometry geometry, int count, double radius, double side, SplittableRandom random, String name) {
        double room = side / 2 - radius;
        int standing = 0;
        while (standing < count) {
            Point place = new Point(random.nextDouble(-room, room), 0, random.nextDouble(-room, room));
            CylinderObject cylinder = new CylinderObject(place, radius, 1).turned(0, random.nextDouble(-180, 180));
            // False where it would touch another or the world's border.
            if (geometry.addObject(name == null ? cylinder : cylinder.moveable(name + standing))) {
                standing++;
            }
        }
    }

    /** How many pairs of cylinders touch or overlap, seen from above: every pair, exactly. */
    private static int overlaps(List<GeometryObject> objects) {
        List<CylinderObject> cylinders = new ArrayList<>();
        for (GeometryObject object : objects) {
            cylinders.add((CylinderObject) object);
        }
        int overlaps = 0;
        for (int i = 0; i < cylinders.size(); i++) {
            for (int k = 0; k < i; k++) {
                CylinderObject a = cylinders.get(i);
                CylinderObject b = cylinders.get(k);
                double rough = Math.hypot(
                        a.center().x() - b.center().x(),
                        a.center().z() - b.center().z());
                boolean far = rough > (a.radius() + b.radius()) * 1.001; // a thousandth is more than any rounding
                overlaps += !far && touch(a, b) ? 1 : 0;
            }
        }
        return overlaps;
    }

    private static boolean touch(CylinderObject a, CylinderObject b) {
        BigDecimal dx = exact(a.center().x()).subtract(exact(b.center().x()));
        BigDecimal dz = exact(a.center().z()).subtract(exact(b.center().z()));
        BigDecimal reach = exact(a.radius()).add(exact(b.radius()));
        return dx.multiply(dx).add(dz.multiply(dz)).compareTo(reach.multiply(reach)) <= 0;
    }

    /** A double is a fraction of powers of two, which decimals can hold without rounding. */
    private static BigDecimal exact(double value) {
        return new BigDecimal(value);
    }
}
