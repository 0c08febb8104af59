package robosim.geometry.stress;

import java.util.Objects;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.proof.Witnesses;
import robosim.geometry.reference.MeshTruth;
import robosim.geometry.reference.Quantity.Arithmetic;

/** Whether two small meshes have a point in common: two surfaces, or a solid one and a surface. */
final class MeshFamily extends Family {
    private final boolean solid;

    /**
     * @param solid whether the first counts its inside, and is closed
     */
    MeshFamily(String name, boolean solid) {
        super(name);
        this.solid = solid;
    }

    @Override
    int product(Case c, Scratch s) {
        return CollisionDetection.intersects(Objects.requireNonNull(c.meshA), Objects.requireNonNull(c.meshB)) ? 1 : 0;
    }

    @Override
    @Nullable
    String proof(Case c, int answer, Witnesses witnesses, Scratch scratch) {
        return witnesses.overlap(c.meshA, c.meshB, Dimension.SPATIAL, answer == 1, true);
    }

    @Override
    int truth(Case c, Arithmetic n) {
        boolean meet = MeshTruth.meet(n, c.trianglesA, c.trianglesB);
        if (!meet && solid) {
            // The first of b's corners; b is one connected piece.
            meet = MeshTruth.isInside(n, c.trianglesA, c.trianglesB[0], c.trianglesB[1], c.trianglesB[2]);
        }
        return meet ? 1 : 0;
    }

    @Override
    double[] mix(boolean adversarial) {
        return new double[] {0.25, 0.9};
    }

    @Override
    Source source(SplittableRandom random) {
        return new Meshes(random);
    }

    private final class Meshes implements Source {
        private final SplittableRandom random;
        private final Surfaces first;
        private final Surfaces second;

        Meshes(SplittableRandom random) {
            this.random = random;
            first = new Surfaces(random);
            second = new Surfaces(random);
        }

        @Override
        public void random(Case c) {
            make(first, false, solid);
            make(second, false, false);
            if (Mixed.isDue(random)) {
                mixed();
                first.center(first.about());
                second.center(second.about());
                finish(c);
                return;
            }
            double far = solid ? 1.4 : 0.6;
            if (random.nextInt(4) == 0) {
                first.turnAndPut(0, 0, 0);
                second.turnAndPut(Forms.between(random, far), Forms.between(random, far), Forms.between(random, far));
            } else {
                second.move(Forms.between(random, far), Forms.between(random, far), Forms.between(random, far));
            }
            if (solid) {
                second.scale(-random.nextInt(4));
            }
            finish(c);
        }

        /** Makes one thin, or the second tiny; a tiny one meets the inside of a solid one, or one of its sides. */
        private void mixed() {
            int which = random.nextInt(1, 8);
            if ((which & 1) != 0) {
                first.squash(Mixed.factor(random));
            }
            if ((which & 2) != 0) {
                second.squash(Mixed.factor(random));
            }
            if ((which & 4) != 0) {
                second.scale(-random.nextInt(10, 67));
            }
        }

        private void make(Surfaces surfaces, boolean grid, boolean closed) {
            if (closed) {
                surfaces.closed(grid);
            } else {
                surfaces.strip(grid);
            }
        }

        @Override
        public void adversarial(Case c) {
            boolean grid = random.nextInt(4) != 0;
            make(first, grid, solid || random.nextBoolean());
            make(second, grid, false);
            if (solid) {
                second.scale(-random.nextInt(5));
            } else if (random.nextBoolean()) {
                second.scale(random.nextInt(-3, 3));
            }
            double far = random.nextInt(6) / 2.0;
            second.move(far * random.nextInt(-1, 2), far * random.nextInt(-1, 2), far * random.nextInt(-1, 2));
            if (random.nextInt(5) == 0) {
                mixed();
                first.center(first.point());
                second.center(second.point());
            } else if (random.nextInt(3) != 0) {
                touch();
            }
            if (random.nextInt(3) == 0) {
                first.nudge();
                second.nudge();
            }
            switch (random.nextInt(8)) {
                case 0 -> scale(40);
                case 1 -> scale(-40);
                case 2 -> scale(-300);
                case 3 -> scale(-random.nextInt(1030, 1074));
                case 4 -> move(1e6);
                case 5 -> move(1e9);
                default -> {}
            }
            finish(c);
        }

        /** Puts all of the second so that a corner of it is on a corner, an edge or a face of the first. */
        private void touch() {
            double[] triangles = first.triangles();
            double[] row = new double[Case.ROW];
            System.arraycopy(triangles, 9 * random.nextInt(triangles.length / 9), row, 0, 9);
            double[] p = new double[3];
            Forms.point(robosim.geometry.reference.Truth.Form.TRIANGLE, random, row, p);
            double[] q =
                    second.corners.get(random.nextInt(second.corners.size())).clone();
            double gap = random.nextInt(3) == 0 ? Forms.tiny(random) : 0;
            second.move(p[0] - q[0] + gap, p[1] - q[1], p[2] - q[2]);
        }

        private void scale(int power) {
            first.scale(power);
            second.scale(power);
        }

        private void move(double far) {
            first.move(far, -far, far / 2);
            second.move(far, -far, far / 2);
        }

        private void finish(Case c) {
            c.meshA = solid ? first.mesh().solid() : first.mesh();
            c.meshB = second.mesh();
            c.trianglesA = first.triangles();
            c.trianglesB = second.triangles();
            c.a[0] = c.trianglesA[0];
            c.b[1] = c.trianglesB[1];
        }
    }
}
