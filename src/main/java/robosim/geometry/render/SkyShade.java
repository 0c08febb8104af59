package robosim.geometry.render;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Color;

/**
 * The soft shadows of the sky in a whole picture: of each pixel how many of its rays found the sky, and the mean of that over
 * its neighbours on the same surface. Pixels whose places differ by eight share their directions, and any eight by eight
 * pixels have all of them, so that an even surface is even in the picture.
 *
 * <p>Blocks are written by different threads; the means are taken when all are there.
 */
final class SkyShade {
    /** The side of the squares of pixels that together look in all directions; a power of two. */
    static final int SIDE = 8;

    /** The cosine of the angle between the normals of neighbours that count as one surface. */
    private static final float ALIKE = 0.94f;

    /** How far a neighbour may be from the plane of a pixel, in widths of a pixel. */
    private static final float APART = 3;

    private int width;
    private int height;

    /** The linear light of each pixel without that of the sky, and that of the sky where it is free: three numbers each. */
    private float[] light = new float[0];

    private float[] sky = new float[0];

    /** A point of the surface in a pixel, relative to the eye, and the normal there; a normal of zeros for none. */
    private float[] point = new float[0];

    private float[] normal = new float[0];

    /** How many rays asked for the sky, and how many of them found it. */
    private short[] asked = new short[0];

    private short[] found = new short[0];

    /** The width of a pixel one unit ahead. */
    private float pixel;

    /** Makes room for a picture. */
    void reset(int newWidth, int newHeight, double widthOfPixel) {
        int count = newWidth * newHeight;
        width = newWidth;
        height = newHeight;
        pixel = (float) widthOfPixel;
        if (asked.length != count) {
            light = new float[3 * count];
            sky = new float[3 * count];
            point = new float[3 * count];
            normal = new float[3 * count];
            asked = new short[count];
            found = new short[count];
        }
        Arrays.fill(normal, 0);
        Arrays.fill(asked, (short) 0);
        Arrays.fill(found, (short) 0);
    }

    /** Where the directions of a pixel begin among all, in an order in which parts of the square are spread too. */
    int first(int at) {
        int x = at % width;
        int y = at / width;
        int mixed = x ^ y;
        int cell = 0;
        for (int bit = 1; bit < SIDE; bit *= 2) { // the order of a dither matrix
            cell = cell << 2 | ((mixed & bit) != 0 ? 2 : 0) | ((y & bit) != 0 ? 1 : 0);
        }
        return cell;
    }

    /** Notes a surface in a pixel; the last one counts. */
    void surface(int at, Hits hits, int k) {
        for (int c = 0; c < 3; c++) {
            point[3 * at + c] = (float) (hits.point[3 * k + c] - hits.from[3 * k + c]);
            normal[3 * at + c] = (float) hits.normal[3 * k + c];
        }
    }

    /** Notes a ray that asked for the sky. */
    void ask(int at, boolean isFree) {
        asked[at]++;
        if (isFree) {
            found[at]++;
        }
    }

    /** Notes the light of a pixel. */
    void light(int at, double red, double green, double blue, double skyRed, double skyGreen, double skyBlue) {
        light[3 * at] = (float) red;
        light[3 * at + 1] = (float) green;
        light[3 * at + 2] = (float) blue;
        sky[3 * at] = (float) skyRed;
        sky[3 * at + 1] = (float) skyGreen;
        sky[3 * at + 2] = (float) skyBlue;
    }

    /**
     * Writes a row of the picture.
     *
     * @param only the pixels that are written; null for all
     */
    void resolve(int row, boolean @Nullable [] only, int[] out) {
        for (int at = row * width; at < (row + 1) * width; at++) {
            if (only != null && !only[at]) {
                continue;
            }
            double share = share(at, at - row * width, row);
            out[at] = Color.component(light[3 * at] + share * sky[3 * at]) << 16
                    | Color.component(light[3 * at + 1] + share * sky[3 * at + 1]) << 8
                    | Color.component(light[3 * at + 2] + share * sky[3 * at + 2]);
        }
    }

    private double share(int at, int column, int row) {
        int asking = 0;
        int finding = 0;
        float nx = normal[3 * at];
        float ny = normal[3 * at + 1];
        float nz = normal[3 * at + 2];
        float px = point[3 * at];
        float py = point[3 * at + 1];
        float pz = point[3 * at + 2];
        // A pixel covers more of a surface that is seen from the side, but along the surface.
        float apart = APART * pixel * (float) Math.sqrt(px * px + py * py + pz * pz);
        int top = Math.max(0, row - SIDE / 2);
        int bottom = Math.min(height, row + SIDE / 2);
        int left = Math.max(0, column - SIDE / 2);
        int right = Math.min(width, column + SIDE / 2);
        for (int y = top; y < bottom; y++) {
            for (int other = y * width + left; other < y * width + right; other++) {
                int k = 3 * other;
                float alike = nx * normal[k] + ny * normal[k + 1] + nz * normal[k + 2];
                float away = nx * (point[k] - px) + ny * (point[k + 1] - py) + nz * (point[k + 2] - pz);
                if (alike > ALIKE && Math.abs(away) < apart) {
                    asking += asked[other];
                    finding += found[other];
                }
            }
        }
        return asking == 0 ? 1 : (double) finding / asking;
    }
}
