package robosim.geometry.dynamics.spatial;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.engine.World;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;

/** When two turning boxes meet that are nearly in contact, against a walk through many times. */
class SpatialTimeOfImpactTest {
    private static final double SLICE = 1e-3;
    private static final int TIMES = 100;

    private final World world = world();
    private final NearbyPieces near = new NearbyPieces(world.placer(), new double[] {30, 30, 30});
    private final ContactGeometry meeting = new ContactGeometry();
    private final RotationVectors turning = new RotationVectors();
    private final LeafColumn leafA = new LeafColumn(1);
    private final LeafColumn leafB = new LeafColumn(1);
    private final double[] place = new double[Pose.PLACE];

    private static World world() {
        Scratch scratch = new Scratch();
        ObjectRegistry registry = new ObjectRegistry(60, 60, 60, Dimension.SPATIAL, Accuracy.EXACT, null, scratch);
        registry.add(new BoxObject(new Point(0, 0, 0), 0.5, 0.3, 0.4).moveable("a"), false);
        registry.add(new BoxObject(new Point(2, 0, 0), 0.5, 0.3, 0.4).moveable("b"), false);
        return new World(registry, scratch);
    }

    private RigidBody box(String name) {
        RigidBody body = new RigidBody(world.objects.find(name), 1, new double[] {1, 1, 1}, false, Math.sqrt(0.125));
        for (int k = 0; k < 3; k++) {
            body.place[3 + 4 * k] = 1;
        }
        return body;
    }

    /** How far the two are apart after a share of a slice; 0 where they touch. */
    private double apart(RigidBody a, RigidBody b, double share) {
        at(a, share, leafA);
        at(b, share, leafB);
        return meeting.measure(leafA.kind(0), leafA.rows(), 0, leafB.kind(0), leafB.rows(), 0) ? meeting.apart : 0;
    }

    private void at(RigidBody body, double share, LeafColumn leaf) {
        double[] turn = {SLICE * body.v[3], SLICE * body.v[4], SLICE * body.v[5]};
        turning.turn(body.place, turn, share, place);
        for (int axis = 0; axis < 3; axis++) {
            place[axis] = body.place[axis] + share * SLICE * body.v[axis];
        }
        near.leaf(body, place, leaf);
    }

    /** Puts a box at a random attitude beside another one, so that it rolls and slips on that one where they are nearest. */
    private void putBeside(SplittableRandom random, RigidBody a, RigidBody b) {
        for (RigidBody body : List.of(a, b)) {
            double[] turn = {random.nextDouble(-3, 3), random.nextDouble(-3, 3), random.nextDouble(-3, 3)};
            turning.turn(body.place, turn, 1, body.place);
            for (int k = 0; k < 3; k++) {
                body.v[k] = random.nextDouble(-1, 1);
                body.v[3 + k] = random.nextDouble(-8, 8);
            }
        }
        double gap = 1e-7 * Math.pow(1000, random.nextDouble());
        double angle = random.nextDouble(6);
        b.place[0] = 2 * Math.cos(angle);
        b.place[1] = random.nextDouble(-1, 1);
        b.place[2] = 2 * Math.sin(angle);
        for (int k = 0; k < 200 && apart(a, b, 0) > gap * (1 + 1e-6); k++) {
            b.place[0] += (meeting.apart - gap) * meeting.nx;
            b.place[1] += (meeting.apart - gap) * meeting.ny;
            b.place[2] += (meeting.apart - gap) * meeting.nz;
        }
        double slip = random.nextDouble(-0.1, 0.1);
        double[] n = {meeting.nx, meeting.ny, meeting.nz};
        for (int k = 0; k < 3; k++) {
            int y = (k + 1) % 3;
            int z = (k + 2) % 3;
            // The centre of the other one moves as a point of the first would, but for turning more or less than that.
            double y0 = b.place[y] - a.place[y];
            double z0 = b.place[z] - a.place[z];
            b.v[k] = a.v[k] + a.v[3 + y] * z0 - a.v[3 + z] * y0 + slip * n[k];
        }
        for (int k = 0; k < 3; k++) {
            b.v[3 + k] = a.v[3 + k] + random.nextDouble(-1, 1);
        }
    }

    @Test
    void whatIsFoundIsAContactAndNoneIsLost() {
        SplittableRandom random = new SplittableRandom(7);
        int met = 0;
        int never = 0;
        int untrue = 0;
        for (int run = 0; run < Effort.cases(2000); run++) {
            RigidBody a = box("a");
            RigidBody b = box("b");
            putBeside(random, a, b);
            System.arraycopy(a.v, 0, a.u, 0, 6);
            System.arraycopy(b.v, 0, b.u, 0, 6);
            Clusters cluster = new Clusters(List.of(a, b), new double[3], (one, other) -> false);
            cluster.member = new int[] {0, 1};
            cluster.count = 2;
            double share = new SpatialTimeOfImpact(List.of(a, b), near).first(cluster, SLICE);
            for (int k = 0; k <= TIMES; k++) {
                assertThat(apart(a, b, share * k / TIMES))
                        .as("run %d at %d of %d, share %s", run, k, TIMES, share)
                        .isGreaterThan(TurningSweep.GAP);
            }
            if (share < SpatialTimeOfImpact.NEVER) {
                met++;
                untrue += apart(a, b, share) > 2 * TurningSweep.GAP ? 1 : 0;
            } else {
                never++;
            }
        }
        assertThat(met).isGreaterThan(Effort.cases(2000) / 20);
        assertThat(never).isGreaterThan(Effort.cases(2000) / 20);
        assertThat(untrue).as("of %d", met).isZero();
    }
}
