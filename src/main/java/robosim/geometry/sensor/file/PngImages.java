package robosim.geometry.sensor.file;

import java.io.IOException;
import java.nio.file.Path;
import robosim.geometry.check.Checks;
import robosim.geometry.image.PngWriter;
import robosim.geometry.sensor.DepthFrame;
import robosim.geometry.sensor.NormalFrame;
import robosim.geometry.sensor.SegmentationFrame;
import robosim.geometry.world.AtomicFileWriter;

/**
 * Writes images of cameras as PNG: depths and numbers as greys of 16 bits, normals as colours of 8.
 *
 * <pre>{@code
 * Geometry world = new Geometry(20, 4, 20);
 * world.addObject(new BoxObject(new Point(5, 0, 0), 2, 2, 2));
 * DepthFrame image = new DepthFrame();
 * DepthCamera.of(Intrinsics.fieldOfView(64, 48, 87)).read(world, image);
 * PngImages.writeDepth(image, 1, Files.createTempDirectory("images").resolve("depth.png"));
 * }</pre>
 */
public final class PngImages {
    /** The largest number of 16 bits. */
    private static final int MOST = 0xffff;

    private PngImages() {}

    /**
     * Writes depths along the axis in whole millimetres, 0 where there is none: see {@link DepthFrame#millimetres}.
     *
     * @param metresPerUnit of the world, above 0: 1 for a world in metres
     */
    public static void writeDepth(DepthFrame image, double metresPerUnit, Path file) throws IOException {
        short[] millimetres = new short[checked(image.size())];
        image.millimetres(metresPerUnit, millimetres);
        write(millimetres, image.columns(), image.rows(), file);
    }

    /** Writes the labels of a segmentation, 0 where there is none; each must be at most 65,535. */
    public static void writeLabels(SegmentationFrame image, Path file) throws IOException {
        write(narrow("labels", image.labels(), image.size()), image.columns(), image.rows(), file);
    }

    /** Writes the numbers of the objects of a segmentation, 0 where there is none; each must be at most 65,535. */
    public static void writeInstances(SegmentationFrame image, Path file) throws IOException {
        write(narrow("instances", image.instances(), image.size()), image.columns(), image.rows(), file);
    }

    /**
     * Writes normals along the camera's optical axes (X to the right, Y down, Z forward), as red, green and blue from 0 for
     * -1 to 255 for 1; black where there is none.
     */
    public static void writeNormals(NormalFrame image, Path file) throws IOException {
        int[] pixels = new int[checked(image.size())];
        double[] normal = new double[3];
        for (int k = 0; k < pixels.length; k++) {
            image.ownNormal(k, normal, 0);
            boolean isThere = normal[0] != 0 || normal[1] != 0 || normal[2] != 0;
            pixels[k] = isThere ? level(normal[2]) << 16 | level(0.0 - normal[1]) << 8 | level(normal[0]) : 0;
        }
        AtomicFileWriter.write(file, out -> PngWriter.writeColour(out, image.columns(), image.rows(), pixels));
    }

    private static int level(double component) {
        return (int) Math.rint(127.5 * (Math.max(-1, Math.min(1, component)) + 1));
    }

    private static short[] narrow(String argument, int[] numbers, int size) {
        short[] narrow = new short[checked(size)];
        for (int k = 0; k < size; k++) {
            if (numbers[k] < 0 || numbers[k] > MOST) {
                throw new IllegalArgumentException(
                        argument + " must be from 0 to " + MOST + " for 16 bits (got: " + numbers[k] + ")");
            }
            narrow[k] = (short) numbers[k];
        }
        return narrow;
    }

    private static int checked(int size) {
        if (size == 0) {
            throw new IllegalArgumentException("image must have been read (got: none)");
        }
        return size;
    }

    private static void write(short[] pixels, int width, int height, Path file) throws IOException {
        Checks.present("file", file);
        AtomicFileWriter.write(file, out -> PngWriter.writeGrey16(out, width, height, pixels));
    }
}
