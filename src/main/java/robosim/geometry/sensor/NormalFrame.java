package robosim.geometry.sensor;

import java.io.IOException;
import java.nio.file.Path;
import robosim.geometry.image.PngWriter;
import robosim.geometry.world.shared.AtomicFileWriter;

/** An image of a {@link NormalCamera}. */
public final class NormalFrame extends RayFrame {
    private final double[] vector = new double[3];

    /** An empty frame. */
    public NormalFrame() {}

    /**
     * The X component, along the world's axis, of the unit normal of the surface that a ray met; 0 for none. It is, to the
     * bit, what {@link robosim.geometry.Geometry#castRay} returns.
     */
    public double normalX(int ray) {
        return buffer().normalX(checked(ray));
    }

    /** Its Y component. */
    public double normalY(int ray) {
        return buffer().normalY(checked(ray));
    }

    /** Its Z component. */
    public double normalZ(int ray) {
        return buffer().normalZ(checked(ray));
    }

    /**
     * All normals, X, Y and Z of each ray, along the world's axes: the frame's own array, no copy. Elements from three times
     * {@link #size} on mean nothing.
     */
    public double[] normals() {
        return buffer().normals();
    }

    /**
     * Writes the normal of a ray along the camera's own axes.
     *
     * @param out takes X, Y and Z
     * @param at  where in the array they begin
     */
    public void ownNormal(int ray, double[] out, int at) {
        turnBack(normalX(ray), normalY(ray), normalZ(ray), out, at);
    }

    @Override
    double field(PointCloud.Field field, int ray) {
        if (field.axis() >= 0) {
            ownNormal(ray, vector, 0);
            return vector[field.axis()];
        }
        return super.field(field, ray);
    }

    /**
     * Writes normals along the camera's optical axes (X to the right, Y down, Z forward) as a PNG image: red, green and blue
     * from 0 for -1 to 255 for 1; black where there is none.
     *
     * @throws IOException if it cannot be written, naming the file
     * @throws IllegalArgumentException if nothing has been read into this frame
     */
    public void writePng(Path file) throws IOException {
        int[] pixels = new int[SensorFiles.pixels(this)];
        double[] normal = new double[3];
        for (int k = 0; k < pixels.length; k++) {
            ownNormal(k, normal, 0);
            boolean isThere = normal[0] != 0 || normal[1] != 0 || normal[2] != 0;
            pixels[k] = isThere ? level(normal[2]) << 16 | level(0.0 - normal[1]) << 8 | level(normal[0]) : 0;
        }
        AtomicFileWriter.write(file, out -> PngWriter.writeColour(out, columns(), rows(), pixels));
    }

    private static int level(double component) {
        return (int) Math.rint(127.5 * (Math.max(-1, Math.min(1, component)) + 1));
    }
}
