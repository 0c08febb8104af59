package robosim.geometry.world.mesh;

import robosim.geometry.model.Point;

/** An affine transform: three rows of four numbers. */
final class AffineTransform {
    static final AffineTransform NONE = new AffineTransform(new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});

    private final double[] m;

    /** Takes over the rows. */
    AffineTransform(double[] rows) {
        m = rows;
    }

    static AffineTransform scaled(double x, double y, double z) {
        return new AffineTransform(new double[] {x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0});
    }

    static AffineTransform moved(double x, double y, double z) {
        return new AffineTransform(new double[] {1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z});
    }

    /** The rotation by a quaternion of any size but zero; a half turn about an axis of coordinates is exact. */
    static AffineTransform quaternion(double qx, double qy, double qz, double qw) {
        double size = Math.max(Math.max(Math.abs(qx), Math.abs(qy)), Math.max(Math.abs(qz), Math.abs(qw)));
        if (!(size > 0)) {
            throw new IllegalArgumentException("a rotation must not be zero (got: 0, 0, 0, 0)");
        }
        double x = qx / size; // so that no square over- or underflows
        double y = qy / size;
        double z = qz / size;
        double w = qw / size;
        double twice = 2 / (x * x + y * y + z * z + w * w);
        return new AffineTransform(new double[] {
            1 - twice * (y * y + z * z),
            twice * (x * y - z * w),
            twice * (x * z + y * w),
            0,
            twice * (x * y + z * w),
            1 - twice * (x * x + z * z),
            twice * (y * z - x * w),
            0,
            twice * (x * z - y * w),
            twice * (y * z + x * w),
            1 - twice * (x * x + y * y),
            0
        });
    }

    /** First the inner one, then this. */
    AffineTransform then(AffineTransform inner) {
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
        return new AffineTransform(product);
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
