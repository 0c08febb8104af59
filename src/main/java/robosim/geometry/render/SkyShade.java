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

    /** How often the neighbours of pixels are added up: twice along rows and columns. */
    static final int PASSES = 4;

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

    /**
     * How many rays asked for the sky, and in each of three components how much of its light they found, where one that found
     * the sky counts 1: of a pixel, and later of those around it.
     */
    private float[] asked = new float[0];

    private float[] found = new float[0];

    /** The same, half way from a pixel to those around it. */
    private float[] askedAlong = new float[0];

    private float[] foundAlong = new float[0];

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
            asked = new float[count];
            found = new float[3 * count];
            askedAlong = new float[count];
            foundAlong = new float[3 * count];
        }
        Arrays.fill(normal, 0);
        Arrays.fill(asked, 0);
        Arrays.fill(found, 0);
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
            find(at, 1, 1, 1);
        }
    }

    /** Notes light that a ray found, as a share of that of the sky. */
    void find(int at, double red, double green, double blue) {
        found[3 * at] += (float) red;
        found[3 * at + 1] += (float) green;
        found[3 * at + 2] += (float) blue;
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
     * Adds up, for each pixel of a row, what was asked and found by its neighbours on the same surface: in even passes those
     * in its row, in odd ones those in its column. All rows are done before the next pass begins.
     *
     * @param pass from 0; after {@link #PASSES}, near neighbours count more than far ones, so that no step is seen where one
     *             enters or leaves
     */
    void gather(int pass, int row) {
        boolean isAlong = pass % 2 == 0;
        int step = isAlong ? 1 : width;
        // As many neighbours as a square is wide, which is even: one more on one side, and then on the other.
        int before = pass < 2 ? SIDE / 2 : SIDE / 2 - 1;
        int after = SIDE - 1 - before;
        float[] fromAsked = isAlong ? asked : askedAlong;
        float[] fromFound = isAlong ? found : foundAlong;
        float[] toAsked = isAlong ? askedAlong : asked;
        float[] toFound = isAlong ? foundAlong : found;
        for (int column = 0; column < width; column++) {
            int at = row * width + column;
            int place = isAlong ? column : row;
            int first = at - step * Math.min(before, place);
            int last = at + step * Math.min(after, (isAlong ? width : height) - 1 - place);
            float nx = normal[3 * at];
            float ny = normal[3 * at + 1];
            float nz = normal[3 * at + 2];
            float px = point[3 * at];
            float py = point[3 * at + 1];
            float pz = point[3 * at + 2];
            // A pixel covers more of a surface that is seen from the side, but along the surface.
            float apart = APART * pixel * (float) Math.sqrt(px * px + py * py + pz * pz);
            float asking = 0;
            float red = 0;
            float green = 0;
            float blue = 0;
            for (int other = first; other <= last; other += step) {
                int k = 3 * other;
                float alike = nx * normal[k] + ny * normal[k + 1] + nz * normal[k + 2];
                float away = nx * (point[k] - px) + ny * (point[k + 1] - py) + nz * (point[k + 2] - pz);
                if (alike > ALIKE && Math.abs(away) < apart) {
                    asking += fromAsked[other];
                    red += fromFound[k];
                    green += fromFound[k + 1];
                    blue += fromFound[k + 2];
                }
            }
            toAsked[at] = asking; // whole numbers below 2^24, so exact
            toFound[3 * at] = red;
            toFound[3 * at + 1] = green;
            toFound[3 * at + 2] = blue;
        }
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
            out[at] = component(at, 0) << 16 | component(at, 1) << 8 | component(at, 2);
        }
    }

    private int component(int at, int c) {
        double share = asked[at] == 0 ? 1 : (double) found[3 * at + c] / asked[at];
        return Color.component(light[3 * at + c] + share * sky[3 * at + c]);
    }
}
