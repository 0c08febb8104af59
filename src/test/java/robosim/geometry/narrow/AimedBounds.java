package robosim.geometry.narrow;

import java.math.BigDecimal;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Predicate;
import robosim.geometry.engine.objects.WorldBounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.CylinderCylinder;
import robosim.geometry.reference.Decimals;

/**
 * Filters that a question at random seldom brings to their bound, each asked about what is built so that its roundings add
 * up and contact is within the last bits. Prints how many of their verdicts are wrong by exact decimals; for
 * {@link robosim.geometry.exact.FilterTest}, which runs it with the bounds as they are and with a tenth of them.
 */
public final class AimedBounds {
    private static final int COUNT = 20_000;

    private final SplittableRandom random = new SplittableRandom(77);
    private final Scratch scratch = new Scratch();

    private AimedBounds() {}

    /** Prints a line for each filter: its name and the number of wrong verdicts. */
    public static void main(String[] args) {
        AimedBounds aimed = new AimedBounds();
        Map<String, Predicate<AimedBounds>> filters = new LinkedHashMap<>();
        filters.put("WorldBounds.box", AimedBounds::isBorderWrong);
        filters.put("CylinderCylinder.along", a -> a.isParallelWrong(true));
        filters.put("CylinderCylinder.across", a -> a.isParallelWrong(false));
        filters.forEach((name, isWrong) -> {
            int wrong = 0;
            for (int n = 0; n < COUNT; n++) {
                wrong += isWrong.test(aimed) ? 1 : 0;
            }
            System.out.println(name + " " + wrong);
        });
    }

    // A box at any attitude whose farthest corner is within some last bits of a side of the world.
    private boolean isBorderWrong() {
        double[] row = Rows.box(
                random.nextDouble(),
                0,
                0,
                random.nextDouble(),
                random.nextDouble(),
                random.nextDouble(),
                Rows.rotation(random));
        BigDecimal reach = new BigDecimal(row[0]);
        for (int k = 0; k < 3; k++) {
            reach = reach.add(new BigDecimal(row[3 + k]).multiply(new BigDecimal(Math.abs(row[6 + k]))));
        }
        double half = reach.doubleValue();
        half += random.nextInt(-1, 2) * Math.ulp(half);
        LeafColumn column = new LeafColumn(1);
        column.append(1);
        System.arraycopy(row, 0, column.rows(), 0, Leaf.STRIDE);
        column.setKind(0, LeafKind.BOX);
        boolean truth = reach.compareTo(new BigDecimal(half)) <= 0;
        return new WorldBounds(2 * half, 100, 100, Dimension.SPATIAL).holds(column, 0, 1) != truth;
    }

    // On one stored axis, end to end or side by side.
    private boolean isParallelWrong(boolean isAlong) {
        double[] r = Rows.rotation(random);
        double[] a = Rows.cylinder(
                random.nextDouble(-1, 1),
                random.nextDouble(-1, 1),
                random.nextDouble(-1, 1),
                random.nextDouble(0.1, 1),
                random.nextDouble(0.1, 1),
                r);
        double far = random.nextDouble(1.5, 3);
        int column = isAlong ? 1 : 2;
        double aside = isAlong ? 0.01 : 0;
        double[] b = Rows.cylinder(
                a[0] + far * r[column] + aside * r[0],
                a[1] + far * r[3 + column] + aside * r[3],
                a[2] + far * r[6 + column] + aside * r[6],
                1,
                1,
                r);
        int given = isAlong ? 4 : 3;
        double rest = far - a[given];
        b[given] = rest + random.nextInt(-4, 5) * Math.ulp(rest);
        BigDecimal[] w =
                Decimals.minus(CylinderTwin.decimals(b[0], b[1], b[2]), CylinderTwin.decimals(a[0], a[1], a[2]));
        BigDecimal[] axis = CylinderTwin.decimals(a[7], a[10], a[13]);
        BigDecimal square = Decimals.dot(axis, axis);
        BigDecimal[] cross = Decimals.cross(w, axis);
        BigDecimal heights = new BigDecimal(a[4]).add(new BigDecimal(b[4])).multiply(square);
        BigDecimal radii = new BigDecimal(a[3]).add(new BigDecimal(b[3]));
        boolean truth = Decimals.dot(w, axis).abs().compareTo(heights) <= 0
                && Decimals.dot(cross, cross).compareTo(radii.multiply(radii).multiply(square)) <= 0;
        return CylinderCylinder.touch(
                        new Leaf(LeafKind.CYLINDER, a, 0), new Leaf(LeafKind.CYLINDER, b, 0), scratch.overlap)
                != truth;
    }
}
