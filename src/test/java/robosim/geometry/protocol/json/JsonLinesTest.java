package robosim.geometry.protocol.json;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Base64;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.Samples;
import robosim.geometry.protocol.SonarRequestBundle;

@Timeout(60)
class JsonLinesTest {
    private static final GeometryObject BALL = new SphereObject(new Point(), 1);

    @Test
    void everyRequestComesBackAsItWas() throws ProtocolException {
        for (Bundle bundle : Samples.everyBundle()) {
            if (bundle instanceof DistanceBundle) {
                continue;
            }
            String line = JsonLines.write(bundle);
            Bundle read = JsonLines.readRequest(line);
            assertThat(read).isEqualTo(bundle).hasToString(bundle.toString());
            assertThat(JsonLines.write(read)).isEqualTo(line).doesNotContain("\n");
        }
    }

    @Test
    void everyReplyComesBackAsItWas() throws ProtocolException {
        MoveRequest made = new MoveRequest("robot", 0.1, -0.0, 1e-300, Math.PI / 2, -0.0);
        List<Reply> replies = List.of(
                new Reply(new MoveBundle(List.of())),
                new Reply(
                        new MoveBundle(List.of(made)),
                        List.of(Problem.of(1, "blocked by \"wall\\3\""), Problem.of(4, () -> "later"))),
                new Reply(new DistanceBundle(List.of(-0.0, 1e-320, Double.POSITIVE_INFINITY))),
                new Reply(
                        new DistanceBundle(List.of(Double.NaN, 2.5, Double.NaN)),
                        List.of(Problem.of(0, "no moveable object \"\u00e9\ud83e\udd16\""), Problem.of(2, "no"))));
        for (Reply reply : replies) {
            String line = JsonLines.write(reply);
            assertThat(JsonLines.readReply(line)).isEqualTo(reply);
            assertThat(JsonLines.write(JsonLines.readReply(line))).isEqualTo(line);
        }
        assertThat(JsonLines.write(new Reply(new DistanceBundle(List.of(Double.NaN)))))
                .isEqualTo("{\"type\":\"distances\",\"distances\":[{\"error\":\"no distance\"}]}");
    }

    @Test
    void doublesKeepTheirBits() throws ProtocolException {
        SplittableRandom random = new SplittableRandom(17);
        List<MoveRequest> moves = new ArrayList<>();
        int tiny = 0;
        while (moves.size() < 4000) {
            double[] numbers =
                    random.longs(5).mapToDouble(Double::longBitsToDouble).toArray();
            for (int k = 0; k < 5; k++) {
                // All exponents that are allowed; every fourth is a neighbour of a decimal that people write.
                numbers[k] = random.nextInt(4) == 0
                        ? Math.nextUp(random.nextInt(100_000) / 1000.0)
                        : Math.abs(numbers[k]) <= 0x1p100 ? numbers[k] : Math.scalb(random.nextDouble(), -1060);
                tiny += Math.abs(numbers[k]) < Double.MIN_NORMAL ? 1 : 0;
            }
            moves.add(new MoveRequest("r", numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]));
        }
        assertThat(tiny).isBetween(1000, 19_000);
        MoveBundle bundle = new MoveBundle(moves);
        MoveBundle read = (MoveBundle) JsonLines.readRequest(JsonLines.write(bundle));
        assertThat(read).isEqualTo(bundle); // records compare doubles by their bits
    }

    @Test
    void objectsKeepEveryBitOfTheirAttitude() throws ProtocolException {
        SplittableRandom random = new SplittableRandom(18);
        List<GeometryObject> objects = new ArrayList<>(Samples.everyShape());
        for (int k = 0; k < 500; k++) {
            GeometryObject object = new BoxObject(new Point(k, 0, 0), 1, 2, 3);
            for (int turn = 0; turn <= k % 4; turn++) {
                object = object.turned(k % 5 == 0 ? random.nextDouble(-90, 90) : 0, random.nextDouble(-200, 200) / 3);
            }
            objects.add(object);
        }
        InitBundle read = (InitBundle) JsonLines.readRequest(JsonLines.write(new InitBundle(objects)));
        int rests = 0;
        for (int k = 0; k < objects.size(); k++) {
            GeometryObject was = objects.get(k);
            GeometryObject is = read.objects().get(k);
            assertThat(is).isEqualTo(was);
            assertThat(is.heading()).isEqualTo(was.heading());
            assertThat(is.pose().lostHeading()).isEqualTo(was.pose().lostHeading());
            assertThat(is.turned(0, 0.1)).isEqualTo(was.turned(0, 0.1));
            rests += was.pose().lostHeading() != 0 ? 1 : 0;
        }
        assertThat(rests).isBetween(100, 450);
    }

    @Test
    void whatAMaterialLeavesOutIsTheDefaults() throws ProtocolException {
        InitBundle read = (InitBundle) JsonLines.readRequest("{\"type\":\"init\",\"objects\":[" + ball("")
                + "," + ball("\"color\":\"#FF8000\"") + "," + ball("\"color\":[0.1,0,1],\"label\":7")
                + "," + ball("\"texture\":{\"size\":2,\"second\":\"#ffffff\",\"first\":[0,0,0],\"kind\":\"checker\"}")
                + "]}");
        assertThat(read.objects())
                .extracting(GeometryObject::material)
                .containsExactly(
                        Material.DEFAULT,
                        Material.of(Color.parse("#ff8000")),
                        Material.of(new Color(0.1, 0, 1)).withLabel(7),
                        Material.DEFAULT.withTexture(new Texture.Checker(Color.BLACK, Color.WHITE, 2)));
    }

    private static String ball(String material) {
        return "{\"kind\":\"sphere\",\"center\":[0,0,0],\"radius\":1,\"material\":{" + material + "}}";
    }

    private static String picture(int columns, int rows, int pixels) {
        return ball("\"texture\":{\"kind\":\"image\",\"columns\":" + columns + ",\"rows\":" + rows + ",\"pixels\":\""
                + Base64.getEncoder().encodeToString(new byte[3 * pixels]) + "\",\"width\":1,\"height\":1}");
    }

    @Test
    void equalPicturesShareTheirPixels() throws ProtocolException {
        List<GeometryObject> balls = new ArrayList<>();
        for (int k = 0; k < 3; k++) {
            ImageTexture image = new ImageTexture(2, 1, new int[] {1, 2}, k / 2 + 1, 1);
            balls.add(new SphereObject(new Point(), k).withMaterial(Material.DEFAULT.withTexture(image)));
        }
        InitBundle read = (InitBundle) JsonLines.readRequest(JsonLines.write(new InitBundle(balls)));
        assertThat(read.objects()).isEqualTo(balls);
        assertThat(read.objects().get(1).material().texture())
                .isSameAs(read.objects().get(0).material().texture());
    }

    @Test
    void fieldsComeInAnyOrderWithSpaceBetweenThem() throws ProtocolException {
        Bundle read = JsonLines.readRequest("  {\t\"objects\" : [ {\"radius\":2e0,\"center\":[1,-0,1E1],\"name\":\"b\","
                + "\"kind\":\"sphere\"} ] , \"type\" : \"init\" } \r");
        assertThat(read).isEqualTo(new InitBundle(List.of(new SphereObject(new Point(1, 0, 10), 2).named("b"))));
        read = JsonLines.readRequest("{\"type\":\"init\",\"objects\":[{\"kind\":\"mesh\",\"vertices\":[[0,0,0],[1,0,0],"
                + "[0,0,1]],\"faces\":[[0,1.0,2e0]]}]}");
        assertThat(((MeshObject) ((InitBundle) read).objects().get(0)).faces()).isEqualTo(new int[][] {{0, 1, 2}});
    }

    @Test
    void anUnknownKindIsRefusedWithAllThatAreKnown() {
        String line = "{\"type\":\"init\",\"objects\":[{\"kind\":\"cone\"}]}";
        String all = "box, cylinder, sphere, capsule, mesh, group or grid";
        assertThat(all.split(", | or ")).hasSameSizeAs(GeometryObject.Kind.values());
        assertThatThrownBy(() -> JsonLines.readRequest(line))
                .hasMessage("at /objects/0/kind: must be " + all + " (got: \"cone\")");
    }

    static Stream<Arguments> bad() {
        String move = "{\"objectName\":\"r\",\"x\":1,\"y\":0,\"z\":0,\"rx\":0,\"ry\":0}";
        String moves = "{\"type\":\"moves\",\"moves\":[" + move + ",%s]}";
        String box =
                "{\"type\":\"init\",\"objects\":[{\"kind\":\"box\",\"center\":[0,0,0],\"width\":1,\"height\":1,%s}]}";
        String mesh = "{\"type\":\"init\",\"objects\":[{\"kind\":\"mesh\",\"vertices\":[[0,0,0],[1,0,0],[0,0,1]],%s}]}";
        String init = "{\"type\":\"init\",\"objects\":[%s]}";
        String sonar = "{\"type\":\"sonars\",\"requests\":[{\"objectName\":\"r\",%s}]}";
        return Stream.of(
                Arguments.of("", "blank line"),
                Arguments.of("   ", "blank line"),
                Arguments.of("[]", "the message: must be an object, {...} (got: a list)"),
                Arguments.of("{}", "must have the field \"type\""),
                Arguments.of("{\"type\":7}", "at /type: must be a string (got: a number)"),
                Arguments.of(
                        "{\"type\":\"x\"}",
                        "a request's type must be init, moves, sonars, batch or step, where there is no connection"
                                + " that answers a hello, a load or a ping (got: \"x\")"),
                Arguments.of("{\"type\":\"load\",\"file\":\"a.xml\"}", "must be init, moves, sonars, batch or step"),
                Arguments.of("{\"type\":\"ping\"}", "a hello, a load or a ping (got: \"ping\")"),
                Arguments.of("{\"type\":\"moves\"}", "the message: must have the field \"moves\""),
                Arguments.of(
                        "{\"type\":\"moves\",\"moves\":[],\"more\":1}", "at /more: a field must be one of type, moves"),
                Arguments.of(
                        "{\"type\":\"moves\",\"moves\":[],\"moves\":[]}", "at /moves: a field must occur only once"),
                Arguments.of(
                        "{\"type\":\"moves\",\"type\":\"moves\",\"moves\":[]}",
                        "at /type: a field must occur only once"),
                Arguments.of("{\"type\":\"moves\",\"moves\":{}}", "at /moves: must be a list, [...] (got: an object)"),
                Arguments.of("{\"type\":\"moves\",\"moves\":[]} {}", "nothing may follow a message"),
                Arguments.of("{\"type\":\"moves\",\"moves\":[]}x", "must be JSON"),
                Arguments.of("{\"type\":\"moves\",\"moves\":[]", "must be JSON"),
                Arguments.of("{\"type\":\"moves\",\"moves\":[],}", "must be JSON"),
                Arguments.of("{\"type\":\"moves\",/**/\"moves\":[]}", "must be JSON"),
                Arguments.of("{'type':\"moves\",\"moves\":[]}", "must be JSON"),
                Arguments.of("{\"type\":\"moves\",\n\"moves\":[]}", "a control character must be escaped"),
                Arguments.of("{\"type\":\"mov\tes\",\"moves\":[]}", "must be JSON"),
                Arguments.of(moves.formatted(move.replace(":1,", ":NaN,")), "at /moves/1/x: must be JSON"),
                Arguments.of(moves.formatted(move.replace(":1,", ":NaN,")), "numbers are finite"),
                Arguments.of(moves.formatted(move.replace(":1,", ":-Infinity,")), "numbers are finite"),
                Arguments.of(moves.formatted(move.replace(":1,", ":nan,")), "numbers are finite"),
                Arguments.of(moves.formatted(move.replace(":1,", ":\"NaN\",")), "at /moves/1/x: must be a number"),
                Arguments.of(
                        moves.formatted(move.replace(":1,", ":null,")), "at /moves/1/x: must be a number (got: null)"),
                Arguments.of(
                        moves.formatted(move.replace(":1,", ":1e999,")),
                        "at /moves/1/x: must be a number that a double"),
                Arguments.of(
                        moves.formatted(move.replace(":1,", ":1e31,")),
                        "at /moves/1/x: x must be a number from -2^100"),
                Arguments.of(moves.formatted(move.replace(":1,", ":01,")), "must be JSON"),
                Arguments.of(moves.formatted(move.replace(":1,", ":+1,")), "must be JSON"),
                Arguments.of(moves.formatted(move.replace(":1,", ":.5,")), "must be JSON"),
                Arguments.of(moves.formatted(move.replace(":1,", ":0x10,")), "must be JSON"),
                Arguments.of(moves.formatted(move.replace(":1,", ":" + "1".repeat(1101) + ",")), "1100 characters"),
                Arguments.of(moves.formatted(move.replace("\"x\":1,", "")), "at /moves/1: must have the field \"x\""),
                Arguments.of(moves.formatted(move.replace("\"r\"", "\"\\ud83e\"")), "unpaired surrogate"),
                Arguments.of(moves.formatted(move.replace("\"r\"", "\"\\udd16\\ud83e\"")), "unpaired surrogate"),
                Arguments.of(moves.formatted(move.replace("\"r\"", "\"\ud83e\"")), "unpaired surrogate"),
                Arguments.of(moves.formatted(move.replace("\"r\"", "\"" + "x".repeat(65_536) + "\"")), "65535 bytes"),
                Arguments.of(
                        moves.formatted(move.replace("\"r\"", "\"" + "\u4e2d".repeat(21_846) + "\"")), "65535 bytes"),
                Arguments.of(
                        box.formatted("\"length\":1,\"radius\":1"),
                        "at /objects/0: a box must not have the field \"radius\""),
                Arguments.of(box.formatted("\"solid\":true"), "a box must have the field \"length\""),
                Arguments.of(box.formatted("\"length\":-1"), "at /objects/0/length: length must be a number from 0"),
                Arguments.of(box.formatted("\"length\":1,\"moveable\":true"), "name must be given"),
                Arguments.of(box.formatted("\"length\":1,\"moveable\":1"), "/moveable: must be true or false"),
                Arguments.of(box.formatted("\"length\":1,\"name\":\" \""), "name must have a visible character"),
                Arguments.of(
                        box.formatted("\"length\":1,\"rotation\":[1,0,0]"), "/rotation: must be a list of 9 numbers"),
                Arguments.of(
                        box.formatted("\"length\":1,\"rotation\":[1,0,0,0,1,0,0,0,1,0]"),
                        "/rotation/9: a list must have at most 9 items"),
                Arguments.of(
                        box.formatted("\"length\":1,\"rotation\":[1,0,0,0,1,0,0,0,-1]"), "rotation must be 9 numbers"),
                Arguments.of(box.formatted("\"length\":1,\"headingDegrees\":[0,0]"), "rotation that it belongs to"),
                Arguments.of(init.formatted(ball("\"colour\":1")), "/material/colour: a field must be one of color, "),
                Arguments.of(
                        init.formatted(ball("\"color\":\"red\"")),
                        "at /objects/0/material/color: color must be #rrggbb, six hexadecimal digits (got: red)"),
                Arguments.of(init.formatted(ball("\"color\":[1,1]")), "/color: must be a list of 3 numbers (got: 2)"),
                Arguments.of(
                        init.formatted(ball("\"mirror\":1.5")),
                        "at /objects/0/material/mirror: mirror must be a number from 0 to 1 (got: 1.5)"),
                Arguments.of(init.formatted(ball("\"label\":-1")), "/material/label: must be a whole number from 0 to"),
                Arguments.of(
                        init.formatted(ball("\"texture\":{\"kind\":\"wood\"}")), "must be checker, stripes or image"),
                Arguments.of(
                        init.formatted(ball(
                                "\"texture\":{\"kind\":\"checker\",\"first\":\"#000000\",\"second\":\"#000000\"}")),
                        "of kind \"checker\" it must have the field \"size\""),
                Arguments.of(init.formatted(picture(2, 2, 3)), "bytes must have 3 for each of 2 x 2 pixels (got: 9)"),
                Arguments.of(
                        init.formatted(picture(99_999, 99_999, 1)), "at most 67108864 pixels (got: 99999 x 99999)"),
                Arguments.of(
                        init.formatted(picture(1155, 1155, 1155 * 1155)),
                        "/pixels: must have at most 3999999 bytes in base64 (got: more)"),
                Arguments.of(
                        mesh.formatted("\"faces\":[[0,1,2]],\"texturePoints\":[0,0]"),
                        "texturePoints and textureCorners must come together (got: one of them)"),
                Arguments.of(
                        mesh.formatted("\"faces\":[[0,1,2]],\"texturePoints\":[0,0],\"textureCorners\":[0,0]"),
                        "corners must have one index for each corner of the 1 faces, 3 (got: 2)"),
                Arguments.of(
                        mesh.formatted("\"faces\":[[0,1,2]],\"texturePoints\":[0,0],\"textureCorners\":[0,0,1]"),
                        "corners[2] must be -1 or one of the 1 points"),
                Arguments.of(
                        mesh.formatted("\"faces\":[[0,1,2]],\"texturePoints\":[0,0],\"textureCorners\":[0,0,-2]"),
                        "/textureCorners/2: must be a whole number from -1 to"),
                Arguments.of(mesh.formatted("\"faces\":[]"), "face"),
                Arguments.of(mesh.formatted("\"faces\":[[0,1]]"), "3 or 4 corners (got: 2)"),
                Arguments.of(mesh.formatted("\"faces\":[[0,1,3]]"), "at /objects/0/faces: "),
                Arguments.of(mesh.formatted("\"faces\":[[0,1,-1]]"), "/faces/0/2: must be a whole number"),
                Arguments.of(mesh.formatted("\"faces\":[[0,1,0.5]]"), "/faces/0/2: must be a whole number"),
                Arguments.of(mesh.formatted("\"faces\":[[0,1,1.00000000000000000001]]"), "must be a whole number"),
                Arguments.of(
                        mesh.formatted("\"faces\":[[0,1,1" + "0".repeat(900) + ".0e-900]]"),
                        "/faces/0/2: must be a whole number"),
                Arguments.of(mesh.formatted("\"faces\":[[0,1,2]],\"solid\":true"), "must be closed"),
                Arguments.of(sonar.formatted("\"xOffset\":0,\"zOffset\":-0.0"), "must not both be zero"),
                Arguments.of(
                        sonar.formatted("\"xOffset\":1,\"zOffset\":0,\"beam\":null"),
                        "at /requests/0/beam: must be an object, {...} (got: null)"),
                Arguments.of(
                        sonar.formatted("\"xOffset\":1,\"zOffset\":0,\"beam\":{\"min\":2,\"max\":1,\"width\":0}"),
                        "at /requests/0/beam/max: max must be at least min"),
                Arguments.of("\ufeff{\"type\":\"moves\",\"moves\":[]}", "byte order mark"));
    }

    @ParameterizedTest
    @MethodSource("bad")
    void whatIsWrongIsNamedWithItsPlace(String line, String reason) {
        assertThatThrownBy(() -> JsonLines.readRequest(line))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining(reason)
                .message()
                .doesNotContain("enable", "was expecting", "\n")
                .hasSizeLessThan(800);
    }

    private static GeometryObject nested(int levels) {
        GeometryObject object = BALL;
        for (int k = 0; k < levels; k++) {
            object = new ObjectGroup(List.of(object));
        }
        return object;
    }

    @Test
    void groupsNestAsDeepAsPromisedAndNoDeeper() throws ProtocolException {
        InitBundle deep = new InitBundle(List.of(nested(28)));
        assertThat(JsonLines.readRequest(JsonLines.write(deep))).isEqualTo(deep);
        for (int levels : new int[] {32, ObjectGroup.MAX_DEPTH}) {
            assertThatThrownBy(() -> JsonLines.readRequest(JsonLines.write(new InitBundle(List.of(nested(levels))))))
                    .isInstanceOf(ProtocolException.class)
                    .hasMessageContaining("nesting must be at most 64 deep");
        }
        assertThatThrownBy(() -> JsonLines.readRequest("{\"a\":" + "[".repeat(1_000_000)))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("nesting must be at most 64 deep");
    }

    @Tag("slow")
    @Test
    void listsAndPartsHaveTheirLimits() throws ProtocolException {
        String item = "{\"objectName\":\"\",\"xOffset\":1,\"zOffset\":0},";
        String most = item.repeat(MessageLimits.MAX_LIST_LENGTH);
        String fair = "{\"type\":\"sonars\",\"requests\":[" + most.substring(0, most.length() - 1) + "]}";
        assertThat(((SonarRequestBundle) JsonLines.readRequest(fair)).requests())
                .hasSize(MessageLimits.MAX_LIST_LENGTH);
        assertThatThrownBy(() -> JsonLines.readRequest(fair.replaceFirst("\\[", "[" + item)))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("at /requests/1100000: a list must have at most 1100000 items");
        // Meshes inside many groups count in each: 600,000 faces in 26 groups.
        MeshObject mesh = new MeshObject(
                List.of(new Point(), new Point(1, 0, 0), new Point(0, 0, 1)),
                Collections.nCopies(600_000, new int[] {0, 1, 2}).toArray(int[][]::new));
        GeometryObject group = mesh;
        for (int k = 0; k < 26; k++) {
            group = new ObjectGroup(List.of(group));
        }
        String heavy = JsonLines.write(new InitBundle(List.of(group)));
        assertThatThrownBy(() -> JsonLines.readRequest(heavy))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("at most 16000000 parts");
        InitBundle light =
                new InitBundle(((ObjectGroup) ((ObjectGroup) group).members().get(0)).members());
        assertThat(JsonLines.readRequest(JsonLines.write(light))).isEqualTo(light);
    }

    @Test
    void aLineHasAnEnd() {
        String long1 = "{\"type\":\"moves\",\"moves\":[" + " ".repeat(MessageLimits.MAX_MESSAGE_BYTES) + "]}";
        assertThatThrownBy(() -> JsonLines.readRequest(long1))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("a line must have at most " + MessageLimits.MAX_MESSAGE_BYTES);
    }

    @Test
    void anAnswerIsNoRequestAndTheOtherWayRound() {
        assertThatThrownBy(() -> JsonLines.write(new DistanceBundle(List.of())))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("DistanceBundle");
        assertThatThrownBy(() -> JsonLines.readRequest("{\"type\":\"distances\",\"distances\":[]}"))
                .isInstanceOf(ProtocolException.class);
        assertThatThrownBy(() -> JsonLines.readReply("{\"type\":\"sonars\",\"requests\":[]}"))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("an answer's type");
        assertThatThrownBy(() -> JsonLines.readReply("{\"type\":\"distances\",\"distances\":[-1]}"))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("at /distances/0");
    }

    /** A Java peer's name may be no Unicode; its line is well-formed, and refused where it is read. */
    @Test
    void halfASurrogatePairIsEscaped() {
        String line = JsonLines.write(new MoveBundle(List.of(new MoveRequest("a\ud83eb", 0, 0, 0, 0, 0))));
        assertThat(line).contains("\"a\\ud83eb\"");
        assertThatThrownBy(() -> JsonLines.readRequest(line)).hasMessageContaining("at /moves/0/objectName");
    }

    @Test
    void theModulesVersionIsTheProjects() throws Exception {
        String pom = java.nio.file.Files.readString(java.nio.file.Path.of("pom.xml"));
        assertThat(pom).contains("<version>" + JsonLines.MODULE.split(" ")[1] + "</version>\n  <packaging>");
    }

    /** The sign, the point and the exponent are characters too. */
    @Test
    void aNumberHasAtMostItsCharactersWhateverTheyAre() throws ProtocolException {
        String line =
                "{\"type\":\"moves\",\"moves\":[{\"objectName\":\"a\",\"x\":%s,\"y\":0,\"z\":0,\"rx\":0,\"ry\":0}]}";
        for (String form : new String[] {"0.%s", "-0.%s", "0.%se0", "-0.%se-1", "0.%sE+00"}) {
            int rest = 1100 - form.length() + 2;
            String most = form.formatted("1".repeat(rest));
            assertThat(most).hasSize(1100);
            assertThat(JsonLines.readRequest(line.formatted(most))).isInstanceOf(MoveBundle.class);
            assertThatThrownBy(() -> JsonLines.readRequest(line.formatted(form.formatted("1".repeat(rest + 1)))))
                    .as(form)
                    .isInstanceOf(ProtocolException.class)
                    .hasMessageContaining("at /moves/0/x: a number must have at most 1100 characters (got: more)");
        }
    }
}
