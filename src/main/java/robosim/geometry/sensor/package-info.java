/**
 * The sensors of robots: lidars, depth cameras and other cameras, sonars, bumpers, and their noise.
 *
 * <ul>
 *   <li>{@link Lidar}: rotating or still lasers; reads a {@link LidarFrame}
 *   <li>{@link DepthCamera}: reads a {@link DepthFrame}
 *   <li>{@link NormalCamera} and {@link SegmentationCamera}: read a {@link NormalFrame} and a {@link
 *       SegmentationFrame}
 *   <li>{@link SonarArray}: reads a {@link SonarFrame}
 *   <li>{@link ProximitySensor} and {@link Bumper}: the distance to what is near, and contacts
 *   <li>{@link RaySensor} and {@link RayFrame}: what sensors of rays and their frames share
 *   <li>{@link Intrinsics}: size and lens of a camera
 *   <li>{@link Noise}: what a sensor gets wrong
 *   <li>{@link PointCloud}: points with their fields; writes PLY and PCD
 *   <li>{@link NpyWriter}: arrays for NumPy
 * </ul>
 *
 * <p>A sensor is an immutable value: what it is mounted on, its rays, its ranges and its noise. It is read into a frame,
 * whose arrays are used again by the next reading, so that a sensor that keeps its frame allocates nothing. It reads a
 * world or, on any number of threads, a snapshot; no answer depends on the number of threads. Without noise, which is off
 * unless asked for, each number is to the bit what a single call of {@link robosim.geometry.Geometry} returns.
 *
 * <pre>{@code
 * Geometry world = new Geometry(20, 4, 20);
 * world.addObject(new BoxObject(new Point(5, 0, 0), 2, 2, 2).named("crate"));
 * world.addObject(new CylinderObject(new Point(0, -1, 0), 0.3, 1).moveable("robot"));
 *
 * Lidar lidar = Lidar.velodyneVlp16(10).on("robot", Pose.of(new Point(0, 1, 0), 0)); // on a mast, 10 turns a second
 * LidarFrame turn = new LidarFrame();
 * lidar.read(world, turn);
 * turn.rows();              // 16
 * turn.range(8 * turn.columns() + turn.columns() / 2) < 4.01; // true: the front of the crate, straight ahead
 *
 * DepthCamera camera = DepthCamera.of(Intrinsics.fieldOfView(320, 240, 87)).withRange(0.3, 10);
 * DepthFrame image = new DepthFrame();
 * camera.at(Pose.of(new Point(0, 0, 0), 0)).read(world, image);
 * image.depth(120 * 320 + 160); // 4.0: along the axis
 * }</pre>
 *
 * A sensor's own axes are those of every object: +X forward, +Y up and +Z to the right; {@link
 * robosim.geometry.sensor.PointCloud.Axes} has those of ROS.
 */
@NullMarked
package robosim.geometry.sensor;

import org.jspecify.annotations.NullMarked;
