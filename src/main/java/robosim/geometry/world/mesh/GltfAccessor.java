package robosim.geometry.world.mesh;

import java.nio.ByteBuffer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.Limits;

/** The numbers that an accessor of a glTF file takes from its buffers: of every type, dense or sparse. */
final class GltfAccessor {
    private final GltfFile file;
    private final GltfPart accessor;
    private final int type;
    private final int size;
    private final int parts;
    private final boolean isNormalized;

    private GltfAccessor(GltfFile file, GltfPart accessor, int parts) throws FileProblem {
        this.file = file;
        this.accessor = accessor;
        this.parts = parts;
        type = accessor.whole("componentType");
        size = size(accessor, type);
        isNormalized = accessor.isTrue("normalized");
        String shape = parts == 1 ? "SCALAR" : "VEC" + parts;
        if (!accessor.text("type").equals(shape)) {
            throw accessor.wrong("its type must be " + shape + " (got: " + accessor.text("type") + ")");
        }
    }

    /**
     * The numbers of an accessor, one element behind the other.
     *
     * @param parts how many numbers an element has: 1 to 3
     */
    static double[] read(GltfFile file, int index, int parts) throws FileProblem {
        GltfAccessor accessor = new GltfAccessor(file, file.root.item("accessors", index), parts);
        return accessor.read();
    }

    private static int size(GltfPart of, int type) throws FileProblem {
        return switch (type) {
            case 5120, 5121 -> 1;
            case 5122, 5123 -> 2;
            case 5125, 5126 -> 4;
            default -> throw of.wrong("componentType must be 5120 to 5123, 5125 or 5126 (got: " + type + ")");
        };
    }

    private double[] read() throws FileProblem {
        int count = accessor.whole("count");
        if (count > Limits.MAX_NUMBERS / parts) {
            throw accessor.wrong("an accessor must have at most " + Limits.MAX_NUMBERS + " numbers (got: " + count
                    + " of " + parts + ")");
        }
        if (!accessor.has("bufferView") && count > file.bytes()) {
            throw accessor.wrong(
                    "an accessor without bytes of its own must have at most as many elements as the file has"
                            + " bytes (got: " + count + " of " + file.bytes() + ")");
        }
        int stride = size * parts;
        if (accessor.has("bufferView")) {
            GltfPart view = file.root.item("bufferViews", accessor.whole("bufferView"));
            int given = view.whole("byteStride", 0);
            stride = given == 0 ? stride : given;
            bytes(accessor, count, stride, size * parts); // before there is room for what they would hold
        }
        double[] numbers = new double[count * parts]; // zero where there is no view
        if (accessor.has("bufferView")) {
            fill(accessor, numbers, count, stride, null);
        }
        GltfPart sparse = accessor.child("sparse");
        if (sparse != null) {
            sparse(sparse, numbers, count);
        }
        return numbers;
    }

    /** Replaces some elements by others. */
    private void sparse(GltfPart sparse, double[] numbers, int count) throws FileProblem {
        int replaced = sparse.whole("count");
        if (replaced > count) {
            throw sparse.wrong("count must be at most that of the accessor (got: " + replaced + " of " + count + ")");
        }
        GltfPart indices = sparse.required("indices");
        int kind = indices.whole("componentType");
        int width = size(indices, kind);
        ByteBuffer bytes = bytes(indices, replaced, width, width);
        int[] places = new int[replaced];
        for (int k = 0; k < replaced; k++) {
            double place = number(bytes, indices.whole("byteOffset", 0) + k * width, kind);
            if (!(place >= 0 && place < count)) {
                throw indices.wrong(
                        "an index must be below " + count + ", the number of elements (got: " + place + ")");
            }
            places[k] = (int) place;
        }
        fill(sparse.required("values"), numbers, replaced, size * parts, places);
    }

    /** The bytes of a view, which must hold so many elements. */
    private ByteBuffer bytes(GltfPart of, int count, int stride, int width) throws FileProblem {
        ByteBuffer bytes = file.view(of.whole("bufferView"));
        long end = of.whole("byteOffset", 0) + (count == 0 ? 0 : (count - 1L) * stride + width);
        if (end > bytes.limit()) {
            throw of.wrong(
                    "its elements must end before their bytes do (got: " + end + " of " + bytes.limit() + " bytes)");
        }
        return bytes;
    }

    private void fill(GltfPart from, double[] numbers, int count, int stride, int @Nullable [] places)
            throws FileProblem {
        ByteBuffer bytes = bytes(from, count, stride, size * parts);
        int offset = from.whole("byteOffset", 0);
        for (int k = 0; k < count; k++) {
            FileWork.take(1);
            int element = places == null ? k : places[k];
            for (int part = 0; part < parts; part++) {
                double number = number(bytes, offset + k * stride + part * size, type);
                numbers[element * parts + part] = isNormalized ? normalized(number) : number;
            }
        }
    }

    private static double number(ByteBuffer bytes, int at, int type) {
        return switch (type) {
            case 5120 -> bytes.get(at);
            case 5121 -> bytes.get(at) & 0xff;
            case 5122 -> bytes.getShort(at);
            case 5123 -> bytes.getShort(at) & 0xffff;
            case 5125 -> bytes.getInt(at) & 0xffffffffL;
            default -> bytes.getFloat(at);
        };
    }

    /** A whole number as a share of the largest one of its type; the smallest signed one is -1 too. */
    private double normalized(double number) {
        return switch (type) {
            case 5120 -> Math.max(-1, number / 127);
            case 5121 -> number / 255;
            case 5122 -> Math.max(-1, number / 32767);
            case 5123 -> number / 65535;
            default -> number;
        };
    }
}
