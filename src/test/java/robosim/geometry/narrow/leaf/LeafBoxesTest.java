package robosim.geometry.narrow.leaf;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Which boxes meet another one or are near it, against a look at each. */
class LeafBoxesTest {
    private final SplittableRandom random = new SplittableRandom(8101);
    private final LeafBoxes boxes = new LeafBoxes();

    @Test
    void findsWhatALookAtEachFinds() {
        int found = 0;
        int asked = 0;
        for (int trial = 0; trial < 400; trial++) {
            int size = random.nextInt(random.nextBoolean() ? 14 : 400) + 1;
            boolean isFlat = random.nextBoolean();
            boolean isOnLattice = random.nextInt(3) == 0;
            double[][] all = new double[size][];
            boxes.clear(size, isFlat);
            for (int k = 0; k < size; k++) {
                all[k] = box(isOnLattice);
                boxes.set(k, all[k]);
            }
            for (int question = 0; question < 20; question++) {
                double[] box = box(isOnLattice);
                double far = random.nextInt(3) == 0 ? 0 : random.nextDouble(2);
                List<Integer> meeting = new ArrayList<>();
                for (int k = 0; k < size; k++) {
                    if (gap(all[k], box, 0, isFlat) <= far
                            && gap(all[k], box, 2, isFlat) <= far
                            && gap(all[k], box, 1, isFlat) <= far) {
                        meeting.add(k);
                    }
                }
                System.arraycopy(box, 0, boxes.box, 0, 6);
                assertThat(list(boxes.meeting(far))).containsExactlyElementsOf(meeting);
                System.arraycopy(box, 0, boxes.box, 0, 6);
                int near = boxes.within(far);
                for (int k : list(near)) {
                    assertThat(distance(all[k], box, isFlat)).isLessThanOrEqualTo(far * (1 + 1e-9) + 1e-150);
                }
                for (int k = 0; k < size; k++) {
                    if (distance(all[k], box, isFlat) <= far) {
                        assertThat(list(near)).contains(k);
                    }
                }
                found += near;
                asked += size;
            }
        }
        assertThat(found).isBetween(asked / 50, asked / 2);
    }

    private List<Integer> list(int count) {
        List<Integer> list = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            list.add(boxes.found(k));
        }
        return list;
    }

    private double[] box(boolean isOnLattice) {
        double[] box = new double[6];
        for (int k = 0; k < 3; k++) {
            box[k] = isOnLattice ? random.nextInt(6) : random.nextDouble(6);
            box[3 + k] =
                    box[k] + (isOnLattice ? random.nextInt(3) : random.nextDouble(random.nextInt(20) == 0 ? 6 : 1));
        }
        return box;
    }

    private static double gap(double[] a, double[] b, int axis, boolean isFlat) {
        return isFlat && axis == 1 ? 0 : Math.max(a[axis] - b[3 + axis], b[axis] - a[3 + axis]);
    }

    private static double distance(double[] a, double[] b, boolean isFlat) {
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double gap = Math.max(0, gap(a, b, axis, isFlat));
            square += gap * gap;
        }
        return Math.sqrt(square);
    }
}
