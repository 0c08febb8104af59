package robosim.geometry.world;

import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Dimension;
import robosim.geometry.world.mesh.MeshFiles;
import robosim.geometry.world.rosmap.MapWalls;

/**
 * Options for information that files of other formats do not contain.
 *
 * @param wallHeight height in metres of the walls of a ROS map, which does not specify it; above 0
 * @param scale      world units per unit of a mesh file; above 0
 * @param up         which axis of a mesh file points up
 * @param models     folders whose subfolders are models, for SDFormat's {@code model://}; and folders in which Gazebo keeps
 *     the models of Fuel that it has downloaded, such as {@code ~/.gz/fuel}, for their addresses
 * @param unknown    what the cells of a ROS map are of which it knows nothing
 * @param isMapCentred whether the world of a ROS map is centred at the middle of its image, and so as large as the image,
 *     instead of at the origin of the map's frame
 * @param dimension whether heights count; null for what the file says or, where it says nothing, for that of its format:
 *     {@code PLANAR} for a ROS map, else {@code SPATIAL}. A world of which {@code PLANAR} is asked has no floors, as
 *     {@link World#planar}
 */
public record ImportOptions(
        double wallHeight,
        double scale,
        Up up,
        List<Path> models,
        Unknown unknown,
        boolean isMapCentred,
        @Nullable Dimension dimension) {
    /** Walls as high as a door, meshes unscaled, no model folders. */
    public static final ImportOptions DEFAULT = new ImportOptions(MapWalls.HEIGHT, 1, Up.Y, List.of());

    /** What cells are of which a map knows nothing. */
    public enum Unknown {
        /** A robot may drive there, and rays pass through. */
        FREE,
        /** Walls as all others. */
        OCCUPIED,
        /** Walls too, but of an object of their own, {@code unknown part of the map}. */
        EDGE
    }

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
        Checks.present("unknown", unknown);
        models = Checks.list("models", models);
    }

    /** Options for worlds of the dimension that is usual for their format. */
    public ImportOptions(
            double wallHeight, double scale, Up up, List<Path> models, Unknown unknown, boolean isMapCentred) {
        this(wallHeight, scale, up, models, unknown, isMapCentred, null);
    }

    /** Options with unknown cells free, and maps where their frame has them. */
    public ImportOptions(double wallHeight, double scale, Up up, List<Path> models) {
        this(wallHeight, scale, up, models, Unknown.FREE, false);
    }

    /** These options with other model folders. */
    public ImportOptions withModels(List<Path> folders) {
        return new ImportOptions(wallHeight, scale, up, folders, unknown, isMapCentred, dimension);
    }

    /** These options with unknown cells of another kind. */
    public ImportOptions withUnknown(Unknown cells) {
        return new ImportOptions(wallHeight, scale, up, models, cells, isMapCentred, dimension);
    }

    /** These options with the middle of a map's image, or the origin of its frame, at the centre of the world. */
    public ImportOptions withMapCentred(boolean isCentred) {
        return new ImportOptions(wallHeight, scale, up, models, unknown, isCentred, dimension);
    }

    /** These options with a dimension; null for that which is usual for the format of the file. */
    public ImportOptions withDimension(@Nullable Dimension other) {
        return new ImportOptions(wallHeight, scale, up, models, unknown, isMapCentred, other);
    }
}
