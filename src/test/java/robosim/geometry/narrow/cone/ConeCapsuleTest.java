package robosim.geometry.narrow.cone;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafKind;

/** Capsules that a cone in space hardly hears, or hardly misses. The census has the random ones, in every regime. */
class ConeCapsuleTest {
    private final Scratch scratch = new Scratch();

    /** A segment that touches the border from outside, between its ends, at a distance of 1: (1, 0, 1) at 60 degrees from (1, 1, 0). */
    @Test
    void aTangentSegmentIsHeard() {
        double[] d = {1, 1, 0};
        // Through (1, 0, 1) and along (1, -1, -1), which is square to the border there.
        double[] row = new double[16];
        row[0] = 1;
        row[2] = 1;
        row[4] = 1;
        row[7] = 1;
        row[10] = -1;
        row[13] = -1;
        assertThat(cone(new double[3], d, 0.5, LeafKind.CAPSULE, row))
                .isBetween(Math.sqrt(2) * (1 - 0x1p-40), Math.sqrt(2) * (1 + 0x1p-52));
        row[3] = 0x1p-30;
        assertThat(cone(new double[3], d, 0.5, LeafKind.CAPSULE, row)).isBetween(1.414, 1.4142136);
        // Turned away by a little more than what may be heard.
        row[3] = 0;
        assertThat(cone(new double[3], d, 0.5 + 0x1p-40, LeafKind.CAPSULE, row)).isInfinite();
    }

    /** Beside a short segment that is nearest at an end, to which a search comes close only. */
    @Test
    void aShortSegmentIsHardlyBelowTheTruth() {
        double[] o = {0.7041550027051194, 0.3085778573652017, -0.1111495927988969};
        double[] d = {-0.19837810385662885, -4.239867797583155, 4.6533562501149826};
        double[] row = new double[16];
        double[] numbers = {
            0.744159406988691, 0.10591009542814556, -0.14465301078602355, 0.20927192959509372, 7.144968664870911E-7
        };
        System.arraycopy(numbers, 0, row, 0, 5);
        row[7] = 0.7251703615315184;
        row[10] = 0.02941728775104118;
        row[13] = 0.6879408186302216;
        double cosine = StrictMath.cos(1.7292261900499056E-5);
        // Of decimals of 60 digits.
        double truth = 1.0472294009282421489e-5;
        assertThat(cone(o, d, cosine, LeafKind.CAPSULE, row)).isBetween(truth - 0x1p-45, truth);
    }

    /** Thin ones that pass a narrow cone by 10^-12 to 10^-5, where the distance from the cone hardly changes along them. */
    @Test
    void whatIsMissedByLittleIsNotHeard() {
        double[] o = {-1.3612539954111225, 1.7855461550813745, -1.0378057674317152};
        double[] d = {1.0664419243522767E-4, -0.9999999922875328, 6.365493562095842E-5};
        double[] row = new double[16];
        row[0] = -1.361111138644569;
        row[1] = -0.17303440448196383;
        row[2] = -1.037910276671231;
        row[4] = 1.9585805595633383;
        isMissed(o, d, 1.1434148170146109E-4, LeafKind.UPRIGHT_CAPSULE, row);

        o = new double[] {-2.4436706506733015, 0.7061061702098379, -1.009773318196646};
        d = new double[] {1.1634127356854398, -8.719614090779476, -1.6131363705031816};
        row = new double[16];
        row[0] = -1.9439286637154725;
        row[1] = -1.0482157567056718;
        row[2] = -1.371636005160548;
        row[4] = 2.286159294408648;
        row[7] = 0.26875068058742463;
        row[10] = -0.9433839730299987;
        row[13] = -0.19442158088527758;
        isMissed(o, d, 0.1430309559089543, LeafKind.CAPSULE, row);

        o = new double[] {4.048684937915821, 0.9499087638184673, 3.2002982565877383};
        d = new double[] {-3.058325500165685, -0.2611644758629321, -2.098380762228681};
        row = new double[16];
        row[0] = 0.8695099992353867;
        row[1] = 0.6781559529111871;
        row[2] = 1.018708585089707;
        row[3] = 3.726558602259326E-8;
        row[4] = 5.675546243502183E-4;
        row[7] = -0.876424495136596;
        row[10] = 0.4720453277568838;
        row[13] = -0.09514889840381309;
        isMissed(o, d, 6.913805323962652E-6, LeafKind.CAPSULE, row);
    }

    private void isMissed(double[] o, double[] d, double half, LeafKind kind, double[] row) {
        double cosine = StrictMath.cos(half);
        assertThat(cone(o, d, cosine, kind, row)).isInfinite();
    }

    private double cone(double[] o, double[] d, double cosine, LeafKind kind, double[] row) {
        double sine = Math.sqrt((1 - cosine) * (1 + cosine));
        return SpatialCone.distance(
                new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]).widen(cosine, sine),
                kind,
                row,
                0,
                Double.POSITIVE_INFINITY,
                scratch.cone);
    }
}
