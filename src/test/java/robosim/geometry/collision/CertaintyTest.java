package robosim.geometry.collision;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Between which shapes a verdict may be uncertain: those that the javadoc of {@link Certainty} names, and no others. */
@Tag("slow")
class CertaintyTest {
    private final SplittableRandom random = new SplittableRandom(36076);

    @Test
    void onlyWhatTheDocumentationNames() {
        for (Dimension dimension : Dimension.values()) {
            Set<String> uncertain = new TreeSet<>();
            int cases = Effort.cases(6_000, 2_000);
            for (int k = 0; k < cases; k++) {
                GeometryObject a = shape(k % 5, random.nextBoolean());
                GeometryObject b = shape(k / 5 % 5, random.nextBoolean());
                GeometryObject touching = touching(dimension, a, b);
                if (touching == null) {
                    continue;
                }
                Verdict verdict = ContactQuery.decide(touching, b, dimension, Budget.UNLIMITED);
                if (verdict.certainty() == Certainty.UNCERTAIN) {
                    assertThat(verdict.answer()).isEqualTo(Verdict.Answer.YES);
                    uncertain.add(pair(a, b));
                }
            }
            if (dimension == Dimension.SPATIAL) {
                assertThat(uncertain)
                        .containsExactlyInAnyOrder(
                                "turned CYLINDER, turned CYLINDER",
                                "turned CYLINDER, upright CYLINDER",
                                "turned CAPSULE, turned CYLINDER",
                                "turned CAPSULE, upright CYLINDER",
                                "turned CYLINDER, upright CAPSULE",
                                "upright CAPSULE, upright CYLINDER");
            } else {
                assertThat(uncertain)
                        .allSatisfy(pair -> assertThat(pair).containsAnyOf("turned CYLINDER", "turned CAPSULE"))
                        .hasSizeGreaterThan(10);
            }
        }
    }

    private static String pair(GeometryObject a, GeometryObject b) {
        String one = name(a);
        String other = name(b);
        return one.compareTo(other) < 0 ? one + ", " + other : other + ", " + one;
    }

    private static String name(GeometryObject object) {
        return (object.rotation()[4] == 1 ? "upright " : "turned ") + object.kind();
    }

    private GeometryObject shape(int kind, boolean isUpright) {
        double ry = random.nextDouble(-180, 180);
        double rx = isUpright ? 0 : random.nextDouble(-180, 180);
        double p = random.nextDouble(0.2, 1);
        double q = random.nextDouble(0.2, 2);
        return switch (kind) {
            case 0 -> new BoxObject(new Point(), p, q, 1).turned(rx, ry);
            case 1 -> new CylinderObject(new Point(), p, q).turned(rx, ry);
            case 2 -> new SphereObject(new Point(), p).turned(rx, ry);
            case 3 -> new CapsuleObject(new Point(), p, q).turned(rx, ry);
            default ->
                new MeshObject(
                                List.of(new Point(p, 0, 0), new Point(0, q, 0), new Point(-1, 0, p)),
                                new int[][] {{0, 1, 2}})
                        .turned(rx, ry);
        };
    }

    /** The first moved to where the two touch, but for rounding; null if they overlap where it began. */
    private GeometryObject touching(Dimension dimension, GeometryObject a, GeometryObject b) {
        double x = random.nextDouble(-1, 1);
        double y = dimension == Dimension.PLANAR ? 0 : random.nextDouble(-1, 1);
        double z = random.nextDouble(-1, 1);
        double near = 0;
        double far = 1e3;
        for (int k = 0; k < 64; k++) {
            double middle = near / 2 + far / 2;
            boolean isApart = ContactQuery.decide(moved(a, x, y, z, middle), b, dimension, Budget.UNLIMITED)
                            .answer()
                    == Verdict.Answer.NO;
            near = isApart ? near : middle;
            far = isApart ? middle : far;
        }
        return near == 0 ? null : moved(a, x, y, z, random.nextBoolean() ? near : far);
    }

    private static GeometryObject moved(GeometryObject a, double x, double y, double z, double times) {
        return a.movedTo(new Point(times * x, times * y, times * z));
    }
}
