package robosim.geometry.render;

import java.util.Objects;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.image.PngWriter;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SenseOptions.Carrier;
import robosim.geometry.sensor.Intrinsics;

/**
 * A colour camera: surfaces with their materials, lit by a {@link Lighting}, with hard shadows and
 * mirrors. An immutable value; what it sees goes into a {@link ColorFrame}, which is used again for the next picture. It
 * sees heights in a PLANAR world too; each picture of a PLANAR {@link Geometry} first makes a copy of it with heights, so
 * for many pictures of one state take its {@link Snapshot}.
 *
 * <p>The optical axis is the camera's own +X, +Y is up in the picture and +Z to the right, as of a
 * {@link robosim.geometry.model.RayPattern#pinhole}. Each pixel is the mean light of its samples, which lie on a regular
 * grid; with one sample, in its middle.
 *
 * <h2>Shadows without acne and without leaks</h2>
 *
 * Whether a light reaches a point is decided by an exact ray. The point at which a ray meets a surface is rounded, though,
 * and may lie just behind the surface, which would then shadow itself. So the way to a light starts above the surface by a
 * height that comes from the error of this very hit and is no parameter: with M the largest of the distance, of the
 * coordinates of the point and of those of the surface's object near it, a distance is within 4 ulp of M, and what the
 * pose, the direction and the point itself add is less than half as much again, so that the rounded point is within
 * 0.34 * 2<sup>-47</sup> M of the surface. A point 2<sup>-47</sup> M above it, along the normal, is certainly above it
 * (also with a normal that is off by as much as 70 degrees), and no ray that leaves from there to the lit side meets the
 * face, or the convex solid, that it stands on.
 *
 * <p>Light counts only if two exact rays that start at this same point are free: the one to the light and the one back to
 * where the point was seen from. Both together are an unbroken way from the light to the eye, so a closed room stays dark.
 * Where one of them is not free, as in a gap narrower than that height, the point is dark. The same holds for what a mirror
 * shows.
 */
public final class ColorCamera {
    /** The most samples of a pixel along each axis. */
    public static final int MOST_SAMPLES = 16;

    /** The most mirrors on the way of a sample. */
    public static final int MOST_MIRRORS = 64;

    /** The most rays of a sample towards the sky. */
    public static final int MOST_SKY_RAYS = 256;

    private final FramePlan plan;
    private final double fieldOfView;
    private final Pose pose;
    private final @Nullable String carrier;
    private final Options options;

    /**
     * What a painter needs to know beside the plan.
     *
     * @param skyRays of each sample
     * @param smoothRays of each pixel; they take the place of the others
     * @param isIndirect whether these add the light of the surfaces that they hit
     */
    record Options(
            Lighting lighting,
            int mirrors,
            int skyRays,
            int smoothRays,
            double skyReach,
            boolean isIndirect,
            Carrier seen,
            int threads) {
        Options lit(Lighting by) {
            return new Options(by, mirrors, skyRays, smoothRays, skyReach, isIndirect, seen, threads);
        }

        Options mirrored(int depth) {
            return new Options(lighting, depth, skyRays, smoothRays, skyReach, isIndirect, seen, threads);
        }

        Options shaded(int rays, int smooth, double reach, boolean bounces) {
            return new Options(lighting, mirrors, rays, smooth, reach, bounces, seen, threads);
        }

        Options carried(Carrier as) {
            return new Options(lighting, mirrors, skyRays, smoothRays, skyReach, isIndirect, as, threads);
        }

        Options threaded(int count) {
            return new Options(lighting, mirrors, skyRays, smoothRays, skyReach, isIndirect, seen, count);
        }
    }

    private ColorCamera(FramePlan plan, double fieldOfView, Pose pose, @Nullable String carrier, Options options) {
        this.plan = plan;
        this.fieldOfView = fieldOfView;
        this.pose = pose;
        this.carrier = carrier;
        this.options = options;
    }

    /**
     * A camera at the origin that looks along +X, on a clear day, with one sample for each pixel, up to three mirrors on the
     * way of a ray, and on one thread.
     *
     * @param width                        pixels in a row, at least 1
     * @param height                       rows, at least 1; all pixels are at most 2<sup>26</sup>
     * @param horizontalFieldOfViewDegrees from the left edge of the picture to the right one, above 0 and below 180
     */
    public static ColorCamera of(int width, int height, double horizontalFieldOfViewDegrees) {
        if (width < 1 || height < 1 || (long) width * height > PngWriter.MAX_PIXELS) {
            throw new IllegalArgumentException("width and height must be at least 1, and their product at most "
                    + PngWriter.MAX_PIXELS + " pixels (got: " + width + " x " + height + ")");
        }
        if (!(horizontalFieldOfViewDegrees > 0 && horizontalFieldOfViewDegrees < 180)) { // written so that NaN fails it
            throw new IllegalArgumentException("horizontalFieldOfViewDegrees must be above 0 and below 180 (got: "
                    + horizontalFieldOfViewDegrees + ")");
        }
        return new ColorCamera(
                new FramePlan(width, height, horizontalFieldOfViewDegrees, 1),
                horizontalFieldOfViewDegrees,
                Pose.ORIGIN,
                null,
                new Options(Lighting.DAY, 3, 0, 0, Double.POSITIVE_INFINITY, false, Carrier.IGNORED, 1));
    }

    /**
     * A calibrated camera at the origin, otherwise as {@link #of(int, int, double)} makes it.
     *
     * @param intrinsics its size, focal lengths, optical axis and distortion
     * @throws IllegalArgumentException if the distortion shows nothing in some pixel
     */
    public static ColorCamera of(Intrinsics intrinsics) {
        Checks.present("intrinsics", intrinsics).pattern(); // which refuses a lens that does not fit
        double fieldOfView =
                Math.min(179.999, 2 * Degrees.toDegrees(StrictMath.atan(intrinsics.width() / (2 * intrinsics.fx()))));
        return of(intrinsics.width(), intrinsics.height(), fieldOfView).planned(new FramePlan(intrinsics, fieldOfView));
    }

    private ColorCamera planned(FramePlan other) {
        return new ColorCamera(other, fieldOfView, pose, carrier, options);
    }

    private ColorCamera with(Options other) {
        return new ColorCamera(plan, fieldOfView, pose, carrier, other);
    }

    /** This camera at a place in the world, carried by nothing. */
    public ColorCamera at(Pose place) {
        return new ColorCamera(plan, fieldOfView, Checks.present("place", place), null, options);
    }

    /**
     * This camera mounted on a moveable object.
     *
     * @param name  of the object
     * @param mount where the camera is and which way it faces, in the object's own frame
     */
    public ColorCamera on(String name, Pose mount) {
        return new ColorCamera(
                plan, fieldOfView, Checks.present("mount", mount), Checks.present("name", name), options);
    }

    /** This camera with other light. */
    public ColorCamera withLighting(Lighting lighting) {
        return with(options.lit(Checks.present("lighting", lighting)));
    }

    /**
     * This camera with more samples for each pixel, for smooth edges.
     *
     * @param count along each axis, 1 to {@link #MOST_SAMPLES}: 4 takes 16 samples for each pixel
     */
    public ColorCamera withSamples(int count) {
        check("samples", count, 1, MOST_SAMPLES);
        return new ColorCamera(plan.withSamples(count), fieldOfView, pose, carrier, options);
    }

    /**
     * This camera with one sample for each pixel, and more only for those that differ from one beside them: the edges of
     * things, of shadows and of what textures show. That takes a fraction of the time of {@link #withSamples}, and looks much
     * the same; what is so small that it lies between the middles of pixels may be missed.
     *
     * @param count samples of such pixels along each axis, 1 to {@link #MOST_SAMPLES}
     */
    public ColorCamera withSmoothEdges(int count) {
        check("samples", count, 1, MOST_SAMPLES);
        return new ColorCamera(plan.withEdges(count), fieldOfView, pose, carrier, options);
    }

    /**
     * This camera with another number of mirrors that a ray may meet one after the other; a mirror behind the last one shows
     * its own colour only.
     *
     * @param depth 0 to {@link #MOST_MIRRORS}; 0 for no mirrors at all
     */
    public ColorCamera withMirrors(int depth) {
        check("mirrors", depth, 0, MOST_MIRRORS);
        return with(options.mirrored(depth));
    }

    /**
     * This camera with soft shadows of the sky: each sample asks so many rays whether the sky is free there. The rays are
     * the same ones each time; with few samples the picture is grainy.
     *
     * @param count for each sample, 0 to {@link #MOST_SKY_RAYS}; with 0 the sky reaches everything
     * @param reach how far an object can be that hides the sky, in world units; may be infinite. The light of a room would
     *              be none at all, so choose some metres
     */
    public ColorCamera withSkyRays(int count, double reach) {
        check("count", count, 0, MOST_SKY_RAYS);
        checkReach(reach);
        return with(options.shaded(count, 0, reach, false));
    }

    private static void checkReach(double reach) {
        if (!(reach > 0)) { // written so that NaN fails it
            throw new IllegalArgumentException("reach must be above 0 (got: " + reach + ")");
        }
    }

    /**
     * This camera with soft shadows of the sky that are smooth: each pixel asks so many rays whether the sky is free there,
     * and takes a mean of its own and those of the pixels around it, as far as they show the same surface. Eight by eight
     * pixels have together 64 times as many directions, so that few rays are enough. What a mirror shows asks one ray
     * for each sample.
     *
     * @param count for each pixel, 0 to {@link #MOST_SKY_RAYS}; with 0 the sky reaches everything
     * @param reach how far an object can be that hides the sky, in world units; may be infinite
     */
    public ColorCamera withSmoothSky(int count, double reach) {
        check("count", count, 0, MOST_SKY_RAYS);
        checkReach(reach);
        return with(options.shaded(0, count, reach, false));
    }

    /**
     * This camera with smooth shadows of the sky and with indirect light: a surface that hides the sky gives the light that
     * it gets itself, from lights and from the sky, once. So what stands in deep shadow is not black, and takes on the
     * colours beside it. The paths of that light are exact rays too, and none comes through a wall.
     *
     * @param count for each pixel, as of {@link #withSmoothSky}
     * @param reach as there; also how far indirect light comes
     */
    public ColorCamera withIndirectLight(int count, double reach) {
        ColorCamera smooth = withSmoothSky(count, reach);
        return smooth.with(options.shaded(0, count, reach, true));
    }

    /** This camera, which sees or does not see the object that carries it. That object throws its shadow in any case. */
    public ColorCamera withCarrier(Carrier seen) {
        return with(options.carried(Checks.present("carrier", seen)));
    }

    /**
     * This camera on up to so many threads, which counts for pictures of a {@link Snapshot}. No pixel depends on it.
     *
     * @param count 1 to 1024
     */
    public ColorCamera withThreads(int count) {
        return with(options.threaded(Checks.threads(count)));
    }

    private static void check(String argument, int value, int least, int most) {
        if (value < least || value > most) {
            throw new IllegalArgumentException(
                    argument + " must be from " + least + " to " + most + " (got: " + value + ")");
        }
    }

    /** Pixels in a row. */
    public int width() {
        return plan.width;
    }

    /** The number of rows. */
    public int height() {
        return plan.height;
    }

    /**
     * The intrinsic parameters of this camera, for an image of so many times as many pixels along each axis.
     *
     * @param times at least 1
     */
    public Intrinsics intrinsics(int times) {
        check("times", times, 1, MOST_SAMPLES);
        return plan.intrinsics(times);
    }

    /** Horizontal field of view in degrees; of a calibrated camera about what it would be without distortion. */
    public double fieldOfView() {
        return fieldOfView;
    }

    /** Samples of a pixel along each axis; with smooth edges, of those that have most. */
    public int samples() {
        return plan.edges == null ? plan.samples : plan.edges.samples;
    }

    /** The light. */
    public Lighting lighting() {
        return options.lighting;
    }

    /** The name of the object that carries the camera; null if nothing does. */
    public @Nullable String carrier() {
        return carrier;
    }

    /** Where the camera is: in the world, or in the own frame of its carrier. */
    public Pose pose() {
        return pose;
    }

    /**
     * Takes a picture of a world, on the calling thread. Under a {@link robosim.geometry.WorkLimit} of the world it counts as
     * one call; where it is ended, the frame has no picture.
     *
     * @throws IllegalArgumentException if the world has no moveable object of the carrier's name
     */
    public void render(Geometry world, ColorFrame out) {
        render(world, out, percent -> {});
    }

    /**
     * Takes a picture of a world, on the calling thread.
     *
     * @param progress is told how many percent are done, many times for each block; what it throws ends the picture, and the frame has none
     * @throws IllegalArgumentException if the world has no moveable object of the carrier's name
     */
    public void render(Geometry world, ColorFrame out, IntConsumer progress) {
        Checks.present("world", world);
        Checks.present("out", out).reset(plan.width, plan.height);
        Checks.present("progress", progress);
        world.together("a picture", () -> {
            paint(out.painter(world), out, progress);
            return out;
        });
    }

    private void paint(BlockPainter painter, ColorFrame out, IntConsumer progress) {
        int[] percent = {0};
        painter.pausing(() -> progress.accept(percent[0])); // a block of many mirrors and lights takes long
        try {
            paint(new BlockPainter[] {painter}, out, done -> {
                percent[0] = done;
                progress.accept(done);
            });
        } finally {
            painter.pausing(() -> {});
        }
    }

    /**
     * A part of the work on a picture.
     *
     * @param only  the pixels that are painted; null for all
     * @param shade where the shadows of the sky are noted; null if each sample has its own
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    record Pass(
            FramePlan plan,
            boolean @Nullable [] only,
            @Nullable SkyShade shade) {
        /** How many percent of the picture are done after so many blocks: half of it is the pixels that differ. */
        int percent(int blocks) {
            int percent = (int) (100L * blocks / plan.blocks());
            return only != null ? 50 + percent / 2 : plan.edges != null ? percent / 2 : percent;
        }
    }

    /** Takes a picture, with a thread for each painter. */
    private void paint(BlockPainter[] painters, ColorFrame out, IntConsumer progress) {
        SkyShade shade = options.smoothRays > 0 ? out.shade(plan) : null;
        paint(painters, new Pass(plan, null, shade), out, progress);
        if (plan.edges != null) {
            paint(painters, new Pass(plan.edges, out.edges(plan.width, plan.height), shade), out, progress);
        }
        out.finish(plan.width, plan.height);
    }

    private void paint(BlockPainter[] painters, Pass pass, ColorFrame out, IntConsumer progress) {
        for (BlockPainter painter : painters) {
            painter.begin(this, pass);
        }
        int[] pixels = out.pixels();
        share(painters.length, pass.plan.blocks(), (k, block) -> {
            painters[k].paint(block, pixels);
            progress.accept(pass.percent(block + 1));
        });
        SkyShade shade = pass.shade;
        if (shade != null) {
            for (int k = 0; pass.only == null && k < SkyShade.PASSES; k++) {
                int part = k;
                share(painters.length, pass.plan.height, (thread, row) -> shade.gather(part, row));
            }
            share(painters.length, pass.plan.height, (k, row) -> shade.resolve(row, pass.only, pixels));
        }
    }

    /** What a thread does with a part of the work. */
    @FunctionalInterface
    private interface Part {
        void work(int thread, int part);
    }

    /** Shares parts among threads; one alone is the caller. */
    private static void share(int threads, int parts, Part work) {
        AtomicInteger taken = new AtomicInteger();
        IntConsumer thread = k -> {
            for (int part = taken.getAndIncrement(); part < parts; part = taken.getAndIncrement()) {
                work.work(k, part);
            }
        };
        if (threads == 1) {
            thread.accept(0);
        } else {
            IntStream.range(0, threads).parallel().forEach(thread);
        }
    }

    /** Takes a picture of a snapshot, on as many threads as the camera has. */
    public void render(Snapshot snapshot, ColorFrame out) {
        render(snapshot, out, percent -> {});
    }

    /**
     * Takes a picture of a snapshot.
     *
     * @param progress is told how many percent are done, from any of the threads, now and then
     */
    public void render(Snapshot snapshot, ColorFrame out, IntConsumer progress) {
        Checks.present("snapshot", snapshot);
        Checks.present("out", out).reset(plan.width, plan.height);
        Checks.present("progress", progress);
        paint(out.painters(snapshot, Math.min(options.threads, plan.blocks())), out, progress);
    }

    FramePlan plan() {
        return plan;
    }

    Options options() {
        return options;
    }

    /** Where the camera is in a world. */
    Pose placeIn(Geometry world) {
        if (carrier == null) {
            return pose;
        }
        GeometryObject object = world.getObject(carrier);
        if (!object.isMoveable()) {
            throw new IllegalArgumentException("carrier must be a moveable object (got: " + carrier + ")");
        }
        return pose.within(object.pose());
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ColorCamera that
                && plan.width == that.plan.width
                && plan.height == that.plan.height
                && plan.isLike(that.plan)
                && fieldOfView == that.fieldOfView
                && pose.equals(that.pose)
                && Objects.equals(carrier, that.carrier)
                && options.equals(that.options);
    }

    @Override
    public int hashCode() {
        return Objects.hash(plan.width, plan.height, plan.samples, fieldOfView, pose, carrier, options.lighting);
    }

    @Override
    public String toString() {
        return "ColorCamera of " + plan.width + " x " + plan.height + " pixels, " + fieldOfView + " degrees, "
                + (carrier == null ? "at " : "on " + carrier + " at ") + pose.center();
    }
}
