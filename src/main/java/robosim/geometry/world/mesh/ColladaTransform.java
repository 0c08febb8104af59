package robosim.geometry.world.mesh;

import robosim.geometry.exact.Degrees;
import robosim.geometry.world.shared.FileProblem;

/** The transforms that COLLADA has elements for. */
final class ColladaTransform {
    private ColladaTransform() {}

    /** Scales, after it turned the axis that points up to Y; an unknown axis is Y, the format's default. */
    static AffineTransform upright(String upAxis, double scale) {
        return new AffineTransform(
                switch (upAxis) {
                    case "X_UP" -> new double[] {0, -scale, 0, 0, scale, 0, 0, 0, 0, 0, scale, 0};
                    case "Z_UP" -> new double[] {scale, 0, 0, 0, 0, 0, scale, 0, 0, -scale, 0, 0};
                    default -> new double[] {scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0};
                });
    }

    /** Whether an element is a transform of a node. */
    static boolean isTransform(ColladaElement element) {
        return switch (element.name) {
            case "matrix", "translate", "rotate", "scale", "lookat", "skew" -> true;
            default -> false;
        };
    }

    /** The transform of an element, which is one. */
    static AffineTransform of(ColladaElement element) throws FileProblem {
        return switch (element.name) {
            case "translate" -> {
                double[] t = element.exactly(3);
                yield new AffineTransform(new double[] {1, 0, 0, t[0], 0, 1, 0, t[1], 0, 0, 1, t[2]});
            }
            case "scale" -> {
                double[] s = element.exactly(3);
                yield new AffineTransform(new double[] {s[0], 0, 0, 0, 0, s[1], 0, 0, 0, 0, s[2], 0});
            }
            case "rotate" -> rotation(element, element.exactly(4));
            case "matrix", "bind_shape_matrix" -> matrix(element.exactly(16));
            default ->
                throw element.wrong("<" + element.name + "> is not supported in a <node>; bake the transforms in the"
                        + " program that made the file (got: <" + element.name + ">)");
        };
    }

    /** The last row of an affine matrix has no meaning. */
    private static AffineTransform matrix(double[] rows) {
        double[] m = new double[12];
        System.arraycopy(rows, 0, m, 0, 12);
        return new AffineTransform(m);
    }

    /** About an axis by degrees, by Rodrigues' formula; quarter turns about the axes of coordinates are exact. */
    private static AffineTransform rotation(ColladaElement element, double[] numbers) throws FileProblem {
        double most = Math.max(Math.abs(numbers[0]), Math.max(Math.abs(numbers[1]), Math.abs(numbers[2])));
        if (most == 0) {
            if (numbers[3] == 0) {
                return AffineTransform.NONE;
            }
            throw element.wrong("the axis of <rotate> must not be zero (got: 0 0 0)");
        }
        double x = numbers[0] / most;
        double y = numbers[1] / most;
        double z = numbers[2] / most;
        double length = Math.sqrt(x * x + y * y + z * z);
        x /= length;
        y /= length;
        z /= length;
        double c = Degrees.cos(numbers[3]);
        double s = Degrees.sin(numbers[3]);
        double v = 1 - c;
        return new AffineTransform(new double[] {
            c + x * x * v,
            x * y * v - z * s,
            x * z * v + y * s,
            0,
            x * y * v + z * s,
            c + y * y * v,
            y * z * v - x * s,
            0,
            x * z * v - y * s,
            y * z * v + x * s,
            c + z * z * v,
            0
        });
    }
}
