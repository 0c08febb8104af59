package robosim.geometry.net.pace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.net.session.LogBudget;

/** What messages and worlds of all connections take together is bounded, and all get there. */
@Timeout(60)
class SharedMemoryTest {
    private static CompletableFuture<Boolean> growing(MessageMemory.Share share, long bytes, CountDownLatch begun) {
        return CompletableFuture.supplyAsync(() -> {
            begun.countDown();
            try {
                share.growTo(bytes);
                return true;
            } catch (IOException e) {
                return false;
            }
        });
    }

    @Test
    void whoFindsNoRoomWaitsUntilAnotherIsDone() throws Exception {
        MessageMemory room = new MessageMemory(100);
        MessageMemory.Share first = room.share();
        MessageMemory.Share second = room.share();
        MessageMemory.Share third = room.share();
        first.growTo(60);
        second.growTo(30);
        CountDownLatch begun = new CountDownLatch(1);
        CompletableFuture<Boolean> grown = growing(third, 50, begun);
        assertThat(begun.await(20, TimeUnit.SECONDS)).isTrue();
        assertThat(grown).isNotDone();
        assertThat(room.taken()).isEqualTo(90);
        second.free();
        assertThat(grown).isNotDone(); // 60 and 50 are more than there is
        first.free();
        assertThat(grown.get(20, TimeUnit.SECONDS)).isTrue();
        assertThat(room.taken()).isEqualTo(50);
    }

    /** Else two that each hold half of what they need would wait for ever. */
    @Test
    void theEldestGoesOnWhateverItWants() throws Exception {
        MessageMemory room = new MessageMemory(100);
        MessageMemory.Share eldest = room.share();
        MessageMemory.Share other = room.share();
        eldest.growTo(50);
        other.growTo(50);
        CompletableFuture<Boolean> grown = growing(other, 70, new CountDownLatch(1));
        eldest.growTo(1000);
        assertThat(room.taken()).isEqualTo(1050);
        assertThat(grown).isNotDone();
        eldest.free();
        assertThat(grown.get(20, TimeUnit.SECONDS)).isTrue();
        assertThat(room.taken()).isEqualTo(70);
    }

    @Test
    void whoIsClosedWaitsNoMoreAndHoldsNothing() throws Exception {
        MessageMemory room = new MessageMemory(100);
        MessageMemory.Share first = room.share();
        MessageMemory.Share second = room.share();
        first.growTo(100);
        CountDownLatch begun = new CountDownLatch(1);
        CompletableFuture<Boolean> grown = growing(second, 50, begun);
        assertThat(begun.await(20, TimeUnit.SECONDS)).isTrue();
        second.close();
        assertThat(grown.get(20, TimeUnit.SECONDS)).isFalse();
        first.close();
        assertThat(room.taken()).isZero();
        assertThatThrownBy(() -> first.growTo(1)).hasMessageContaining("closed");
    }

    @Test
    void worldsOfAllConnectionsFitIntoTheirMemoryAndOneAloneIsNotRefused() {
        int large = 1 << 20;
        WorldMemory worlds = new WorldMemory(20L * large);
        WorldMemory.Share first = worlds.share();
        WorldMemory.Share second = worlds.share();
        assertThat(first.claim(40 * large)).as("alone").isNull();
        assertThat(second.claim(large)).contains("20 MiB", "some 8 MiB more, beside 320 MiB", "-Xmx");
        assertThat(second.claim(WorldMemory.SMALL_BYTES - 1)).isNull();
        assertThat(first.claim(large)).as("a smaller one in its place").isNull();
        assertThat(second.claim(large)).isNull();
        assertThat(worlds.share().claim(large)).contains("(got: some 8 MiB more, beside 16 MiB)");
        first.free();
        assertThat(worlds.share().claim(large)).isNull();
    }

    @Test
    void aLogGetsSoManyLinesASecondAndTellsHowManyItDidNotGet() {
        long[] now = {5};
        LogBudget budget = new LogBudget(() -> now[0]);
        int written = 0;
        for (int k = 0; k < 100_000; k++) {
            written += budget.take() >= 0 ? 1 : 0;
        }
        assertThat(written).isEqualTo(2000);
        now[0] += 1_000_000_000;
        assertThat(budget.take()).isEqualTo(98_000);
        assertThat(budget.take()).isZero();
        for (int k = 0; k < 8; k++) {
            assertThat(budget.take()).isZero();
        }
        assertThat(budget.take()).isEqualTo(-1);
        now[0] += 3_600_000_000_000L;
        written = 0;
        for (int k = 0; k < 100_000; k++) {
            written += budget.take() >= 0 ? 1 : 0;
        }
        assertThat(written).as("however long it was quiet").isEqualTo(2000);
    }
}
