package robosim.geometry.stress;

import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.PlanarOverlap;
import robosim.geometry.narrow.overlap.SpatialOverlap;
import robosim.geometry.narrow.sweep.PlanarSweep;
import robosim.geometry.narrow.sweep.SpatialSweep;
import robosim.geometry.proof.Witnesses;
import robosim.geometry.reference.Quantity.Arithmetic;
import robosim.geometry.reference.Truth;
import robosim.geometry.reference.Truth.Form;
import robosim.geometry.reference.WayTruth;

/** Whether a leaf that moves straight on touches another by the end of its way: 1 or 0, and 2 where it does at once. */
final class SweepFamily extends Family {
    private static final int AT_ONCE = 2;

    private final boolean planar;
    private final Form[] formsA;
    private final Form[] formsB;

    SweepFamily(String name, boolean planar, Form[] formsA, Form[] formsB) {
        super(name);
        this.planar = planar;
        this.formsA = formsA;
        this.formsB = formsB;
    }

    @Override
    int product(Case c, Scratch s) {
        LeafKind kindA = OverlapFamily.kind(c.formA);
        LeafKind kindB = OverlapFamily.kind(c.formB);
        boolean atOnce = planar
                ? PlanarOverlap.test(new Leaf(kindA, c.a, 0), new Leaf(kindB, c.b, 0), s.overlap)
                : SpatialOverlap.test(new Leaf(kindA, c.a, 0), new Leaf(kindB, c.b, 0), s.overlap);
        if (atOnce) {
            return AT_ONCE;
        }
        return time(c, s) < Double.POSITIVE_INFINITY ? 1 : 0;
    }

    private double time(Case c, Scratch s) {
        LeafKind kindA = OverlapFamily.kind(c.formA);
        LeafKind kindB = OverlapFamily.kind(c.formB);
        double dx = c.ray[3];
        double dy = c.ray[4];
        double dz = c.ray[5];
        return planar
                ? PlanarSweep.translation(new Leaf(kindA, c.a, 0), dx, dy, dz, new Leaf(kindB, c.b, 0), s.sweep)
                : SpatialSweep.translation(new Leaf(kindA, c.a, 0), dx, dy, dz, new Leaf(kindB, c.b, 0), s.sweep);
    }

    @Override
    @Nullable
    String proof(Case c, int answer, Witnesses witnesses, Scratch scratch) {
        return answer == AT_ONCE
                ? null
                : witnesses.translation(
                        Witnesses.object(OverlapFamily.kind(c.formA), c.a),
                        new double[] {c.ray[3], c.ray[4], c.ray[5]},
                        Witnesses.object(OverlapFamily.kind(c.formB), c.b),
                        planar ? Dimension.PLANAR : Dimension.SPATIAL,
                        time(c, scratch));
    }

    @Override
    int truth(Case c, Arithmetic n) {
        boolean atOnce =
                planar ? Truth.planar(n, c.formA, c.a, c.formB, c.b) : Truth.spatial(n, c.formA, c.a, c.formB, c.b);
        if (atOnce) {
            return AT_ONCE;
        }
        double[] way = {c.ray[3], c.ray[4], c.ray[5]};
        return meets(c, n, way) ? 1 : 0;
    }

    private boolean meets(Case c, Arithmetic n, double[] way) {
        if (planar) {
            return WayTruth.planar(n, c.formA, c.a, way[0], way[2], c.formB, c.b);
        }
        if (c.formA == Form.UPRIGHT_CYLINDER) {
            return WayTruth.upright(n, c.a, way, c.formB, c.b);
        }
        if (c.formB == Form.UPRIGHT_CYLINDER) {
            double[] back = {-way[0], -way[1], -way[2]};
            return WayTruth.upright(n, c.b, back, c.formA, c.a);
        }
        if (c.formA == Form.SPHERE) {
            return WayTruth.ball(n, c.a, way, c.formB, c.b);
        }
        if (c.formB == Form.SPHERE) {
            double[] back = {-way[0], -way[1], -way[2]};
            return WayTruth.ball(n, c.b, back, c.formA, c.a);
        }
        return WayTruth.spatial(n, c.formA, c.a, way, c.formB, c.b);
    }

    @Override
    String call() {
        return (planar ? "PlanarSweep" : "SpatialSweep")
                + ".translation(Leaf.A, a, 0, ray[3], ray[4], ray[5], Leaf.B, b, 0, new Scratch())";
    }

    /** A cylinder that rises or sinks on its way is left to exact numbers wherever its plan meets the other's. */
    @Override
    double exactAtRandom() {
        return !planar && formsA[0] == Form.UPRIGHT_CYLINDER ? 0.65 : super.exactAtRandom();
    }

    @Override
    double[] mix(boolean adversarial) {
        return new double[] {0.25, 0.9};
    }

    @Override
    Source source(SplittableRandom random) {
        return new Ways(random);
    }

    private final class Ways implements Source {
        private static final int THRESHOLD_CASES = 16;

        private final SplittableRandom random;
        private final Scratch scratch = new Scratch();
        private final double[] p = new double[3];
        private final double[] q = new double[3];
        private final Case base = new Case();
        private final double[] aside = new double[3];
        private double share;
        private int left;

        Ways(SplittableRandom random) {
            this.random = random;
        }

        private void forms(Case c, boolean grid) {
            c.formA = formsA[random.nextInt(formsA.length)];
            c.formB = formsB[random.nextInt(formsB.length)];
            if (grid) {
                Forms.grid(c.formA, random, c.a);
                Forms.grid(c.formB, random, c.b);
            } else {
                Forms.random(c.formA, random, c.a);
                Forms.random(c.formB, random, c.b);
            }
        }

        @Override
        public void random(Case c) {
            forms(c, false);
            if (Mixed.isDue(random)) {
                Mixed.sizes(c, random);
                Mixed.meet(c, random);
                back(c);
            } else {
                general(c);
            }
        }

        /** Moves the first back by a part of a way that is long beside either, so that it comes to where it is on that. */
        private void back(Case c) {
            double far = 2 * (Forms.reach(c.formA, c.a) + Forms.reach(c.formB, c.b));
            double share = 0.2 + random.nextDouble();
            for (int k = 0; k < 3; k++) {
                c.ray[3 + k] = Forms.between(random, far);
            }
            Forms.move(c.formA, c.a, -share * c.ray[3], -share * c.ray[4], -share * c.ray[5]);
        }

        /** So far apart that they seldom touch, and towards about the middle of the other. */
        private void general(Case c) {
            double x = Forms.between(random, 1);
            double y = planar ? 0 : Forms.between(random, 1);
            double z = Forms.between(random, 1);
            double reach = Forms.reach(c.formA, c.a) + Forms.reach(c.formB, c.b);
            double n = reach * (0.8 + 2 * random.nextDouble()) / Math.sqrt(x * x + y * y + z * z);
            double[] to = {n * x, n * y, n * z};
            Forms.move(c.formB, c.b, to[0], to[1], to[2]);
            boolean thin = c.formA == Form.TRIANGLE && c.formB == Form.TRIANGLE;
            double off = reach * (thin && !planar ? 0.15 : 0.7);
            double length = 0.3 + 1.2 * random.nextDouble();
            for (int k = 0; k < 3; k++) {
                c.ray[3 + k] = length * (to[k] + Forms.between(random, off));
            }
        }

        @Override
        public void adversarial(Case c) {
            if (left > 0) {
                nextAtThreshold(c);
                return;
            }
            switch (random.nextInt(14)) {
                case 0 -> {
                    beginThreshold(c);
                    nextAtThreshold(c);
                    return;
                }
                case 1, 2, 3, 4 -> {
                    forms(c, true);
                    for (int k = 0; k < 3; k++) {
                        c.ray[3 + k] = random.nextInt(-8, 9);
                        if (random.nextInt(3) == 0) {
                            c.ray[3 + k] = random.nextBoolean() ? 0.0 : -0.0;
                        }
                    }
                    if (random.nextInt(3) == 0) {
                        toContact(c, 0);
                    }
                }
                case 9, 10 -> {
                    forms(c, false);
                    Mixed.sizes(c, random);
                    if (random.nextBoolean()) {
                        Mixed.touch(c, random);
                    } else {
                        Mixed.meet(c, random);
                    }
                    back(c);
                }
                case 5, 6 -> {
                    forms(c, true);
                    toContact(c, random.nextBoolean() ? 0 : Forms.tiny(random));
                }
                case 7, 8 -> {
                    forms(c, false);
                    toContact(c, random.nextBoolean() ? 0 : Forms.tiny(random));
                }
                default -> {
                    forms(c, false);
                    general(c);
                    int only = 3 + random.nextInt(3); // along one axis, and just past a corner
                    for (int k = 3; k < 6; k++) {
                        c.ray[k] = k == only ? 4 * c.ray[k] : 0;
                    }
                    pass(c, only - 3);
                }
            }
            Mutations.flatten(c, random);
            Mutations.place(c, random);
        }

        /** So that after some whole steps, or half-way through twice as many, a point of the one is on one of the other. */
        private void toContact(Case c, double gap) {
            Forms.point(c.formA, random, c.a, p);
            Forms.point(c.formB, random, c.b, q);
            double stretch = random.nextInt(3) == 0 ? 2 : 1;
            for (int k = 0; k < 3; k++) {
                double step = random.nextInt(-6, 7);
                c.ray[3 + k] = stretch * step + (k == 1 ? 0 : gap);
                q[k] -= p[k] + step;
            }
            Forms.move(c.formA, c.a, q[0], q[1], q[2]);
        }

        private void pass(Case c, int axis) {
            Forms.point(c.formA, random, c.a, p);
            Forms.point(c.formB, random, c.b, q);
            double gap = random.nextBoolean() ? 0 : Forms.tiny(random);
            Forms.move(
                    c.formB,
                    c.b,
                    axis == 0 ? 0 : p[0] - q[0] + gap,
                    axis == 1 ? 0 : p[1] - q[1] + gap,
                    axis == 2 ? 0 : p[2] - q[2] + gap);
        }

        /** Turns the way aside, or shortens it, until the product says that it is free. */
        private void beginThreshold(Case c) {
            forms(c, false);
            if (random.nextInt(3) == 0) {
                Mixed.sizes(c, random);
            }
            general(c);
            boolean shorten = random.nextInt(3) == 0;
            for (int k = 0; k < 3; k++) {
                double to = Forms.middle(c.formB, c.b, k) - Forms.middle(c.formA, c.a, k);
                c.ray[3 + k] = to;
                aside[k] = shorten ? -to : Forms.between(random, 4);
            }
            base.copyFrom(c);
            share = Threshold.lastYes(t -> {
                at(c, t);
                return product(c, scratch) > 0;
            });
            left = THRESHOLD_CASES;
        }

        private void at(Case c, double t) {
            c.copyFrom(base);
            for (int k = 0; k < 3; k++) {
                c.ray[3 + k] += t * aside[k];
            }
        }

        private void nextAtThreshold(Case c) {
            left--;
            at(c, Math.max(0, Forms.step(share, random.nextInt(-3, 4))));
            if (random.nextBoolean()) {
                int at = 3 + random.nextInt(3);
                c.ray[at] = Forms.step(c.ray[at], random.nextInt(-2, 3));
            }
        }
    }
}
