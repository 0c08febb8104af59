package robosim.geometry.report.speed;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Pairs of objects about one unit large that are apart, or deep in each other, by about what is asked; or just touch. */
final class PairMaker {
    /** What meets what, and how it is seen. */
    enum Family {
        DISC_DISC("disc and disc", Dimension.PLANAR),
        BOX_DISC("turned box and disc", Dimension.PLANAR),
        BOX_BOX("turned boxes", Dimension.PLANAR),
        CYLINDER_BOX("upright cylinder and box", Dimension.SPATIAL),
        BALL_BALL("spheres", Dimension.SPATIAL),
        TURNED_TURNED("boxes in any attitude", Dimension.SPATIAL);

        final String text;
        final Dimension dimension;

        Family(String text, Dimension dimension) {
            this.text = text;
            this.dimension = dimension;
        }
    }

    /** Two objects and how far they truly are apart. */
    record Pair(GeometryObject a, GeometryObject b, BigDecimal gap) {}

    private static final int STEPS = 40;

    private final Family family;
    private final SplittableRandom random;
    private final Touching touching;

    PairMaker(Family family, SplittableRandom random) {
        this.family = family;
        this.random = random;
        touching = new Touching(random);
    }

    /** A pair that is apart by a gap, or deep in each other where that is below 0, as well as doubles can place them. */
    Pair near(double gap) {
        GeometryObject a = first().movedTo(new Point(somewhere(), somewhere(), somewhere()));
        GeometryObject b = second();
        double[] way = direction();
        double from = 0;
        double to = 12;
        double least = Gap.between(a, at(a, way, from, b), family.dimension).doubleValue();
        double most = Gap.between(a, at(a, way, to, b), family.dimension).doubleValue();
        double middle = 0;
        // False position, with halving where one end does not move.
        for (int step = 0; step < STEPS && least < gap; step++) {
            double share = step % 3 == 2 ? 0.5 : (gap - least) / (most - least);
            middle = from + share * (to - from);
            double here =
                    Gap.between(a, at(a, way, middle, b), family.dimension).doubleValue();
            if (Math.abs(here - gap) <= 0.01 * Math.abs(gap) || !(from < middle && middle < to)) {
                break;
            }
            if (here < gap) {
                from = middle;
                least = here;
            } else {
                to = middle;
                most = here;
            }
        }
        GeometryObject placed = at(a, way, middle, b);
        return new Pair(a, placed, Gap.truth(a, placed, family.dimension));
    }

    /** A pair that touches exactly; null where this attempt led to none. */
    @Nullable
    Pair touching() {
        GeometryObject[] two = touching.pair(family);
        BigDecimal gap = Gap.truth(two[0], two[1], family.dimension);
        return gap.signum() == 0 ? new Pair(two[0], two[1], gap) : null;
    }

    private double somewhere() {
        return random.nextDouble(-0.5, 0.5);
    }

    private double size() {
        return random.nextDouble(0.4, 1.6);
    }

    private BoxObject box() {
        return new BoxObject(new Point(), size(), size(), size());
    }

    private double angle() {
        return random.nextDouble(-180, 180);
    }

    private GeometryObject first() {
        return switch (family) {
            case DISC_DISC, CYLINDER_BOX -> new CylinderObject(new Point(), size() / 2, size());
            case BALL_BALL -> new SphereObject(new Point(), size() / 2);
            case BOX_DISC, BOX_BOX -> box().turned(0, angle());
            case TURNED_TURNED -> box().turned(angle(), angle());
        };
    }

    private GeometryObject second() {
        return switch (family) {
            case DISC_DISC, BOX_DISC -> new CylinderObject(new Point(), size() / 2, size());
            case BALL_BALL -> new SphereObject(new Point(), size() / 2);
            case BOX_BOX, CYLINDER_BOX -> box().turned(0, angle());
            case TURNED_TURNED -> box().turned(angle(), angle());
        };
    }

    private double[] direction() {
        double angle = Math.toRadians(angle());
        double rise = family.dimension == Dimension.PLANAR ? 0 : random.nextDouble(-1, 1);
        double level = Math.sqrt(1 - rise * rise);
        return new double[] {level * Math.cos(angle), rise, level * Math.sin(angle)};
    }

    private static GeometryObject at(GeometryObject a, double[] way, double distance, GeometryObject b) {
        Point c = a.center();
        return b.movedTo(new Point(c.x() + way[0] * distance, c.y() + way[1] * distance, c.z() + way[2] * distance));
    }
}
