package robosim.geometry.render;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;

/** Lights the points of a block, as far as the ways to the lights are free. */
final class Illuminator {
    private static final int RAY = 7;

    private final Geometry world;
    private double[] rays = new double[0];
    private int[] asker = new int[0];
    private double[] carried = new double[0];
    private long[] free = new long[0];
    private Runnable pause = () -> {};

    Illuminator(Geometry world) {
        this.world = world;
    }

    /** Runs something between two parts of the work. */
    void pausing(Runnable between) {
        pause = between;
    }

    private void freeRays(int count) {
        pause.run();
        world.freeRays(rays, count, free);
    }

    /** Makes room for the points of a block. */
    void reserve(int most) {
        if (asker.length < most) {
            rays = new double[RAY * most];
            asker = new int[most];
            carried = new double[3 * most];
            free = new long[most / Long.SIZE + 1];
        }
    }

    /** Adds the light of a beam to all points that it reaches. */
    void addLight(Hits hits, PixelBeam beam) {
        int count = 0;
        for (int k = 0; k < hits.count; k++) {
            int at = 3 * k;
            if (beam.reaches(hits.point, hits.normal, at)) {
                ray(count, k, hits, beam.wayX, beam.wayY, beam.wayZ, beam.distance);
                carry(hits, k, beam, 3 * count);
                count++;
            }
        }
        if (beam.hasShadows) {
            freeRays(count);
        }
        for (int j = 0; j < count; j++) {
            if (!beam.hasShadows || isFree(j)) {
                int at = 3 * asker[j];
                hits.direct[at] += carried[3 * j];
                hits.direct[at + 1] += carried[3 * j + 1];
                hits.direct[at + 2] += carried[3 * j + 2];
            }
        }
    }

    private void ray(int count, int k, Hits hits, double dx, double dy, double dz, double range) {
        int at = RAY * count;
        rays[at] = hits.point[3 * k];
        rays[at + 1] = hits.point[3 * k + 1];
        rays[at + 2] = hits.point[3 * k + 2];
        rays[at + 3] = dx;
        rays[at + 4] = dy;
        rays[at + 5] = dz;
        rays[at + 6] = range;
        asker[count] = k;
    }

    /** Takes a ray of a point into a direction for one of those that are asked together. */
    void askSky(int count, int k, Hits hits, int way, double reach) {
        ray(count, k, hits, 0, 0, 0, reach);
        SkyRays.way(way, hits.normal, 3 * k, rays, RAY * count + 3);
    }

    /** Answers so many rays that were taken. */
    void look(int count) {
        freeRays(count);
    }

    /** Writes a ray that was taken: its start, its direction and its range. */
    void ray(int ray, double[] out, int at) {
        System.arraycopy(rays, RAY * ray, out, at, RAY);
    }

    /** The point of a ray. */
    int asker(int ray) {
        return asker[ray];
    }

    /** Whether a ray met nothing. */
    boolean isFree(int k) {
        return (free[k / Long.SIZE] >>> k & 1) == 1;
    }

    /** What a point makes of the light: some is scattered in its colour, some goes on about the mirrored direction. */
    private void carry(Hits hits, int k, PixelBeam beam, int to) {
        int at = 3 * k;
        ShadedSurface met = hits.at(k);
        double highlight = 0;
        if (met.specular > 0) {
            double nx = hits.normal[at];
            double ny = hits.normal[at + 1];
            double nz = hits.normal[at + 2];
            double facing = 2 * (nx * beam.wayX + ny * beam.wayY + nz * beam.wayZ);
            double along = -((facing * nx - beam.wayX) * hits.way[at]
                    + (facing * ny - beam.wayY) * hits.way[at + 1]
                    + (facing * nz - beam.wayZ) * hits.way[at + 2]);
            highlight = met.specular * PortablePowers.of(Math.min(1, along), met.shininess);
        }
        carried[to] = beam.red * beam.strength * (met.diffuse * hits.color[at] + highlight);
        carried[to + 1] = beam.green * beam.strength * (met.diffuse * hits.color[at + 1] + highlight);
        carried[to + 2] = beam.blue * beam.strength * (met.diffuse * hits.color[at + 2] + highlight);
    }

    /**
     * Darkens the light of the sky by what hides it nearby.
     *
     * @param first  by point, the number of its first direction
     * @param rounds how many directions each point looks into
     */
    void hideSky(Hits hits, int[] first, int rounds, double reach) {
        int[] seen = asker; // not needed for its own purpose: each point asks once a round
        Arrays.fill(seen, 0, hits.count, 0);
        for (int round = 0; round < rounds; round++) {
            for (int k = 0; k < hits.count; k++) {
                int at = RAY * k;
                System.arraycopy(hits.point, 3 * k, rays, at, 3);
                SkyRays.way(first[k] + round, hits.normal, 3 * k, rays, at + 3);
                rays[at + 6] = reach;
            }
            freeRays(hits.count);
            for (int k = 0; k < hits.count; k++) {
                seen[k] += isFree(k) ? 1 : 0;
            }
        }
        for (int k = 0; k < hits.count; k++) {
            double share = (double) seen[k] / rounds;
            hits.ambient[3 * k] *= share;
            hits.ambient[3 * k + 1] *= share;
            hits.ambient[3 * k + 2] *= share;
        }
    }

    /**
     * Looks back from points to where they were seen from, and tells the bit of each that is seen indeed.
     *
     * @param ignored the object that carries the camera; null for none
     * @param asked   by point, whether it is of interest; all others are taken for seen
     */
    void lookBack(Hits hits, @Nullable String ignored, boolean[] asked, boolean[] seen) {
        int count = 0;
        for (int k = 0; k < hits.count; k++) {
            seen[k] = true;
            if (asked[k]) {
                int at = 3 * k;
                double dx = hits.from[at] - hits.point[at];
                double dy = hits.from[at + 1] - hits.point[at + 1];
                double dz = hits.from[at + 2] - hits.point[at + 2];
                double distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
                seen[k] = false;
                if (distance > 0) {
                    ray(count++, k, hits, dx, dy, dz, distance);
                }
            }
        }
        if (ignored == null) {
            freeRays(count);
        } else {
            pause.run();
            world.freeRays(rays, count, ignored, free);
        }
        for (int j = 0; j < count; j++) {
            seen[asker[j]] = isFree(j);
        }
    }
}
