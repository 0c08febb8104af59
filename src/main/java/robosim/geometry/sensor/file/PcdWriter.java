package robosim.geometry.sensor.file;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import robosim.geometry.check.Checks;
import robosim.geometry.sensor.PointCloud;
import robosim.geometry.world.AtomicFileWriter;

/**
 * Writes point clouds as PCD, version 0.7, binary: the format of the Point Cloud Library (PCL), which Open3D and ROS's
 * pcl_ros read too. Places and normals are floats of 32 bits.
 */
public final class PcdWriter {
    private PcdWriter() {}

    /**
     * Writes a cloud.
     *
     * @param axes along which the file has its points
     * @throws IOException if it cannot be written, naming the file
     */
    public static void write(PointCloud cloud, PointCloud.Axes axes, Path file) throws IOException {
        Rows rows = new Rows(Checks.present("cloud", cloud), Checks.present("axes", axes));
        List<Rows.Column> columns = rows.columns();
        String header = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
                + line("FIELDS", columns, Rows.Column::pcd)
                + line("SIZE", columns, column -> column.type().bytes)
                + line("TYPE", columns, column -> column.type().pcd)
                + line("COUNT", columns, column -> 1)
                + "WIDTH " + cloud.size() + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + cloud.size()
                + "\nDATA binary\n";
        AtomicFileWriter.write(file, out -> {
            out.write(header.getBytes(StandardCharsets.US_ASCII));
            rows.writeTo(out);
        });
    }

    private static String line(String name, List<Rows.Column> columns, Function<Rows.Column, Object> entry) {
        return columns.stream().map(entry).map(String::valueOf).collect(Collectors.joining(" ", name + " ", "\n"));
    }
}
