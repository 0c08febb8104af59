package robosim.geometry.world.sdf;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.image.PixelSink;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.LimitProblem;
import robosim.geometry.world.shared.Limits;

/**
 * The surface of a heightmap: a corner for each pixel of its image, the brightest of which is as high as the size says, as
 * in Gazebo's ImageHeightmap. The image's first row is at the largest Y.
 */
final class SdfHeightmap implements PixelSink {
    private final SdfElement shape;
    private final Point size;
    private final Point place;

    /** Steps from a pixel to the next. */
    private final int sampling;

    private Format format = new Format(0, 0, 1, 1);
    private char[] heights = {};
    private int highest;

    SdfHeightmap(SdfElement shape) throws FileProblem {
        this.shape = shape;
        size = shape.vector("size", new Point(1, 1, 1));
        place = shape.vector("pos", new Point());
        if (!(size.x() > 0 && size.y() > 0 && size.z() >= 0)) {
            throw shape.wrong("<size> must be above 0, and its height at least 0 (got: " + size.x() + " " + size.y()
                    + " " + size.z() + ")");
        }
        double steps = shape.child("sampling") == null ? 1 : shape.number("sampling");
        if (!(steps >= 1 && steps <= Limits.MAX_CORNERS) || steps != Math.rint(steps)) {
            throw shape.wrong(
                    "<sampling> must be a whole number from 1 to " + Limits.MAX_CORNERS + " (got: " + steps + ")");
        }
        sampling = (int) steps;
    }

    @Override
    public void begin(Format given) throws FileProblem {
        format = given;
        if (given.width() < 2 || given.height() < 2) {
            throw shape.wrong("the image of a heightmap must have at least 2 x 2 pixels (got: " + given.width() + " x "
                    + given.height() + ")");
        }
        long triangles = 2L * (given.width() - 1) * sampling * (given.height() - 1) * sampling;
        if (triangles > Limits.MAX_FACES || (given.width() - 1L) * (given.height() - 1L) > Limits.MAX_FACES) {
            throw new LimitProblem(
                    shape.file.shown(),
                    shape.line,
                    shape.column,
                    "a heightmap must have at most " + Limits.MAX_FACES
                            + " triangles; make its image smaller, or <sampling> 1 (got: " + given.width() + " x "
                            + given.height() + " pixels, sampled " + sampling + " times)");
        }
    }

    @Override
    public void pixels(int row, int first, int step, int count, int[] samples) {
        if (heights.length == 0) {
            heights = new char[format.width() * format.height()];
        }
        for (int k = 0; k < count; k++) {
            int height = samples[k * format.channels()]; // of colours the red one
            highest = Math.max(highest, height);
            heights[row * format.width() + first + k * step] = (char) height;
        }
    }

    /** How many corners the surface has. */
    int corners() {
        return columns() * rows();
    }

    private int columns() {
        return (format.width() - 1) * sampling + 1;
    }

    private int rows() {
        return (format.height() - 1) * sampling + 1;
    }

    MeshObject mesh() {
        int columns = columns();
        int rows = rows();
        List<Point> vertices = new ArrayList<>(columns * rows);
        for (int row = 0; row < rows; row++) {
            FileWork.take(columns);
            double y = place.y() + size.y() * (0.5 - (double) row / (rows - 1));
            for (int column = 0; column < columns; column++) {
                double x = place.x() + size.x() * ((double) column / (columns - 1) - 0.5);
                double share = highest == 0 ? 0 : height(row, column) / highest;
                vertices.add(SdfPose.place(x, y, place.z() + size.z() * share));
            }
        }
        int[][] faces = new int[(columns - 1) * (rows - 1)][];
        int at = 0;
        for (int row = 0; row + 1 < rows; row++) {
            for (int column = 0; column + 1 < columns; column++) {
                int corner = row * columns + column;
                faces[at++] = new int[] {corner, corner + columns, corner + columns + 1, corner + 1};
            }
        }
        return new MeshObject(vertices, faces);
    }

    /** Between the pixels the one along the row, then the one across. */
    private double height(int row, int column) {
        int y = row / sampling;
        int x = column / sampling;
        double down = (double) (row % sampling) / sampling;
        double along = (double) (column % sampling) / sampling;
        double upper = along(y, x, along);
        return down == 0 ? upper : upper + down * (along(y + 1, x, along) - upper);
    }

    private double along(int y, int x, double share) {
        int at = y * format.width() + x;
        return share == 0 ? heights[at] : heights[at] + share * (heights[at + 1] - heights[at]);
    }
}
