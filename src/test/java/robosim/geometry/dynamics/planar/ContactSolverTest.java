package robosim.geometry.dynamics.planar;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** What the solver finds keeps the laws of contact, also where contacts that slide rub less than those that stick. */
class ContactSolverTest {
    private static final int RUNS = 4000;
    private static final double STILL = 0.3;
    private static final double SLIDING = 0.2;

    /** Speeds here are of the order of 1 m/s. */
    private static final double NOTHING = 1e-9;

    private final MovingBodies bodies = new MovingBodies();
    private final FloorFriction floor = new FloorFriction(bodies);
    private final Island island = new Island(bodies, floor);
    private final ContactSolver solver = new ContactSolver(bodies, floor, island);
    private final SplittableRandom random = new SplittableRandom(5);

    /** A body that is pressed into a wedge, with another one behind it: no contact goes from sticking to sliding for ever. */
    @Test
    void contactsStickOrSlide() {
        for (int body = 0; body < 2; body++) {
            bodies.add();
            floor.set(body, 0, 0);
        }
        int sticking = 0;
        int sliding = 0;
        int broken = 0;
        for (int run = 0; run < RUNS; run++) {
            begin();
            assertThat(solver.solve(true)).isTrue();
            boolean isBroken = false;
            for (int c = 0; c < island.count; c++) {
                isBroken |= !isLawful(c);
                boolean isPushed = solver.push[c] > 0;
                sticking += isPushed && Math.abs(island.aside(c)) < NOTHING ? 1 : 0;
                sliding += isPushed && Math.abs(island.aside(c)) >= NOTHING ? 1 : 0;
            }
            broken += isBroken ? 1 : 0;
        }
        assertThat(sticking).isGreaterThan(RUNS / 4);
        assertThat(sliding).isGreaterThan(RUNS / 2);
        // Where contacts went on to change from sticking to sliding, 292 islands broke a law.
        assertThat(broken).isLessThan(RUNS / 100);
    }

    private void begin() {
        island.begin();
        for (int body = 0; body < 2; body++) {
            bodies.lightness[body] = random.nextDouble(0.1, 1);
            bodies.ease[body] = random.nextDouble(1, 40);
            bodies.size[body] = 0.3;
            bodies.x[body] = 0;
            bodies.z[body] = 0.5 * body;
            bodies.vx[body] = random.nextDouble(-1, 1);
            bodies.vz[body] = random.nextDouble(-1, 1);
            bodies.w[body] = random.nextDouble(-4, 4);
            island.addBody(body);
        }
        contact(-1, random.nextDouble(-3.2, 0));
        contact(-1, random.nextDouble(-3.2, 0));
        contact(1, random.nextDouble(-2, -1));
    }

    /** A contact of the first body with a wall or the other one, towards which the normal points from there by an angle. */
    private void contact(int other, double angle) {
        double nx = Math.cos(angle);
        double nz = Math.sin(angle);
        double aside = random.nextDouble(-0.2, 0.2);
        int c = island.add(0, 0, other, -0.25 * nx - aside * nz, -0.25 * nz + aside * nx, nx, nz);
        island.restitution[c] = 0;
        island.still[c] = STILL;
        island.sliding[c] = SLIDING;
        island.least[c] = 0;
    }

    private boolean isLawful(int c) {
        double parting = island.parting(c);
        double aside = island.aside(c);
        double push = solver.push[c];
        double rub = solver.rub[c];
        boolean isNormal = push >= 0 && parting > -NOTHING && (push < NOTHING || parting < NOTHING);
        boolean isSticking = Math.abs(aside) < NOTHING && Math.abs(rub) <= STILL * push + NOTHING;
        boolean isSliding = aside * rub <= NOTHING && Math.abs(Math.abs(rub) - SLIDING * push) < NOTHING;
        return isNormal && (isSticking || isSliding);
    }
}
