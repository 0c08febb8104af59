package robosim.geometry.stress;

import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.PlanarOverlap;
import robosim.geometry.narrow.overlap.SpatialOverlap;
import robosim.geometry.proof.Witnesses;
import robosim.geometry.reference.Quantity.Arithmetic;
import robosim.geometry.reference.Truth;
import robosim.geometry.reference.Truth.Form;

/** Whether two convex leaves have a point in common, in the plane or in space. */
final class OverlapFamily extends Family {
    final boolean planar;
    private final Form[] formsA;
    private final Form[] formsB;
    private final double spread;
    private final boolean parallel;

    /**
     * @param spread how far apart the random ones are at most, in the sum of their reaches, for a mix of yes and no
     */
    OverlapFamily(String name, boolean planar, Form[] formsA, Form[] formsB, double spread) {
        this(name, planar, formsA, formsB, spread, false);
    }

    /**
     * @param parallel whether both have the same attitude, to the bit
     */
    OverlapFamily(String name, boolean planar, Form[] formsA, Form[] formsB, double spread, boolean parallel) {
        super(name);
        this.planar = planar;
        this.formsA = formsA;
        this.formsB = formsB;
        this.spread = spread;
        this.parallel = parallel;
    }

    static LeafKind kind(Form form) {
        return LeafKind.valueOf(form.name());
    }

    @Override
    int product(Case q, Scratch s) {
        boolean touch = planar
                ? PlanarOverlap.test(new Leaf(kind(q.formA), q.a, 0), new Leaf(kind(q.formB), q.b, 0), s.overlap)
                : SpatialOverlap.test(new Leaf(kind(q.formA), q.a, 0), new Leaf(kind(q.formB), q.b, 0), s.overlap);
        return touch ? 1 : 0;
    }

    @Override
    int truth(Case q, Arithmetic n) {
        boolean touch =
                planar ? Truth.planar(n, q.formA, q.a, q.formB, q.b) : Truth.spatial(n, q.formA, q.a, q.formB, q.b);
        return touch ? 1 : 0;
    }

    @Override
    @Nullable
    String proof(Case q, int answer, Witnesses witnesses, Scratch scratch) {
        return witnesses.overlap(
                Witnesses.object(kind(q.formA), q.a),
                Witnesses.object(kind(q.formB), q.b),
                planar ? Dimension.PLANAR : Dimension.SPATIAL,
                answer == 1,
                true);
    }

    @Override
    String call() {
        return (planar ? "PlanarOverlap" : "SpatialOverlap") + ".test(Leaf.A, a, 0, Leaf.B, b, 0, new Scratch())";
    }

    @Override
    Source source(SplittableRandom random) {
        return new Pairs(random);
    }

    private final class Pairs implements Source {
        private final SplittableRandom random;
        private final Threshold threshold;
        private final Scratch scratch = new Scratch();
        private final double[] p = new double[3];
        private final double[] q = new double[3];

        Pairs(SplittableRandom random) {
            this.random = random;
            threshold = new Threshold(OverlapFamily.this, random, scratch);
        }

        private void forms(Case c) {
            c.formA = formsA[random.nextInt(formsA.length)];
            c.formB = formsB[random.nextInt(formsB.length)];
            c.ray[0] = 0;
        }

        @Override
        public void random(Case c) {
            forms(c);
            if (Mixed.isDue(random)) {
                mixed(c);
                Mixed.meet(c, random);
                together(c);
            } else {
                general(c);
            }
        }

        private void mixed(Case c) {
            Forms.random(c.formA, random, c.a);
            Forms.random(c.formB, random, c.b);
            align(c);
            Mixed.sizes(c, random);
        }

        private void general(Case c) {
            Forms.random(c.formA, random, c.a);
            Forms.random(c.formB, random, c.b);
            align(c);
            apart(c, spread * random.nextDouble());
        }

        private void align(Case c) {
            if (parallel) {
                System.arraycopy(c.a, 6, c.b, 6, 9);
            }
        }

        /** Moves both about, b so far from a in some direction. */
        private void apart(Case c, double share) {
            double x = Forms.between(random, 1);
            double y = planar ? 0 : Forms.between(random, 1);
            double z = Forms.between(random, 1);
            double n =
                    share * (Forms.reach(c.formA, c.a) + Forms.reach(c.formB, c.b)) / Math.sqrt(x * x + y * y + z * z);
            Forms.move(c.formB, c.b, toMiddle(c, 0) + n * x, toMiddle(c, 1) + n * y, toMiddle(c, 2) + n * z);
            together(c);
        }

        private void together(Case c) {
            double shiftX = Forms.between(random, 2);
            double shiftY = Forms.between(random, 2);
            double shiftZ = Forms.between(random, 2);
            Forms.move(c.formA, c.a, shiftX, shiftY, shiftZ);
            Forms.move(c.formB, c.b, shiftX, shiftY, shiftZ);
        }

        private static double toMiddle(Case c, int axis) {
            return Forms.middle(c.formA, c.a, axis) - Forms.middle(c.formB, c.b, axis);
        }

        @Override
        public void adversarial(Case c) {
            if (threshold.isGoing()) {
                threshold.next(c);
                return;
            }
            forms(c);
            switch (random.nextInt(24)) {
                case 0 -> {
                    general(c);
                    if (random.nextBoolean()) {
                        Mixed.sizes(c, random);
                    } else {
                        Mutations.elongate(c, random);
                    }
                    threshold.begin(c);
                    threshold.next(c);
                    return;
                }
                case 1, 2, 3, 4 -> {
                    Forms.grid(c.formA, random, c.a);
                    Forms.grid(c.formB, random, c.b);
                    align(c);
                }
                case 5, 6, 7, 8 -> {
                    nearlyParallel(c);
                    align(c);
                }
                case 9, 10, 11 -> {
                    touching(c, false);
                    align(c);
                }
                case 12, 13 -> {
                    touching(c, true);
                    align(c);
                }
                case 14, 15 -> {
                    Mutations.tangent(c, random, planar);
                    align(c);
                }
                case 16, 17 -> {
                    mixed(c);
                    Mixed.meet(c, random);
                }
                case 18, 19 -> {
                    mixed(c);
                    Mixed.touch(c, random);
                }
                default -> {
                    general(c);
                    Mutations.elongate(c, random);
                    meetAt(c);
                }
            }
            Mutations.flatten(c, random);
            Mutations.place(c, random);
        }

        /** A point of b is put on a point of a, and a little further. */
        private void meetAt(Case c) {
            Forms.point(c.formA, random, c.a, p);
            Forms.point(c.formB, random, c.b, q);
            double gap = random.nextInt(3) == 0 ? 0 : Forms.tiny(random);
            Forms.move(c.formB, c.b, p[0] - q[0] + gap, p[1] - q[1], p[2] - q[2] + gap);
        }

        private void touching(Case c, boolean dyadic) {
            Forms.grid(c.formA, random, c.a);
            if (dyadic) {
                Forms.grid(c.formB, random, c.b);
            } else {
                Forms.random(c.formB, random, c.b);
            }
            Forms.point(c.formA, random, c.a, p);
            if (c.formB == Form.TRIANGLE) {
                double x = p[0] - c.b[0];
                double y = p[1] - c.b[1];
                double z = p[2] - c.b[2];
                Forms.move(c.formB, c.b, x, y, z);
                Mutations.share(c, random);
            } else {
                Forms.point(c.formB, random, c.b, q);
                Forms.move(c.formB, c.b, p[0] - q[0], p[1] - q[1], p[2] - q[2]);
            }
        }

        /** b has a's attitude but for a little, and lies on one of its sides but for a little. */
        private void nearlyParallel(Case c) {
            Forms.random(c.formA, random, c.a);
            Forms.random(c.formB, random, c.b);
            double gap = random.nextInt(3) == 0 ? 0 : Forms.tiny(random);
            double angle = random.nextInt(4) == 0 ? 0 : Forms.tiny(random);
            if (c.formA == Form.TRIANGLE && c.formB == Form.TRIANGLE) {
                Mutations.coplanar(c, random, gap);
                return;
            }
            if (c.formB == Form.TRIANGLE) {
                Mutations.lay(c.formA, c.a, c.b, random, gap);
                return;
            }
            if (c.formA == Form.TRIANGLE) {
                Mutations.lay(c.formB, c.b, c.a, random, gap);
                return;
            }
            if (Forms.isTurned(c.formA) || c.formB == Form.UPRIGHT_BOX) {
                System.arraycopy(c.a, 6, c.b, 6, 9);
                if (c.formB == Form.UPRIGHT_BOX && c.formA != Form.UPRIGHT_BOX) {
                    Forms.yaw(c.b, Forms.between(random, 3));
                }
                Forms.disturb(c.formB, random, c.b, angle);
            }
            int axis = random.nextInt(3);
            double side = random.nextBoolean() ? 1 : -1;
            for (int k = 0; k < 3; k++) {
                double share = k == axis ? side : Forms.between(random, 1);
                double sizes = Forms.size(c.formA, c.a, k) + Forms.size(c.formB, c.b, k);
                double way = sizes * share + (k == axis ? side * gap : 0);
                for (int r = 0; r < 3; r++) {
                    c.b[r] += way * (Forms.hasAxes(c.formA) ? c.a[6 + 3 * r + k] : r == k ? 1 : 0);
                }
            }
        }
    }
}
