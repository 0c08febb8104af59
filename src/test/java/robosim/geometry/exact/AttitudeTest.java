package robosim.geometry.exact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** An attitude in the middle of an array: nine numbers, a heading and its tail, and nothing beside them changes. */
class AttitudeTest {
    private static final int AT = 3;

    private final double[] column = new double[AT + Attitude.STRIDE + 2];

    AttitudeTest() {
        Arrays.fill(column, 7);
        System.arraycopy(Attitude.identity(), 0, column, AT, Attitude.STRIDE);
    }

    private double[] rotation() {
        assertThat(Arrays.copyOf(column, AT)).containsOnly(7);
        assertThat(Arrays.copyOfRange(column, AT + Attitude.STRIDE, column.length))
                .containsOnly(7);
        double[] rotation = Arrays.copyOfRange(column, AT, AT + 9);
        assertThat(Attitude.isRotation(rotation)).isTrue();
        assertThat(Attitude.isRotation(column, AT)).isTrue();
        return rotation;
    }

    @Test
    void facesXAtFirst() {
        assertThat(rotation()).containsExactly(1, 0, 0, 0, 1, 0, 0, 0, 1);
        assertThat(Attitude.isUpright(column, AT)).isTrue();
        assertThat(Attitude.heading(column, AT)).isZero();
    }

    /** A positive turn is counter-clockwise seen from above: from X to -Z. */
    @Test
    void quarterTurnsAreExact() {
        Attitude.turn(column, AT, 0, 90);
        assertThat(rotation()).containsExactly(0, 0, 1, 0, 1, 0, -1, 0, 0);
        assertThat(Attitude.heading(column, AT)).isEqualTo(90);
        Attitude.turnVertically(column, AT, 180);
        assertThat(Attitude.heading(column, AT)).isEqualTo(-90);
        Attitude.setHeading(column, AT, 180, 0);
        assertThat(rotation()).containsExactly(-1, 0, 0, 0, 1, 0, 0, 0, -1);
        Attitude.setHeading(column, AT, -180, 0);
        assertThat(Attitude.heading(column, AT)).isEqualTo(180);
    }

    @Test
    void aHeadingKeepsWhatRoundingLeavesOut() {
        for (int k = 0; k < 3_600; k++) {
            Attitude.turn(column, AT, 0, 0.1);
        }
        // 3,600 times the double 0.1, which is above a tenth by 2^-54 / 10.
        assertThat(Attitude.heading(column, AT)).isCloseTo(3_600 * 0x1.999999999999ap-4 - 360, within(1e-13));
        int told = 0;
        for (int k = 1; k < 400; k++) {
            double heading = 0.37 * k - 90;
            Attitude.setHeading(column, AT, heading, 0.45 * Math.ulp(heading));
            double cosine = rotation()[0];
            assertThat(cosine).isEqualTo(Degrees.cos(heading, 0.45 * Math.ulp(heading)));
            told += cosine == Degrees.cos(heading) ? 0 : 1;
        }
        assertThat(told).as("cosines that the tail changes").isPositive();
        Attitude.setHeading(column, AT, 10, 0x1p-60);
        Attitude.turn(column, AT, 0, -10);
        assertThat(Attitude.heading(column, AT)).isEqualTo(0x1p-60);
    }

    /** First about the own Y, then about the own X; a tipped one turns about the world's axes when it is told so. */
    @Test
    void tippedAttitudesAreComposed() {
        Attitude.turn(column, AT, 90, 90);
        assertThat(rotation()).containsExactly(0, 1, 0, 0, 0, -1, -1, 0, 0);
        assertThat(Attitude.isUpright(column, AT)).isFalse();
        assertThat(Attitude.heading(column, AT)).isEqualTo(90);
        Attitude.turnVertically(column, AT, -90);
        assertThat(rotation()).containsExactly(1, 0, 0, 0, 0, -1, 0, 1, 0);
        assertThat(Attitude.heading(column, AT)).isZero();
        Attitude.turn(column, AT, 0, 30);
        assertThat(Attitude.heading(column, AT)).as("about the level own Y").isZero();
        Attitude.orient(column, AT, new double[] {1, 0, 0, 0, 0, -1, 0, 1, 0});
        Attitude.turnAboutX(column, AT, -90);
        assertThat(rotation()).containsExactly(1, 0, 0, 0, 1, 0, 0, 0, 1);
        assertThat(Attitude.isUpright(column, AT)).isTrue();
    }

    @Test
    void anAttitudeThatIsGiven() {
        double[] half = {-1, -0.0, 0, 0, 1, -0.0, -0.0, 0, -1};
        Attitude.orient(column, AT, half);
        assertThat(Attitude.heading(column, AT)).isEqualTo(180);
        assertThat(Arrays.stream(rotation()).map(x -> 1 / x).filter(x -> x == Double.NEGATIVE_INFINITY))
                .isEmpty();
        assertThat(Attitude.isRotation(new double[] {1, 0, 0, 0, 1, 0, 0, 0, -1}))
                .as("a mirror")
                .isFalse();
        // Any of the numbers that hold the own Y up.
        for (int k : new int[] {1, 3, 4, 5, 7}) {
            System.arraycopy(Attitude.identity(), 0, column, AT, Attitude.STRIDE);
            column[AT + k] += 0x1p-50;
            assertThat(Attitude.isUpright(column, AT)).as("number " + k).isFalse();
        }
    }
}
