package robosim.geometry.sensor;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import robosim.geometry.check.Checks;
import robosim.geometry.image.PngWriter;
import robosim.geometry.world.shared.AtomicFileWriter;

/**
 * Files of what sensors read: point clouds as rows of little-endian numbers, the body of a binary PLY and PCD alike, and
 * images as PNG.
 */
final class SensorFiles {
    /** The largest number of 16 bits. */
    private static final int MOST = 0xffff;

    private static final int ROWS = 4096;

    /** The type of a number: its names in PLY and PCD, and its bytes. */
    private enum Type {
        FLOAT("float", 'F', Float.BYTES),
        UNSIGNED_SHORT("ushort", 'U', Short.BYTES),
        INT("int", 'I', Integer.BYTES);

        final String ply;
        final char pcd;
        final int bytes;

        Type(String ply, char pcd, int bytes) {
            this.ply = ply;
            this.pcd = pcd;
            this.bytes = bytes;
        }
    }

    /**
     * A number of each row.
     *
     * @param ply its name in PLY
     * @param pcd its name in PCD
     */
    private record Column(String ply, String pcd, Type type) {
        Column(String name, Type type) {
            this(name, name, type);
        }
    }

    private final PointCloud cloud;
    private final PointCloud.Axes axes;
    private final List<Column> columns = new ArrayList<>();
    private final double[] vector = new double[3];

    private SensorFiles(PointCloud cloud, PointCloud.Axes axes) {
        this.cloud = cloud;
        this.axes = axes;
        columns.add(new Column("x", Type.FLOAT));
        columns.add(new Column("y", Type.FLOAT));
        columns.add(new Column("z", Type.FLOAT));
        for (PointCloud.Field field : cloud.fields()) {
            columns.add(column(field));
        }
    }

    private static Column column(PointCloud.Field field) {
        return switch (field) {
            case INTENSITY -> new Column("intensity", Type.FLOAT);
            case RING -> new Column("ring", Type.UNSIGNED_SHORT);
            case TIME -> new Column("time", Type.FLOAT);
            case LABEL -> new Column("label", Type.INT);
            case INSTANCE -> new Column("instance", Type.INT);
            case NORMAL_X -> new Column("nx", "normal_x", Type.FLOAT);
            case NORMAL_Y -> new Column("ny", "normal_y", Type.FLOAT);
            case NORMAL_Z -> new Column("nz", "normal_z", Type.FLOAT);
        };
    }

    private int width() {
        return columns.stream().mapToInt(column -> column.type().bytes).sum();
    }

    private void writeTo(OutputStream out) throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(ROWS * width()).order(ByteOrder.LITTLE_ENDIAN);
        for (int point = 0; point < cloud.size(); point++) {
            put(point, bytes);
            if (!bytes.hasRemaining() || point == cloud.size() - 1) {
                out.write(bytes.array(), 0, bytes.position());
                bytes.clear();
            }
        }
    }

    private void put(int point, ByteBuffer bytes) {
        axes.of(cloud.x(point), cloud.y(point), cloud.z(point), vector);
        putVector(bytes);
        for (PointCloud.Field field : cloud.fields()) {
            switch (field) {
                case INTENSITY, TIME -> bytes.putFloat((float) cloud.value(field, point));
                case RING -> bytes.putShort((short) cloud.value(field, point));
                case LABEL, INSTANCE -> bytes.putInt((int) cloud.value(field, point));
                case NORMAL_X -> {
                    axes.of(
                            cloud.value(PointCloud.Field.NORMAL_X, point),
                            cloud.value(PointCloud.Field.NORMAL_Y, point),
                            cloud.value(PointCloud.Field.NORMAL_Z, point),
                            vector);
                    putVector(bytes);
                }
                case NORMAL_Y, NORMAL_Z -> {
                    // with the first of them
                }
            }
        }
    }

    private void putVector(ByteBuffer bytes) {
        for (double component : vector) {
            bytes.putFloat((float) component);
        }
    }

    /** Writes a cloud as PLY, version 1.0. */
    static void writePly(PointCloud cloud, PointCloud.Axes axes, Path file) throws IOException {
        SensorFiles rows = new SensorFiles(cloud, Checks.present("axes", axes));
        StringBuilder header = new StringBuilder("ply\nformat binary_little_endian 1.0\n");
        header.append("element vertex ").append(cloud.size()).append('\n');
        for (Column column : rows.columns) {
            header.append("property ")
                    .append(column.type().ply)
                    .append(' ')
                    .append(column.ply())
                    .append('\n');
        }
        rows.write(header.append("end_header\n").toString(), file);
    }

    /** Writes a cloud as PCD, version 0.7. */
    static void writePcd(PointCloud cloud, PointCloud.Axes axes, Path file) throws IOException {
        SensorFiles rows = new SensorFiles(cloud, Checks.present("axes", axes));
        String header = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
                + rows.line("FIELDS", Column::pcd)
                + rows.line("SIZE", column -> column.type().bytes)
                + rows.line("TYPE", column -> column.type().pcd)
                + rows.line("COUNT", column -> 1)
                + "WIDTH " + cloud.size() + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + cloud.size()
                + "\nDATA binary\n";
        rows.write(header, file);
    }

    private String line(String name, Function<Column, Object> entry) {
        return columns.stream().map(entry).map(String::valueOf).collect(Collectors.joining(" ", name + " ", "\n"));
    }

    private void write(String header, Path file) throws IOException {
        AtomicFileWriter.write(file, out -> {
            out.write(header.getBytes(StandardCharsets.US_ASCII));
            writeTo(out);
        });
    }

    /** Writes the numbers of an image's rays as greys of 16 bits; each must fit. */
    static void writeGreys(String argument, int[] numbers, RayFrame image, Path file) throws IOException {
        short[] narrow = new short[pixels(image)];
        for (int k = 0; k < narrow.length; k++) {
            if (numbers[k] < 0 || numbers[k] > MOST) {
                throw new IllegalArgumentException(
                        argument + " must be from 0 to " + MOST + " for 16 bits (got: " + numbers[k] + ")");
            }
            narrow[k] = (short) numbers[k];
        }
        writeGreys(narrow, image, file);
    }

    /** Writes an image of greys of 16 bits. */
    static void writeGreys(short[] greys, RayFrame image, Path file) throws IOException {
        AtomicFileWriter.write(file, out -> PngWriter.writeGrey16(out, image.columns(), image.rows(), greys));
    }

    /** How many pixels an image has; refuses one that has not been read. */
    static int pixels(RayFrame image) {
        if (image.size() == 0) {
            throw new IllegalArgumentException("the frame must have been read before it is written (got: no rays)");
        }
        return image.size();
    }
}
