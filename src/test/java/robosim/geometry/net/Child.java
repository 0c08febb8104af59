package robosim.geometry.net;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.ChildJvm;
import robosim.geometry.protocol.Bundle;

/** One end in a process of its own, to be killed. */
final class Child implements AutoCloseable {
    private final Process process;
    private final BufferedReader output;

    private Child(Process process) {
        this.process = process;
        this.output = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    }

    /**
     * Starts one.
     *
     * @param role  {@code serve}, {@code connect}, {@code dial} or {@code listen}
     * @param flags of its Java
     */
    static Child start(String role, int port, long seed, String... flags) throws IOException {
        List<String> command = ChildJvm.command(flags);
        command.addAll(List.of("-cp", System.getProperty("java.class.path")));
        command.addAll(List.of(Child.class.getName(), role, "" + port, "" + seed));
        Process process = new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        process.getOutputStream().close();
        return new Child(process);
    }

    /** Its next line. */
    String line() throws IOException {
        String line = output.readLine();
        if (line == null) {
            throw new IOException("the process must say another line (got: its end)");
        }
        return line;
    }

    /** As {@code kill -9} does, where the system has that. */
    void kill() throws InterruptedException {
        process.destroyForcibly();
        process.waitFor();
    }

    @Override
    public void close() throws InterruptedException {
        kill();
    }

    /** Talks until it is killed, and says after each conversation how it differed; a server says its port. */
    public static void main(String[] arguments) throws Exception {
        int port = Integer.parseInt(arguments[1]);
        Conversation conversation = Conversation.of(Long.parseLong(arguments[2]), 500);
        switch (arguments[0]) {
            case "serve" -> say("" + new GeometryServer(port).port());
            case "connect" -> GeometryClient.main(new String[] {"127.0.0.1", arguments[1]});
            case "dial" -> {
                while (true) {
                    try (Peer peer = Peer.dial(port)) {
                        say(talk(peer, conversation));
                    }
                }
            }
            default -> {
                try (ServerSocket listening = new ServerSocket(port, 10, InetAddress.getLoopbackAddress())) {
                    say("" + listening.getLocalPort());
                    while (true) {
                        try (Peer peer = new Peer(listening.accept())) {
                            say(talk(peer, conversation));
                        }
                    }
                }
            }
        }
    }

    private static void say(String line) {
        System.out.println(line);
        System.out.flush();
    }

    private static String talk(Peer peer, Conversation conversation) throws IOException {
        peer.send(conversation.world());
        List<Bundle> heard = new ArrayList<>();
        for (Bundle request : conversation.requests()) {
            peer.send(request);
            heard.add(peer.receive());
            if (heard.size() == 10) {
                say("talking");
            }
        }
        String difference = conversation.difference(heard);
        return difference.isEmpty() ? "same" : difference;
    }
}
