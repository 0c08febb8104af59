package robosim.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Each part is done once, by whoever takes it, and nobody is at work any more when the call returns. */
class ParallelPartsTest {
    private static final int PARTS = 100;

    private final ForkJoinPool pool = new ForkJoinPool(3);
    private final AtomicIntegerArray done = new AtomicIntegerArray(PARTS);
    private final AtomicInteger atWork = new AtomicInteger();
    private final Set<Thread> threads = ConcurrentHashMap.newKeySet();

    @AfterEach
    void close() {
        pool.shutdownNow();
    }

    private class Counting extends ParallelParts<String> {
        Counting() {
            super(PARTS);
        }

        @Override
        String begin() {
            atWork.incrementAndGet();
            return "helper";
        }

        @Override
        void part(String with, int part) {
            threads.add(Thread.currentThread());
            done.incrementAndGet(part);
        }

        @Override
        void end(String with) {
            atWork.decrementAndGet();
        }
    }

    private void assertAllDoneOnce() {
        for (int part = 0; part < PARTS; part++) {
            assertThat(done.get(part)).as("part %d", part).isEqualTo(1);
        }
        assertThat(atWork).hasValue(0);
    }

    @Test
    void helpersShareTheParts() {
        CountDownLatch meeting = new CountDownLatch(3);
        pool.invoke(ForkJoinTask.adapt(() -> new Counting() {
            @Override
            void part(String with, int part) {
                if (part < 3) { // three threads have one each
                    meeting.countDown();
                    await(meeting);
                }
                super.part(with, part);
            }
        }.run("own", 3)));
        assertAllDoneOnce();
        assertThat(threads).hasSize(3);
    }

    private static void await(CountDownLatch latch) {
        try {
            assertThat(latch.await(60, TimeUnit.SECONDS)).isTrue();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void outsideAnyPool() {
        new Counting().run("own", 8);
        assertAllDoneOnce();
    }

    @Test
    void whatAHelperThrowsIsThrown() {
        assertThatThrownBy(() -> pool.invoke(ForkJoinTask.adapt(() -> {
                    CountDownLatch helped = new CountDownLatch(1);
                    new Counting() {
                        @Override
                        void part(String with, int part) {
                            if (with.equals("own")) {
                                await(helped);
                            } else {
                                helped.countDown();
                                throw new IllegalStateException("a part has failed");
                            }
                        }
                    }.run("own", 2);
                })))
                .hasMessageContaining("a part has failed");
    }

    @Test
    void anInterruptIsKept() {
        Thread.currentThread().interrupt();
        new Counting().run("own", 4);
        assertThat(Thread.interrupted()).isTrue();
        assertAllDoneOnce();
    }
}
