package robosim.geometry.net;

import java.util.Locale;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.LongAdder;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;

/** Counts what the connections of one server or client do. */
final class Figures implements FiguresMXBean {
    private final AtomicInteger open = new AtomicInteger();
    private final LongAdder opened = new LongAdder();
    private final LongAdder refused = new LongAdder();
    private final LongAdder bundles = new LongAdder();
    private final LongAdder requests = new LongAdder();
    private final LongAdder refusedMoves = new LongAdder();
    private final LongAdder errors = new LongAdder();
    private final Histogram times = new Histogram();
    private final LongAdder answers = new LongAdder();
    private final LongAdder answerNanos = new LongAdder();

    void opened() {
        open.incrementAndGet();
        opened.increment();
    }

    void closed() {
        open.decrementAndGet();
    }

    void refused() {
        refused.increment();
    }

    void failed() {
        errors.increment();
    }

    void carriedOut(Bundle request, @Nullable Reply reply) {
        bundles.increment();
        if (request instanceof MoveBundle moves) {
            requests.add(moves.moves().size());
            if (reply != null && reply.bundle() instanceof MoveBundle made) {
                refusedMoves.add(moves.moves().size() - made.moves().size());
            }
        } else if (request instanceof SonarRequestBundle sonars) {
            requests.add(sonars.requests().size());
        } else if (request instanceof BatchRequestBundle batch) {
            requests.add(batch.size());
        } else if (request instanceof StepBundle step) {
            requests.add(1 + step.size());
        }
    }

    /** Counts an answer that was sent, with the time since its request came. */
    void answered(long nanos) {
        times.add(nanos);
        answers.increment();
        answerNanos.add(nanos);
    }

    @Override
    public int getOpenConnections() {
        return open.get();
    }

    @Override
    public long getConnections() {
        return opened.sum();
    }

    @Override
    public long getRefusedConnections() {
        return refused.sum();
    }

    @Override
    public long getBundles() {
        return bundles.sum();
    }

    @Override
    public long getRequests() {
        return requests.sum();
    }

    @Override
    public long getRefusedMoves() {
        return refusedMoves.sum();
    }

    @Override
    public long getErrors() {
        return errors.sum();
    }

    @Override
    public long getAnswers() {
        return answers.sum();
    }

    @Override
    public double getAnswerMicrosecondsInAll() {
        return answerNanos.sum() / 1e3;
    }

    @Override
    public double getAnswerMicrosecondsP50() {
        return times.quantile(0.5) / 1e3;
    }

    @Override
    public double getAnswerMicrosecondsP99() {
        return times.quantile(0.99) / 1e3;
    }

    @Override
    public String line() {
        return String.format(
                Locale.ROOT,
                "connections %d open, %d in all, %d refused; %d bundles, %d requests, %d moves refused; %d errors;"
                        + " an answer takes %.0f us (p50), %.0f us (p99)",
                getOpenConnections(),
                getConnections(),
                getRefusedConnections(),
                getBundles(),
                getRequests(),
                getRefusedMoves(),
                getErrors(),
                getAnswerMicrosecondsP50(),
                getAnswerMicrosecondsP99());
    }
}
