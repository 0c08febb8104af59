import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.stream.IntStream;
import robosim.geometry.Geometry;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.render.ColorFrame;
import robosim.geometry.sensor.Intrinsics;
import robosim.geometry.sensor.SegmentationCamera;
import robosim.geometry.sensor.SegmentationFrame;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldReader;

/**
 * Training data for vision: pictures of a world from random places, with ground truth. For each frame it writes a picture in
 * colour, a mask of instances and one of labels as PNG of 16 bits, and in {@code coco.json} for each object that is seen its box in
 * the picture, its mask, which fraction of it is visible, and its box in space as the camera sees it.
 *
 * <p>A frame depends on its number alone, so the files have the same bits for any number of threads. Frames that are there
 * already are kept: a run that was ended continues where it was.
 *
 * <pre>
 * java -cp target/classes examples/VisionDataset.java WORLD.xml FOLDER FRAMES THREADS
 * </pre>
 */
public final class VisionDataset {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 240;
    private static final double FIELD_OF_VIEW = 70; // degrees
    private static final double ROOM = 0.2; // around the camera, in world units
    private static final int TRIES = 10_000;
    private static final Intrinsics LENS = Intrinsics.fieldOfView(WIDTH, HEIGHT, FIELD_OF_VIEW);

    private final World world;
    private final Path folder;
    private final List<GeometryObject> seen = new ArrayList<>();
    private final TreeMap<Integer, String> labels = new TreeMap<>();

    private VisionDataset(World world, Path folder) {
        this.world = world.spatial();
        this.folder = folder;
        for (GeometryObject object : this.world.joined()) {
            GeometryObject look = object.seen(); // its visuals, if it has any
            if (look != null) {
                seen.add(look);
                labels.put(look.material().label(), "label " + look.material().label());
            }
        }
    }

    /** Writes the frames that are missing, and then the list of all. */
    public static void main(String[] args) throws IOException {
        Path file = Path.of(args.length > 0 ? args[0] : "worlds/rooms.xml");
        Path folder = Path.of(args.length > 1 ? args[1] : "target/vision-dataset");
        int frames = Integer.parseInt(args.length > 2 ? args[2] : "8");
        int threads = Integer.parseInt(args.length > 3 ? args[3] : "2");
        for (String each : List.of("images", "instances", "labels", "annotations")) {
            Files.createDirectories(folder.resolve(each));
        }
        VisionDataset set = new VisionDataset(WorldReader.read(file), folder);
        int[] missing = IntStream.range(0, frames)
                .filter(frame -> !Files.exists(set.annotations(frame)))
                .toArray();
        set.write(missing, threads);
        int boxes = set.writeList(frames);
        System.out.printf(
                Locale.ROOT, "%d new frames of %d, with %d boxes, in %s%n", missing.length, frames, boxes, folder);
    }

    /** Each thread has a world of its own. */
    private void write(int[] frames, int threads) {
        IntStream.range(0, threads).parallel().forEach(thread -> {
            Geometry geometry = world.toGeometry();
            ColorFrame picture = new ColorFrame();
            SegmentationFrame masks = new SegmentationFrame();
            for (int k = thread; k < frames.length; k += threads) {
                try {
                    write(frames[k], geometry, picture, masks);
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            }
        });
    }

    private void write(int frame, Geometry geometry, ColorFrame picture, SegmentationFrame masks) throws IOException {
        Pose camera = camera(geometry, new SplittableRandom(1 + frame));
        ColorCamera.of(LENS)
                .withLighting(world.light())
                .withSmoothEdges(2)
                .withSmoothSky(1, 2)
                .at(camera)
                .render(geometry, picture);
        picture.writePng(image("images", frame));
        masks.forget(); // so that its numbers are those of this frame
        look(seen, camera, masks);
        masks.writeInstances(image("instances", frame));
        masks.writeLabels(image("labels", frame));
        Path half = folder.resolve("annotations/" + frame + ".part");
        Files.writeString(half, String.join("\n", boxes(frame, camera, masks)));
        Files.move(half, annotations(frame), StandardCopyOption.ATOMIC_MOVE); // last, so that the frame is complete
    }

    /** A free place in the lower half of the world, from which the camera looks at one of the objects. */
    private Pose camera(Geometry geometry, SplittableRandom random) {
        for (int k = 0; k < TRIES; k++) {
            Point eye = new Point(
                    world.width() * (random.nextDouble() - 0.5),
                    world.height() * (random.nextDouble(0.1, 0.5) - 0.5),
                    world.length() * (random.nextDouble() - 0.5));
            Point target = seen.get(random.nextInt(seen.size())).center();
            boolean isAbove = eye.x() == target.x() && eye.z() == target.z();
            if (!isAbove && !geometry.testObject(new SphereObject(eye, ROOM))) {
                return Pose.lookAt(eye, target);
            }
        }
        throw new IllegalStateException("a world must have room for a camera (got: none in " + TRIES + " places)");
    }

    /** What a camera sees of some objects, which may overlap. */
    private void look(List<GeometryObject> objects, Pose camera, SegmentationFrame out) {
        double most = 4 * Math.max(world.width(), Math.max(world.height(), world.length()));
        Geometry geometry = new Geometry(most, most, most);
        objects.forEach(geometry::addObjectUnchecked);
        SegmentationCamera.of(LENS).at(camera).read(geometry, out);
    }

    private List<String> boxes(int frame, Pose camera, SegmentationFrame masks) {
        List<String> lines = new ArrayList<>();
        SegmentationFrame alone = new SegmentationFrame();
        for (int number = 1; number <= masks.known(); number++) {
            GeometryObject object = masks.known(number);
            boolean[] mask = mask(masks, number);
            alone.forget();
            look(List.of(object), camera, alone);
            lines.add(annotation(frame, number, object, mask, count(mask(alone, 1)), camera));
        }
        return lines;
    }

    private static boolean[] mask(SegmentationFrame frame, int number) {
        boolean[] mask = new boolean[WIDTH * HEIGHT];
        for (int k = 0; k < mask.length; k++) {
            mask[k] = frame.instance(k) == number;
        }
        return mask;
    }

    private static int count(boolean[] mask) {
        int count = 0;
        for (boolean each : mask) {
            count += each ? 1 : 0;
        }
        return count;
    }

    private static String annotation(
            int frame, int number, GeometryObject object, boolean[] mask, int whole, Pose camera) {
        int left = WIDTH;
        int top = HEIGHT;
        int right = -1;
        int bottom = -1;
        for (int k = 0; k < mask.length; k++) {
            if (mask[k]) {
                left = Math.min(left, k % WIDTH);
                right = Math.max(right, k % WIDTH);
                top = Math.min(top, k / WIDTH);
                bottom = Math.max(bottom, k / WIDTH);
            }
        }
        // The box in space: around the object in its own frame, which stands in that of the camera.
        var own = object.at(Pose.ORIGIN).bounds();
        Point middle =
                new Point((own.minX() + own.maxX()) / 2, (own.minY() + own.maxY()) / 2, (own.minZ() + own.maxZ()) / 2);
        Pose box = Pose.of(middle, 0).within(object.pose()).relativeTo(camera);
        String name = object.name();
        return String.format(
                Locale.ROOT,
                "{\"id\":%d,\"image_id\":%d,\"instance\":%d,\"category_id\":%d,\"name\":\"%s\",\"iscrowd\":0,\"area\":%d,"
                        + "\"bbox\":[%d,%d,%d,%d],\"visible_fraction\":%s,\"box3d\":{\"center\":%s,\"size\":%s,\"rotation\":%s},"
                        + "\"segmentation\":{\"size\":[%d,%d],\"counts\":%s}}",
                frame * 100_000L + number,
                frame,
                number,
                object.material().label(),
                name == null ? object.kind().word() : name.replace("\\", "\\\\").replace("\"", "\\\""),
                count(mask),
                left,
                top,
                right - left + 1,
                bottom - top + 1,
                (double) count(mask) / whole,
                List.of(box.center().x(), box.center().y(), box.center().z()),
                List.of(own.maxX() - own.minX(), own.maxY() - own.minY(), own.maxZ() - own.minZ()),
                Arrays.toString(box.rotation()),
                HEIGHT,
                WIDTH,
                runs(mask));
    }

    /** How many pixels are outside, inside, outside and so on: column by column, as COCO has it. */
    private static List<Integer> runs(boolean[] mask) {
        List<Integer> runs = new ArrayList<>();
        boolean isInside = false;
        int length = 0;
        for (int k = 0; k < mask.length; k++) {
            if (mask[k % HEIGHT * WIDTH + k / HEIGHT] != isInside) {
                runs.add(length);
                length = 0;
                isInside = !isInside;
            }
            length++;
        }
        runs.add(length);
        return runs;
    }

    /** Writes the list of all frames, and returns how many boxes it has. */
    private int writeList(int frames) throws IOException {
        List<String> images = new ArrayList<>();
        List<String> boxes = new ArrayList<>();
        for (int frame = 0; frame < frames; frame++) {
            images.add(String.format(
                    Locale.ROOT,
                    "{\"id\":%d,\"file_name\":\"%06d.png\",\"width\":%d,\"height\":%d}",
                    frame,
                    frame,
                    WIDTH,
                    HEIGHT));
            Files.readAllLines(annotations(frame)).stream()
                    .filter(line -> !line.isEmpty())
                    .forEach(boxes::add);
        }
        List<String> categories = new ArrayList<>();
        labels.forEach((label, name) -> categories.add("{\"id\":" + label + ",\"name\":\"" + name + "\"}"));
        Files.writeString(
                folder.resolve("coco.json"),
                "{\"images\":[\n" + String.join(",\n", images) + "\n],\"annotations\":[\n" + String.join(",\n", boxes)
                        + "\n],\"categories\":[\n" + String.join(",\n", categories) + "\n]}\n");
        return boxes.size();
    }

    private Path image(String kind, int frame) {
        return folder.resolve(String.format(Locale.ROOT, "%s/%06d.png", kind, frame));
    }

    private Path annotations(int frame) {
        return folder.resolve("annotations/" + frame + ".json");
    }
}
