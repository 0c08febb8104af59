package robosim.geometry.narrow.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.MeshObject;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.Sweep;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;

/** A mesh swept against a mesh, by both trees and past what clearly keeps off, against a sweep of every pair of triangles. */
class MeshSweepTest {
    private final Sweep sweep = new Sweep(new Scratch());
    private final Sweep plain = new Sweep(new Scratch());
    private final LeafColumn one = new LeafColumn(1);
    private final LeafColumn two = new LeafColumn(1);

    private interface Motion {
        void set(Sweep sweep);
    }

    private enum Regime {
        FREE,
        AT_ONCE,
        LATER
    }

    private final int[] seen = new int[Regime.values().length];

    @ParameterizedTest
    @EnumSource
    void translations(MeshRayTest.Family family) {
        SplittableRandom random = new SplittableRandom(7001 + family.ordinal());
        for (int trial = 0; trial < Effort.cases(family == MeshRayTest.Family.SINGLE ? 400 : 28); trial++) {
            MeshObject mover = MeshPairsTest.placed(family.mesh(random), random.nextInt(5), random);
            MeshObject rest = MeshPairsTest.placed(family.mesh(random), random.nextInt(5), random);
            rest = MeshPairsTest.brought(rest, MeshRayTest.rows(LocalLeaves.placed(mover)), trial, family, random);
            boolean isLattice = family == MeshRayTest.Family.LATTICE || family == MeshRayTest.Family.COPLANAR;
            double far = family.size() * (random.nextInt(4) == 0 ? 0.01 : 6);
            double[] way = new double[3];
            for (int k = 0; k < 3; k++) {
                boolean isWay = k == trial % 3 || random.nextBoolean();
                way[k] = !isWay ? 0 : isLattice ? random.nextInt(-8, 9) : random.nextDouble(-far, far);
            }
            Dimension dimension = Dimension.values()[random.nextInt(2)];
            String what = mover + " by " + way[0] + " " + way[1] + " " + way[2] + " to " + rest + " " + dimension;
            compare(mover, rest, what, each -> each.translation(dimension, way[0], way[1], way[2]));
        }
        assertThat(seen[Regime.FREE.ordinal()]).isPositive();
        assertThat(seen[Regime.AT_ONCE.ordinal()] + seen[Regime.LATER.ordinal()])
                .isPositive();
    }

    @ParameterizedTest
    @EnumSource(
            mode = EnumSource.Mode.EXCLUDE,
            names = {"FAR_FROM_ITS_ORIGIN", "HUGE_AND_TINY"}) // all pairs of these take too long
    void turns(MeshRayTest.Family family) {
        SplittableRandom random = new SplittableRandom(7011 + family.ordinal());
        for (int trial = 0; trial < Effort.cases(8); trial++) {
            MeshObject mover = MeshPairsTest.placed(family.mesh(random), random.nextInt(5), random);
            MeshObject rest = MeshPairsTest.placed(family.mesh(random), random.nextInt(5), random);
            rest = MeshPairsTest.brought(rest, MeshRayTest.rows(LocalLeaves.placed(mover)), trial, family, random);
            double degrees = random.nextBoolean() ? random.nextDouble(-5, 5) : random.nextDouble(-200, 200);
            boolean isLevel = random.nextBoolean();
            Dimension dimension = isLevel ? Dimension.values()[random.nextInt(2)] : Dimension.SPATIAL;
            double angle = random.nextDouble(7);
            double off = family.size() * random.nextInt(3);
            double wx = isLevel ? 0 : StrictMath.cos(angle);
            double wz = isLevel ? 0 : StrictMath.sin(angle);
            String what = mover + " turned by " + degrees + " about " + wx + " " + wz + " by " + rest;
            compare(
                    mover,
                    rest,
                    what,
                    each -> each.turn(dimension).about(off, 0, 0).by(wx, isLevel ? 1 : 0, wz, degrees));
        }
        assertThat(seen[Regime.FREE.ordinal()] + seen[Regime.LATER.ordinal()]).isPositive();
    }

    private void compare(MeshObject mover, MeshObject rest, String what, Motion motion) {
        LeafColumn a = LocalLeaves.placed(mover);
        LeafColumn b = LocalLeaves.placed(rest);
        motion.set(plain);
        a.mesh(0).tree(); // whose order numbers the pieces
        b.mesh(0).tree();
        double least = Double.POSITIVE_INFINITY;
        int own = -1;
        int other = -1;
        for (int t = 0; t < a.mesh(0).size(); t++) {
            one.setPiece(a, 0, t);
            for (int u = 0; u < b.mesh(0).size(); u++) {
                two.setPiece(b, 0, u);
                double free = plain.free(one, 0, two, 0);
                boolean isFirst = free == least && own >= 0 && isLower(a, b, t, u, own, other);
                if (free < least || isFirst) {
                    least = free;
                    own = t;
                    other = u;
                }
            }
        }
        motion.set(sweep);
        assertThat(sweep.free(a, 0, b, 0)).as(what).isEqualTo(least);
        assertThat(sweep.ownPiece()).as(what).isEqualTo(own);
        assertThat(sweep.otherPiece()).as(what).isEqualTo(other);
        assertThat(sweep.isBlocked(a, 0, b, 0, null)).as(what).isEqualTo(least < Double.POSITIVE_INFINITY);
        Regime regime = own < 0 ? Regime.FREE : least == 0 ? Regime.AT_ONCE : Regime.LATER;
        seen[regime.ordinal()]++;
    }

    private static boolean isLower(LeafColumn a, LeafColumn b, int t, int u, int own, int other) {
        int order = Integer.compare(a.mesh(0).tree().item(t), a.mesh(0).tree().item(own));
        return order < 0
                || (order == 0 && b.mesh(0).tree().item(u) < b.mesh(0).tree().item(other));
    }
}
