/**
 * Worlds as files: an XML format with a schema, its reader and writer, and readers of SDFormat, ROS maps and OBJ and STL
 * meshes.
 *
 * <ul>
 *   <li>{@link World}: a world as a value: size, {@link Unit} and objects
 *   <li>{@link WorldObject}: an object, with its body and each {@link SonarRing}
 *   <li>{@link WorldReader} and {@link WorldWriter}: worlds from and to files
 *   <li>{@link WorldImport}: a world from a file of any format, and a report of what was {@link Skipped}
 *   <li>{@link ImportOptions}: what files of other formats leave open
 *   <li>{@link SdfSensor}: the sensors that SDFormat describes
 *   <li>{@link WorldException}: a file that cannot be used, with its line and the remedy
 * </ul>
 *
 * <p>{@link robosim.geometry.world.WorldReader} turns a file into a {@link robosim.geometry.world.World}, a value;
 * {@link robosim.geometry.world.World#toGeometry()} makes a {@link robosim.geometry.Geometry} of it. The format's
 * schema is {@code worlds/world.xsd}, which is also in the jar, in this package. Files of other formats contain more
 * than a world does: {@link robosim.geometry.world.WorldImport} also reports what was left out of them, and why.
 *
 * <pre>{@code
 * World world = WorldReader.read(Path.of("worlds/rooms.xml"));
 * world.width();                                  // 40
 * Geometry geometry = world.toGeometry();
 * geometry.simpleMove("drum 1", 0.2, 0, 0);       // true
 * WorldWriter.toXml(world).lines().findFirst().get(); // "<?xml version="1.0" encoding="UTF-8"?>"
 * }</pre>
 */
@NullMarked
package robosim.geometry.world;

import org.jspecify.annotations.NullMarked;
