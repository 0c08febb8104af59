package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectOutputStream;
import java.io.ObjectStreamConstants;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketOption;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.net.pace.CpuTurn;
import robosim.geometry.net.pace.CpuTurns;
import robosim.geometry.net.pace.MessageMemory;
import robosim.geometry.net.pace.PacedInput;
import robosim.geometry.net.pace.PacedOutput;
import robosim.geometry.net.pace.SocketSettings;
import robosim.geometry.net.pace.Watchdog;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageTranslator;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;

/** Nobody waits for an acknowledgement that the other end puts off. No clock is asked: writes and options are counted. */
@Timeout(60)
class PacedStreamsTest {
    /** Answers are small and waited for: each is handed to the system whole, and sent at once. */
    @Test
    void anAnswerIsOneWriteWithoutDelay() throws Exception {
        try (ServerSocket listening = Peer.listen();
                Socket environment = new Socket(InetAddress.getLoopbackAddress(), listening.getLocalPort());
                Socket module = listening.accept()) {
            SocketSettings.apply(module);
            assertThat(module.getTcpNoDelay()).isTrue();
            int[] writes = new int[1];
            OutputStream counting = new FilterOutputStream(module.getOutputStream()) {
                @Override
                public void write(byte[] bytes, int at, int length) throws IOException {
                    writes[0]++;
                    out.write(bytes, at, length);
                }
            };
            try (Watchdog watchdog = new Watchdog("watchdog of a test", Timeouts.DEFAULT.finest())) {
                Watchdog.Guard guard = watchdog.guard(() -> {});
                CpuTurn turn = new CpuTurns(1, System::nanoTime).turn();
                PacedOutput paced =
                        new PacedOutput(counting, guard, Timeouts.DEFAULT.stall(), Timeouts.DEFAULT.message(), turn);
                ObjectOutputStream bare = new ObjectOutputStream(paced); // writes every 1,024 bytes
                bare.writeObject(new DistanceBundle(Collections.nCopies(700, 1.5)));
                bare.flush();
                assertThat(writes[0]).isEqualTo(1);
                MessageWriter writer = new MessageWriter(paced);
                for (int k = 1; k <= 3; k++) {
                    writes[0] = 0;
                    writer.write(new DistanceBundle(Collections.nCopies(700, 0.5 * k)));
                    assertThat(writes[0]).isEqualTo(1);
                }
            }
            assertThat(environment.getInputStream().available()).isPositive();
        }
    }

    /** The option to acknowledge at once, as Linux has it. */
    private static final class QuickAck implements SocketOption<Boolean> {
        @Override
        public String name() {
            return "TCP_QUICKACK";
        }

        @Override
        public Class<Boolean> type() {
            return Boolean.class;
        }
    }

    /** What is done, in its order. */
    private static final class Told extends Socket {
        final List<String> events = new ArrayList<>();

        @Override
        public Set<SocketOption<?>> supportedOptions() {
            return Set.of(new QuickAck());
        }

        @Override
        public <T> Socket setOption(SocketOption<T> option, T value) {
            events.add(option.name() + " " + value);
            return this;
        }

        @Override
        public void setSoTimeout(int millis) {
            return; // nothing to wait for
        }
    }

    /**
     * A peer with a bare object stream hands a message over in parts, and its system holds each back until the one before is
     * acknowledged: the module acknowledges before it waits for more, unless an answer has done so.
     */
    @Test
    void whatNoAnswerAcknowledgesIsAcknowledgedBeforeMoreIsWaitedFor() throws Exception {
        byte[] bytes = Peer.bytes(new MoveBundle(List.of()));
        byte[] parts = {4, (byte) (bytes.length / 2), (byte) (bytes.length - bytes.length / 2 - 5), 1};
        assertThat(bytes[bytes.length - 1]).isEqualTo(ObjectStreamConstants.TC_RESET);
        Told socket = new Told();
        InputStream in = new InputStream() {
            private final ByteArrayInputStream all = new ByteArrayInputStream(bytes);
            private int reads;

            @Override
            public int read() {
                throw new UnsupportedOperationException();
            }

            @Override
            public int read(byte[] into, int at, int length) {
                int got = reads < parts.length ? all.read(into, at, parts[reads]) : -1;
                socket.events.add(got < 0 ? "end" : "part " + ++reads);
                return got;
            }
        };
        try (Watchdog watchdog = new Watchdog("watchdog of a test", Timeouts.DEFAULT.finest())) {
            PacedInput paced = new PacedInput(
                    socket,
                    in,
                    watchdog.guard(() -> {}),
                    Timeouts.DEFAULT.idle(),
                    Timeouts.DEFAULT.stall(),
                    Timeouts.DEFAULT.message(),
                    new CpuTurns(1, System::nanoTime).turn(),
                    new MessageMemory(1000).share(),
                    () -> false);
            MessageReader reader = new MessageReader(paced, MessageTranslator.RECORDS, paced);
            assertThat(reader.read()).isEqualTo(new MoveBundle(List.of()));
            socket.events.add("answer");
            paced.answered();
            assertThat(reader.read()).isNull();
        }
        assertThat(socket.events)
                .containsExactly(
                        "part 1",
                        "TCP_QUICKACK true",
                        "part 2",
                        "TCP_QUICKACK true",
                        "part 3",
                        "answer",
                        "part 4",
                        "TCP_QUICKACK true",
                        "end");
    }
}
