package robosim.geometry.stress;

import java.util.Arrays;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.MeshObject;
import robosim.geometry.reference.Truth.Form;

/** One question of a family: its numbers, reused from case to case. */
final class Case {
    static final int ROW = 16;

    Form formA = Form.SPHERE;
    Form formB = Form.SPHERE;
    final double[] a = new double[ROW];
    final double[] b = new double[ROW];

    /** A ray's start and direction, or a way. */
    final double[] ray = new double[6];

    @Nullable
    MeshObject meshA;

    @Nullable
    MeshObject meshB;

    /** The placed triangles of the meshes, nine numbers each. */
    double[] trianglesA = {};

    double[] trianglesB = {};

    void copyFrom(Case that) {
        formA = that.formA;
        formB = that.formB;
        System.arraycopy(that.a, 0, a, 0, ROW);
        System.arraycopy(that.b, 0, b, 0, ROW);
        System.arraycopy(that.ray, 0, ray, 0, 6);
        meshA = that.meshA;
        meshB = that.meshB;
        trianglesA = that.trianglesA;
        trianglesB = that.trianglesB;
    }

    /** The numbers of all that there is, as Java source. */
    String paste() {
        StringBuilder text = new StringBuilder();
        text.append(formA).append(" double[] a = ").append(literal(a));
        text.append(formB).append(" double[] b = ").append(literal(b));
        text.append("double[] ray = ").append(literal(ray));
        if (trianglesA.length > 0) {
            text.append("double[] trianglesA = ").append(literal(trianglesA));
        }
        if (trianglesB.length > 0) {
            text.append("double[] trianglesB = ").append(literal(trianglesB));
        }
        return text.toString();
    }

    private static String literal(double[] numbers) {
        return Arrays.stream(numbers).mapToObj(Double::toHexString).collect(Collectors.joining(", ", "{", "};\n"));
    }
}
