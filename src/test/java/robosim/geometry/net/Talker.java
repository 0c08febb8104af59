package robosim.geometry.net;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Semaphore;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.Bundle;

/** An environment that asks a whole conversation, several requests ahead of their answers, and keeps what it hears. */
final class Talker {
    private static final int PATIENCE_MILLIS = 20_000;

    private final int port;
    private final int ahead;
    private final Conversation conversation;

    /** Before each answer is read. */
    private Pace beforeReading = k -> {};

    private int receiveBuffer;
    private Tongue tongue = Tongue.JAVA;

    /** What is done before the k-th answer is read. */
    @FunctionalInterface
    interface Pace {
        void before(int k) throws InterruptedException;
    }

    /**
     * Over that port of this machine.
     *
     * @param ahead how many requests may be without an answer
     */
    Talker(int port, int ahead, Conversation conversation) {
        this.port = port;
        this.ahead = ahead;
        this.conversation = conversation;
    }

    /** Speaks that. */
    Talker in(Tongue other) {
        tongue = other;
        return this;
    }

    /** Reads slowly, out of a small buffer. */
    Talker reading(Pace pace) {
        beforeReading = pace;
        receiveBuffer = 1 << 13;
        return this;
    }

    /** What came, in order, until all was answered or the connection ended, however it did. */
    List<Bundle> talk() throws InterruptedException {
        List<Bundle> heard = new ArrayList<>();
        talk(heard::add);
        return heard;
    }

    /** How many answers came, each the truth and in its place; -1 where one was not. Keeps none of them. */
    int compare() throws InterruptedException {
        int[] same = new int[2];
        talk(answer -> {
            boolean right = same[0] == same[1]++
                    && same[0] < conversation.replies().size()
                    && conversation.replies().get(same[0]).bundle().equals(answer);
            same[0] += right ? 1 : 0;
        });
        return same[0] == same[1] ? same[0] : -1;
    }

    private void talk(Consumer<Bundle> heard) throws InterruptedException {
        Semaphore free = new Semaphore(ahead);
        try (Socket socket = new Socket()) {
            if (receiveBuffer > 0) {
                socket.setReceiveBufferSize(receiveBuffer);
            }
            socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), PATIENCE_MILLIS);
            socket.setTcpNoDelay(true);
            socket.setSoTimeout(PATIENCE_MILLIS);
            Thread sender = new Thread(() -> send(socket, free), "talker");
            sender.start();
            listenToTheEnd(socket, free, heard);
            free.release(1 << 20);
            socket.close();
            sender.join();
        } catch (IOException e) {
            return; // it was not even reached
        }
    }

    private void listenToTheEnd(Socket socket, Semaphore free, Consumer<Bundle> heard) throws InterruptedException {
        try {
            listen(socket, free, heard);
        } catch (IOException e) {
            return; // the end, as ends go on a bad network
        }
    }

    private void send(Socket socket, Semaphore free) {
        try {
            Tongue.Saying saying = tongue.over(new BufferedOutputStream(socket.getOutputStream(), 1 << 14));
            saying.say(conversation.world());
            for (Bundle request : conversation.requests()) {
                free.acquire();
                saying.say(request);
            }
            socket.shutdownOutput();
        } catch (IOException | InterruptedException e) {
            return; // the listening half sees it too
        }
    }

    private void listen(Socket socket, Semaphore free, Consumer<Bundle> heard)
            throws IOException, InterruptedException {
        Tongue.Hearing hearing = tongue.over(socket.getInputStream());
        beforeReading.before(0);
        @Nullable Bundle answer = hearing.hear();
        for (int count = 1; answer != null; count++) {
            heard.accept(answer);
            free.release();
            beforeReading.before(count);
            answer = hearing.hear();
        }
    }
}
