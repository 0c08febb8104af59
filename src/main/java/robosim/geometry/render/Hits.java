package robosim.geometry.render;

import org.jspecify.annotations.Nullable;

/** Points of surfaces that the rays of a block met, in flat arrays: three numbers each of most. */
final class Hits {
    /** How far above a surface its point is taken, as a share of the coordinates: see {@link ColorCamera}. */
    private static final double ABOVE = 0x1p-47;

    int count;

    /** Where the ray came from, and its unit direction. */
    final double[] from;

    final double[] way;

    /** The point, just above the surface, and the unit normal. */
    final double[] point;

    final double[] normal;

    /** The linear colour there. */
    final double[] color;

    /** The light of the sky and that of lights, in the surface's colour as far as it is scattered. */
    final double[] ambient;

    final double[] direct;
    final @Nullable ShadedSurface[] surface;

    /** The sample to which the light goes, and the share of it that does. */
    final int[] target;

    final double[] weight;

    private final TexturePoint work = new TexturePoint();
    private final double[] found = new double[3];

    Hits(int most) {
        from = new double[3 * most];
        way = new double[3 * most];
        point = new double[3 * most];
        normal = new double[3 * most];
        color = new double[3 * most];
        ambient = new double[3 * most];
        direct = new double[3 * most];
        surface = new ShadedSurface[most];
        target = new int[most];
        weight = new double[most];
    }

    /** Takes a ray for the next point; {@link #add} tells where it ends. */
    int aim(double x, double y, double z, double dx, double dy, double dz) {
        int at = 3 * count;
        from[at] = x;
        from[at + 1] = y;
        from[at + 2] = z;
        way[at] = dx;
        way[at + 1] = dy;
        way[at + 2] = dz;
        return at;
    }

    /** Adds the point at a distance along the ray that was taken last. */
    void add(
            double distance,
            ShadedSurface met,
            int face,
            double[] normals,
            int ray,
            SkyLight sky,
            int sample,
            double share) {
        int k = count++;
        int at = 3 * k;
        double px = from[at] + distance * way[at];
        double py = from[at + 1] + distance * way[at + 1];
        double pz = from[at + 2] + distance * way[at + 2];
        double nx = normals[3 * ray];
        double ny = normals[3 * ray + 1];
        double nz = normals[3 * ray + 2];
        normal[at] = nx;
        normal[at + 1] = ny;
        normal[at + 2] = nz;
        double most = Math.max(
                Math.max(distance, largest(from[at], from[at + 1], from[at + 2])), largest(px, py, pz) + met.size);
        double above = ABOVE * most;
        point[at] = px + nx * above;
        point[at + 1] = py + ny * above;
        point[at + 2] = pz + nz * above;
        surface[k] = met;
        target[k] = sample;
        weight[k] = share;
        if (met.hasPattern()) {
            met.color(px, py, pz, normal, at, face, work, found);
            color[at] = found[0];
            color[at + 1] = found[1];
            color[at + 2] = found[2];
        } else {
            color[at] = met.red;
            color[at + 1] = met.green;
            color[at + 2] = met.blue;
        }
        for (int c = 0; c < 3; c++) {
            ambient[at + c] = sky.ambient(c, ny) * met.diffuse * color[at + c];
            direct[at + c] = 0;
        }
    }

    private static double largest(double x, double y, double z) {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    }

    /** The surface of a point. */
    ShadedSurface at(int k) {
        ShadedSurface met = surface[k];
        if (met == null) {
            throw new AssertionError("a point has a surface");
        }
        return met;
    }
}
