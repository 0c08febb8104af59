package robosim.geometry.report.speed;

import static robosim.geometry.reference.Decimals.cross;
import static robosim.geometry.reference.Decimals.dot;
import static robosim.geometry.reference.Decimals.minus;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.DecimalRoot;
import robosim.geometry.reference.Gaps;
import robosim.geometry.report.speed.SignedGap.Shape;

/** The true signed gap of two objects as they are stored: upright boxes and cylinders, spheres, boxes in any attitude. */
final class Gap {
    private static final MathContext DIGITS = new MathContext(60);

    private Gap() {}

    /** Distance, or below 0 the depth. */
    static BigDecimal truth(GeometryObject a, GeometryObject b, Dimension dimension) {
        BigDecimal along = between(a, b, dimension);
        boolean isBoxes = a instanceof BoxObject && b instanceof BoxObject;
        // Beside an edge or a corner no single axis tells how far two boxes are apart.
        return along.signum() > 0 && isBoxes && dimension == Dimension.SPATIAL ? Gaps.distance(a, b, dimension) : along;
    }

    /** The same, but for boxes in any attitude that are apart the greatest gap along one axis. */
    static BigDecimal between(GeometryObject a, GeometryObject b, Dimension dimension) {
        if (dimension == Dimension.PLANAR) {
            return SignedGap.between(shape(a), shape(b));
        }
        if (a instanceof SphereObject one && b instanceof SphereObject other) {
            BigDecimal[] way = minus(exact(a.center()), exact(b.center()));
            return DecimalRoot.of(dot(way, way), DIGITS)
                    .subtract(number(one.radius()))
                    .subtract(number(other.radius()));
        }
        if (a instanceof BoxObject one && b instanceof BoxObject other) {
            return boxes(one, other);
        }
        return upright(a, b);
    }

    private static BigDecimal upright(GeometryObject a, GeometryObject b) {
        BigDecimal aside = SignedGap.between(shape(a), shape(b));
        BigDecimal apart =
                number(a.center().y()).subtract(number(b.center().y())).abs();
        BigDecimal above = apart.subtract(half(height(a))).subtract(half(height(b)));
        if (aside.signum() <= 0 || above.signum() <= 0) {
            return aside.max(above);
        }
        return DecimalRoot.of(aside.multiply(aside).add(above.multiply(above)), DIGITS);
    }

    private static double height(GeometryObject object) {
        return object instanceof BoxObject box ? box.height() : ((CylinderObject) object).height();
    }

    static Shape shape(GeometryObject object) {
        BigDecimal x = number(object.center().x());
        BigDecimal z = number(object.center().z());
        if (object instanceof CylinderObject cylinder) {
            return new Shape(List.<BigDecimal[]>of(new BigDecimal[] {x, z}), number(cylinder.radius()));
        }
        if (!(object instanceof BoxObject box) || Math.abs(object.rotation()[4]) != 1) {
            throw new IllegalArgumentException("must be an upright box or cylinder (got: " + object + ")");
        }
        double[] r = box.rotation();
        List<BigDecimal[]> corners = new ArrayList<>();
        for (int corner = 0; corner < 4; corner++) {
            BigDecimal along = signed(half(box.width()), corner & 1);
            BigDecimal aside = signed(half(box.length()), corner >> 1);
            corners.add(new BigDecimal[] {
                x.add(along.multiply(number(r[0]))).add(aside.multiply(number(r[2]))),
                z.add(along.multiply(number(r[6]))).add(aside.multiply(number(r[8])))
            });
        }
        return new Shape(corners, BigDecimal.ZERO);
    }

    /** The greatest gap along the 15 axes on which two boxes can be told apart. */
    private static BigDecimal boxes(BoxObject a, BoxObject b) {
        BigDecimal[][] ownA = halves(a);
        BigDecimal[][] ownB = halves(b);
        List<BigDecimal[]> axes = new ArrayList<>();
        for (int k = 0; k < 3; k++) {
            axes.add(cross(ownA[k], ownA[(k + 1) % 3]));
            axes.add(cross(ownB[k], ownB[(k + 1) % 3]));
            for (int m = 0; m < 3; m++) {
                axes.add(cross(ownA[k], ownB[m]));
            }
        }
        BigDecimal[] way = minus(exact(b.center()), exact(a.center()));
        BigDecimal most = null;
        for (BigDecimal[] axis : axes) {
            BigDecimal square = dot(axis, axis);
            if (square.signum() == 0) {
                continue;
            }
            BigDecimal gap = dot(way, axis).abs();
            for (int k = 0; k < 3; k++) {
                gap = gap.subtract(dot(ownA[k], axis).abs())
                        .subtract(dot(ownB[k], axis).abs());
            }
            gap = gap.divide(DecimalRoot.of(square, DIGITS), DIGITS);
            most = most == null || gap.compareTo(most) > 0 ? gap : most;
        }
        if (most == null) {
            throw new IllegalArgumentException("boxes must have faces (got: " + a + ", " + b + ")");
        }
        return most;
    }

    /** The three half edges of a box. */
    private static BigDecimal[][] halves(BoxObject box) {
        double[] r = box.rotation();
        double[] sizes = {box.width(), box.height(), box.length()};
        BigDecimal[][] halves = new BigDecimal[3][3];
        for (int axis = 0; axis < 3; axis++) {
            for (int k = 0; k < 3; k++) {
                halves[axis][k] = half(sizes[axis]).multiply(number(r[3 * k + axis]));
            }
        }
        return halves;
    }

    static BigDecimal number(double value) {
        return new BigDecimal(value);
    }

    private static BigDecimal half(double value) {
        return number(value / 2);
    }

    private static BigDecimal signed(BigDecimal value, int bit) {
        return bit == 0 ? value.negate() : value;
    }

    private static BigDecimal[] exact(Point p) {
        return new BigDecimal[] {number(p.x()), number(p.y()), number(p.z())};
    }
}
