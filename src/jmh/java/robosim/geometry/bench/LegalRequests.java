package robosim.geometry.bench;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * What a client may send: worlds of all kinds of objects and all kinds of requests about them, in JSON lines, drawn at random.
 * Each line has exactly one answer. Sizes are drawn evenly in their logarithm, so that most lines are small and some are as
 * large as a message may reasonably be.
 */
final class LegalRequests {
    private static final int WIDE = 60;
    private static final int MOVERS = 40;

    private final SplittableRandom random;

    private boolean isSpatial;

    LegalRequests(long seed) {
        this.random = new SplittableRandom(seed);
    }

    /** A world; sometimes as a file that the module reads. */
    byte[] world() {
        isSpatial = random.nextBoolean();
        if (random.nextInt(8) == 0) {
            return load();
        }
        String objects = list(MOVERS, k -> mover("r" + k)) + "," + list(size(2000), k -> obstacle(2));
        String accuracy = random.nextInt(4) == 0 ? "DOP" : "EXACT";
        return line(
                "{\"type\":\"init\",\"answer\":true,\"settings\":{\"width\":200,\"height\":200,\"length\":200,\"dimension\":\"%s\","
                                .formatted(isSpatial ? "SPATIAL" : "PLANAR")
                        + "\"accuracy\":\"" + accuracy + "\"},\"objects\":[" + objects + "]}");
    }

    private byte[] load() {
        StringBuilder file =
                new StringBuilder("<world xmlns='urn:robosim:world:1' width='200' height='20' length='200'>");
        for (int k = 0; k < MOVERS; k++) {
            file.append("<cylinder name='r%d' moveable='true' center='%d 0 %d' radius='0.3' height='1'/>"
                    .formatted(k, k - 20, k % 7));
        }
        for (int k = size(3000); k > 0; k--) {
            file.append("<box center='%d 0 %d' width='1' height='1' length='1'/>".formatted(whole(), whole()));
        }
        String content = Base64.getEncoder()
                .encodeToString(file.append("</world>").toString().getBytes(StandardCharsets.UTF_8));
        return line("{\"type\":\"load\",\"file\":\"w.xml\",\"files\":{\"w.xml\":\"" + content + "\"}}");
    }

    /** A request about that world, or one that is refused and leaves it. */
    byte[] request() {
        return line(
                switch (random.nextInt(7)) {
                    case 0 ->
                        "{\"type\":\"moves\",\"moves\":[" + list(size(3000), k -> "{" + motion(true) + "}") + "]}";
                    case 1 -> "{\"type\":\"sonars\",\"requests\":[" + list(size(10_000), k -> sonar()) + "]}";
                    case 2 -> step();
                    case 3 -> wrong();
                    default ->
                        "{\"type\":\"batch\",\"requests\":[" + list(1 + random.nextInt(4), k -> batched()) + "]}";
                });
    }

    private String step() {
        String bodies = list(1 + random.nextInt(MOVERS), k -> {
            String drive = random.nextBoolean()
                    ? ""
                    : ",\"drive\":{\"kind\":\""
                            + pick("differential", "omnidirectional", "ackermann", "velocity", "force") + "\"}";
            return "{\"objectName\":\"r%d\",\"mass\":2,\"inertia\":1,\"restitution\":%s,\"velocity\":{\"x\":%s,\"y\":0,\"z\":%s,\"ry\":%s}%s}"
                    .formatted(k, number(0, 1), number(-3, 3), number(-3, 3), number(-2, 2), drive);
        });
        String commands = list(
                1 + random.nextInt(MOVERS),
                k -> "{\"objectName\":\"r%d\",\"forward\":%s,\"turn\":%s}".formatted(k, number(-2, 2), number(-1, 1)));
        return "{\"type\":\"step\",\"seconds\":%s,\"bodies\":[%s],\"commands\":[%s]}"
                .formatted(size(3000) / 50.0, bodies, commands);
    }

    private String wrong() {
        return pick(
                "{\"type\":\"step\",\"seconds\":-1}",
                "{\"type\":\"fly\"}",
                "{\"type\":\"ping\",\"id\":7}",
                "{\"type\":\"moves\",\"moves\":[{\"objectName\":\"r0\",\"x\":1}]}",
                "{\"type\":\"init\",\"objects\":[{\"kind\":\"box\",\"center\":[0,0,0],\"width\":-1,\"height\":1,\"length\":1}]}",
                "{\"type\":\"load\",\"file\":\"w.xml\",\"files\":{\"w.xml\":\"AAAA\"}}");
    }

    private String batched() {
        String name = "\"objectName\":\"r" + random.nextInt(MOVERS) + "\"";
        return switch (random.nextInt(14)) {
            case 0, 1 ->
                "{\"kind\":\"sense\",%s,\"pattern\":%s,\"max\":%s,\"width\":%s,%s}"
                        .formatted(
                                name,
                                pattern(300_000),
                                random.nextBoolean() ? "null" : number(1, 90),
                                0,
                                "\"normals\":%b,\"objects\":%b,\"rep117\":%b"
                                        .formatted(random.nextBoolean(), random.nextBoolean(), random.nextBoolean()));
            case 2 ->
                "{\"kind\":\"sense\",%s,\"pattern\":%s,\"width\":%s}".formatted(name, pattern(2000), number(0, 3));
            case 3 ->
                "{\"kind\":\"sense\",%s,\"pattern\":%s,\"motion\":{\"duration\":0.1,\"x\":2,\"y\":0,\"z\":1,\"ry\":1}}"
                        .formatted(name, pattern(3000));
            case 4 -> "{\"kind\":\"poses\",%s,\"poses\":\"%s\"}".formatted(name, packed(size(100_000)));
            case 5 -> "{\"kind\":\"edges\",%s,\"edges\":\"%s\"}".formatted(name, packed(2 * size(50_000)));
            case 6 -> picture(name);
            case 7 ->
                "{\"kind\":\"world\"},{\"kind\":\"list\",\"first\":%d,\"count\":%d},{\"kind\":\"pose\",%s}"
                        .formatted(random.nextInt(100), size(60_000), name);
            case 8 ->
                "{\"kind\":\"place\",%s,\"center\":[%d,0,%d],\"heading\":1,\"identify\":true}"
                        .formatted(name, whole(), whole());
            case 9 ->
                "{\"kind\":\"add\",\"object\":%s,\"overlapping\":%b}".formatted(obstacle(2), random.nextBoolean());
            case 10 ->
                "{\"kind\":\"remove\",\"objectName\":\"none\"},{\"kind\":\"move\"," + motion(false)
                        + ",\"identify\":true}";
            case 11 -> "{\"kind\":\"moveToContact\"," + motion(false) + ",\"clearance\":" + number(0, 0.5) + "}";
            case 12 ->
                "{\"kind\":\"moveAndSlide\"," + motion(false) + ",\"clearance\":0.01,\"bends\":" + random.nextInt(65)
                        + (isSpatial ? ",\"stepHeight\":0.3,\"maxSlope\":0.7,\"snap\":0.2}" : "}");
            default -> "{\"kind\":\"separate\"," + name + ",\"max\":" + number(0, 9) + "}";
        };
    }

    private String picture(String name) {
        int side = size(600);
        return "{\"kind\":\"picture\",%s,\"mount\":{\"place\":[0,1,0]},\"samples\":%d,\"mirrors\":%d,\"pattern\":{\"kind\":\"pinhole\",\"width\":%d,\"height\":%d,\"fieldOfView\":1.2}}"
                .formatted(name, 1 + random.nextInt(2), random.nextInt(8), side, side);
    }

    private String pattern(int most) {
        int count = size(most);
        int side = (int) Math.ceil(Math.sqrt(count));
        return switch (random.nextInt(4)) {
            case 0 -> "{\"kind\":\"fan\",\"first\":-3,\"step\":%s,\"count\":%d}".formatted(6.0 / count, count);
            case 1 ->
                "{\"kind\":\"layers\",\"elevations\":[-0.2,0,0.3],\"first\":-3,\"step\":%s,\"count\":%d}"
                        .formatted(6.0 / count, 1 + count / 3);
            case 2 -> "{\"kind\":\"pinhole\",\"width\":%d,\"height\":%d,\"fieldOfView\":1.4}".formatted(side, side);
            default ->
                "{\"kind\":\"directions\",\"directions\":\"%s\"}"
                        .formatted(
                                doubles(3 * Math.min(count, 50_000), k -> k % 3 == 1 ? 0 : 1 - random.nextDouble(2)));
        };
    }

    private String motion(boolean isWhole) {
        String lift = isSpatial && random.nextInt(4) == 0 ? number(-1, 1) : "0";
        return "\"objectName\":\"r%d\",\"x\":%s,\"y\":%s,\"z\":%s%s,\"ry\":%s"
                .formatted(
                        random.nextInt(MOVERS),
                        number(-3, 9),
                        lift,
                        number(-3, 3),
                        isWhole ? ",\"rx\":0" : "",
                        number(-7, 7));
    }

    private String sonar() {
        String beam = random.nextInt(3) == 0
                ? ""
                : ",\"beam\":{\"min\":0,\"max\":%s,\"width\":%s}"
                        .formatted(random.nextBoolean() ? "null" : number(1, 90), number(0, 3));
        return "{\"objectName\":\"r%d\",\"xOffset\":%s,\"zOffset\":1%s}"
                .formatted(random.nextInt(MOVERS + 1), number(-1, 1), beam);
    }

    private String mover(String name) {
        String head = "\"name\":\"%s\",\"moveable\":true,\"center\":[%d,0,%d]".formatted(name, whole(), whole());
        return switch (random.nextInt(4)) {
            case 0 -> "{\"kind\":\"box\",%s,\"width\":0.6,\"height\":1,\"length\":0.4}".formatted(head);
            case 1 -> "{\"kind\":\"sphere\",%s,\"radius\":0.4}".formatted(head);
            default -> "{\"kind\":\"cylinder\",%s,\"radius\":0.3,\"height\":1}".formatted(head);
        };
    }

    private String obstacle(int depth) {
        String at = "\"center\":[%d,0,%d]".formatted(whole(), whole());
        return switch (random.nextInt(depth == 0 ? 20 : 22 + depth)) {
            case 22 ->
                "{\"kind\":\"group\",%s,\"members\":[%s]}".formatted(at, list(1 + size(20), k -> obstacle(depth - 1)));
            case 20, 21 -> mesh(at, size(3000));
            case 23 -> grid(at);
            case 0, 1, 2 ->
                "{\"kind\":\"sphere\",%s,\"radius\":%s,\"material\":{\"mirror\":0.8}}".formatted(at, number(0.1, 1));
            case 3, 4, 5 -> "{\"kind\":\"capsule\",%s,\"radius\":%s,\"segment\":1}".formatted(at, number(0.1, 1));
            case 6, 7, 8 -> "{\"kind\":\"cylinder\",%s,\"radius\":%s,\"height\":2}".formatted(at, number(0.1, 1));
            default ->
                "{\"kind\":\"box\",%s,\"width\":%s,\"height\":2,\"length\":1,\"heading\":%s}"
                        .formatted(at, number(0.1, 2), number(-3, 3));
        };
    }

    /** A ruffled patch of ground. */
    private String mesh(String at, int faces) {
        int side = 1 + (int) Math.sqrt(faces / 2.0);
        String points = list(
                (side + 1) * (side + 1),
                k -> "[%s,%s,%s]"
                        .formatted(4.0 * (k / (side + 1)) / side, number(-0.2, 0.2), 4.0 * (k % (side + 1)) / side));
        String triangles = list(2 * side * side, k -> {
            int corner = k / 2 / side * (side + 1) + k / 2 % side;
            return k % 2 == 0
                    ? "[%d,%d,%d]".formatted(corner, corner + 1, corner + side + 1)
                    : "[%d,%d,%d]".formatted(corner + 1, corner + side + 2, corner + side + 1);
        });
        return "{\"kind\":\"mesh\",%s,\"vertices\":[%s],\"faces\":[%s]}".formatted(at, points, triangles);
    }

    private String grid(String at) {
        int side = 8 * size(60);
        byte[] cells = new byte[side * side / 8];
        cells[0] = 1;
        for (int k = 1; k < cells.length; k++) {
            cells[k] = (byte) (random.nextInt(9) == 0 ? random.nextInt(256) : 0);
        }
        return "{\"kind\":\"grid\",%s,\"cell\":0.1,\"height\":1,\"columns\":%d,\"rows\":%d,\"occupied\":\"%s\"}"
                .formatted(at, side, side, Base64.getEncoder().encodeToString(cells));
    }

    private String packed(int poses) {
        return doubles(4 * poses, k -> switch (k % 4) {
            case 1 -> 0;
            case 3 -> random.nextDouble(6);
            default -> random.nextDouble(-WIDE, WIDE);
        });
    }

    private static String doubles(int count, java.util.function.IntToDoubleFunction number) {
        ByteBuffer numbers = ByteBuffer.allocate(8 * count).order(ByteOrder.LITTLE_ENDIAN);
        for (int k = 0; k < count; k++) {
            numbers.putDouble(number.applyAsDouble(k));
        }
        return Base64.getEncoder().encodeToString(numbers.array());
    }

    /** From 1 to a bound, evenly in its logarithm. */
    private int size(int most) {
        return (int) Math.exp(random.nextDouble(Math.log(most + 1.0)));
    }

    private int whole() {
        return random.nextInt(-WIDE, WIDE);
    }

    private String number(double low, double high) {
        return String.format(Locale.ROOT, "%.4f", random.nextDouble(low, high));
    }

    private String pick(String... of) {
        return List.of(of).get(random.nextInt(of.length));
    }

    private static String list(int count, IntFunction<String> item) {
        return IntStream.range(0, count).mapToObj(item).collect(Collectors.joining(","));
    }

    private static byte[] line(String text) {
        return (text + "\n").getBytes(StandardCharsets.UTF_8);
    }
}
