package robosim.geometry.world;

import java.nio.file.Path;

/**
 * An SDFormat file.
 *
 * @param path   the file, links followed
 * @param folder the folder relative to which it names other files
 * @param shown  its name in messages
 */
record SdfFile(Path path, Path folder, String shown) {}
