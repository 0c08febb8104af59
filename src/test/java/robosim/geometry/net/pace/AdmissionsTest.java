package robosim.geometry.net.pace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.protocol.ProtocolException;

/** Who makes room for whom, by a clock that only the test moves; a look at it takes a millisecond. */
@Tag("clock")
class AdmissionsTest {
    private static final long SECOND = TimeUnit.SECONDS.toNanos(1);
    private static final long LOOK = TimeUnit.MILLISECONDS.toNanos(1);

    private final AtomicLong time = new AtomicLong();
    private final Admissions admissions = new Admissions(3, () -> time.addAndGet(LOOK));
    private final List<String> displaced = new ArrayList<>();

    private Admissions.Newcomer enter(String address, int number, boolean idle) throws Exception {
        return admissions.enter(
                InetAddress.getByName(address),
                10 * SECOND,
                () -> idle,
                () -> displaced.add(address + " number " + number));
    }

    @Test
    void theOldestMakesRoomWhereAllComeFromThisMachine() throws Exception {
        for (int k = 0; k < Admissions.MOST; k++) {
            enter("127.0.0.1", k, true);
        }
        assertThat(displaced).isEmpty();
        time.addAndGet(6 * SECOND);
        enter("127.0.0.1", -1, true);
        enter("192.0.2.1", -1, true);
        assertThat(displaced).containsExactly("127.0.0.1 number 0", "127.0.0.1 number 1");
        assertThat(admissions.waiting()).isEqualTo(Admissions.MOST);
    }

    @Test
    void anAddressThatTakesMuchMakesRoomItself() throws Exception {
        enter("192.0.2.9", 0, true);
        for (int k = 0; k <= Admissions.MOST_FROM_ONE; k++) {
            enter("192.0.2.1", k, true);
        }
        assertThat(displaced).containsExactly("192.0.2.1 number 0");
        for (int k = 0; admissions.waiting() < Admissions.MOST; k++) {
            enter("192.0.2." + (20 + k / 10), k, true);
        }
        time.addAndGet(6 * SECOND);
        enter("192.0.2.77", 0, true);
        assertThat(displaced).containsExactly("192.0.2.1 number 0", "192.0.2.1 number 1");
    }

    @Test
    void whoWaitsForTheServerStays() throws Exception {
        for (int k = 0; k < Admissions.MOST; k++) {
            enter("127.0.0.1", k, k == 100);
        }
        time.addAndGet(6 * SECOND);
        enter("127.0.0.1", -1, false);
        assertThat(displaced).containsExactly("127.0.0.1 number 100");
        long before = time.get();
        enter("127.0.0.1", -2, false); // all have; the oldest goes, but only after a while
        assertThat(displaced).containsExactly("127.0.0.1 number 100", "127.0.0.1 number 0");
        assertThat(time.get() - before).isBetween(Admissions.PATIENCE_NANOS, 3 * Admissions.PATIENCE_NANOS);
    }

    @Test
    void nobodyIsDisplacedAtOnce() throws Exception {
        for (int k = 0; k < Admissions.MOST; k++) {
            enter("127.0.0.1", k, true);
        }
        long last = time.get();
        enter("127.0.0.1", -1, true);
        assertThat(displaced).hasSize(1);
        assertThat(time.get()).isGreaterThanOrEqualTo(last - Admissions.MOST * LOOK * 2 + Admissions.GRACE_NANOS);
    }

    @Test
    void admittedPeersHavePlacesOfTheirOwn() throws Exception {
        List<Admissions.Newcomer> peers = new ArrayList<>();
        for (int k = 0; k < 3; k++) {
            assertThat(admissions.isFull()).isFalse();
            Admissions.Newcomer peer = enter("127.0.0.1", k, true);
            peer.admit();
            peer.admit();
            assertThat(peer.isAdmitted()).isTrue();
            peers.add(peer);
        }
        assertThat(admissions.waiting()).isZero();
        assertThat(admissions.isFull()).isTrue();
        Admissions.Newcomer fourth = enter("127.0.0.1", 3, true);
        assertThatThrownBy(fourth::admit)
                .isInstanceOf(ProtocolException.class)
                .hasMessage("there must be at most 3 connections (got: more); close one, or dial again later");
        peers.get(1).leave();
        peers.get(1).leave();
        fourth.admit();
        assertThat(admissions.isFull()).isTrue();
        assertThat(displaced).isEmpty();
    }
}
