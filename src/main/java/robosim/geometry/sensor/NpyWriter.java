package robosim.geometry.sensor;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Collectors;
import robosim.geometry.check.Checks;
import robosim.geometry.world.shared.AtomicFileWriter;

/**
 * Writes arrays as NumPy's {@code .npy}, version 1.0, little-endian and in C order: {@code numpy.load} returns them with
 * their shape. A depth image is {@code write(frame.depths(), file, frame.rows(), frame.columns())}.
 */
public final class NpyWriter {
    /** The header ends at a multiple of this. */
    private static final int ALIGNMENT = 64;

    private static final int MAGIC = 10;
    private static final int SOME = 8192;

    private NpyWriter() {}

    /** Puts one number of an array. */
    private interface Numbers {
        void put(int index, ByteBuffer out);
    }

    /**
     * Writes numbers as float64, to the bit.
     *
     * @param values at least as many as the shape has; those beyond are left out, as the arrays of frames may have more
     * @param shape  the length of each dimension, at least 0; the last one varies fastest
     */
    public static void write(double[] values, Path file, int... shape) throws IOException {
        int count = count(Checks.present("values", values).length, shape);
        write("<f8", Double.BYTES, count, (k, out) -> out.putDouble(values[k]), file, shape);
    }

    /** Writes numbers as float32, rounded to the nearest. */
    public static void writeFloats(double[] values, Path file, int... shape) throws IOException {
        int count = count(Checks.present("values", values).length, shape);
        write("<f4", Float.BYTES, count, (k, out) -> out.putFloat((float) values[k]), file, shape);
    }

    /** Writes numbers as int32. */
    public static void write(int[] values, Path file, int... shape) throws IOException {
        int count = count(Checks.present("values", values).length, shape);
        write("<i4", Integer.BYTES, count, (k, out) -> out.putInt(values[k]), file, shape);
    }

    /** Writes numbers as uint16, such as the millimetres of a depth image. */
    public static void write(short[] values, Path file, int... shape) throws IOException {
        int count = count(Checks.present("values", values).length, shape);
        write("<u2", Short.BYTES, count, (k, out) -> out.putShort(values[k]), file, shape);
    }

    private static int count(int most, int... shape) {
        long count = 1;
        for (int length : Checks.present("shape", shape)) {
            if (length < 0 || (count *= length) > most) {
                throw new IllegalArgumentException(
                        "shape must have lengths of at least 0, of no more numbers than there are, " + most + " (got: "
                                + Arrays.toString(shape) + ")");
            }
        }
        return (int) count;
    }

    private static void write(String type, int bytes, int count, Numbers numbers, Path file, int... shape)
            throws IOException {
        byte[] header = header(type, shape);
        AtomicFileWriter.write(file, out -> {
            out.write(header);
            write(bytes, count, numbers, out);
        });
    }

    private static void write(int bytes, int count, Numbers numbers, OutputStream out) throws IOException {
        ByteBuffer some = ByteBuffer.allocate(SOME * bytes).order(ByteOrder.LITTLE_ENDIAN);
        for (int first = 0; first < count; first += SOME) {
            int end = Math.min(count, first + SOME);
            some.clear();
            for (int k = first; k < end; k++) {
                numbers.put(k, some);
            }
            out.write(some.array(), 0, some.position());
        }
    }

    private static byte[] header(String type, int... shape) {
        String lengths = Arrays.stream(shape).mapToObj(String::valueOf).collect(Collectors.joining(", "));
        String tuple = shape.length == 1 ? lengths + "," : lengths;
        String text = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" + tuple + "), }";
        int length = text.length() + 1;
        int padding = Math.floorMod(-(MAGIC + length), ALIGNMENT);
        String padded = text + " ".repeat(padding) + "\n";
        ByteBuffer header = ByteBuffer.allocate(MAGIC + padded.length()).order(ByteOrder.LITTLE_ENDIAN);
        header.put((byte) 0x93)
                .put("NUMPY".getBytes(StandardCharsets.US_ASCII))
                .put((byte) 1)
                .put((byte) 0);
        header.putShort((short) padded.length());
        header.put(padded.getBytes(StandardCharsets.US_ASCII));
        return header.array();
    }
}
