package robosim.geometry.world;

import java.nio.file.Path;
import java.util.List;

/** Reads ROS maps as users do. */
final class RosMaps {
    private RosMaps() {}

    /** A map with walls of the usual height. */
    static World read(Path yaml) throws WorldException {
        return WorldImport.read(yaml, ImportOptions.DEFAULT).world();
    }

    /** A map with walls of a height. */
    static World read(Path yaml, double height) throws WorldException {
        return WorldImport.read(yaml, new ImportOptions(height, 1, ImportOptions.Up.Y, List.of()))
                .world();
    }
}
