package robosim.geometry.cli.worlds;

import java.util.Arrays;
import robosim.geometry.Snapshot;
import robosim.geometry.material.Color;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.sensor.DepthCamera;
import robosim.geometry.sensor.DepthFrame;
import robosim.geometry.sensor.Intrinsics;
import robosim.geometry.sensor.NormalCamera;
import robosim.geometry.sensor.NormalFrame;
import robosim.geometry.sensor.RayFrame;
import robosim.geometry.sensor.RaySensor;
import robosim.geometry.sensor.SegmentationCamera;
import robosim.geometry.sensor.SegmentationFrame;

/** What a picture shows of a world, and how a sensor's numbers become colours for people. */
enum PictureStyle {
    COLOUR,
    DEPTH,
    NORMALS,
    OBJECTS,
    LABELS,
    POINTS;

    static final int NOTHING = 0x0d1117;

    /** Of surfaces without a label. */
    private static final int UNLABELLED = 0x4a4f57;

    /** The share of pixels that may be nearer than the first colour of a ramp, or farther than its last one. */
    private static final double BEYOND = 0.01;

    /** From near to far. */
    private static final int[] RAMP = {0xfff7d6, 0xffd27a, 0xfb9a4b, 0xe4575a, 0xa8326f, 0x642a7a, 0x2c2560, 0x141a3c};

    /** Neighbours differ in hue and in lightness. */
    private static final int[] WHEEL = {
        0xe4572e, 0x17bebb, 0xffc914, 0x5465ff, 0x76b041, 0xd1499b, 0xf6ae99, 0x2e86ab, 0xb8d8ba, 0x8f5db7, 0xd9a441,
        0x3bceac, 0xee6c8a, 0x4a7c59, 0x9ad1ff, 0xa44a3f
    };

    /** How much lighter or darker the colours are each time around. */
    private static final double[] ROUNDS = {1, 0.62, 1.3, 0.8};

    /** The picture of a sensor in a camera's place, as colours row by row: each is the mean of several samples. */
    int[] picture(ColorCamera camera, CameraWorld studio, Snapshot world) {
        int samples = camera.samples();
        Intrinsics intrinsics = camera.intrinsics(samples);
        int[] fine = switch (this) {
            case DEPTH -> {
                DepthFrame frame = new DepthFrame();
                read(DepthCamera.of(intrinsics), frame, camera, world);
                yield depths(frame.depths());
            }
            case NORMALS -> {
                NormalFrame frame = new NormalFrame();
                read(NormalCamera.of(intrinsics), frame, camera, world);
                yield normals(frame);
            }
            case OBJECTS, LABELS -> {
                SegmentationFrame frame = new SegmentationFrame();
                read(SegmentationCamera.of(intrinsics), frame, camera, world);
                yield this == OBJECTS ? objects(frame, studio) : labels(frame);
            }
            case COLOUR, POINTS -> throw new IllegalStateException("no sensor of a camera (got: " + this + ")");
        };
        return means(fine, camera.width(), camera.height(), samples);
    }

    private static <S extends RaySensor<S, F>, F extends RayFrame> void read(
            S sensor, F frame, ColorCamera camera, Snapshot world) {
        String carrier = camera.carrier();
        S placed = carrier == null ? sensor.at(camera.pose()) : sensor.on(carrier, camera.pose());
        placed.withThreads(Runtime.getRuntime().availableProcessors()).read(world, frame);
    }

    private static int[] depths(double[] depths) {
        double[] sorted =
                Arrays.stream(depths).filter(Double::isFinite).sorted().toArray();
        int last = sorted.length - 1;
        double near = last < 0 ? 0 : sorted[(int) (BEYOND * last)];
        double far = last < 0 ? 1 : sorted[(int) ((1 - BEYOND) * last)];
        int[] pixels = new int[depths.length];
        for (int k = 0; k < pixels.length; k++) {
            pixels[k] = Double.isFinite(depths[k]) ? ramp((depths[k] - near) / (far - near)) : NOTHING;
        }
        return pixels;
    }

    /** The colour of a share of the way along the ramp; what is beyond an end has its colour. */
    static int ramp(double share) {
        double at = share >= 0 ? Math.min(1, share) * (RAMP.length - 1) : 0; // of NaN, where all is equally far, too
        int k = Math.min((int) at, RAMP.length - 2);
        return mixed(RAMP[k], RAMP[k + 1], at - k);
    }

    /** A colour between two others. */
    static int mixed(int first, int second, double share) {
        int pixel = 0;
        for (int shift = 0; shift < 24; shift += 8) {
            double a = first >> shift & 255;
            double b = second >> shift & 255;
            pixel |= (int) Math.rint(a + (b - a) * share) << shift;
        }
        return pixel;
    }

    /** To the right is red, up is green, towards the camera is blue. */
    private static int[] normals(NormalFrame frame) {
        int[] pixels = new int[frame.size()];
        double[] normal = new double[3];
        for (int k = 0; k < pixels.length; k++) {
            frame.ownNormal(k, normal, 0);
            boolean isThere = normal[0] != 0 || normal[1] != 0 || normal[2] != 0;
            pixels[k] = isThere ? level(normal[2]) << 16 | level(normal[1]) << 8 | level(0.0 - normal[0]) : NOTHING;
        }
        return pixels;
    }

    private static int level(double component) {
        return (int) Math.rint(127.5 * (Math.max(-1, Math.min(1, component)) + 1));
    }

    /** An object has its colour in every picture of its world. */
    private static int[] objects(SegmentationFrame frame, CameraWorld studio) {
        int[] colours = new int[frame.known() + 1];
        colours[0] = NOTHING;
        for (int k = 1; k < colours.length; k++) {
            int number = studio.number(frame.known(k));
            colours[k] = number == 0 ? UNLABELLED : colour(number);
        }
        int[] pixels = new int[frame.size()];
        for (int k = 0; k < pixels.length; k++) {
            pixels[k] = colours[frame.instance(k)];
        }
        return pixels;
    }

    private static int[] labels(SegmentationFrame frame) {
        int[] pixels = new int[frame.size()];
        for (int k = 0; k < pixels.length; k++) {
            int label = frame.label(k);
            pixels[k] = frame.instance(k) == 0 ? NOTHING : label == 0 ? UNLABELLED : colour(label);
        }
        return pixels;
    }

    private static int colour(int number) {
        int own = WHEEL[(number - 1) % WHEEL.length];
        double round = ROUNDS[(number - 1) / WHEEL.length % ROUNDS.length];
        return round <= 1 ? mixed(0, own, round) : mixed(own, 0xffffff, round - 1);
    }

    /** Pixels of the mean light of squares of samples. */
    static int[] means(int[] fine, int width, int height, int samples) {
        int[] pixels = new int[width * height];
        double[] sum = new double[3];
        for (int k = 0; k < pixels.length; k++) {
            Arrays.fill(sum, 0);
            int corner = k / width * samples * width * samples + k % width * samples;
            for (int s = 0; s < samples * samples; s++) {
                int pixel = fine[corner + s / samples * width * samples + s % samples];
                for (int channel = 0; channel < 3; channel++) {
                    sum[channel] += Color.linear(pixel >> (16 - 8 * channel) & 255);
                }
            }
            double share = 1.0 / (samples * samples);
            pixels[k] = Color.ofLinear(share * sum[0], share * sum[1], share * sum[2])
                    .packed();
        }
        return pixels;
    }
}
