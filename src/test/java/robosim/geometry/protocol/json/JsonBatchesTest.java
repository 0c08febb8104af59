package robosim.geometry.protocol.json;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.BatchSamples;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.FreeEdgesRequest;
import robosim.geometry.protocol.batch.FreePosesRequest;
import robosim.geometry.protocol.batch.NoAnswer;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.batch.WorldRequest;
import robosim.geometry.protocol.pace.MessagePace;

@Timeout(60)
class JsonBatchesTest {
    private static final double INFINITY = Double.POSITIVE_INFINITY;

    private static String packed(double... numbers) {
        ByteBuffer bytes = ByteBuffer.allocate(8 * numbers.length).order(ByteOrder.LITTLE_ENDIAN);
        for (double number : numbers) {
            bytes.putDouble(number);
        }
        return Base64.getEncoder().encodeToString(bytes.array());
    }

    private static String batch(String requests) {
        return "{\"type\":\"batch\",\"requests\":[" + requests + "]}";
    }

    private static String fan(String fields) {
        return batch("{\"kind\":\"sense\",\"objectName\":\"r\",\"pattern\":"
                + "{\"kind\":\"fan\",\"first\":0,\"step\":1,\"count\":4}" + fields + "}");
    }

    private static String pattern(String fields) {
        return batch("{\"kind\":\"sense\",\"objectName\":\"r\",\"pattern\":{" + fields + "}}");
    }

    private static String poses(String base64) {
        return batch("{\"kind\":\"poses\",\"objectName\":\"r\",\"poses\":\"" + base64 + "\"}");
    }

    private static String answers(String answers) {
        return "{\"type\":\"answers\",\"answers\":[" + answers + "]}";
    }

    @Test
    void everyRequestComesBackAsItWas() throws ProtocolException {
        for (Bundle bundle : List.of(
                BatchSamples.requests(),
                BatchSamples.frames().get(0),
                BatchSamples.pictures().get(0),
                BatchSamples.world().get(0),
                BatchSamples.obstacles().get(0),
                new BatchRequestBundle(List.of()))) {
            String line = JsonLines.write(bundle);
            Bundle read = JsonLines.readRequest(line);
            assertThat(read).isEqualTo(bundle).hasToString(bundle.toString());
            assertThat(JsonLines.write(read)).isEqualTo(line).doesNotContain("\n");
            assertThat(JsonLines.isReply(line)).isFalse();
        }
    }

    @Test
    void everyAnswerComesBackAsItWas() throws ProtocolException {
        Reply reply = new Reply(BatchSamples.answers(), List.of(Problem.of(5, "no moveable object \"\u00e9\"")));
        String line = JsonLines.write(reply);
        assertThat(JsonLines.readReply(line)).isEqualTo(reply);
        assertThat(JsonLines.isReply(line)).isTrue();
        Reply pictures = new Reply(BatchSamples.pictures().get(1));
        assertThat(JsonLines.readReply(JsonLines.write(pictures))).isEqualTo(pictures);
        assertThat(JsonLines.write(pictures)).contains("{\"width\":1,\"height\":1,\"rgb\":\"/4AB\"}");
        Reply obstacles = new Reply(BatchSamples.obstacles().get(1));
        assertThat(JsonLines.readReply(JsonLines.write(obstacles))).isEqualTo(obstacles);
        assertThat(JsonLines.write(obstacles))
                .contains("{\"done\":false,\"obstacle\":\"\",\"obstacles\":[{\"index\":4,\"kind\":\"box\","
                        + "\"center\":[0.0,0.0,-3.0]},{\"index\":9007199254740991,\"name\":\"wall \u00e9\","
                        + "\"kind\":\"grid\",\"center\":[1.0E-300,2.0,3.0]}]}");
        Reply frames = new Reply(BatchSamples.frames().get(1));
        assertThat(JsonLines.readReply(JsonLines.write(frames))).isEqualTo(frames);
        assertThat(JsonLines.write(frames))
                .contains("\"names\":[\"\",\"wall"
                        + " \u00e9\"],\"objects\":\"AQAAAP////8AAAAA\",\"labels\":\"////fwAAAAAHAAAA\"");
        assertThat(JsonLines.write(new Reply(new BatchAnswerBundle(List.of(new NoAnswer())))))
                .isEqualTo(answers("{\"error\":\"no answer\"}"));
        assertThatThrownBy(() -> JsonLines.write(BatchSamples.answers())).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void aListOfTheWorldIsReadAndWritten() throws ProtocolException {
        Bundle copies = BatchSamples.copies().get(0);
        assertThat(JsonLines.readRequest(JsonLines.write(copies))).isEqualTo(copies);
        Reply ticks = new Reply(BatchSamples.copies().get(1));
        assertThat(JsonLines.readReply(JsonLines.write(ticks))).isEqualTo(ticks);
        Bundle asked = BatchSamples.listed().get(0);
        assertThat(JsonLines.readRequest(JsonLines.write(asked))).isEqualTo(asked);
        Reply told = new Reply(BatchSamples.listed().get(1));
        assertThat(JsonLines.readReply(JsonLines.write(told))).isEqualTo(told);
        assertThat(JsonLines.write(told))
                .contains("{\"listed\":[]},{\"listed\":[{\"index\":0,\"kind\":\"mesh\",\"center\":[0.0,0.0,0.0],")
                .contains("\"name\":\"wall \u00e9\",\"kind\":\"box\"")
                .contains(
                        "\"moveable\":true,\"low\":[-1.0,-2.0,-3.0],\"high\":[-1.0,-2.0,-3.0]}],\"next\":9007199254740991}");
        assertThat(JsonLines.readRequest(batch("{\"kind\":\"list\"}")))
                .isEqualTo(new BatchRequestBundle(List.of(new WorldRequest.ListObjects(0, 1000))));
    }

    @Test
    void numbersAreLittleEndianDoubles() throws ProtocolException {
        Reply reply =
                new Reply(new BatchAnswerBundle(List.of(new SenseAnswer(Numbers.of(1.5, INFINITY), Numbers.NONE))));
        assertThat(JsonLines.write(reply)).isEqualTo(answers("{\"distances\":\"" + packed(1.5, INFINITY) + "\"}"));
        assertThat(packed(1.5, INFINITY)).isEqualTo("AAAAAAAA+D8AAAAAAADwfw==");
    }

    @Test
    void whatIsLeftOutHasItsDefault() throws ProtocolException {
        assertThat(JsonLines.readRequest(batch("{\"kind\":\"moveToContact\",\"objectName\":\"r\"},"
                        + "{\"objectName\":\"r\",\"z\":2,\"kind\":\"moveAndSlide\"},"
                        + "{\"objectName\":\"r\",\"kind\":\"moveAndSlide\",\"maxSlopeRadians\":0.5},"
                        + "{\"objectName\":\"r\",\"kind\":\"moveAndSlide\",\"stepHeight\":0.25,\"snap\":1},"
                        + "{\"max\":2,\"objectName\":\"r\",\"kind\":\"separate\"},"
                        + "{\"kind\":\"attach\",\"carrier\":\"r\",\"objectName\":\"b\"},"
                        + "{\"identify\":false,\"kind\":\"move\",\"objectName\":\"r\"},"
                        + "{\"kind\":\"sense\",\"pattern\":{\"kind\":\"fan\",\"first\":0,\"step\":1,\"count\":4}}")))
                .isEqualTo(new BatchRequestBundle(List.of(
                        new WorldRequest.GoToContact("r", 0, 0, 0, 0, 0, 0),
                        new WorldRequest.GoAndSlide("r", 0, 0, 2, 0, 0, 0, 4),
                        new WorldRequest.GoAndSlide("r", 0, 0, 0, 0, 0, 0, 4, new WorldRequest.Walk(0, 0.5, 0)),
                        new WorldRequest.GoAndSlide(
                                "r", 0, 0, 0, 0, 0, 0, 4, new WorldRequest.Walk(0.25, Math.PI / 2, 1)),
                        new WorldRequest.Separate("r", 2),
                        new WorldRequest.Attach("b", "r", null),
                        new WorldRequest.Go("r", 0, 0, 0, 0, 0),
                        new SenseRequest("", new BeamPattern.Fan(0, 1, 4)))));
        BeamPattern pattern = new BeamPattern.Fan(0, 1, 4);
        assertThat(JsonLines.readRequest(fan("")))
                .isEqualTo(new BatchRequestBundle(List.of(new SenseRequest("r", pattern))));
        assertThat(JsonLines.readRequest(
                        fan(",\"max\":null,\"min\":0,\"width\":0,\"normals\":false,\"seesCarrier\":false,"
                                + "\"mount\":{\"place\":[0,0,0]}")))
                .isEqualTo(JsonLines.readRequest(fan("")));
    }

    /** Every double, and every length of padding, in strings longer than any other text may be. */
    @Test
    void packedNumbersKeepTheirBitsAtAnyLength() throws ProtocolException {
        SplittableRandom random = new SplittableRandom(19);
        for (int count : new int[] {1, 2, 3, 4, 100, 1 << 14, 20_001}) {
            double[] numbers = new double[4 * count];
            for (int k = 0; k < numbers.length; k++) {
                double number = Double.longBitsToDouble(random.nextLong());
                numbers[k] = Math.abs(number) <= 0x1p100 ? number : k;
            }
            BatchRequestBundle bundle =
                    new BatchRequestBundle(List.of(new FreePosesRequest("r", new Numbers(numbers))));
            String line = JsonLines.write(bundle);
            assertThat(line).contains('"' + packed(numbers) + '"');
            assertThat(JsonLines.readRequest(line)).isEqualTo(bundle);
        }
    }

    /** A line that is read as it arrives, a byte at a time, is the same. */
    @Test
    void longLinesAreReadAsTheyArrive() throws IOException {
        double[] numbers = new SplittableRandom(3).doubles(80_000).toArray();
        BatchRequestBundle bundle = new BatchRequestBundle(List.of(
                new FreeEdgesRequest("r", new Numbers(numbers)), new SenseRequest("r", new BeamPattern.Fan(0, 1, 4))));
        String text = "{\"type\":\"hello\",\"version\":1}\n" + JsonLines.write(bundle) + "\n";
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        ByteArrayInputStream slow = new ByteArrayInputStream(bytes) {
            @Override
            public synchronized int read(byte[] into, int at, int length) {
                return super.read(into, at, Math.min(length, 997));
            }
        };
        JsonCodec codec = JsonCodec.open(
                slow,
                new ByteArrayOutputStream(),
                MessagePace.NONE,
                PeerAdmission.OPEN,
                WorldLoader.NONE,
                reason -> {});
        assertThat(codec.read()).isEqualTo(bundle);
        assertThat(codec.read()).isNull();
    }

    static Stream<Arguments> wrong() {
        String one = packed(1, 2, 3, 4);
        return Stream.of(
                Arguments.of(batch("{\"kind\":\"sense\",\"objectName\":\"r\"}"), "it must have the field \"pattern\""),
                Arguments.of(batch("{\"objectName\":\"r\"}"), "must have the field \"kind\""),
                Arguments.of(
                        batch("{\"kind\":\"x\",\"objectName\":\"r\"}"),
                        "must be sense, poses, edges, measure, picture, world, pose, place, add, remove, move,"
                                + " moveToContact, drive, moveAndSlide, list, separate, attach, detach, scene, prove, copy or tick (got: \"x\")"),
                Arguments.of(batch("{\"kind\":\"poses\",\"poses\":\"\"}"), "must have the field \"objectName\""),
                Arguments.of(fan(",\"poses\":\"\""), "of kind \"sense\" it must not have the field \"poses\""),
                Arguments.of(fan(",\"min\":2,\"max\":1"), "at /requests/0/max: max must be at least min"),
                Arguments.of(fan(",\"min\":-1"), "min must be from 0"),
                Arguments.of(fan(",\"width\":4"), "width must be an angle in radians"),
                Arguments.of(fan(",\"width\":0.1,\"normals\":true"), "width must be 0 for normals"),
                Arguments.of(fan(",\"mount\":{}"), "must have the field \"place\""),
                Arguments.of(fan(",\"mount\":{\"place\":[0,0]}"), "must be a list of 3 numbers (got: 2)"),
                Arguments.of(
                        fan(",\"mount\":{\"place\":[0,0,0],\"rotation\":[1,0,0,0,1,0,0,0,2]}"),
                        "rotation must be 9 numbers"),
                Arguments.of(
                        batch("{\"kind\":\"separate\",\"objectName\":\"r\"}"),
                        "of kind \"separate\" it must have the field \"max\""),
                Arguments.of(
                        batch("{\"kind\":\"separate\",\"objectName\":\"r\",\"max\":null}"),
                        "max must be a number from 0 to 2^100 (got: Infinity)"),
                Arguments.of(
                        batch("{\"kind\":\"pose\",\"objectName\":\"r\",\"rep117\":true}"),
                        "of kind \"pose\" it must not have the field \"rep117\""),
                Arguments.of(fan(",\"rep117\":1"), "must be true or false"),
                Arguments.of(
                        "{\"type\":\"step\",\"seconds\":1,\"mixing\":{\"restitution\":\"MEAN\"}}",
                        "must have the field \"friction\""),
                Arguments.of(
                        "{\"type\":\"step\",\"seconds\":1,\"mixing\":{\"restitution\":\"MEAN\",\"friction\":\"MOST\"}}",
                        "GEOMETRIC_MEAN"),
                Arguments.of(
                        "{\"type\":\"answers\",\"answers\":[{\"done\":false,\"displacement\":[0,0,0]}]}",
                        "done must be true with a displacement (got: false)"),
                Arguments.of(pattern("\"kind\":\"cube\""), "must be fan, layers, pinhole or directions"),
                Arguments.of(pattern("\"kind\":\"fan\",\"first\":0,\"step\":1"), "it must have the field \"count\""),
                Arguments.of(
                        pattern("\"kind\":\"fan\",\"first\":0,\"step\":1,\"count\":0"),
                        "a whole number from 1 to 16777216"),
                Arguments.of(pattern("\"kind\":\"fan\",\"first\":0,\"step\":1,\"count\":1e9"), "from 1 to 16777216"),
                Arguments.of(pattern("\"kind\":\"fan\",\"first\":0,\"step\":1,\"count\":1.5"), "a whole number"),
                Arguments.of(
                        pattern("\"kind\":\"fan\",\"first\":0,\"step\":1,\"count\":2,\"height\":2"),
                        "must not have the field \"height\""),
                Arguments.of(
                        pattern("\"kind\":\"fan\",\"first\":0,\"step\":1,\"count\":1048577"),
                        "requests must have at most 1048576 beams together (got: 1048577)"),
                Arguments.of(
                        pattern("\"kind\":\"pinhole\",\"width\":4096,\"height\":4096,\"fieldOfView\":1"),
                        "at most 1048576 beams together (got: 16777216)"),
                Arguments.of(
                        pattern("\"kind\":\"pinhole\",\"width\":16777216,\"height\":2,\"fieldOfView\":1"),
                        "height must be from 1 to 1"),
                Arguments.of(
                        pattern("\"kind\":\"pinhole\",\"width\":1,\"height\":1,\"fieldOfView\":0"),
                        "fieldOfView must be"),
                Arguments.of(
                        pattern("\"kind\":\"layers\",\"elevations\":[],\"first\":0,\"step\":0,\"count\":1"),
                        "number of elevations must be from 1"),
                Arguments.of(
                        pattern("\"kind\":\"layers\",\"elevations\":[0,2],\"first\":0,\"step\":0,\"count\":1"),
                        "elevations[1] must be an angle in radians"),
                Arguments.of(pattern("\"kind\":\"directions\",\"directions\":\"\""), "at least one beam"),
                Arguments.of(
                        pattern("\"kind\":\"directions\",\"directions\":\"" + packed(0, 0, 0) + "\""),
                        "direction 0 must not be zero"),
                Arguments.of(
                        pattern("\"kind\":\"directions\",\"directions\":\"" + packed(0, Double.NaN, 0) + "\""),
                        "directions[1] "),
                Arguments.of(poses("x"), "must be"),
                Arguments.of(poses("AAA"), "must be"),
                Arguments.of(poses("AAAA"), "must have 32 bytes each in base64 (got: 3 bytes)"),
                Arguments.of(poses(one + one), "must be base64"),
                Arguments.of(poses(one.substring(0, 8) + " " + one.substring(8)), "must be base64"),
                Arguments.of(poses("AA==" + packed(1, 2, 3, 4, 5, 6, 7).substring(4)), "must be base64"),
                Arguments.of(poses(one.replace("A=", "B=")), "must be base64"),
                Arguments.of(poses("===="), "must be base64"),
                Arguments.of(poses("A==="), "must be base64"),
                Arguments.of(poses(one.substring(0, 8) + "\\n" + one.substring(8)), "must be base64"),
                Arguments.of(
                        poses(one.replace('=', '*')),
                        "must be base64, with its padding and nothing else (got: other characters)"),
                Arguments.of(poses(one.replace("=", "")), "must be base64"),
                Arguments.of(
                        poses(one.replace('A', '-')),
                        "must be base64, with its padding and nothing else (got: other characters)"),
                Arguments.of(
                        poses("\u00e9" + one.substring(1)),
                        "must be base64, with its padding and nothing else (got: other characters)"),
                Arguments.of(poses(packed(0, 0, 0, Double.NaN)), "poses[3] must be an angle in radians"),
                Arguments.of(poses(packed(0, INFINITY, 0, 0)), "poses[1] must be"),
                Arguments.of(
                        batch("{\"kind\":\"poses\",\"objectName\":\"r\",\"poses\":[1,2,3,4]}"), "a string of base64"),
                Arguments.of(
                        batch("{\"kind\":\"edges\",\"objectName\":\"r\",\"edges\":\"" + one + "\"}"), "64 bytes each"),
                Arguments.of(poses(one).substring(0, 70), "must be JSON (RFC 8259), which ends"),
                Arguments.of(answers("{\"distances\":\"" + packed(-1) + "\"}"), "distances[0] must be at least 0"),
                Arguments.of(
                        answers("{\"distances\":\"" + packed(Double.NaN) + "\"}"), "distances[0] must be at least 0"),
                Arguments.of(
                        answers("{\"distances\":\"" + packed(1) + "\",\"count\":1}"), "an answer must have distances"),
                Arguments.of(answers("{}"), "an answer must have distances"),
                Arguments.of(answers("{\"normals\":\"\"}"), "an answer must have distances"),
                Arguments.of(answers("{\"count\":3,\"free\":\"\"}"), "free must have 1 bytes for 3 bits (got: 0)"),
                Arguments.of(answers("{\"count\":3,\"free\":\"/w==\"}"), "no bits but its 3"),
                Arguments.of(answers("{\"count\":300000,\"free\":\"\"}"), "a whole number from 0 to 262144"));
    }

    @ParameterizedTest
    @MethodSource("wrong")
    void whatIsWrongIsNamed(String line, String reason) {
        assertThatThrownBy(() -> {
                    if (line.startsWith("{\"type\":\"answers\"")) {
                        JsonLines.readReply(line);
                    } else {
                        JsonLines.readRequest(line);
                    }
                })
                .as(line)
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining(reason);
    }

    /** Beyond the limit of one value, of all together, and just within. */
    @Test
    void batchesHaveTheirLimits() throws ProtocolException {
        String largest = packed(new double[4 * MessageLimits.MAX_POSES]);
        assertThat(((BatchRequestBundle) JsonLines.readRequest(poses(largest))).size())
                .isEqualTo(MessageLimits.MAX_POSES);
        assertThatThrownBy(() -> JsonLines.readRequest(poses(packed(new double[4 * MessageLimits.MAX_POSES + 4]))))
                .hasMessageContaining("must have at most 8388608 bytes in base64 (got: more)");
        String one = "{\"kind\":\"poses\",\"objectName\":\"r\",\"poses\":\"" + packed(0, 0, 0, 0) + "\"}";
        String many = "{\"kind\":\"poses\",\"objectName\":\"r\",\"poses\":\"" + largest + "\"}";
        assertThatThrownBy(() -> JsonLines.readRequest(batch(many + "," + one)))
                .hasMessageContaining(
                        "requests must have at most 262144 poses, edges and requests of other kinds together (got:"
                                + " 262145)");
        String half = "{\"kind\":\"sense\",\"objectName\":\"r\",\"pattern\":"
                + "{\"kind\":\"fan\",\"first\":0,\"step\":0,\"count\":524288}}";
        assertThat(((BatchRequestBundle) JsonLines.readRequest(batch(half + "," + half))).size())
                .isEqualTo(MessageLimits.MAX_BEAMS);
        assertThatThrownBy(() -> JsonLines.readRequest(batch(half + "," + half + "," + half)))
                .hasMessageContaining("requests must have at most 1048576 beams together (got: 1572864)");
    }

    /** Escapes are JSON's, not base64's: a peer's library may escape a slash. */
    @Test
    void escapesAreOfJson() throws ProtocolException {
        String slash = packed(-0x1p99, 0, 0, 0);
        double number =
                ByteBuffer.wrap(new byte[] {63, -1, -1, -1, -1, -1, -1, -1}).getDouble();
        assertThat(packed(number, 0, 0, 0)).startsWith("////");
        assertThat(JsonLines.readRequest(poses(packed(number, 0, 0, 0).replace("/", "\\/"))))
                .isEqualTo(JsonLines.readRequest(poses(packed(number, 0, 0, 0))));
        assertThat(JsonLines.readRequest(poses(slash.replace("A", "\\u0041"))))
                .isEqualTo(JsonLines.readRequest(poses(slash)));
    }

    /** As the JDK decodes and encodes them; what it encodes otherwise is refused. */
    @Test
    void base64IsThatOfTheJdk() {
        SplittableRandom random = new SplittableRandom(64);
        int whole = 0;
        for (int round = 0; round < 20_000; round++) {
            byte[] bytes = new byte[random.nextInt(12)];
            random.nextBytes(bytes);
            StringBuilder text = new StringBuilder(Base64.getEncoder().encodeToString(bytes));
            for (int k = random.nextInt(3); k > 0 && text.length() > 0; k--) {
                text.setCharAt(random.nextInt(text.length()), "A=+/-_ z9\u00e9".charAt(random.nextInt(10)));
            }
            if (random.nextInt(4) == 0) {
                text.setLength(random.nextInt(text.length() + 1));
            }
            Base64Sink sink = new Base64Sink(100);
            sink.write(text.toString().toCharArray(), 0, text.length());
            byte[] truth = null;
            try {
                truth = Base64.getDecoder().decode(text.toString());
                truth = Base64.getEncoder().encodeToString(truth).contentEquals(text) ? truth : null;
            } catch (IllegalArgumentException e) {
                // is no base64
            }
            assertThat(sink.isWhole()).as(text.toString()).isEqualTo(truth != null);
            if (truth != null) {
                assertThat(sink.bytes()).isEqualTo(truth);
                whole++;
            }
        }
        assertThat(whole).isBetween(5_000, 15_000);
    }

    /** A text that is not packed is as short as before. */
    @Test
    void otherTextsAreNoLonger() {
        String name = "x".repeat(MessageLimits.MAX_TEXT_BYTES + 1);
        assertThatThrownBy(() -> JsonLines.readRequest(
                        batch("{\"kind\":\"poses\",\"poses\":\"\",\"objectName\":\"" + name + "\"}")))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("a string must have at most 65535 bytes");
    }
}
