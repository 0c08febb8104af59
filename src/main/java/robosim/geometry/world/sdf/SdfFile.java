package robosim.geometry.world.sdf;

import java.nio.file.Path;

/**
 * An SDFormat file.
 *
 * @param path   the file, links followed
 * @param folder the folder relative to which it names other files
 * @param shown  its name in messages
 */
public record SdfFile(Path path, Path folder, String shown) {}
