package robosim.geometry.proof;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.contract.RandomObjects;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** Damaged witnesses, and good ones of other claims, are rejected: by the checker, and by the one in Python. */
@Tag("clock")
class DamagedProofsTest {
    private static final Point NOWHERE = new Point(1e6, 1e6, 1e6);

    private final SplittableRandom random = new SplittableRandom(4410);
    private final RandomObjects objects = new RandomObjects(random, 1.5);
    private final List<String> documents = new ArrayList<>();
    private @Nullable Scene checked;
    private @Nullable ProofChecker checker;
    private int valid;
    private int damaged;
    private int wrong;

    private ProofChecker checker(Scene scene) {
        ProofChecker made = checker == null || checked != scene ? new ProofChecker(scene) : checker;
        checker = made;
        checked = scene;
        return made;
    }

    private void accepts(Scene scene, Proof proof) {
        assertThat(checker(scene).check(proof).reason()).as("%s", proof).isEmpty();
        valid++;
        if (documents.size() < 300) {
            documents.add("valid\t" + ProofJson.of(proof, scene));
        }
    }

    private void rejects(Scene scene, Claim claim, Witness witness, boolean isDamage) {
        Proof proof = new Proof(claim, witness);
        assertThat(checker(scene).check(proof).isValid())
                .as("%s in %s", proof, scene)
                .isFalse();
        damaged += isDamage ? 1 : 0;
        wrong += isDamage ? 0 : 1;
        if (documents.size() < 300) {
            documents.add("invalid\t" + ProofJson.of(proof, scene));
        }
    }

    private static Witness with(Witness w, List<Witness.Slab> slabs) {
        return new Witness(w.common(), slabs, w.contact(), w.outsides(), w.reach());
    }

    private static Witness with(Witness w, Witness.Contact contact) {
        return new Witness(w.common(), w.slabs(), contact, w.outsides(), w.reach());
    }

    /** Every slab is needed, as those pairs are given one that the axes do not decide. */
    private void damageSlabs(Scene scene, Claim claim, Witness w) {
        for (int k = 0; k < Math.min(4, w.slabs().size()); k++) {
            Witness.Slab slab = w.slabs().get(k);
            Point n = slab.normal();
            List<Witness.Slab> without = new ArrayList<>(w.slabs());
            without.remove(k);
            // The axes may decide a pair all the same, where doubles were not sure of it.
            if (checker(scene).check(new Proof(claim, with(w, without))).isValid()) {
                continue;
            }
            rejects(scene, claim, with(w, without), true);
            rejects(scene, claim, replaced(w, k, slab.mine(), slab.theirs(), 1, n, -1), true);
            rejects(scene, claim, replaced(w, k, slab.mine(), slab.theirs(), 1, n, 0), true);
            rejects(scene, claim, replaced(w, k, slab.mine() + 1000, slab.theirs(), 1, n, 1), true);
            rejects(scene, claim, replaced(w, k, slab.mine(), slab.theirs() + 100000, 1, n, 1), true);
            if (slab.to() > slab.from()) {
                rejects(scene, claim, replaced(w, k, slab.mine(), slab.theirs(), 0.5, n, 1), true);
            }
        }
    }

    private static Witness replaced(Witness w, int k, int mine, int theirs, double part, Point n, double sign) {
        Witness.Slab s = w.slabs().get(k);
        double to = s.from() + part * (s.to() - s.from());
        List<Witness.Slab> slabs = new ArrayList<>(w.slabs());
        Point normal = new Point(sign * n.x(), sign * n.y(), sign * n.z());
        slabs.set(k, new Witness.Slab(mine, theirs, s.from(), to, normal, s.along()));
        return with(w, slabs);
    }

    private void pairs(int count) {
        for (int k = 0; k < count; k++) {
            GeometryObject a = objects.next();
            GeometryObject b = objects.next();
            Scene scene = Scene.of(b);
            boolean touches = CollisionDetection.intersects(a, b);
            Attempt attempt =
                    touches ? Prover.of(b).touching(a, 0) : Prover.of(b).apart(a);
            Proof proof = attempt.proof();
            if (proof == null) {
                continue;
            }
            accepts(scene, proof);
            Witness w = proof.witness();
            GeometryObject elsewhere = a.movedTo(touches ? new Point(40, 0, 0) : b.center());
            if (CollisionDetection.intersects(elsewhere, b) != touches) {
                Claim claim = touches
                        ? new Claim.Touching(elsewhere, 0)
                        : new Claim.Apart(elsewhere, Claim.ALL, 0, List.of());
                rejects(scene, claim, w, false);
            }
            if (touches) {
                rejects(scene, new Claim.Apart(a, Claim.ALL, 0, List.of()), w, false);
                rejects(scene, new Claim.Distance(a, Claim.ALL, 0, 1e-300, 9), w, false);
                rejects(scene, proof.claim(), with(w, (Witness.Contact) null), true);
                damageContact(scene, proof.claim(), w);
            } else {
                rejects(scene, new Claim.Touching(a, 0), w, false);
                rejects(scene, new Claim.Apart(b, Claim.ALL, 0, List.of()), w, false);
                damageSlabs(scene, proof.claim(), w);
            }
        }
    }

    private void damageContact(Scene scene, Claim claim, Witness w) {
        Witness.Contact c = w.contact();
        rejects(scene, claim, with(w, contact(c.mine(), c.theirs(), c, Witness.Form.NEAR, c.point())), true);
        rejects(scene, claim, with(w, contact(c.mine() + 1000, c.theirs(), c, c.form(), c.point())), true);
        rejects(scene, claim, with(w, contact(c.mine(), c.theirs() + 1000, c, c.form(), c.point())), true);
        rejects(scene, claim, with(w, contact(c.mine(), -1, c, c.form(), c.point())), true);
        rejects(scene, claim, with(w, contact(c.mine(), c.theirs(), c, Witness.Form.POINT, NOWHERE)), true);
    }

    private static Witness.Contact contact(int mine, int theirs, Witness.Contact c, Witness.Form form, Point point) {
        return new Witness.Contact(mine, theirs, form, c.corners(), point, c.anchors());
    }

    private void world() {
        RandomObjects wide = new RandomObjects(random, 5);
        Geometry world = new Geometry(40, 40, 40);
        for (int n = 0; n < 12; n++) {
            world.addObject(wide.next());
        }
        if (!world.addObject(wide.primitive().moveable("robot"))) {
            return;
        }
        GeometryObject robot = world.getObject("robot");
        int self = world.objects().indexOf(robot);
        Scene scene = world.prove().scene();
        Point d = wide.direction();
        for (Attempt attempt :
                world.prove().move("robot", new Move(4 * d.x(), d.y(), 4 * d.z(), 0, random.nextInt(-80, 80)))) {
            move(scene, attempt, self);
        }
        Ray ray = new Ray(wide.place(), wide.direction());
        beam(scene, world.prove().ray(ray, 30));
        beam(scene, world.prove().cone(ray, 30, random.nextInt(1, 80)));
        near(scene, world.prove().proximity("robot", 30));
    }

    private void move(Scene scene, Attempt attempt, int self) {
        Proof proof = attempt.proof();
        if (proof == null) {
            return;
        }
        accepts(scene, proof);
        Witness w = proof.witness();
        damageSlabs(scene, proof.claim(), w);
        if (proof.claim() instanceof Claim.Blocked c) {
            rejects(scene, new Claim.Translation(c.body(), self, c.displacement(), 1, c.touched()), w, false);
            rejects(scene, new Claim.Translation(c.body(), self, c.displacement(), c.at(), c.touched()), w, false);
            rejects(
                    scene,
                    new Claim.Blocked(
                            c.body(), self, c.displacement(), c.free(), c.free() / 2 - 1e-9, c.other(), c.touched()),
                    w,
                    false);
            rejects(
                    scene,
                    new Claim.Blocked(c.body(), self, c.displacement(), c.free(), c.at(), self, c.touched()),
                    w,
                    false);
        } else if (proof.claim() instanceof Claim.Translation c) {
            // An object that nobody was told of stands in the way.
            Scene fuller = with(scene, new BoxObject(c.body().center(), 0.01, 0.01, 0.01));
            rejects(fuller, c, w, false);
            Claim other = new Claim.Translation(c.body(), self == 0 ? 1 : 0, c.displacement(), 1, c.touched());
            rejects(scene, other, w, false);
            rejects(scene, new Claim.Translation(c.body(), self, new Point(500, 0, 0), 1, c.touched()), w, false);
        } else if (proof.claim() instanceof Claim.Turn c) {
            rejects(with(scene, new BoxObject(c.body().center(), 0, 0, 0)), c, w, false);
            rejects(scene, new Claim.Turn(c.body(), self, new Point(), c.tangent(), c.touched()), w, false);
        } else if (proof.claim() instanceof Claim.Apart c) {
            rejects(with(scene, c.body().named("twin")), c, w, false);
            rejects(
                    scene,
                    new Claim.Apart(c.body().movedTo(new Point(20.000001, 0, 0)), self, Claim.ALL, List.of()),
                    w,
                    false);
        }
    }

    private static Scene with(Scene scene, GeometryObject more) {
        List<GeometryObject> all = new ArrayList<>(scene.objects());
        all.add(more);
        return new Scene(all, scene.dimension(), scene.size());
    }

    private void beam(Scene scene, Attempt attempt) {
        Proof proof = attempt.proof();
        if (proof == null) {
            return;
        }
        accepts(scene, proof);
        Witness w = proof.witness();
        damageSlabs(scene, proof.claim(), w);
        if (proof.claim() instanceof Claim.Ray c) {
            Witness farther = new Witness(w.common(), w.slabs(), w.contact(), w.outsides(), 1e3);
            if (c.high() < 30) {
                double beyond = c.high() * 1.001 + 1e-6;
                rejects(
                        scene,
                        new Claim.Ray(c.start(), c.direction(), -1, beyond, Double.POSITIVE_INFINITY, -1),
                        w,
                        false);
                rejects(
                        scene,
                        new Claim.Ray(c.start(), c.direction(), -1, beyond, Double.POSITIVE_INFINITY, -1),
                        farther,
                        false);
                if (c.low() > 0) {
                    rejects(
                            scene,
                            new Claim.Ray(c.start(), c.direction(), -1, 0, c.low() * 0.999, c.other()),
                            w,
                            false);
                    rejects(
                            scene,
                            new Claim.Ray(c.start(), c.direction(), c.other(), c.low(), c.high(), c.other()),
                            w,
                            false);
                }
            }
            if (c.low() > 0) {
                Point start = c.start();
                rejects(with(scene, new BoxObject(start, 0, 0, 0)), c, w, false);
                rejects(scene, c, new Witness(w.common(), w.slabs(), w.contact(), w.outsides(), w.reach() / 2), true);
            }
        } else if (proof.claim() instanceof Claim.Cone c && c.low() > 0) {
            rejects(with(scene, new BoxObject(c.start(), 0, 0, 0)), c, w, false);
            rejects(scene, new Claim.Cone(c.start(), c.direction(), 0, -1, c.low(), c.high(), -1), w, false);
        }
    }

    private void near(Scene scene, Attempt attempt) {
        Proof proof = attempt.proof();
        if (proof == null) {
            return;
        }
        accepts(scene, proof);
        Claim.Distance c = (Claim.Distance) proof.claim();
        if (c.low() > 0 && c.high() < Double.POSITIVE_INFINITY) {
            Witness w = proof.witness();
            rejects(scene, new Claim.Distance(c.body(), c.self(), -1, c.high() * 1.0001, 99), w, false);
            rejects(scene, new Claim.Distance(c.body(), c.self(), -1, 0, c.low() * 0.9999), w, false);
            rejects(scene, new Claim.Distance(c.body(), c.self(), c.self(), c.low(), c.high()), w, false);
        }
    }

    @Test
    void noneIsAccepted(@TempDir Path folder) throws Exception {
        int count = Effort.cases(2000);
        pairs(count);
        for (int k = 0; k < count / 4; k++) {
            world();
        }
        assertThat(damaged).isGreaterThan(2 * count);
        assertThat(wrong).isGreaterThan(2 * count);
        python(folder);
    }

    private void python(Path folder) throws Exception {
        StringBuilder lines = new StringBuilder();
        for (String document : documents) {
            lines.append(document.substring(document.indexOf('\t') + 1)).append('\n');
        }
        Path file = Files.writeString(folder.resolve("proofs.jsonl"), lines);
        Path out = folder.resolve("out.txt");
        Process process;
        try {
            process = new ProcessBuilder("python3", "examples/check_proof.py", file.toString())
                    .redirectErrorStream(true)
                    .redirectOutput(out.toFile())
                    .start();
        } catch (java.io.IOException none) {
            Assumptions.abort("there is no python3");
            return;
        }
        assertThat(process.waitFor(120, TimeUnit.SECONDS)).isTrue();
        List<String> found = Files.readAllLines(out);
        assertThat(found)
                .as("%s", found.subList(Math.max(0, found.size() - 5), found.size()))
                .hasSameSizeAs(documents);
        for (int k = 0; k < documents.size(); k++) {
            String document = documents.get(k);
            assertThat(found.get(k)).as(document).startsWith(document.substring(0, document.indexOf('\t')));
        }
    }
}
