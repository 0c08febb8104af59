package robosim.geometry.world.sdf;

import java.nio.file.Path;

/**
 * A file of SDFormat.
 *
 * @param path   the file, links followed
 * @param folder the folder from which it names others
 * @param shown  what messages call it
 */
public record SdfFile(Path path, Path folder, String shown) {}
