package robosim.geometry.sensor.file;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.sensor.PointCloud;
import robosim.geometry.sensor.PointCloud.Field;

/** The points of a cloud as rows of little-endian numbers: the body of a binary PLY and PCD alike. */
final class Rows {
    private static final int ROWS = 4096;

    /** The type of a number: its names in PLY and PCD, and its bytes. */
    enum Type {
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
    record Column(String ply, String pcd, Type type) {
        Column(String name, Type type) {
            this(name, name, type);
        }
    }

    private final PointCloud cloud;
    private final PointCloud.Axes axes;
    private final List<Column> columns = new ArrayList<>();
    private final double[] vector = new double[3];

    Rows(PointCloud cloud, PointCloud.Axes axes) {
        this.cloud = cloud;
        this.axes = axes;
        columns.add(new Column("x", Type.FLOAT));
        columns.add(new Column("y", Type.FLOAT));
        columns.add(new Column("z", Type.FLOAT));
        for (Field field : cloud.fields()) {
            columns.add(column(field));
        }
    }

    private static Column column(Field field) {
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

    List<Column> columns() {
        return columns;
    }

    private int width() {
        return columns.stream().mapToInt(column -> column.type().bytes).sum();
    }

    void writeTo(OutputStream out) throws IOException {
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
        for (Field field : cloud.fields()) {
            switch (field) {
                case INTENSITY, TIME -> bytes.putFloat((float) cloud.value(field, point));
                case RING -> bytes.putShort((short) cloud.value(field, point));
                case LABEL, INSTANCE -> bytes.putInt((int) cloud.value(field, point));
                case NORMAL_X -> {
                    axes.of(
                            cloud.value(Field.NORMAL_X, point),
                            cloud.value(Field.NORMAL_Y, point),
                            cloud.value(Field.NORMAL_Z, point),
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
}
