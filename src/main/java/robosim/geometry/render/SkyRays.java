package robosim.geometry.render;

import robosim.geometry.exact.VectorMath;

/**
 * Directions in which the sky is looked for: as many of them around the normal as the cosine of the angle to it makes light
 * from there count. Always the same ones, in an order in which any that follow each other are spread evenly.
 */
final class SkyRays {
    /** A power of two. */
    static final int COUNT = 1024;

    /** Three numbers each: along the two tangents and the normal. */
    private static final double[] WAYS = new double[3 * COUNT];

    static {
        for (int k = 0; k < COUNT; k++) {
            double share = inverted(k, 2); // of the disc below the hemisphere
            double angle = 2 * Math.PI * inverted(k, 3);
            double aside = Math.sqrt(share);
            WAYS[3 * k] = aside * StrictMath.cos(angle);
            WAYS[3 * k + 1] = aside * StrictMath.sin(angle);
            WAYS[3 * k + 2] = Math.sqrt(1 - share);
        }
    }

    private SkyRays() {}

    /** The digits of a number behind the point, in the opposite order (Halton). */
    private static double inverted(int number, int base) {
        double result = 0.5 / COUNT;
        double digit = 1.0 / base;
        for (int left = number; left > 0; left /= base) {
            result += digit * (left % base);
            digit /= base;
        }
        return Math.min(result, 1 - 0x1p-20);
    }

    /** The first direction for a pixel: neighbours have others, and always the same. */
    static int first(int pixel) {
        int mixed = pixel * 0x9e3779b9;
        mixed ^= mixed >>> 15;
        mixed *= 0x85ebca6b;
        return mixed >>> 13;
    }

    /** Writes a direction about a unit normal. */
    static void way(int number, double[] n, int at, double[] out, int to) {
        int k = 3 * (number & (COUNT - 1));
        double nx = n[at];
        double ny = n[at + 1];
        double nz = n[at + 2];
        // Any two tangents: across the axis that is farthest from the normal.
        double tx;
        double ty;
        double tz;
        if (Math.abs(ny) < 0.7) {
            tx = nz;
            ty = 0;
            tz = -nx;
        } else {
            tx = 0;
            ty = -nz;
            tz = ny;
        }
        double length = VectorMath.length(tx, ty, tz);
        tx /= length;
        ty /= length;
        tz /= length;
        double bx = ny * tz - nz * ty;
        double by = nz * tx - nx * tz;
        double bz = nx * ty - ny * tx;
        out[to] = WAYS[k] * tx + WAYS[k + 1] * bx + WAYS[k + 2] * nx;
        out[to + 1] = WAYS[k] * ty + WAYS[k + 1] * by + WAYS[k + 2] * ny;
        out[to + 2] = WAYS[k] * tz + WAYS[k + 1] * bz + WAYS[k + 2] * nz;
    }
}
