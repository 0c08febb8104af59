package robosim.geometry.world.stage;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.mesh.Prism;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Folder;
import robosim.geometry.world.shared.ImageFiles;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Rectangles;

/**
 * The body of one Stage model without its children, in its own frame: a rectangle, its blocks, or the dark pixels of its
 * bitmap, stretched until they fill its size, as Stage's BlockGroup does.
 */
final class StageShape {
    /** Thickness in metres of the walls that {@code boundary} puts around a model. */
    private static final double BOUNDARY = 0.01;

    private final StageEntity model;
    private final double[] size;
    private final List<GeometryObject> parts = new ArrayList<>();

    private StageShape(StageEntity model, double[] size) {
        this.model = model;
        this.size = size;
    }

    /** Width, depth and height of a model. */
    static double[] size(StageEntity model) throws FileProblem {
        double[] size = model.numbers("size", 0.1, 0.1, 0.1);
        for (double each : size) {
            if (!(each >= 0 && each <= 0x1p100)) {
                throw model.wrong("size must be at least 0 (got: " + each + ")");
            }
        }
        return size;
    }

    /** @param folder the bitmap is below it */
    static List<GeometryObject> of(StageEntity model, boolean hasDefault, Path folder) throws FileProblem {
        StageShape shape = new StageShape(model, size(model));
        List<StageEntity> blocks = model.children.stream()
                .filter(each -> each.type.equals("block"))
                .toList();
        try {
            if (model.has("bitmap")) {
                shape.bitmap(folder);
            } else if (!blocks.isEmpty()) {
                shape.blocks(blocks);
            } else if (hasDefault && model.number("noblocks", 0) == 0) {
                shape.box(-0.5, -0.5, 0.5, 0.5, 0, 1);
            }
            if (model.number("boundary", 0) != 0) {
                shape.boundary();
            }
        } catch (IllegalArgumentException e) {
            throw model.wrong(String.valueOf(e.getMessage()));
        }
        return shape.parts;
    }

    /** A box between shares of the size. */
    private void box(double fromX, double fromY, double toX, double toY, double low, double high) {
        parts.add(new BoxObject(
                new Point((fromX + toX) / 2 * size[0], (low + high) / 2 * size[2], -(fromY + toY) / 2 * size[1]),
                (toX - fromX) * size[0],
                (high - low) * size[2],
                (toY - fromY) * size[1]));
    }

    private void boundary() {
        double x = BOUNDARY / size[0];
        double y = BOUNDARY / size[1];
        box(-0.5, -0.5, -0.5 + x, 0.5, 0, 1);
        box(-0.5, -0.5, 0.5, -0.5 + y, 0, 1);
        box(-0.5, 0.5 - y, 0.5, 0.5, 0, 1);
        box(0.5 - x, -0.5, 0.5, 0.5, 0, 1);
    }

    private void bitmap(Path folder) throws FileProblem {
        Path from = model.file.toAbsolutePath().resolveSibling("").normalize();
        Path file;
        String name = model.text("bitmap", "");
        try {
            Path relative = folder.relativize(from.resolve(name).normalize());
            file = Folder.locate(folder, relative.toString(), "world", "image");
        } catch (IOException e) {
            throw model.wrong("the bitmap could not be read: " + e);
        }
        StageBitmap image = new StageBitmap();
        ImageFiles.read(file, image);
        BitSet dark = image.dark;
        if (dark.isEmpty()) {
            throw model.wrong(
                    "a bitmap must have a pixel that is darker than half of white (got: none in " + name + ")");
        }
        int columns = image.width();
        int[] bounds = {columns, image.height(), 0, 0};
        for (int k = dark.nextSetBit(0); k >= 0; k = dark.nextSetBit(k + 1)) {
            bounds[0] = Math.min(bounds[0], k % columns);
            bounds[1] = Math.min(bounds[1], k / columns);
            bounds[2] = Math.max(bounds[2], k % columns + 1);
            bounds[3] = Math.max(bounds[3], k / columns + 1);
        }
        double width = bounds[2] - bounds[0];
        double height = bounds[3] - bounds[1];
        Rectangles.cover(dark, columns, image.height(), (fromColumn, fromRow, toColumn, toRow) -> {
            if (parts.size() == Limits.MAX_OBJECTS) {
                throw new IllegalArgumentException("a bitmap must consist of at most " + Limits.MAX_OBJECTS
                        + " rectangles of dark pixels; scale or smooth its image (got: more)");
            }
            box(
                    (fromColumn - bounds[0]) / width - 0.5,
                    0.5 - (toRow - bounds[1]) / height,
                    (toColumn - bounds[0]) / width - 0.5,
                    0.5 - (fromRow - bounds[1]) / height,
                    0,
                    1);
        });
    }

    /** Polygons that are extruded between two heights. */
    private void blocks(List<StageEntity> blocks) throws FileProblem {
        List<List<double[]>> polygons = new ArrayList<>();
        List<double[]> heights = new ArrayList<>();
        double[] least = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] most = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (StageEntity block : blocks) {
            int count = (int) block.number("points", 0);
            if (count < 3 || count > Limits.MAX_CORNERS) {
                throw block.wrong("a block must have 3 to " + Limits.MAX_CORNERS + " points (got: " + count + ")");
            }
            List<double[]> polygon = new ArrayList<>();
            for (int k = 0; k < count; k++) {
                double[] point = block.numbers("point[" + k + "]", 0, 0);
                polygon.add(point);
                for (int axis = 0; axis < 2; axis++) {
                    least[axis] = Math.min(least[axis], point[axis]);
                    most[axis] = Math.max(most[axis], point[axis]);
                }
            }
            if (Prism.doubleArea(polygon) < 0) {
                Collections.reverse(polygon);
            }
            double[] z = block.numbers("z", 0, 1);
            least[2] = Math.min(least[2], z[0]);
            most[2] = Math.max(most[2], z[1]);
            polygons.add(polygon);
            heights.add(z);
        }
        double[] scale = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            if (!(most[axis] > least[axis])) {
                throw model.wrong("its blocks must have an extent along each axis (got: none)");
            }
            scale[axis] = size[axis] / (most[axis] - least[axis]);
        }
        for (int k = 0; k < polygons.size(); k++) {
            List<double[]> placed = new ArrayList<>();
            for (double[] point : polygons.get(k)) {
                placed.add(new double[] {
                    (point[0] - (least[0] + most[0]) / 2) * scale[0], (point[1] - (least[1] + most[1]) / 2) * scale[1]
                });
            }
            parts.add(Prism.of(placed, heights.get(k)[0] * scale[2], heights.get(k)[1] * scale[2]));
        }
    }
}
