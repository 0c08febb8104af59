package robosim.geometry.bench;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SplittableRandom;

/** What greedy peers do to a server, in JSON lines that are made beforehand, again and again until they are ended. */
enum Greed {
    /** 50 connections that each ask 10,000 wide cones, and read the answers. */
    CONES(50, 1000, true) {
        @Override
        byte[] request() {
            return sonars(
                    10_000,
                    "{\"objectName\":\"r\",\"xOffset\":%d,\"zOffset\":%d,"
                            + "\"beam\":{\"min\":0,\"max\":null,\"width\":2.5}}");
        }
    },

    /** 88 connections that ask much and never read an answer; closed for that, they come again. */
    DEAF(88, 1000, false) {
        @Override
        byte[] request() {
            return sonars(10_000, "{\"objectName\":\"r\",\"xOffset\":%d,\"zOffset\":%d}");
        }
    },

    /** 4 connections that send lines of 49 MB with 1.1 million rays. */
    LINES(4, 1000, true) {
        @Override
        byte[] request() {
            return sonars(1_100_000, "{\"objectName\":\"r\",\"xOffset\":%d,\"zOffset\":%d}");
        }
    },

    /** 4 connections that send the largest worlds, and a question about each. */
    WORLDS(4, 700_000, true) {
        @Override
        byte[] request() {
            return join(List.of(world(700_000), sonars(1, "{\"objectName\":\"r\",\"xOffset\":%d,\"zOffset\":%d}")));
        }
    };

    private static final byte[] HELLO = "{\"type\":\"hello\",\"version\":1}\n".getBytes(StandardCharsets.UTF_8);

    private final int connections;
    private final int objects;
    private final boolean reads;

    Greed(int connections, int objects, boolean reads) {
        this.connections = connections;
        this.objects = objects;
        this.reads = reads;
    }

    /** What is sent again and again, after the world. */
    abstract byte[] request();

    /** Until the process is ended. */
    void begin(int port) {
        byte[] world = world(Math.min(objects, 1000));
        byte[] request = request();
        for (int k = 0; k < connections; k++) {
            new Thread(() -> greed(port, world, request), "greedy").start();
        }
        Fairness.say("begun");
    }

    private void greed(int port, byte[] world, byte[] request) {
        while (true) {
            try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
                if (reads) {
                    Thread reader = new Thread(() -> skip(socket), "reader");
                    reader.setDaemon(true);
                    reader.start();
                }
                socket.getOutputStream().write(HELLO);
                socket.getOutputStream().write(world);
                while (true) {
                    socket.getOutputStream().write(request);
                }
            } catch (IOException e) {
                rest();
            }
        }
    }

    private static void skip(Socket socket) {
        byte[] some = new byte[1 << 16];
        try {
            InputStream in = socket.getInputStream();
            int got = 0;
            while (got >= 0) {
                got = in.read(some);
            }
            socket.close();
        } catch (IOException e) {
            return; // the writing half sees it too
        }
    }

    private static void rest() {
        try {
            Thread.sleep(20);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static byte[] world(int objects) {
        SplittableRandom random = new SplittableRandom(5);
        StringBuilder line = new StringBuilder(128 * objects).append("{\"type\":\"init\",\"objects\":[");
        line.append(
                "{\"kind\":\"cylinder\",\"name\":\"r\",\"moveable\":true,\"center\":[0,0,0],\"radius\":0.2,\"height\":1}");
        for (int k = 1; k < objects; k++) {
            line.append(",{\"kind\":\"box\",\"center\":[")
                    .append(random.nextInt(1, 2000))
                    .append(",0,")
                    .append(random.nextInt(-2000, 2000))
                    .append("],\"width\":1,\"height\":1,\"length\":1}");
        }
        return line.append("]}\n").toString().getBytes(StandardCharsets.UTF_8);
    }

    private static byte[] sonars(int count, String form) {
        SplittableRandom random = new SplittableRandom(7);
        StringBuilder line = new StringBuilder(50 * count).append("{\"type\":\"sonars\",\"requests\":[");
        for (int k = 0; k < count; k++) {
            line.append(k == 0 ? "" : ",").append(String.format(form, random.nextInt(1, 99), random.nextInt(-9, 9)));
        }
        return line.append("]}\n").toString().getBytes(StandardCharsets.UTF_8);
    }

    private static byte[] join(List<byte[]> parts) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        parts.forEach(all::writeBytes);
        return all.toByteArray();
    }
}
