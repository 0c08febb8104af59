package robosim.geometry.stress;

import java.util.SplittableRandom;
import robosim.geometry.exact.Orientation;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.reference.Quantity.Arithmetic;
import robosim.geometry.reference.Truth;

/** On which side of a line, or of a plane, a point lies. */
final class OrientationFamily extends Family {
    private final int axes;

    /**
     * @param axes 2 for a line, 3 for a plane; a case is one point more than that
     */
    OrientationFamily(String name, int axes) {
        super(name);
        this.axes = axes;
    }

    @Override
    int product(Case c, Scratch s) {
        double[] p = c.a;
        return axes == 2
                ? Orientation.side(p[0], p[1], p[2], p[3], p[4], p[5])
                : Orientation.volume(p, p[9], p[10], p[11]);
    }

    @Override
    int truth(Case c, Arithmetic n) {
        return axes == 2 ? Truth.side(n, c.a) : Truth.volume(n, c.a);
    }

    @Override
    Source source(SplittableRandom random) {
        return new Source() {
            @Override
            public void random(Case c) {
                for (int k = 0; k < axes * (axes + 1); k++) {
                    c.a[k] = Forms.between(random, 1);
                }
                if (Mixed.isDue(random)) { // one point far nearer to another than to the rest, or all nearly on a line
                    double factor = Mixed.factor(random);
                    int axis = random.nextInt(axes);
                    for (int k = random.nextBoolean() ? axis : axes * axes; k < axes * (axes + 1); k += axes) {
                        c.a[k] *= factor;
                    }
                }
            }

            @Override
            public void adversarial(Case c) {
                dependent(c, random);
            }
        };
    }

    /** The last point in the span of the others, to the last bit, or nearly. */
    private void dependent(Case c, SplittableRandom random) {
        boolean grid = random.nextBoolean();
        int last = axes * axes;
        for (int k = 0; k < last; k++) {
            c.a[k] = grid ? random.nextInt(-8, 9) : Forms.between(random, 1);
            if (random.nextInt(16) == 0) {
                c.a[k] *= StrictMath.pow(10, random.nextInt(-8, 9));
            }
        }
        double s = grid ? random.nextInt(-8, 9) / 4.0 : Forms.between(random, 2);
        double t = axes == 2 ? 0 : grid ? random.nextInt(-8, 9) / 4.0 : Forms.between(random, 2);
        for (int k = 0; k < axes; k++) {
            double p = c.a[k];
            c.a[last + k] = p + s * (c.a[axes + k] - p) + (axes == 2 ? 0 : t * (c.a[2 * axes + k] - p));
        }
        int sort = random.nextInt(10);
        double far = sort == 0 ? 1e6 : sort == 1 ? 1e9 : 0;
        int power = sort == 2 ? 40 : sort == 3 ? -40 : sort == 4 ? -300 : sort == 5 ? -1060 : 0;
        for (int k = 0; k < last + axes; k++) {
            c.a[k] = Math.scalb(c.a[k] + far, power);
        }
        if (random.nextInt(3) != 0) {
            int at = random.nextInt(last + axes);
            c.a[at] =
                    random.nextInt(3) == 0 ? c.a[at] + Forms.tiny(random) : Forms.step(c.a[at], random.nextInt(-2, 3));
        }
    }
}
