package robosim.geometry.net;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CopyOnWriteArrayList;

/** A bad network between an environment and a server: passes on what each says, with one fault in one direction. */
final class FaultProxy implements AutoCloseable {
    private static final int DUPLICATED = 64;

    /** What goes wrong. The first three lose nothing. */
    enum Fault {
        NONE,
        DELAY,
        SINGLE_BYTES,
        HALF_CLOSE,
        CUT,
        RESET,
        DUPLICATE,
        CORRUPT
    }

    /**
     * What goes wrong, where.
     *
     * @param ofAnswers on the way to the environment, not from it
     * @param at        how many bytes pass before it does
     */
    record Plan(Fault fault, boolean ofAnswers, long at, long seed) {}

    private final int target;
    private final Plan plan;
    private final ServerSocket listening = Peer.listen();
    private final List<Socket> sockets = new CopyOnWriteArrayList<>();
    private final List<Thread> threads = new ArrayList<>();

    /** For one connection. */
    FaultProxy(int target, Plan plan) throws IOException {
        this.target = target;
        this.plan = plan;
        start("accept", this::accept);
    }

    int port() {
        return listening.getLocalPort();
    }

    private void start(String name, Task task) {
        Thread thread = new Thread(
                () -> {
                    try {
                        task.run();
                    } catch (IOException e) {
                        sockets.forEach(FaultProxy::end); // one end is gone, so is the other
                    }
                },
                "proxy-" + name);
        synchronized (threads) {
            threads.add(thread);
        }
        thread.start();
    }

    @FunctionalInterface
    private interface Task {
        void run() throws IOException;
    }

    private void accept() throws IOException {
        Socket environment = listening.accept();
        sockets.add(environment);
        Socket module = new Socket(InetAddress.getLoopbackAddress(), target);
        sockets.add(module);
        environment.setTcpNoDelay(true);
        module.setTcpNoDelay(true);
        start("requests", () -> pass(environment, module, !plan.ofAnswers()));
        start("answers", () -> pass(module, environment, plan.ofAnswers()));
    }

    private void pass(Socket from, Socket to, boolean faulty) throws IOException {
        SplittableRandom random = new SplittableRandom(plan.seed());
        InputStream in = from.getInputStream();
        OutputStream out = to.getOutputStream();
        byte[] bytes = new byte[4096];
        long passed = 0;
        for (int got = in.read(bytes); got >= 0; got = in.read(bytes)) {
            if (!faulty) {
                out.write(bytes, 0, got);
            } else if (!passFaulty(bytes, got, passed, out, to, random)) {
                return;
            }
            passed += got;
        }
        to.shutdownOutput();
    }

    /** Answers false where nothing more is to pass in this direction. */
    private boolean passFaulty(byte[] bytes, int got, long passed, OutputStream out, Socket to, SplittableRandom random)
            throws IOException {
        int at = (int) Math.max(0, Math.min(Integer.MAX_VALUE, plan.at() - passed));
        boolean now = at < got && passed + got > plan.at() && passed <= plan.at();
        switch (plan.fault()) {
            case NONE -> out.write(bytes, 0, got);
            case DELAY -> {
                sleep(random.nextInt(8) == 0 ? 10 : random.nextInt(2));
                out.write(bytes, 0, got);
            }
            case SINGLE_BYTES -> {
                for (int k = 0; k < got; k++) {
                    out.write(bytes[k]);
                }
            }
            case HALF_CLOSE -> {
                out.write(bytes, 0, Math.min(at, got));
                if (now) {
                    to.shutdownOutput();
                    return false;
                }
            }
            case CUT, RESET -> {
                out.write(bytes, 0, Math.min(at, got));
                if (now) {
                    for (Socket socket : sockets) {
                        if (plan.fault() == Fault.RESET) {
                            socket.setSoLinger(true, 0);
                        }
                        end(socket);
                    }
                    return false;
                }
            }
            case DUPLICATE -> {
                out.write(bytes, 0, got);
                if (now) {
                    out.write(bytes, at, Math.min(DUPLICATED, got - at));
                }
            }
            case CORRUPT -> {
                byte[] wrong = Arrays.copyOf(bytes, got);
                if (now) {
                    wrong[at] ^= (byte) (1 << random.nextInt(8));
                }
                out.write(wrong);
            }
        }
        return true;
    }

    private static void sleep(int millis) {
        try {
            Thread.sleep(millis);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void end(Socket socket) {
        try {
            socket.close();
        } catch (IOException e) {
            throw new IllegalStateException("a socket must close", e);
        }
    }

    /** Cuts what is left and waits for the threads. */
    @Override
    public void close() throws IOException {
        listening.close();
        sockets.forEach(FaultProxy::end);
        List<Thread> all;
        synchronized (threads) {
            all = List.copyOf(threads);
        }
        for (Thread thread : all) {
            try {
                thread.join(5000);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
