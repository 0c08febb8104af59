package robosim.geometry.net.pace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.net.HostilePeerTest;

/** Turns on a clock of the test's own: who computes when, without threads and without waiting. */
@Timeout(60)
class CpuTurnsTest {
    private static final long MILLI = 1_000_000;

    /** How often one that computes looks up. */
    private static final long BREATH = MILLI / 10;

    private final AtomicLong now = new AtomicLong(1);

    /** A connection whose peer asks for so much, then says nothing for a while, again and again. */
    private static final class Asker {
        final CpuTurn turn;
        final long work;
        final long pause;
        long left;
        long idleUntil;
        long askedAt;
        long computed;
        long done;
        long longestWait;

        Asker(CpuTurn turn, long work, long pause) {
            this.turn = turn;
            this.work = work;
            this.pause = pause;
            this.left = work;
        }

        void step(CpuTurns turns, long time) {
            if (turn.state == CpuTurn.State.RUNNING) {
                computed += BREATH;
                left -= BREATH;
                if (left <= 0) {
                    turn.give();
                    turn.rest();
                    done++;
                    left = work;
                    idleUntil = time + pause;
                } else {
                    if (turns.areWanted()) {
                        turns.giveWay(turn);
                    }
                    askedAt = turn.isWaiting() ? time : askedAt;
                }
            } else if (turn.state == CpuTurn.State.IDLE && time >= idleUntil) {
                askedAt = time;
                turns.ask(turn);
            }
            if (turn.isWaiting()) {
                longestWait = Math.max(longestWait, time - askedAt);
            }
        }
    }

    private List<Asker> askers(CpuTurns turns, int count, long work, long pause) {
        List<Asker> askers = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            askers.add(new Asker(turns.turn(), work, pause));
        }
        return askers;
    }

    private void run(CpuTurns turns, List<Asker> askers, long time) {
        for (long end = now.get() + time; now.get() < end; now.addAndGet(BREATH)) {
            for (Asker asker : askers) {
                asker.step(turns, now.get());
            }
        }
    }

    private static long running(List<Asker> askers) {
        return askers.stream().filter(asker -> asker.turn.isRunning()).count();
    }

    @Test
    void longWorkIsDoneInSlicesByAsManyAsThereAreProcessorsInFairShares() {
        CpuTurns turns = new CpuTurns(2, now::get);
        List<Asker> greedy = askers(turns, 50, 1_000 * MILLI, 0);
        for (int k = 0; k < 2_000; k++) {
            run(turns, greedy, MILLI);
            assertThat(running(greedy)).isEqualTo(2);
        }
        for (Asker each : greedy) {
            assertThat(each.computed / MILLI).isBetween(40L, 160L); // a fiftieth of two processors is 80
            assertThat(each.longestWait / MILLI).isLessThan(500L);
        }
    }

    @Test
    void aShortQuestionDoesNotWaitForLongOnes() {
        CpuTurns turns = new CpuTurns(2, now::get);
        List<Asker> all = askers(turns, 50, 50 * MILLI, 0);
        Asker healthy = new Asker(turns.turn(), BREATH, MILLI);
        all.add(healthy);
        run(turns, all, 1_000 * MILLI);
        healthy.longestWait = 0; // by now it is known for short questions
        run(turns, all, 1_000 * MILLI);
        assertThat(healthy.longestWait).isZero();
        assertThat(healthy.done).isGreaterThan(1_500);
    }

    /** On a machine that is busy with other things a short question takes long, and stays a short question. */
    @Test
    void whatTheMachineDoesElseMakesNobodyHeavy() {
        AtomicLong processor = new AtomicLong(1);
        CpuTurns turns = new CpuTurns(1, now::get, processor::get);
        CpuTurn healthy = turns.turn();
        CpuTurn other = turns.turn();
        for (CpuTurn each : List.of(healthy, other, healthy, other, healthy, other, healthy, other)) {
            each.take(); // by now both are known for short questions
            processor.addAndGet(BREATH);
            each.give();
            each.rest();
        }
        for (int k = 0; k < 10; k++) {
            healthy.take();
            turns.ask(other);
            assertThat(other.isWaiting()).isTrue();
            now.addAndGet(30 * MILLI); // off the processor
            turns.lend(other);
            assertThat(healthy.isLent).isTrue();
            processor.addAndGet(BREATH);
            healthy.give();
            healthy.rest();
            turns.leave(other);
        }
        assertThat(healthy.need()).isLessThan(CpuTurns.SHORT_NANOS);
        assertThat(healthy.isHeavy()).isFalse();
        healthy.take();
        turns.ask(other);
        now.addAndGet(30 * MILLI);
        processor.addAndGet(30 * MILLI); // on it
        turns.lend(other);
        healthy.give();
        assertThat(healthy.isHeavy()).isTrue();
    }

    @Test
    void aNewcomerWaitsForFewSlices() {
        CpuTurns turns = new CpuTurns(2, now::get);
        List<Asker> all = askers(turns, 50, 1_000 * MILLI, 0);
        run(turns, all, 1_000 * MILLI);
        Asker newcomer = new Asker(turns.turn(), BREATH, MILLI);
        all.add(newcomer);
        run(turns, all, 100 * MILLI);
        assertThat(newcomer.longestWait).isLessThanOrEqualTo(2 * CpuTurns.SLICE_NANOS + BREATH);
        assertThat(newcomer.done).isGreaterThan(10);
    }

    /** Messages that are sent without end are one burst: who never rests is not short. */
    @Test
    void aFloodOfSmallMessagesIsLongWork() {
        CpuTurns turns = new CpuTurns(1, now::get);
        CpuTurn flood = turns.turn();
        turns.ask(flood);
        for (int k = 0; k < 100; k++) { // never idle between two messages
            now.addAndGet(BREATH);
            flood.give();
            turns.ask(flood);
        }
        assertThat(flood.need()).isGreaterThan(CpuTurns.SHORT_NANOS);
    }

    /** It has at least a quarter of a fair share, here a thirty-first. */
    @Test
    void manyOfMiddlingLengthDoNotHoldOffALongOne() {
        CpuTurns turns = new CpuTurns(1, now::get);
        List<Asker> all = askers(turns, 30, 15 * BREATH, 0); // one of them always waits
        run(turns, all, 500 * MILLI);
        Asker large = new Asker(turns.turn(), 100 * MILLI, 0);
        all.add(large);
        run(turns, all, 3_100 * MILLI);
        assertThat(large.computed / MILLI).isBetween(25L, 100L);
    }

    @Test
    void heavyWorkLeavesATurn() {
        CpuTurns turns = new CpuTurns(3, now::get);
        List<Asker> heavy = askers(turns, 10, 1_000 * MILLI, 0);
        for (int k = 0; k < 100; k++) {
            heavy.forEach(each -> each.turn.heavy());
            run(turns, heavy, MILLI);
            assertThat(running(heavy)).isEqualTo(2);
        }
        Asker other = new Asker(turns.turn(), 1_000 * MILLI, 0);
        heavy.add(other);
        run(turns, heavy, 2 * BREATH);
        assertThat(other.turn.isRunning()).isTrue();
    }

    @Test
    void whoDoesNotGiveWayLendsTheTurnAndWaitsForTheNext() {
        CpuTurns turns = new CpuTurns(1, now::get);
        List<CpuTurn> stuck = new ArrayList<>();
        for (int k = 0; k < 3; k++) {
            stuck.add(turns.turn());
            turns.ask(stuck.get(k));
        }
        assertThat(stuck.get(0).isRunning()).isTrue();
        now.addAndGet(CpuTurns.SLICE_NANOS);
        turns.lend(stuck.get(1));
        assertThat(stuck.get(1).isWaiting()).as("too early").isTrue();
        now.addAndGet(CpuTurns.PATIENCE_NANOS);
        turns.lend(stuck.get(1));
        assertThat(stuck.get(1).isRunning()).isTrue();
        now.addAndGet(10 * CpuTurns.PATIENCE_NANOS);
        turns.lend(stuck.get(2));
        assertThat(stuck.get(2).isWaiting())
                .as("no more than there are processors")
                .isTrue();
        turns.giveWay(stuck.get(0)); // it looks up at last
        assertThat(stuck.get(0).isWaiting()).isTrue();
        turns.lend(stuck.get(2));
        assertThat(stuck.get(2).isRunning()).isTrue();
        stuck.forEach(CpuTurn::give);
        assertThat(turns.areWanted()).isFalse();
        CpuTurn next = turns.turn();
        turns.ask(next);
        assertThat(next.isRunning()).as("no turn was lost").isTrue();
    }

    @Test
    void whoIsCutOffComputesNoMoreWhetherItWaitsOrNot() throws Exception {
        CpuTurns turns = new CpuTurns(1, now::get); // which stands still: no turn is lent
        CpuTurn first = turns.turn();
        first.take();
        CpuTurn second = turns.turn();
        CountDownLatch returned = new CountDownLatch(1);
        Thread waiting = new Thread(() -> {
            second.take();
            second.give();
            returned.countDown();
        });
        waiting.start();
        HostilePeerTest.await(second::isWaiting);
        second.cutOff();
        assertThat(returned.await(20, TimeUnit.SECONDS)).isTrue();
        first.breathe();
        first.cutOff();
        assertThatThrownBy(first::breathe).isInstanceOf(CpuTurn.CutOff.class);
        first.give();
        CpuTurn third = turns.turn();
        third.take();
        assertThat(third.isRunning()).isTrue();
        third.give();
    }
}
