package robosim.geometry.stress;

import java.util.Arrays;
import java.util.Objects;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.proof.Witnesses;
import robosim.geometry.reference.MeshTruth;
import robosim.geometry.reference.Quantity.Arithmetic;
import robosim.geometry.reference.Truth.Form;

/** Whether a small box, or a point, meets a solid mesh: its surface or its inside. */
final class SolidFamily extends Family {
    SolidFamily(String name) {
        super(name);
    }

    @Override
    int product(Case c, Scratch s) {
        return CollisionDetection.intersects(Objects.requireNonNull(c.meshA), box(c.b)) ? 1 : 0;
    }

    private static BoxObject box(double[] b) {
        return new BoxObject(new Point(b[0], b[1], b[2]), 2 * b[3], 2 * b[4], 2 * b[5]);
    }

    @Override
    @Nullable
    String proof(Case c, int answer, Witnesses witnesses, Scratch scratch) {
        return witnesses.overlap(box(c.b), c.meshA, Dimension.SPATIAL, answer == 1, true);
    }

    @Override
    int truth(Case c, Arithmetic n) {
        return MeshTruth.meets(n, c.trianglesA, Form.UPRIGHT_BOX, c.b)
                        || MeshTruth.isInside(n, c.trianglesA, c.b[0], c.b[1], c.b[2])
                ? 1
                : 0;
    }

    @Override
    Source source(SplittableRandom random) {
        Surfaces surfaces = new Surfaces(random);
        return new Source() {
            @Override
            public void random(Case c) {
                surfaces.closed(false);
                if (random.nextInt(4) == 0) {
                    surfaces.turnAndPut(0, 0, 0);
                }
                box(c, false);
                for (int k = 0; k < 3; k++) {
                    c.b[k] = Forms.between(random, 1.2);
                    c.b[3 + k] = random.nextDouble() * 0.2;
                }
                if (Mixed.isDue(random)) {
                    mixed(c);
                    double[] p = surfaces.about();
                    for (int k = 0; k < 3; k++) {
                        c.b[k] = p[k] + Forms.between(random, 1.5) * c.b[3 + k];
                    }
                }
                finish(c);
            }

            /** Makes the box small or thin, or the mesh thin. */
            private void mixed(Case c) {
                Mixed.sizes(c.formB, random, c.b);
                if (random.nextInt(3) == 0) {
                    surfaces.squash(Mixed.factor(random));
                }
            }

            @Override
            public void adversarial(Case c) {
                boolean grid = random.nextInt(4) != 0;
                surfaces.closed(grid);
                box(c, grid);
                if (random.nextInt(4) == 0) {
                    mixed(c);
                }
                hard(c);
                finish(c);
            }

            private void box(Case c, boolean grid) {
                c.formB = Form.UPRIGHT_BOX;
                Arrays.fill(c.b, 0);
                Forms.upright(c.b, 1, 0);
                for (int k = 0; k < 3; k++) {
                    // In line with corners, so that a ray from there runs through them
                    c.b[k] = grid ? random.nextInt(-6, 7) / 4.0 : Forms.between(random, 1.5);
                    c.b[3 + k] = random.nextInt(3) * random.nextInt(2) / 16.0;
                }
            }

            /** At the level of a corner, on an edge or a face, or nearly; scaled and moved. */
            private void hard(Case c) {
                double[] triangles = surfaces.triangles();
                double[] row = new double[Case.ROW];
                System.arraycopy(triangles, 9 * random.nextInt(triangles.length / 9), row, 0, 9);
                double[] p = new double[3];
                Forms.point(Form.TRIANGLE, random, row, p);
                int sort = random.nextInt(4);
                for (int k = 0; k < 3; k++) {
                    if (sort == 0 || (sort == 1 && k == 1) || (sort == 2 && k > 0)) {
                        c.b[k] = p[k] + (random.nextInt(4) == 0 ? Forms.tiny(random) : 0);
                    }
                    if (sort == 0 && random.nextBoolean()) {
                        c.b[k] -= c.b[3 + k];
                    }
                }
                int power = switch (random.nextInt(10)) {
                    case 0 -> 40;
                    case 1 -> -40;
                    case 2 -> -300;
                    case 3 -> -1060;
                    default -> 0;
                };
                surfaces.scale(power);
                Forms.scale(c.formB, c.b, power);
                if (random.nextInt(5) == 0) {
                    double far = random.nextBoolean() ? 1e6 : 1e9;
                    surfaces.move(far, -far, far);
                    Forms.move(c.formB, c.b, far, -far, far);
                }
            }

            private void finish(Case c) {
                c.meshA = surfaces.mesh().solid();
                c.trianglesA = surfaces.triangles();
                c.a[0] = c.trianglesA[0];
            }
        };
    }
}
