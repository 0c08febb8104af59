package robosim.geometry.world;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;

/**
 * Reads the collisions of SDFormat, versions 1.4 to 1.12: worlds, models, nested, included and merged ones, links and
 * frames. docs/importing.md says what of the format is read, passed over, left out and refused.
 *
 * <p>A place (x, y, z) of the file is (x, z, -y) in the world, in metres, so that up is up; what faces the file's X faces
 * forward. The world is centred about the file's origin and leaves at least a metre around all objects. A static model
 * becomes one object that rests for each of its collisions, any other model one that may be moved.
 *
 * <p>A file is read whole or not at all. What may matter and cannot be read is left out and named in the result.
 */
public final class SdfReader {
    private SdfReader() {}

    /**
     * Reads a file, which holds one world, or models alone.
     *
     * @param models folders whose subfolders are models, beside the file's own folder, for {@code model://}
     * @throws WorldException naming file, line and remedy, where the file or one that it includes cannot be read
     */
    public static WorldImport read(Path file, List<Path> models) throws WorldException {
        Checks.present("file", file);
        Checks.list("models", models);
        return read(file, models, new ArrayList<>());
    }

    /** Reads the model in a folder. */
    static WorldImport readFolder(Path folder, List<Path> models) throws WorldException {
        List<String> remarks = new ArrayList<>();
        return read(SdfFiles.modelOf(folder, remarks::add), models, remarks);
    }

    private static WorldImport read(Path file, List<Path> models, List<String> remarks) throws WorldException {
        SdfFiles files = new SdfFiles(file, models);
        SdfTree tree = new SdfTree(files);
        SdfObjects objects = new SdfObjects(tree, new SdfShapes(tree, files));
        try {
            objects.add(tree.read(files.main(file.toString())));
            double[] reach = Bounds.reach(
                    objects.objects().stream().map(WorldObject::object).toList());
            World world = new World(
                    size(reach[0]),
                    size(reach[1]),
                    size(reach[2]),
                    Unit.METRE,
                    Dimension.SPATIAL,
                    Accuracy.EXACT,
                    objects.objects());
            Map<String, Integer> read = new TreeMap<>(objects.counts());
            remarks.addAll(files.remarks());
            remarks.addAll(tree.remarks());
            remarks.addAll(objects.remarks());
            return new WorldImport(world, "SDFormat", read, tree.passedOver(), tree.skipped(), remarks);
        } catch (IllegalArgumentException e) {
            throw new WorldException(file.toString(), 0, 0, String.valueOf(e.getMessage()), e);
        }
    }

    private static double size(double reach) {
        return 2 * Math.ceil(reach + 1);
    }
}
