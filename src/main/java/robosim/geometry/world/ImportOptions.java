package robosim.geometry.world;

import java.nio.file.Path;
import java.util.List;
import robosim.geometry.exact.Checks;
import robosim.geometry.world.mesh.MeshFiles;
import robosim.geometry.world.rosmap.MapWalls;

/**
 * Options for information that files of other formats do not contain.
 *
 * @param wallHeight height in metres of the walls of a ROS map, which does not specify it; above 0
 * @param scale      world units per unit of a mesh file; above 0
 * @param up         which axis of a mesh file points up
 * @param models     folders whose subfolders are models, for SDFormat's {@code model://}
 */
public record ImportOptions(double wallHeight, double scale, Up up, List<Path> models) {
    /** Walls as high as a door, meshes unscaled, no model folders. */
    public static final ImportOptions DEFAULT = new ImportOptions(MapWalls.HEIGHT, 1, Up.Y, List.of());

    /** An axis of a mesh file. */
    public enum Up {
        Y,
        Z
    }

    /** Refuses invalid sizes. */
    public ImportOptions {
        if (!(wallHeight > 0 && wallHeight <= 0x1p100)) { // written so that NaN fails it
            throw new IllegalArgumentException(
                    "the walls' height must be above 0 and at most 2^100 (got: " + wallHeight + ")");
        }
        MeshFiles.checkScale(scale);
        Checks.present("up", up);
        models = Checks.list("models", models);
    }

    /** These options with other model folders. */
    public ImportOptions withModels(List<Path> folders) {
        return new ImportOptions(wallHeight, scale, up, folders);
    }
}
