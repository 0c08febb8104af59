package robosim.geometry.scenario;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Move;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.proof.Attempt;
import robosim.geometry.proof.Proof;
import robosim.geometry.proof.ProofChecker;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.scenario.recording.QuietLog;

/**
 * Proves a seeded share of the answers of sessions, and checks the proofs: moves, distances of sonars, and where bodies are after
 * steps. A proof that fails is logged, and stored as a scenario with the world and the request. Batches are not sampled.
 *
 * <p>May be used by sessions in any threads. A session waits while an answer is proved, so that a small share costs little.
 */
public final class AnswerProofs implements Function<String, SessionListener> {
    private static final System.Logger LOG = System.getLogger(AnswerProofs.class.getPackageName());

    private final double share;
    private final SessionOptions options;
    private final Path folder;
    private final LongAdder proved;
    private final LongAdder unprovable;
    private final AtomicLong failed;

    /**
     * Proofs of a share of the answers.
     *
     * @param share   from 0, of none, to 1, of all
     * @param options of the sessions
     * @param folder  where failures are stored; made when there is one
     */
    public AnswerProofs(double share, SessionOptions options, Path folder) {
        this(share, options, folder, new LongAdder(), new LongAdder(), new AtomicLong());
    }

    private AnswerProofs(
            double share,
            SessionOptions options,
            Path folder,
            LongAdder proved,
            LongAdder unprovable,
            AtomicLong failed) {
        this.proved = proved;
        this.unprovable = unprovable;
        this.failed = failed;
        if (!(share >= 0 && share <= 1)) {
            throw new IllegalArgumentException("share must be from 0 to 1 (got: " + share + ")");
        }
        this.share = share;
        this.options = Checks.present("options", options);
        this.folder = Checks.present("folder", folder);
    }

    /** The same for sessions with other options, counted together. */
    public AnswerProofs with(SessionOptions other) {
        return new AnswerProofs(share, other, folder, proved, unprovable, failed);
    }

    /** A listener for the session of a name, which is the seed of what is drawn. */
    @Override
    public SessionListener apply(String session) {
        return new Sample(
                new SplittableRandom(Checks.present("session", session).hashCode()));
    }

    /** The number of proofs that were found and hold; an answer may need several. */
    public long proved() {
        return proved.sum();
    }

    /** The number of answers, or parts of one, without a proof: {@code docs/proofs.md} says which these are. */
    public long unprovable() {
        return unprovable.sum();
    }

    /** The number of proofs that do not hold. */
    public long failed() {
        return failed.get();
    }

    /** The numbers as text for people. */
    @Override
    public String toString() {
        String where = failed() == 0 ? "" : ", see " + folder;
        return String.format(
                Locale.ROOT,
                "proofs: %,d hold, %,d answers have none, %,d failed%s",
                proved(),
                unprovable(),
                failed(),
                where);
    }

    /** The answers of one session. */
    private final class Sample implements SessionListener {
        private final SplittableRandom random;
        private final BitSet drawn = new BitSet();
        private @Nullable Session session;
        private @Nullable Snapshot before;

        Sample(SplittableRandom random) {
            this.random = random;
        }

        @Override
        public void opened(Session opened) {
            session = opened;
        }

        @Override
        public void requested(Bundle request) {
            Geometry world = session == null ? null : session.world();
            before = null;
            draw(size(request));
            if (world != null && !drawn.isEmpty()) {
                before = world.snapshot();
            }
        }

        private void draw(int size) {
            drawn.clear();
            for (int k = 0; k < size; k++) {
                if (random.nextDouble() < share) {
                    drawn.set(k);
                }
            }
        }

        @Override
        public void replied(Bundle request, @Nullable Reply reply, long nanoseconds) {
            if (reply != null && reply.bundle() instanceof StepBundle.Answer step) {
                bodies(step);
            } else if (reply != null && before != null) {
                new Answers(before, request, reply).prove(drawn);
            }
            before = null;
        }

        private void bodies(StepBundle.Answer step) {
            Geometry world = session == null ? null : session.world();
            draw(step.bodies().size());
            for (int k = drawn.nextSetBit(0); world != null && k >= 0; k = drawn.nextSetBit(k + 1)) {
                body(world, step.bodies().get(k));
            }
        }

        private void body(Geometry world, BodyAnswer body) {
            String flaw = check(world, () -> List.of(world.prove().clear(body.objectName())));
            if (flaw != null) {
                String told = "after a step, " + Text.quoted(body.objectName()) + ": " + flaw;
                store(told, init(world.snapshot()), null, null);
            }
        }
    }

    private static int size(Bundle request) {
        return request instanceof MoveBundle moves
                ? moves.moves().size()
                : request instanceof SonarRequestBundle sonars
                        ? sonars.requests().size()
                        : 0;
    }

    /** The answers to one bundle, asked again in a copy of the world before it. */
    private final class Answers {
        private final Snapshot before;
        private final Geometry world;
        private final Session again;
        private final Bundle request;
        private final Reply reply;

        Answers(Snapshot before, Bundle request, Reply reply) {
            this.before = before;
            this.request = request;
            this.reply = reply;
            world = before.toGeometry();
            again = new Session(world, options, SessionListener.NONE, "proof", new QuietLog());
        }

        void prove(BitSet which) {
            for (int k = 0; k < which.length(); k++) {
                String flaw = request instanceof MoveBundle moves
                        ? move(k, moves.moves().get(k), which.get(k))
                        : which.get(k)
                                ? distance(
                                        k,
                                        ((SonarRequestBundle) request)
                                                .requests()
                                                .get(k))
                                : null;
                if (flaw != null) {
                    store("answer " + k + ": " + flaw, init(before), request, reply);
                }
            }
        }

        private @Nullable String move(int k, MoveRequest move, boolean isDrawn) {
            String flaw = isDrawn ? check(world, () -> attempts(move)) : null;
            Reply made = again.reply(new MoveBundle(List.of(move)));
            boolean isRefused = made != null && !made.problems().isEmpty();
            boolean wasRefused = reply.problems().stream().anyMatch(problem -> problem.index() == k);
            return flaw == null && isRefused != wasRefused ? "asked again, the answer is another one" : flaw;
        }

        private List<Attempt> attempts(MoveRequest move) {
            Move turned =
                    new Move(move.x(), move.y(), move.z(), Degrees.toDegrees(move.rx()), Degrees.toDegrees(move.ry()));
            return world.prove().move(move.objectName(), turned);
        }

        private @Nullable String distance(int k, SonarRequest sonar) {
            Reply asked = again.reply(new SonarRequestBundle(List.of(sonar)));
            double given = ((DistanceBundle) reply.bundle()).distances().get(k);
            if (asked == null || !((DistanceBundle) asked.bundle()).distances().equals(List.of(given))) {
                return "asked again, the answer is another one";
            }
            Beam beam = sonar.beam() == null ? options.beam() : sonar.beam();
            double width = Degrees.toDegrees(beam.width());
            return check(
                    world,
                    () -> List.of(world.prove()
                            .sonar(sonar.objectName(), sonar.xOffset(), sonar.zOffset(), beam.max(), width)));
        }
    }

    /** Attempts to prove an answer. */
    @FunctionalInterface
    private interface Proving {
        List<Attempt> attempts();
    }

    /** Counts the outcome, and reports the first flaw. */
    private @Nullable String check(Geometry world, Proving proving) {
        List<Attempt> attempts;
        try {
            attempts = proving.attempts();
        } catch (IllegalArgumentException refused) {
            unprovable.increment(); // a request that is refused, or a world at a coarser accuracy
            return null;
        }
        ProofChecker checker = world.prove().checker();
        List<String> flaws = new ArrayList<>();
        for (Attempt attempt : attempts) {
            Proof proof = attempt.proof();
            ProofChecker.Result result = proof == null ? null : checker.check(proof);
            if (result == null) {
                unprovable.increment();
            } else if (result.isValid()) {
                proved.increment();
            } else {
                flaws.add(result.reason() + ": " + proof);
            }
        }
        return flaws.isEmpty() ? null : flaws.get(0);
    }

    private static InitBundle init(Snapshot world) {
        return new InitBundle(
                world.objects(),
                new WorldSettings(world.width(), world.height(), world.length(), world.dimension(), world.accuracy()));
    }

    private void store(String flaw, InitBundle init, @Nullable Bundle request, @Nullable Reply reply) {
        long number = failed.incrementAndGet();
        String told = Text.line(flaw);
        try {
            Files.createDirectories(folder);
            Path file = write(number, told, init, request, reply);
            LOG.log(System.Logger.Level.WARNING, "a proof failed, stored as " + file + ": " + told);
        } catch (IOException | RuntimeException e) {
            LOG.log(System.Logger.Level.WARNING, "a proof failed, and could not be stored (" + e + "): " + told);
        }
    }

    private Path write(long number, String flaw, InitBundle init, @Nullable Bundle request, @Nullable Reply reply)
            throws IOException {
        for (long next = number; ; next++) {
            Path file = folder.resolve("failed-proof-" + next + ScenarioReader.ENDING);
            try (OutputStream out = Files.newOutputStream(file, StandardOpenOption.CREATE_NEW)) {
                ScenarioWriter writer = new ScenarioWriter(out, new ScenarioHeader("a proof that failed", options));
                writer.note(flaw);
                writer.request(init);
                if (request != null) {
                    writer.request(request);
                    writer.answer(reply, null);
                }
                return file;
            } catch (FileAlreadyExistsException taken) {
                LOG.log(System.Logger.Level.DEBUG, "there is a {0} already", file);
            }
        }
    }
}
