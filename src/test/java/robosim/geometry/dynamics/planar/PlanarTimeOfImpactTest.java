package robosim.geometry.dynamics.planar;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;

/** When two meet, against a walk through many times; also where they touch at first and another corner comes down later. */
class PlanarTimeOfImpactTest {
    private static final double GAP = 1e-10;
    private static final int TIMES = 200;

    /** Where coordinates are so large that a millionth of the gap is lost in rounding. */
    private static final double WALL = 6.1;

    private final ConvexPieces pieces = new ConvexPieces();
    private final MovingBodies bodies = new MovingBodies();
    private final PlanarTimeOfImpact impact = new PlanarTimeOfImpact(bodies, pieces);

    PlanarTimeOfImpactTest() {
        bodies.add();
        pieces.begin(0, 0, 0);
        pieces.corner(0.225, 0.175);
        pieces.corner(-0.225, 0.175);
        pieces.corner(-0.225, -0.175);
        pieces.corner(0.225, -0.175);
        pieces.begin(-1, 0, 0);
        pieces.corner(5, WALL);
        pieces.corner(-5, WALL);
        pieces.corner(-5, WALL + 1);
        pieces.corner(5, WALL + 1);
        impact.stayApart(GAP);
    }

    @Test
    void noMeetingIsLost() {
        SplittableRandom random = new SplittableRandom(7);
        int met = 0;
        int never = 0;
        for (int k = 0; k < Effort.cases(20_000); k++) {
            double angle = random.nextInt(3) == 0 ? 0 : random.nextDouble(-3e-3, 3e-3);
            pieces.turn(0, Math.cos(angle), Math.sin(angle));
            bodies.x[0] = random.nextDouble(-4, 4);
            bodies.time[0] = 0;
            bodies.z[0] = WALL - 0.3;
            bodies.z[0] -= GAP * random.nextDouble(1, 1.001) - impact.measure(0, 1, 0);
            bodies.w[0] = random.nextDouble(-0.4, 0.4);
            // The corner that touches parts from the wall.
            double corner = 0.225 * Math.abs(bodies.w[0]);
            bodies.vz[0] = corner * random.nextDouble(-1, 1.5);
            bodies.vx[0] = random.nextDouble(-0.2, 0.2);
            double from = random.nextDouble(0.01);
            bodies.time[0] = from;
            double time = impact.first(0, 1, from, 0.05);
            double until = Math.min(time, 0.05);
            for (int n = 0; n <= TIMES; n++) {
                double t = from + (until - from) * n / TIMES;
                assertThat(impact.measure(0, 1, t))
                        .as("case %d at %s of %s", k, t, until)
                        .isPositive();
            }
            // What is told as a meeting is one.
            assertThat(time == from || time == PlanarTimeOfImpact.NEVER || impact.measure(0, 1, time) < 2.1 * GAP)
                    .as("case %d at %s", k, time)
                    .isTrue();
            met += time < 0.05 ? 1 : 0;
            never += time < 0.05 ? 0 : 1;
        }
        assertThat(met).isGreaterThan(Effort.cases(300));
        assertThat(never).isGreaterThan(Effort.cases(300));
    }

    /**
     * A box that touches a wall with one corner, which parts, and turns the next one into it; from a run of robots in rooms. The
     * root that is looked for was only ever come upon from behind.
     */
    @Test
    void theNextCornerMeets() {
        pieces.clear();
        pieces.begin(0, 0, 0);
        pieces.corner(0.17462749159748417, -0.22528923449284163);
        pieces.corner(0.17537202934598886, 0.224710149577338);
        pieces.corner(-0.17462749159748417, 0.22528923449284163);
        pieces.corner(-0.17537202934598886, -0.224710149577338);
        pieces.begin(-1, 0, 0);
        pieces.corner(8.899999999999999, -6.1);
        pieces.corner(15.3, -6.1);
        pieces.corner(15.3, -5.9);
        pieces.corner(8.899999999999999, -5.9);
        double from = 0.006089733022888586;
        bodies.time[0] = from;
        bodies.x[0] = 9.4915078494238;
        bodies.z[0] = -6.325322941023011;
        bodies.angle[0] = 1.9304307571709354E-4;
        bodies.vx[0] = 0.017094412007905384;
        bodies.vz[0] = 0.03914696623992056;
        bodies.w[0] = -0.3721597179312793;
        double time = impact.first(0, 1, from, 0.05);
        // The corner in front comes down by 5e-4 m at 0.1 m/s.
        assertThat(time).isBetween(0.0122, 0.0123);
        assertThat(impact.measure(0, 1, time)).isBetween(0.0, GAP);
    }
}
