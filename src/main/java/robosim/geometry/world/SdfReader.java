package robosim.geometry.world;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.world.sdf.SdfFiles;
import robosim.geometry.world.sdf.SdfObjects;
import robosim.geometry.world.sdf.SdfTree;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Floor;

/**
 * Reads the collisions of SDFormat, versions 1.0 to 1.12: worlds, models, nested, included and merged ones, links and
 * frames; and those of robots in URDF. docs/importing.md says which parts of the format are read, ignored and left out.
 *
 * <p>A point (x, y, z) of the file is (x, z, -y) in the world, in metres, so that Y is up; the file's X is forward. The
 * world is centred at the file's origin and leaves at least a metre around all objects. A static model becomes one
 * static object for each of its collisions, any other model one moveable object. A plane that faces straight up is the
 * ground: a thin static box that fills the world, so that robots stand and drive on it.
 *
 * <p>A mistake costs the part that has it: it is left out and listed in the result, as are relevant elements that are not
 * supported. The rest is read.
 */
final class SdfReader {
    /** The format's name in reports. */
    static final String FORMAT = "SDFormat";

    private SdfReader() {}

    /**
     * Reads a file that contains one world, or only models.
     *
     * @param models folders whose subfolders are models, in addition to the file's own folder, for {@code model://}
     * @throws WorldException naming file, line and remedy, if the file cannot be read, has no world and no model, or exceeds a limit
     */
    static WorldImport read(Path file, List<Path> models) throws WorldException {
        Checks.present("file", file);
        Checks.list("models", models);
        return read(file, models, new ArrayList<>());
    }

    /** Reads the model in a folder. */
    static WorldImport readFolder(Path folder, List<Path> models) throws WorldException {
        List<String> remarks = new ArrayList<>();
        try {
            return read(SdfFiles.modelOf(folder, remarks::add), models, remarks);
        } catch (FileProblem e) {
            throw new WorldException(e);
        }
    }

    private static WorldImport read(Path file, List<Path> models, List<String> remarks) throws WorldException {
        try {
            SdfFiles files = new SdfFiles(file, models);
            SdfTree tree = new SdfTree(files);
            SdfObjects found = SdfSensor.found(tree, files, file);
            double[] reach = Bounds.reach(found.objects());
            List<WorldObject> objects = objects(found, size(reach[0]), size(reach[2]));
            World world = new World(
                    size(reach[0]),
                    size(reach[1]),
                    size(reach[2]),
                    Unit.METRE,
                    Dimension.SPATIAL,
                    Accuracy.EXACT,
                    objects,
                    found.lighting(),
                    found.scenery());
            Map<String, Integer> read = new TreeMap<>(found.counts());
            remarks.addAll(files.remarks());
            remarks.addAll(tree.remarks());
            remarks.addAll(found.remarks());
            found.sensors().forEach(each -> SdfSensor.of(each).ignored().ifPresent(remarks::add));
            List<Skipped> skipped = Stream.concat(tree.skipped().stream(), files.leftOut().stream())
                    .map(Skipped::of)
                    .toList();
            return new WorldImport(world, files.isUrdf() ? "URDF" : FORMAT, read, tree.passedOver(), skipped, remarks);
        } catch (FileProblem e) {
            throw new WorldException(e);
        } catch (IllegalArgumentException e) {
            throw new WorldException(new FileProblem(file.toString(), String.valueOf(e.getMessage()), e));
        }
    }

    /** With floors that fill the world; none if there is nothing but floors, since nothing gives such a world its size. */
    private static List<WorldObject> objects(SdfObjects found, double width, double length) {
        List<WorldObject> objects = new ArrayList<>();
        for (GeometryObject each : found.objects()) {
            boolean isFloor = each instanceof BoxObject && found.floors().contains(String.valueOf(each.name()));
            objects.add(new WorldObject(isFloor ? Floor.filling((BoxObject) each, width, length) : each));
        }
        return objects.size() == found.floors().size() ? List.of() : objects;
    }

    private static double size(double reach) {
        return 2 * Math.ceil(reach + 1);
    }
}
