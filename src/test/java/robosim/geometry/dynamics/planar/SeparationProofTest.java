package robosim.geometry.dynamics.planar;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * What is proved to pass does, at every one of many times, decided exactly; and what passes with room to spare is proved.
 * {@code -Ddynamics.passing=N} for N pairs.
 */
@Tag("slow")
class SeparationProofTest {
    private static final int TIMES = 200;

    private final SplittableRandom random = new SplittableRandom(30);
    private final ConvexPieces pieces = new ConvexPieces();
    private final MovingBodies bodies = new MovingBodies();
    private final Trajectories legs = new Trajectories();
    private final SeparationProof passing = new SeparationProof(pieces, bodies);

    /** Half sizes of a box, or a radius and 0. */
    private final double[][] half = new double[2][2];

    private void add(int body) {
        boolean isDisc = random.nextInt(3) == 0;
        half[body][0] = random.nextDouble(0.1, 0.5);
        half[body][1] = isDisc ? 0 : random.nextDouble(0.02, 0.5);
        int b = bodies.add();
        bodies.firstPiece[b] = pieces.count;
        bodies.pieces[b] = 1;
        bodies.ownLightness[b] = 1;
        pieces.begin(b, b, isDisc ? half[body][0] : 0);
        if (isDisc) {
            pieces.corner(0, 0);
        } else {
            pieces.corner(half[body][0], half[body][1]);
            pieces.corner(-half[body][0], half[body][1]);
            pieces.corner(-half[body][0], -half[body][1]);
            pieces.corner(half[body][0], -half[body][1]);
        }
        bodies.size[b] = pieces.reach[pieces.count - 1] + pieces.radius[pieces.count - 1];
    }

    private GeometryObject at(int body, double x, double z, double angle) {
        Point c = new Point(x, 0, z);
        return half[body][1] == 0
                ? new CylinderObject(c, half[body][0], 1)
                : new BoxObject(c, 2 * half[body][0], 1, 2 * half[body][1]).turned(0, Math.toDegrees(angle));
    }

    /** Where a body is at a share of the time; it has one leg, and may bulge. */
    private GeometryObject after(int body, double s) {
        int leg = legs.last[body];
        double around = 4 * s * (1 - s);
        double x = legs.fromX[body] + s * (legs.x[leg] - legs.fromX[body]) + around * passing.bulgeX[body];
        double z = legs.fromZ[body] + s * (legs.z[leg] - legs.fromZ[body]) + around * passing.bulgeZ[body];
        return at(body, x, z, legs.fromAngle[body] + s * (legs.angle[leg] - legs.fromAngle[body]));
    }

    private boolean isApart() {
        for (int k = 0; k <= TIMES; k++) {
            double s = (double) k / TIMES;
            if (CollisionDetection.intersects(after(0, s), after(1, s))) {
                return false;
            }
        }
        return true;
    }

    private void scene(double turn, double bulge) {
        bodies.count = 0;
        pieces.clear();
        add(0);
        add(1);
        passing.begin();
        legs.makeRoom(2);
        for (int body = 0; body < 2; body++) {
            double x = random.nextDouble(-1, 1);
            double z = random.nextDouble(-1, 1);
            double angle = random.nextDouble(-3, 3);
            legs.begin(body, x, z, angle);
            double toX = x + random.nextDouble(-0.5, 0.5);
            double toZ = z + random.nextDouble(-0.5, 0.5);
            legs.add(body, 1, toX, toZ, angle + random.nextDouble(-turn, turn));
            passing.bulgeX[body] = random.nextDouble(-1, 1) * bulge;
            passing.bulgeZ[body] = random.nextDouble(-1, 1) * bulge;
        }
    }

    /** Moves the second body, at both ends, so near to the first that the ends touch but for a gap. */
    private void bringTogether(double gap) {
        PieceSeparation s = new PieceSeparation();
        PieceSeparation.Places places = new PieceSeparation.Places();
        for (int round = 0; round < 2; round++) {
            int a = legs.last[0];
            int b = legs.last[1];
            if (round == 0) {
                s.put(
                        pieces,
                        0,
                        1,
                        places.a(legs.fromX[0], legs.fromZ[0], legs.fromAngle[0])
                                .b(legs.fromX[1], legs.fromZ[1], legs.fromAngle[1]));
                double by = s.distance() - gap;
                legs.fromX[1] += by * s.nx;
                legs.fromZ[1] += by * s.nz;
            } else {
                s.put(
                        pieces,
                        0,
                        1,
                        places.a(legs.x[a], legs.z[a], legs.angle[a]).b(legs.x[b], legs.z[b], legs.angle[b]));
                double by = s.distance() - gap;
                legs.x[b] += by * s.nx;
                legs.z[b] += by * s.nz;
            }
        }
    }

    @Test
    void whatIsProvedToPassDoes() {
        long count = Long.getLong("dynamics.passing", 20_000);
        int proved = 0;
        int apart = 0;
        for (long k = 0; k < count; k++) {
            scene(k % 2 == 0 ? 0.1 : 2, k % 3 == 0 ? 0.2 : 0);
            if (k % 5 == 0) {
                bringTogether(1e-10);
            }
            boolean isProved = passing.isClear(legs, 0, true, 1, true);
            boolean isApart = (isProved || k % 5 != 0) && isApart();
            assertThat(!isProved || isApart).as("pair %d", k).isTrue();
            proved += isProved ? 1 : 0;
            apart += isApart ? 1 : 0;
        }
        // What was not proved came near or passed between two of the times.
        assertThat((double) proved / apart).isBetween(0.97, 1.0);
        assertThat(proved).isBetween((int) (count / 5), (int) (count * 4 / 5));
    }

    /** Two that touch at both ends and turn, so that the straight way meets, are parted by a bulge; and then they pass. */
    @Test
    void aBulgePartsTwo() {
        int parted = 0;
        int met = 0;
        for (int k = 0; k < 3000; k++) {
            scene(0.05, 0);
            for (int body = 0; body < 2; body++) {
                int leg = legs.last[body];
                legs.x[leg] = legs.fromX[body] + random.nextDouble(-0.02, 0.02);
                legs.z[leg] = legs.fromZ[body] + random.nextDouble(-0.02, 0.02);
            }
            bringTogether(1e-10);
            boolean isPassing = passing.isClear(legs, 0, true, 1, true);
            met += isPassing ? 0 : 1;
            for (int round = 0; round < 8 && !isPassing && passing.part(legs, 0, 1); round++) {
                isPassing = passing.isClear(legs, 0, true, 1, true);
            }
            if (isPassing) {
                assertThat(isApart()).as("pair %d", k).isTrue();
                parted++;
            }
        }
        assertThat(met).isGreaterThan(500);
        assertThat(parted).isGreaterThan(2900 - met / 10);
    }
}
