package robosim.geometry.render;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.SenseBuffer.Extra;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.material.Color;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SenseOptions.Carrier;

/** Paints pictures of one world block by block, on one thread at a time. */
final class BlockPainter {
    private static final SenseOptions RANGE = SenseOptions.range(0, Double.POSITIVE_INFINITY);

    private final Geometry world;
    private final Surfaces surfaces;
    private final Illuminator illuminator;
    private final SenseBuffer met = new SenseBuffer(Extra.OBJECTS, Extra.NORMALS, Extra.PARTS);

    private @Nullable ColorCamera camera;
    private ColorCamera.@Nullable Pass pass;
    private PixelBeam[] beams = new PixelBeam[0];
    private SkyLight sky = new SkyLight(Sky.NONE);
    private @Nullable Lighting lighting;

    /** Where the shadows of the sky are noted; null if each sample has its own. */
    private @Nullable SkyShade shade;

    // Where the camera is in the world.
    private double ex;
    private double ey;
    private double ez;
    private final double[] rotation = new double[9];

    private int[] pixels = new int[0];

    /** The linear light of each sample. */
    private double[] light = new double[0];

    /** The light of the sky of each sample, as far as that is noted. */
    private double[] skyLight = new double[0];

    private double[] directions = new double[0];
    private Hits hits = new Hits(0);
    private Hits next = new Hits(0);
    private double[] mirrored = new double[0];
    private int[] skyRays = new int[0];
    private boolean[] asked = new boolean[0];
    private boolean[] seen = new boolean[0];
    private Runnable pause = () -> {};

    BlockPainter(Geometry world) {
        this.world = world;
        surfaces = new Surfaces(world);
        illuminator = new Illuminator(world);
    }

    /** Runs something between two parts of a block, of which none has more rays than the block has samples. */
    void pausing(Runnable between) {
        pause = between;
        illuminator.pausing(between);
    }

    boolean isOf(Geometry other) {
        return world == other;
    }

    /** Begins a part of the work on a picture. */
    void begin(ColorCamera by, ColorCamera.Pass part) {
        camera = by;
        pass = part;
        shade = part.shade();
        surfaces.begin();
        Lighting with = by.options().lighting();
        if (!with.equals(lighting)) {
            lighting = with;
            beams = with.lights().stream().map(PixelBeam::new).toArray(PixelBeam[]::new);
            sky = new SkyLight(with.sky());
        }
        Pose place = by.placeIn(world);
        ex = place.center().x();
        ey = place.center().y();
        ez = place.center().z();
        place.rotation(rotation, 0);
        FramePlan plan = part.plan();
        reserve(plan.mostPixels(), plan.samples * plan.samples);
    }

    private void reserve(int most, int samples) {
        int count = most * samples;
        if (pixels.length < most) {
            pixels = new int[most];
        }
        if (asked.length < count) {
            light = new double[3 * count];
            skyLight = new double[3 * count];
            directions = new double[3 * count];
            hits = new Hits(count);
            next = new Hits(count);
            mirrored = new double[7 * count];
            skyRays = new int[count];
            asked = new boolean[count];
            seen = new boolean[count];
        }
        illuminator.reserve(count);
    }

    /** Paints a block into a picture. */
    void paint(int block, int[] out) {
        ColorCamera by = camera;
        ColorCamera.Pass part = pass;
        if (by == null || part == null) {
            throw new IllegalStateException("a picture must have begun (got: none)");
        }
        FramePlan plan = part.plan();
        int count = plan.pixels(block, part.only(), pixels);
        if (count == 0) {
            return;
        }
        int samples = plan.samples * plan.samples;
        RayPattern pattern = plan.pattern(block, part.only(), pixels, count);
        Arrays.fill(light, 0, 3 * count * samples, 0);
        if (shade != null) {
            Arrays.fill(skyLight, 0, 3 * count * samples, 0);
        }
        look(by, pattern);
        for (int depth = 0; hits.count > 0; depth++) {
            illuminate(by.options(), part, samples, depth);
            boolean isLast = depth >= by.options().mirrors();
            askBack(by, isLast, depth);
            int rays = gather(isLast, shade != null && depth == 0 ? skyLight : light);
            pause.run();
            world.castRays(mirrored, rays, met);
            follow(rays);
        }
        resolve(count, samples, out);
    }

    /** What the rays from the camera meet. */
    private void look(ColorCamera by, RayPattern pattern) {
        String carrier = by.carrier();
        if (carrier == null) {
            world.sense(by.pose(), pattern, RANGE, met);
        } else {
            world.sense(
                    carrier, by.pose(), pattern, RANGE.withCarrier(by.options().seen()), met);
        }
        int count = pattern.size();
        pattern.directions(0, count, directions, 0);
        hits.count = 0;
        double[] r = rotation;
        for (int k = 0; k < count; k++) {
            double x = directions[3 * k];
            double y = directions[3 * k + 1];
            double z = directions[3 * k + 2];
            hits.aim(
                    ex,
                    ey,
                    ez,
                    r[0] * x + r[1] * y + r[2] * z,
                    r[3] * x + r[4] * y + r[5] * z,
                    r[6] * x + r[7] * y + r[8] * z);
            take(hits, k, k, 1);
        }
    }

    /** Takes what the ray met that was aimed last. */
    private void take(Hits into, int ray, int sample, double weight) {
        GeometryObject object = met.object(ray);
        if (object == null) {
            sky.addSeen(into.way[3 * into.count + 1], weight, light, 3 * sample);
        } else {
            ShadedSurface surface = surfaces.of(object, met.part(ray));
            into.add(met.distances()[ray], surface, met.face(ray), met.normals(), ray, sky, sample, weight);
        }
    }

    private void illuminate(ColorCamera.Options options, ColorCamera.Pass part, int samples, int depth) {
        for (PixelBeam beam : beams) {
            illuminator.addLight(hits, beam);
        }
        SkyShade smooth = shade;
        if (smooth != null && depth == 0) {
            if (part.only() == null) { // else the sky was asked for the whole pixel
                askSky(smooth, options, samples);
            }
            return;
        }
        int rounds = smooth == null ? options.skyRays() : 1;
        if (rounds > 0) {
            for (int k = 0; k < hits.count; k++) {
                int sample = hits.target[k];
                skyRays[k] = SkyRays.first(pixels[sample / samples] + depth) + sample % samples * rounds;
            }
            illuminator.hideSky(hits, skyRays, rounds, options.skyReach());
        }
    }

    /** Lets some samples of each pixel ask for the sky. */
    private void askSky(SkyShade smooth, ColorCamera.Options options, int samples) {
        for (int k = 0; k < hits.count; k++) {
            // That in the middle of a pixel stands for its surface, or the last one before it, or the first one.
            int sample = hits.target[k];
            boolean isFirst = k == 0 || hits.target[k - 1] / samples != sample / samples;
            if (isFirst || sample % samples <= samples / 2) {
                smooth.surface(pixels[sample / samples], hits, k);
            }
        }
        int rounds = options.smoothRays();
        for (int round = 0; round < rounds; round++) {
            int asking = (2 * round + 1) * samples / (2 * rounds);
            int count = 0;
            for (int k = 0; k < hits.count; k++) {
                int sample = hits.target[k];
                if (sample % samples == asking) {
                    int way = smooth.first(pixels[sample / samples]) * rounds + round;
                    illuminator.askSky(count++, k, hits, way, options.skyReach());
                }
            }
            illuminator.look(count);
            int hidden = 0;
            for (int j = 0; j < count; j++) {
                int k = illuminator.asker(j);
                boolean isFree = illuminator.isFree(j);
                smooth.ask(pixels[hits.target[k] / samples], isFree);
                if (!isFree && options.isIndirect()) {
                    skyRays[hidden] = k;
                    illuminator.ray(j, mirrored, 7 * hidden++);
                }
            }
            if (hidden > 0) {
                bounce(smooth, options, samples, hidden);
            }
        }
    }

    /**
     * Adds the light of the surfaces that hide the sky, which are lit by lights and by the sky as far as the paths to them
     * are free: none comes through a wall.
     *
     * @param hidden how many rays met one; they are in the place of mirrored ones, and their points in that of sky rays
     */
    private void bounce(SkyShade smooth, ColorCamera.Options options, int samples, int hidden) {
        world.castRays(mirrored, hidden, met);
        next.count = 0;
        for (int ray = 0; ray < hidden; ray++) {
            GeometryObject object = met.object(ray);
            aim(next, ray);
            if (object != null) {
                ShadedSurface surface = surfaces.of(object, met.part(ray));
                next.add(met.distances()[ray], surface, met.face(ray), met.normals(), ray, sky, skyRays[ray], 1);
            }
        }
        for (PixelBeam beam : beams) {
            illuminator.addLight(next, beam);
        }
        for (int k = 0; k < next.count; k++) {
            int way = SkyRays.first(pixels[hits.target[next.target[k]] / samples]);
            illuminator.askSky(k, k, next, way, options.skyReach());
        }
        illuminator.look(next.count);
        for (int k = 0; k < next.count; k++) {
            int from = next.target[k];
            double up = hits.normal[3 * from + 1];
            double free = illuminator.isFree(k) ? 1 : 0;
            smooth.find(
                    pixels[hits.target[from] / samples],
                    share(next.direct[3 * k] + free * next.ambient[3 * k], sky.ambient(0, up)),
                    share(next.direct[3 * k + 1] + free * next.ambient[3 * k + 1], sky.ambient(1, up)),
                    share(next.direct[3 * k + 2] + free * next.ambient[3 * k + 2], sky.ambient(2, up)));
        }
    }

    private static double share(double light, double ofSky) {
        return ofSky > 0 ? light / ofSky : 0;
    }

    /** Asks for points that got light, or show a mirror, whether there is an unbroken way to the eye. */
    private void askBack(ColorCamera by, boolean isLast, int depth) {
        boolean isSkyAsked = by.options().skyRays() > 0 || shade != null;
        for (int k = 0; k < hits.count; k++) {
            int at = 3 * k;
            boolean isLit = hits.direct[at] > 0 || hits.direct[at + 1] > 0 || hits.direct[at + 2] > 0;
            asked[k] = isLit || isSkyAsked || (!isLast && hits.at(k).mirror > 0);
        }
        boolean isIgnored = depth == 0 && by.options().seen() == Carrier.IGNORED;
        illuminator.lookBack(hits, isIgnored ? by.carrier() : null, asked, seen);
    }

    /**
     * Adds the light of all points to their samples, and that of the sky to those it is kept with; answers how many mirrored
     * rays go on.
     */
    private int gather(boolean isLast, double[] fromSky) {
        int rays = 0;
        for (int k = 0; k < hits.count; k++) {
            int at = 3 * k;
            int to = 3 * hits.target[k];
            ShadedSurface surface = hits.at(k);
            double mirror = isLast ? 0 : surface.mirror;
            double own = hits.weight[k] * (1 - mirror);
            if (seen[k]) {
                if (fromSky == light) {
                    light[to] += own * (surface.emittedRed + hits.ambient[at] + hits.direct[at]);
                    light[to + 1] += own * (surface.emittedGreen + hits.ambient[at + 1] + hits.direct[at + 1]);
                    light[to + 2] += own * (surface.emittedBlue + hits.ambient[at + 2] + hits.direct[at + 2]);
                } else {
                    light[to] += own * (surface.emittedRed + hits.direct[at]);
                    light[to + 1] += own * (surface.emittedGreen + hits.direct[at + 1]);
                    light[to + 2] += own * (surface.emittedBlue + hits.direct[at + 2]);
                    fromSky[to] += own * hits.ambient[at];
                    fromSky[to + 1] += own * hits.ambient[at + 1];
                    fromSky[to + 2] += own * hits.ambient[at + 2];
                }
                if (mirror > 0) {
                    mirror(k, rays++, mirror);
                }
            } else {
                light[to] += own * surface.emittedRed;
                light[to + 1] += own * surface.emittedGreen;
                light[to + 2] += own * surface.emittedBlue;
            }
        }
        return rays;
    }

    /** Sends a ray on; it keeps the place of its point among all, which has been looked at. */
    private void mirror(int k, int ray, double share) {
        int at = 3 * k;
        double nx = hits.normal[at];
        double ny = hits.normal[at + 1];
        double nz = hits.normal[at + 2];
        double along = 2 * (hits.way[at] * nx + hits.way[at + 1] * ny + hits.way[at + 2] * nz);
        double dx = hits.way[at] - along * nx;
        double dy = hits.way[at + 1] - along * ny;
        double dz = hits.way[at + 2] - along * nz;
        double length = VectorMath.length(dx, dy, dz);
        int to = 7 * ray;
        System.arraycopy(hits.point, at, mirrored, to, 3);
        mirrored[to + 3] = dx / length;
        mirrored[to + 4] = dy / length;
        mirrored[to + 5] = dz / length;
        mirrored[to + 6] = Double.POSITIVE_INFINITY;
        hits.target[ray] = hits.target[k]; // no ray comes before its point
        hits.weight[ray] = hits.weight[k] * share;
    }

    /** Takes what the mirrored rays met for the points to be looked at now. */
    private void follow(int rays) {
        next.count = 0;
        for (int ray = 0; ray < rays; ray++) {
            aim(next, ray);
            take(next, ray, hits.target[ray], hits.weight[ray]);
        }
        Hits done = hits;
        hits = next;
        next = done;
    }

    private void aim(Hits into, int ray) {
        int at = 7 * ray;
        into.aim(
                mirrored[at], mirrored[at + 1], mirrored[at + 2], mirrored[at + 3], mirrored[at + 4], mirrored[at + 5]);
    }

    /** The mean light of the samples of each pixel, in sRGB, or noted for later. */
    private void resolve(int count, int samples, int[] out) {
        double share = 1.0 / samples;
        SkyShade smooth = shade;
        for (int k = 0; k < count; k++) {
            double red = share * sum(light, samples, k, 0);
            double green = share * sum(light, samples, k, 1);
            double blue = share * sum(light, samples, k, 2);
            if (smooth == null) {
                out[pixels[k]] = Color.component(red) << 16 | Color.component(green) << 8 | Color.component(blue);
            } else {
                smooth.light(
                        pixels[k],
                        red,
                        green,
                        blue,
                        share * sum(skyLight, samples, k, 0),
                        share * sum(skyLight, samples, k, 1),
                        share * sum(skyLight, samples, k, 2));
            }
        }
    }

    private static double sum(double[] of, int samples, int pixel, int component) {
        double sum = 0;
        int end = 3 * samples * (pixel + 1);
        for (int at = 3 * samples * pixel + component; at < end; at += 3) {
            sum += of[at];
        }
        return sum;
    }
}
