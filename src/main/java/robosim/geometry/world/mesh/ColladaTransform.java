package robosim.geometry.world.mesh;

import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileProblem;

/** An affine transform of COLLADA: three rows of four numbers. */
final class ColladaTransform {
    static final ColladaTransform NONE = new ColladaTransform(new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});

    private final double[] m;

    private ColladaTransform(double[] m) {
        this.m = m;
    }

    /** Scales, after it turned the axis that points up to Y; an unknown axis is Y, the format's default. */
    static ColladaTransform upright(String upAxis, double scale) {
        return new ColladaTransform(
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
    static ColladaTransform of(ColladaElement element) throws FileProblem {
        return switch (element.name) {
            case "translate" -> {
                double[] t = element.exactly(3);
                yield new ColladaTransform(new double[] {1, 0, 0, t[0], 0, 1, 0, t[1], 0, 0, 1, t[2]});
            }
            case "scale" -> {
                double[] s = element.exactly(3);
                yield new ColladaTransform(new double[] {s[0], 0, 0, 0, 0, s[1], 0, 0, 0, 0, s[2], 0});
            }
            case "rotate" -> rotation(element, element.exactly(4));
            case "matrix", "bind_shape_matrix" -> matrix(element.exactly(16));
            default ->
                throw element.wrong("<" + element.name + "> is not supported in a <node>; bake the transforms in the"
                        + " program that made the file (got: <" + element.name + ">)");
        };
    }

    /** The last row of an affine matrix has no meaning. */
    private static ColladaTransform matrix(double[] rows) {
        double[] m = new double[12];
        System.arraycopy(rows, 0, m, 0, 12);
        return new ColladaTransform(m);
    }

    /** About an axis by degrees, by Rodrigues' formula; quarter turns about the axes of coordinates are exact. */
    private static ColladaTransform rotation(ColladaElement element, double[] numbers) throws FileProblem {
        double most = Math.max(Math.abs(numbers[0]), Math.max(Math.abs(numbers[1]), Math.abs(numbers[2])));
        if (most == 0) {
            if (numbers[3] == 0) {
                return NONE;
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
        return new ColladaTransform(new double[] {
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

    /** First the inner one, then this. */
    ColladaTransform then(ColladaTransform inner) {
        double[] product = new double[12];
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 4; column++) {
                double sum = column == 3 ? m[4 * row + 3] : 0;
                for (int k = 0; k < 3; k++) {
                    sum += m[4 * row + k] * inner.m[4 * k + column];
                }
                product[4 * row + column] = sum;
            }
        }
        return new ColladaTransform(product);
    }

    Point apply(Point p) {
        return new Point(
                m[0] * p.x() + m[1] * p.y() + m[2] * p.z() + m[3],
                m[4] * p.x() + m[5] * p.y() + m[6] * p.z() + m[7],
                m[8] * p.x() + m[9] * p.y() + m[10] * p.z() + m[11]);
    }

    /** Whether faces change their orientation. */
    boolean isMirror() {
        return m[0] * (m[5] * m[10] - m[6] * m[9])
                        - m[1] * (m[4] * m[10] - m[6] * m[8])
                        + m[2] * (m[4] * m[9] - m[5] * m[8])
                < 0;
    }
}
