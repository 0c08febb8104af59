package robosim.geometry.sensor.file;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import robosim.geometry.check.Checks;
import robosim.geometry.sensor.PointCloud;
import robosim.geometry.world.AtomicFileWriter;

/**
 * Writes point clouds as PLY (Polygon File Format), version 1.0, binary and little-endian, which CloudCompare, MeshLab,
 * Open3D and Blender read. Places and normals are floats of 32 bits.
 */
public final class PlyWriter {
    private PlyWriter() {}

    /**
     * Writes a cloud.
     *
     * @param axes along which the file has its points
     * @throws IOException if it cannot be written, naming the file
     */
    public static void write(PointCloud cloud, PointCloud.Axes axes, Path file) throws IOException {
        Rows rows = new Rows(Checks.present("cloud", cloud), Checks.present("axes", axes));
        StringBuilder header = new StringBuilder("ply\nformat binary_little_endian 1.0\n");
        header.append("element vertex ").append(cloud.size()).append('\n');
        for (Rows.Column column : rows.columns()) {
            header.append("property ")
                    .append(column.type().ply)
                    .append(' ')
                    .append(column.ply())
                    .append('\n');
        }
        header.append("end_header\n");
        AtomicFileWriter.write(file, out -> {
            out.write(header.toString().getBytes(StandardCharsets.US_ASCII));
            rows.writeTo(out);
        });
    }
}
