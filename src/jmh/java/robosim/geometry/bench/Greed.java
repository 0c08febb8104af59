package robosim.geometry.bench;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.IntFunction;

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
    },

    /** 8 connections that ask for pictures of a million pixels of a hall of mirrors. */
    PICTURES(8, 0, true) {
        @Override
        byte[] setting() {
            return line("{\"type\":\"init\",\"settings\":{\"dimension\":\"SPATIAL\"},\"objects\":[", 400, k -> {
                if (k == 0) {
                    return ROBOT;
                }
                return String.format(
                        Locale.ROOT,
                        "{\"kind\":\"sphere\",\"center\":[%d,0,%d],\"radius\":0.9,\"material\":{\"mirror\":0.9}}",
                        2 * (k % 20) + 1,
                        2 * (k / 20) - 20);
            });
        }

        @Override
        byte[] request() {
            return text("{\"type\":\"batch\",\"requests\":[{\"kind\":\"picture\",\"objectName\":\"r\",\"mirrors\":15,"
                    + "\"pattern\":{\"kind\":\"pinhole\",\"width\":1024,\"height\":1024,\"fieldOfView\":1.5}}]}\n");
        }
    },

    /** 8 connections that ask for depth images of 1024 x 1024 with objects and normals. */
    FRAMES(8, 1000, true) {
        @Override
        byte[] request() {
            return text("{\"type\":\"batch\",\"requests\":[{\"kind\":\"sense\",\"objectName\":\"r\",\"objects\":true,"
                    + "\"normals\":true,\"pattern\":"
                    + "{\"kind\":\"pinhole\",\"width\":1024,\"height\":1024,\"fieldOfView\":1.5}}]}\n");
        }
    },

    /** 8 connections that let 3,000 bodies collide for a minute. */
    STEPS(8, 0, true) {
        @Override
        byte[] setting() {
            return line(
                    "{\"type\":\"init\",\"objects\":[",
                    3000,
                    k -> String.format(
                            Locale.ROOT,
                            "{\"kind\":\"cylinder\",\"name\":\"b%d\",\"moveable\":true,\"center\":[%d,0,%d],\"radius\":0.3,\"height\":1}",
                            k,
                            k % 60,
                            k / 60));
        }

        @Override
        byte[] request() {
            SplittableRandom random = new SplittableRandom(3);
            return line(
                    "{\"type\":\"step\",\"seconds\":60,\"bodies\":[",
                    3000,
                    k -> String.format(
                            Locale.ROOT,
                            "{\"objectName\":\"b%d\",\"mass\":1,\"floorFriction\":0,\"velocity\":{\"x\":%.3f,\"y\":0,\"z\":%.3f,\"ry\":0}}",
                            k,
                            random.nextDouble(-1, 1),
                            random.nextDouble(-1, 1)));
        }
    },

    /** 8 connections that ask about 100,000 edges at a time. */
    EDGES(8, 1000, true) {
        @Override
        byte[] request() {
            SplittableRandom random = new SplittableRandom(4);
            ByteBuffer numbers = ByteBuffer.allocate(100_000 * 64).order(ByteOrder.LITTLE_ENDIAN);
            for (int k = 0; k < 200_000; k++) {
                numbers.putDouble(random.nextDouble(1, 2000)).putDouble(0);
                numbers.putDouble(random.nextDouble(-2000, 2000)).putDouble(random.nextDouble(3));
            }
            return text("{\"type\":\"batch\",\"requests\":[{\"kind\":\"edges\",\"objectName\":\"r\",\"edges\":\""
                    + Base64.getEncoder().encodeToString(numbers.array()) + "\"}]}\n");
        }
    },

    /** 8 connections that move one family of slivers along the lines of z = x y a thousandth above the other family. */
    HYPAR(8, 0, true) {
        private static final int SLIVERS = 5000;

        @Override
        byte[] setting() {
            return text("{\"type\":\"init\",\"settings\":{\"dimension\":\"SPATIAL\"},\"objects\":["
                    + rulings(true, "", 0) + "," + rulings(false, "\"name\":\"r\",\"moveable\":true,", 1e-3) + "]}\n");
        }

        private static String rulings(boolean first, String name, double lift) {
            StringBuilder vertices = new StringBuilder();
            StringBuilder faces = new StringBuilder();
            for (int i = 0; i < SLIVERS; i++) {
                double t = -1 + 2.0 * i / (SLIVERS - 1);
                for (int k = 0; k < 3; k++) {
                    double s = k == 0 ? -1 : 1;
                    double u = k == 2 ? t + 0.2 / SLIVERS : t;
                    double x = first ? u : s;
                    double z = first ? s : u;
                    vertices.append(i + k == 0 ? "" : ",")
                            .append(String.format(Locale.ROOT, "[%s,%s,%s]", x, x * z + lift, z));
                }
                faces.append(i == 0 ? "" : ",")
                        .append(String.format(Locale.ROOT, "[%d,%d,%d]", 3 * i, 3 * i + 1, 3 * i + 2));
            }
            return "{\"kind\":\"mesh\"," + name + "\"vertices\":[" + vertices + "],\"faces\":[" + faces + "]}";
        }

        @Override
        byte[] request() {
            return text("{\"type\":\"moves\",\"moves\":"
                    + "[{\"objectName\":\"r\",\"x\":0,\"y\":1e-5,\"z\":0,\"rx\":0,\"ry\":0}]}\n");
        }
    },

    /** 32 connections of {@link LegalRequests}, which rest 60 times as long as they work and wait, and often leave without their answers. */
    MIXED(32, 0, true) {
        @Override
        byte[] request() {
            return new byte[0]; // drawn for each connection
        }

        @Override
        void talk(Socket socket, byte[] world, byte[] request) throws IOException {
            SplittableRandom random = new SplittableRandom(SEEDS.incrementAndGet());
            LegalRequests legal = new LegalRequests(random.nextLong());
            socket.setSoTimeout(120_000);
            InputStream in = new BufferedInputStream(socket.getInputStream(), 1 << 16);
            ask(socket, in, HELLO);
            for (int left = random.nextInt(1, 30); left > 0; left--) {
                long start = System.nanoTime();
                byte[] next = left % 12 == 0 ? legal.world() : legal.request();
                if (random.nextInt(20) == 0) {
                    socket.getOutputStream().write(next);
                    Fairness.rest(random.nextInt(300));
                    return; // nobody waits for this answer
                }
                ask(socket, in, next);
                Fairness.rest(Math.min(120_000, 60 * (System.nanoTime() - start) / 1_000_000));
            }
        }

        private void ask(Socket socket, InputStream in, byte[] line) throws IOException {
            socket.getOutputStream().write(line);
            int got = in.read();
            while (got != '\n') {
                if (got < 0) {
                    throw new EOFException("closed without an answer");
                }
                got = in.read();
            }
        }
    };

    private static final AtomicLong SEEDS = new AtomicLong();

    private static final String ROBOT =
            "{\"kind\":\"cylinder\",\"name\":\"r\",\"moveable\":true,\"center\":[0,0,0],\"radius\":0.2,\"height\":1}";

    static final byte[] HELLO = "{\"type\":\"hello\",\"version\":1}\n".getBytes(StandardCharsets.UTF_8);

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

    /** What is sent once, before it: a world. */
    byte[] setting() {
        return world(Math.min(objects, 1000));
    }

    /** Until the process is ended. */
    void begin(int port) {
        byte[] world = setting();
        byte[] request = request();
        for (int k = 0; k < connections; k++) {
            new Thread(() -> greed(port, world, request), "greedy").start();
        }
        Fairness.say("begun");
    }

    private void greed(int port, byte[] world, byte[] request) {
        while (true) {
            try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
                talk(socket, world, request);
            } catch (IOException e) {
                Fairness.rest(20);
            }
        }
    }

    /** Until the connection ends. */
    void talk(Socket socket, byte[] world, byte[] request) throws IOException {
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

    private static byte[] world(int objects) {
        SplittableRandom random = new SplittableRandom(5);
        StringBuilder line = new StringBuilder(128 * objects).append("{\"type\":\"init\",\"objects\":[");
        line.append(ROBOT);
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

    /** A list of items, of which each is made from its number, and the end of its message. */
    private static byte[] line(String beginning, int count, IntFunction<String> item) {
        StringBuilder line = new StringBuilder(128 * count).append(beginning);
        for (int k = 0; k < count; k++) {
            line.append(k == 0 ? "" : ",").append(item.apply(k));
        }
        return text(line.append("]}\n").toString());
    }

    private static byte[] text(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private static byte[] join(List<byte[]> parts) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        parts.forEach(all::writeBytes);
        return all.toByteArray();
    }
}
