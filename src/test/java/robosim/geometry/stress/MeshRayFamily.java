package robosim.geometry.stress;

import java.util.Objects;
import java.util.SplittableRandom;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.reference.MeshTruth;
import robosim.geometry.reference.Quantity.Arithmetic;
import robosim.geometry.reference.Truth.Form;

/** Whether a ray hits a mesh: a quad, or a closed surface from outside and from within, where none may leak. */
final class MeshRayFamily extends Family {
    /** What the rays are shot at. */
    enum Target {
        QUAD,
        CLOSED,
        SOLID
    }

    private final Target target;

    MeshRayFamily(String name, Target target) {
        super(name);
        this.target = target;
    }

    @Override
    int product(Case c, Scratch s) {
        double[] r = c.ray;
        Ray ray = new Ray(new Point(r[0], r[1], r[2]), new Point(r[3], r[4], r[5]));
        return CollisionDetection.rayDistance(ray, Objects.requireNonNull(c.meshA)) < Double.POSITIVE_INFINITY ? 1 : 0;
    }

    @Override
    int truth(Case c, Arithmetic n) {
        boolean hit = MeshTruth.isHit(n, c.trianglesA, c.ray);
        if (!hit && target == Target.SOLID) {
            hit = MeshTruth.isInside(n, c.trianglesA, c.ray[0], c.ray[1], c.ray[2]);
        }
        return hit ? 1 : 0;
    }

    @Override
    double[] mix(boolean adversarial) {
        return new double[] {0.25, 0.9};
    }

    @Override
    Source source(SplittableRandom random) {
        return new Shots(random);
    }

    private final class Shots implements Source {
        private final SplittableRandom random;
        private final Surfaces surfaces;
        private final double[] row = new double[Case.ROW];
        private final double[] p = new double[3];

        Shots(SplittableRandom random) {
            this.random = random;
            surfaces = new Surfaces(random);
        }

        /** Makes it thin, or tiny as seen from where the ray starts. */
        private void mixed(Case c) {
            int which = random.nextInt(1, 4);
            if ((which & 1) != 0) {
                surfaces.squash(Mixed.factor(random));
            }
            if ((which & 2) != 0) {
                double away = Mixed.far(random);
                for (int k = 0; k < 3; k++) {
                    c.ray[k] *= away;
                }
            }
        }

        private void make(boolean grid) {
            if (target == Target.QUAD) {
                surfaces.quad(grid);
            } else {
                surfaces.closed(grid);
            }
        }

        @Override
        public void random(Case c) {
            make(false);
            if (random.nextInt(4) == 0) {
                surfaces.turnAndPut(Forms.between(random, 0.2), Forms.between(random, 0.2), Forms.between(random, 0.2));
            }
            double far = target == Target.QUAD || random.nextInt(4) != 0 ? 3 : 0.3;
            for (int k = 0; k < 3; k++) {
                c.ray[k] = Forms.between(random, far);
                c.ray[3 + k] = Forms.between(random, 1.5) - c.ray[k];
            }
            if (Mixed.isDue(random)) {
                mixed(c);
                double[] to = surfaces.about();
                for (int k = 0; k < 3; k++) {
                    c.ray[3 + k] = to[k] - c.ray[k];
                }
            }
            finish(c);
        }

        @Override
        public void adversarial(Case c) {
            boolean grid = random.nextInt(4) != 0;
            make(grid);
            if (random.nextInt(4) == 0) {
                surfaces.squash(Mixed.factor(random));
            }
            double[] triangles = surfaces.triangles();
            point(triangles);
            boolean within = target != Target.QUAD && random.nextInt(3) == 0;
            for (int k = 0; k < 3; k++) {
                c.ray[k] = within ? random.nextInt(-1, 2) / 8.0 : random.nextInt(-6, 7);
                c.ray[3 + k] = p[k] - c.ray[k];
            }
            switch (random.nextInt(6)) {
                case 0 -> { // along an edge or in a face
                    double[] from = p.clone();
                    point(triangles);
                    int back = random.nextInt(-2, 4);
                    for (int k = 0; k < 3; k++) {
                        c.ray[3 + k] = p[k] - from[k];
                        c.ray[k] = from[k] - back * c.ray[3 + k];
                    }
                }
                case 1 -> { // along an axis, at the height of a corner
                    int axis = random.nextInt(3);
                    for (int k = 0; k < 3; k++) {
                        c.ray[k] = k == axis ? c.ray[k] : p[k];
                        c.ray[3 + k] = k == axis ? (random.nextBoolean() ? 1 : -1) : random.nextBoolean() ? 0.0 : -0.0;
                    }
                }
                case 2 -> c.ray[3 + random.nextInt(3)] += Forms.tiny(random);
                case 3 -> {
                    int at = random.nextInt(6);
                    c.ray[at] = Forms.step(c.ray[at], random.nextInt(-2, 3));
                }
                default -> {}
            }
            transform(c);
            if (c.ray[3] == 0 && c.ray[4] == 0 && c.ray[5] == 0) {
                c.ray[3] = 1;
            }
            finish(c);
        }

        private void point(double[] triangles) {
            System.arraycopy(triangles, 9 * random.nextInt(triangles.length / 9), row, 0, 9);
            Forms.point(Form.TRIANGLE, random, row, p);
        }

        private void transform(Case c) {
            int power = switch (random.nextInt(10)) {
                case 0 -> 40;
                case 1 -> -40;
                case 2 -> -300;
                default -> 0;
            };
            surfaces.scale(power);
            for (int k = 0; k < 6; k++) {
                c.ray[k] = Math.scalb(c.ray[k], power);
            }
            if (random.nextInt(5) == 0) {
                double far = random.nextBoolean() ? 1e6 : 1e9;
                surfaces.move(far, far, -far);
                c.ray[0] += far;
                c.ray[1] += far;
                c.ray[2] -= far;
            }
        }

        private void finish(Case c) {
            c.meshA = target == Target.SOLID ? surfaces.mesh().solid() : surfaces.mesh();
            c.trianglesA = surfaces.triangles();
            c.a[0] = c.trianglesA[0];
        }
    }
}
