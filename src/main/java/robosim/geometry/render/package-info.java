/**
 * Pictures of a world as a camera would take them: surfaces with their materials in the light of a sky, a sun and lamps,
 * with shadows and mirrors, by the module's own exact rays. No graphics card, no display and no library is needed.
 *
 * <ul>
 *   <li>{@link ColorCamera}: takes pictures of a world or a snapshot
 *   <li>{@link ColorFrame}: a picture: colours and depths of its pixels
 *   <li>{@link Light}: a sun, a lamp or a spot
 *   <li>{@link Lighting}: all lights and the {@link Sky}
 * </ul>
 *
 * <pre>{@code
 * Geometry world = new Geometry(20, 10, 20);
 * world.addObject(new BoxObject(new Point(0, -0.5, 0), 20, 1, 20).withMaterial(Material.of(Color.parse("#b8b0a0"))));
 * world.addObject(new SphereObject(new Point(0, 1.1, 0), 1).withMaterial(Material.of(Color.parse("#d04020"))));
 * ColorCamera camera = ColorCamera.of(64, 48, 60).at(Pose.lookAt(new Point(-4, 3, 5), new Point(0, 1, 0)));
 * ColorFrame frame = new ColorFrame();
 * camera.render(world, frame);
 * frame.width();             // 64
 * frame.pixels().length;     // 3072
 * }</pre>
 *
 * <p>A picture is a function of the world and of the camera: the same bits on every JVM and on any number of threads.
 * Light is added and multiplied in linear components, with the four operations and square roots alone.
 */
@NullMarked
package robosim.geometry.render;

import org.jspecify.annotations.NullMarked;
