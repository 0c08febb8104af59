/**
 * Files of what sensors read, for other programs: PLY and PCD for point clouds, NumPy's .npy for arrays, PNG for images. And noise as
 * SDFormat describes it.
 *
 * <pre>{@code
 * PointCloud cloud = new PointCloud(PointCloud.Field.INTENSITY);
 * cloud.add(1, 2, 3, 0.5);
 * Path folder = Files.createTempDirectory("clouds");
 * PlyWriter.write(cloud, PointCloud.Axes.ROS, folder.resolve("turn.ply"));
 * PcdWriter.write(cloud, PointCloud.Axes.ROS, folder.resolve("turn.pcd"));
 * NpyWriter.write(new double[] {1, 2, 3, 4, 5, 6}, folder.resolve("depth.npy"), 2, 3);
 * }</pre>
 *
 * A file that is there already stays as it was until the new one is complete.
 */
@NullMarked
package robosim.geometry.sensor.file;

import org.jspecify.annotations.NullMarked;
