package robosim.geometry.protocol.json;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.BatchSamples;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageTranslator;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.Samples;
import robosim.geometry.protocol.StepSamples;
import robosim.geometry.protocol.batch.MeasureRequest;
import robosim.geometry.protocol.channel.MessageChannel;
import robosim.geometry.protocol.pace.MessagePace;

/** The published schema and the codec accept the same messages, but for what a schema cannot say. */
class JsonSchemaTest {
    private static final ObjectMapper MAPPER = new ObjectMapper();

    /** What the codec refuses and the schema cannot: rules between values, and the rules of Unicode and of geometry. */
    private static final List<String> BEYOND_A_SCHEMA = List.of(
            "rotation must be 9 numbers",
            "must not both be zero",
            "max must be at least min",
            "must be closed",
            "boundingVolume must enclose",
            "must enclose",
            "name must have a visible character",
            "so there is none to resume",
            "must be indices",
            "faces[",
            "enclose",
            "occupied must have",
            "points must have two numbers each",
            "corners must have one index",
            "corners[",
            "bytes must have 3 for each",
            "a grid stands upright",
            "a grid must lie within",
            "must be base64",
            "width must be 0 for normals",
            "direction ",
            "directions[",
            "poses[",
            "edges[",
            "distances[",
            "normals[",
            "objects[",
            "labels[",
            "objects and labels must have",
            "width must be 0 for objects",
            "seesCarrier must be false",
            "normals must have three numbers for each",
            "free must have",
            "heading and rotation must not both",
            "obstacle must be left out",
            "low must not be above high",
            "objects must be in the order of their indices",
            "next must be -1, or above the last index",
            "obstacles must be at most",
            "contact and normal must be given",
            "rgb must have",
            "pixels together",
            "rays for pictures",
            "beams together",
            "slidingFriction must be at most",
            "must be left out for a drive",
            "maxTurn of a car",
            "must be left out for SIGNED",
            "other must be a name for SIGNED",
            "keeps no sessions");

    private static final List<String> REQUESTS = List.of(
            "{\"type\":\"hello\",\"version\":1}",
            "{\"type\":\"hello\",\"version\":1,\"secret\":\"s\"}",
            "{\"type\":\"ping\"}",
            "{\"type\":\"ping\",\"id\":\"x\"}",
            "{\"type\":\"ping\",\"id\":17}");

    /** Angles and speeds of turning whose names have their unit. */
    private static final List<String> WITH_UNITS = List.of(
            "{\"type\":\"step\",\"seconds\":1,\"bodies\":[{\"objectName\":\"r\",\"maxTurnRadians\":2,\"drive\":{\"kind\":"
                    + "\"omnidirectional\",\"maxTurnRadians\":1,\"maxTurnAccelerationRadians\":3}}],\"commands\":[{"
                    + "\"objectName\":\"r\",\"turnRadians\":0.5}]}",
            "{\"type\":\"batch\",\"requests\":[{\"kind\":\"move\",\"objectName\":\"r\",\"rxRadians\":1,\"ryRadians\":2},"
                    + "{\"kind\":\"moveToContact\",\"objectName\":\"r\",\"ryRadians\":2},{\"kind\":\"place\",\"objectName\":"
                    + "\"r\",\"center\":[0,0,0],\"headingRadians\":1},{\"kind\":\"sense\",\"objectName\":\"r\",\"mount\":{"
                    + "\"place\":[0,0,0],\"headingRadians\":1},\"pattern\":{\"kind\":\"fan\",\"first\":0,\"step\":1,"
                    + "\"count\":2},\"motion\":{\"duration\":1,\"ryRadians\":1}}]}");

    @Test
    void aNameWithItsUnitIsTheSameField() throws IOException {
        for (String line : WITH_UNITS) {
            String without = line.replace("Radians", "");
            assertThat(JsonLines.readRequest(line)).isEqualTo(JsonLines.readRequest(without));
            assertThat(toModule.validate(MAPPER.readTree(without))).isEmpty();
        }
        for (String twice : List.of(
                WITH_UNITS.get(0).replace("\"turnRadians\"", "\"turn\":1,\"turnRadians\""),
                WITH_UNITS.get(0).replace("\"seconds\"", "\"secondsRadians\""),
                WITH_UNITS.get(1).replace("\"rxRadians\"", "\"xRadians\""))) {
            assertThat(refusal(twice)).as(twice).isNotNull();
            assertThat(toModule.validate(MAPPER.readTree(twice))).isNotEmpty();
        }
    }

    private final Schema toModule = schema("toModule");
    private final Schema fromModule = schema("fromModule");

    private static Schema schema(String part) {
        try {
            ObjectNode whole = (ObjectNode) MAPPER.readTree(Files.readString(Path.of("docs", "protocol.schema.json")));
            whole.remove("anyOf");
            whole.put("$ref", "#/$defs/" + part);
            return SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
                    .getSchema(whole);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private static List<String> requests() {
        List<String> lines = new ArrayList<>(REQUESTS);
        for (Bundle bundle : Samples.everyBundle()) {
            if (!(bundle instanceof DistanceBundle)) {
                lines.add(JsonLines.write(bundle));
            }
        }
        lines.add(JsonLines.write(BatchSamples.requests()));
        lines.add(JsonLines.write(BatchSamples.frames().get(0)));
        lines.add(JsonLines.write(BatchSamples.pictures().get(0)));
        for (Bundle bundle : BatchSamples.world()) {
            if (!(bundle instanceof BatchAnswerBundle)) {
                lines.add(JsonLines.write(bundle));
            }
        }
        lines.add(JsonLines.write(BatchSamples.obstacles().get(0)));
        lines.add(JsonLines.write(BatchSamples.listed().get(0)));
        lines.add(JsonLines.write(BatchSamples.copies().get(0)));
        lines.add("{\"type\":\"hello\",\"version\":1,\"resume\":\"\"}");
        lines.add(JsonLines.write(BatchSamples.walks()));
        lines.add(JsonLines.write(BatchSamples.proofs().get(0)));
        lines.add(JsonLines.write(BatchSamples.attachments()));
        lines.add(JsonLines.write(BatchSamples.rules().get(0)));
        lines.add(JsonLines.write(BatchSamples.drives().get(0)));
        lines.add(JsonLines.write(BatchSamples.drives().get(2)));
        lines.add(JsonLines.write(BatchSamples.rules().get(2)));
        lines.add(JsonLines.write(StepSamples.later().get(0)));
        lines.add(JsonLines.write(
                new InitBundle.Answered((InitBundle) BatchSamples.world().get(3))));
        lines.add("{\"type\":\"init\",\"answer\":true,\"objects\":[{\"kind\":\"box\",\"center\":[0,0,0],\"width\":1,"
                + "\"height\":1,\"length\":1,\"heading\":0.5}],\"settings\":{\"dimension\":\"SPATIAL\"}}");
        lines.add(
                "{\"type\":\"batch\",\"requests\":[{\"kind\":\"sense\",\"objectName\":\"r\",\"mount\":{\"place\":[0,0,0],"
                        + "\"heading\":1},\"pattern\":{\"kind\":\"fan\",\"first\":0,\"step\":1,\"count\":2}},{\"kind\":\"move\","
                        + "\"objectName\":\"r\",\"x\":1},{\"kind\":\"place\",\"objectName\":\"r\",\"center\":[0,1,2]}]}");
        lines.add(JsonLines.write(new BatchRequestBundle(List.of())));
        lines.addAll(WITH_UNITS);
        lines.add("{\"type\":\"sonars\",\"requests\":[],\"id\":\"a name\"}");
        lines.add(
                "{\"type\":\"load\",\"file\":\"a\",\"files\":{\"a\":\"/wM=\"},\"named\":true,\"settings\":{\"width\":4}}");
        lines.add("{\"id\":-7,\"type\":\"moves\",\"moves\":[]}");
        StepSamples.requests().forEach(step -> lines.add(JsonLines.write(step)));
        lines.add(JsonLines.write(StepSamples.pushing()));
        lines.add(JsonLines.write(StepSamples.ignoring()));
        lines.add(JsonLines.write(new BatchRequestBundle(List.of(MeasureRequest.signed("a", "b")))));
        return lines;
    }

    private static List<String> replies() {
        MoveBundle made = new MoveBundle(List.of(new MoveRequest("r", 1, 0, -0.0, 1e-300, 2)));
        return List.of(
                "{\"type\":\"distances\",\"id\":17,\"distances\":[]}",
                JsonLines.write(new Reply(BatchSamples.frames().get(1))),
                JsonLines.write(new Reply(BatchSamples.pictures().get(1))),
                JsonLines.write(new Reply(BatchSamples.world().get(1))),
                JsonLines.write(new Reply(BatchSamples.obstacles().get(1))),
                JsonLines.write(new Reply(BatchSamples.listed().get(1))),
                JsonLines.write(new Reply(BatchSamples.copies().get(1))),
                JsonLines.write(new Reply(made)),
                JsonLines.write(new Reply(StepSamples.answer(), List.of(Problem.of(1, "why")))),
                JsonLines.write(new Reply(StepSamples.landing())),
                JsonLines.write(new Reply(BatchSamples.rules().get(1))),
                JsonLines.write(new Reply(BatchSamples.proofs().get(1))),
                JsonLines.write(new Reply(BatchSamples.drives().get(1))),
                JsonLines.write(new Reply(StepSamples.later().get(1))),
                JsonLines.write(new Reply(made, List.of(Problem.of(1, "why")))),
                JsonLines.write(new Reply(
                        new DistanceBundle(List.of(0.0, 1.5, Double.POSITIVE_INFINITY, Double.NaN)),
                        List.of(Problem.of(3, "why")))),
                JsonLines.write(new Reply(BatchSamples.answers(), List.of(Problem.of(5, "why")))));
    }

    /** What the channel says to a peer that sends this message, as its hello or after one; null where it is accepted. */
    private @Nullable String refusal(String line) throws IOException {
        boolean hello = line.contains("\"hello\"");
        String text = (hello ? "" : REQUESTS.get(0) + "\n") + line + "\n";
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        MessageChannel channel = new MessageChannel(
                new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)),
                out,
                MessageTranslator.RECORDS,
                MessagePace.NONE,
                PeerAdmission.OPEN);
        List<String> refusals = new ArrayList<>();
        channel.onWrongRequest(refusals::add);
        channel.loadBy(load -> new WorldLoader.Loaded(List.of(new InitBundle(List.of())), 1, List.of()));
        try {
            channel.read();
        } catch (ProtocolException e) {
            refusals.add(String.valueOf(e.getMessage()));
        }
        assertThat(refusals).hasSizeLessThan(2);
        for (String answer : out.toString(StandardCharsets.UTF_8).lines().toList()) {
            assertThat(fromModule.validate(MAPPER.readTree(answer))).as(answer).isEmpty();
        }
        return refusals.isEmpty() ? null : refusals.get(0);
    }

    private static @Nullable String replyRefusal(String line) {
        try {
            JsonLines.readReply(line);
            return null;
        } catch (ProtocolException e) {
            return e.getMessage();
        }
    }

    @Test
    void everySampleIsAcceptedByBoth() throws IOException {
        for (String line : requests()) {
            assertThat(toModule.validate(MAPPER.readTree(line))).as(line).isEmpty();
            assertThat(refusal(line)).as(line).isNull();
        }
        for (String line : replies()) {
            assertThat(fromModule.validate(MAPPER.readTree(line))).as(line).isEmpty();
            assertThat(replyRefusal(line)).as(line).isNull();
        }
    }

    @Test
    void mutationsAreJudgedAlike() throws IOException {
        SplittableRandom random = new SplittableRandom(20261121);
        List<String> lines = new ArrayList<>(requests());
        int requests = lines.size();
        lines.addAll(replies());
        int accepted = 0;
        int refused = 0;
        int beyond = 0;
        int rounds = Effort.cases(6000);
        for (int round = 0; round < rounds; round++) {
            int which = random.nextInt(lines.size());
            JsonNode message = MAPPER.readTree(lines.get(which));
            mutate(message, random);
            String line = MAPPER.writeValueAsString(message);
            boolean request = which < requests;
            boolean fits = (request ? toModule : fromModule).validate(message).isEmpty();
            String refusal = request ? refusal(line) : replyRefusal(line);
            if (fits && refusal != null) {
                assertThat(BEYOND_A_SCHEMA).as(line + "\n" + refusal).anyMatch(refusal::contains);
                beyond++;
            } else {
                assertThat(refusal == null).as(line + "\n" + refusal).isEqualTo(fits);
                accepted += fits ? 1 : 0;
                refused += fits ? 0 : 1;
            }
        }
        assertThat(accepted).isBetween(rounds / 10, rounds * 2 / 3);
        assertThat(refused).isBetween(rounds / 3, rounds * 9 / 10);
        assertThat(beyond).isBetween(1, rounds / 6);
    }

    private static final List<String> VALUES = List.of(
            "null",
            "true",
            "false",
            "0",
            "-1",
            "7",
            "1.0",
            "0.5",
            "1e20",
            "3e30",
            "1e31",
            "-0.0",
            "\"\"",
            "\"text\"",
            "\" \"",
            "[]",
            "{}",
            "[1]",
            "[0,1,2]",
            "{\"error\":\"x\"}",
            "\"SPATIAL\"",
            "\"mesh\"",
            "\"/wM=\"",
            "\"/wMA\"",
            "9007199254740992",
            "1333333",
            "3.141592653589793",
            "3.1415926535897927");

    /** One change somewhere below a node. */
    private static void mutate(JsonNode message, SplittableRandom random) throws IOException {
        List<JsonNode> places = new ArrayList<>();
        collect(message, places);
        JsonNode place = places.get(random.nextInt(places.size()));
        JsonNode value = MAPPER.readTree(VALUES.get(random.nextInt(VALUES.size())));
        if (place instanceof ObjectNode object) {
            List<String> names = new ArrayList<>();
            object.fieldNames().forEachRemaining(names::add);
            String name = names.isEmpty() ? "none" : names.get(random.nextInt(names.size()));
            switch (random.nextInt(4)) {
                case 0 -> object.remove(name);
                case 1 -> object.set(NAMES.get(random.nextInt(NAMES.size())), value);
                default -> object.set(name, value);
            }
        } else if (place instanceof ArrayNode list && !list.isEmpty()) {
            int at = random.nextInt(list.size());
            switch (random.nextInt(4)) {
                case 0 -> list.remove(at);
                case 1 -> list.add(list.get(at));
                case 2 -> list.add(value);
                default -> list.set(at, value);
            }
        }
    }

    private static final List<String> NAMES = List.of(
            "type",
            "kind",
            "name",
            "moveable",
            "center",
            "rotation",
            "headingDegrees",
            "solid",
            "radius",
            "cell",
            "columns",
            "occupied",
            "secret",
            "id",
            "settings",
            "pattern",
            "mount",
            "normals",
            "beam",
            "unknown",
            "boundingVolume",
            "refused",
            "heading",
            "headingRadians",
            "turn",
            "ry",
            "answer",
            "object",
            "obstacle",
            "obstacles",
            "identify",
            "clearance",
            "layers",
            "ignored",
            "bends",
            "contacts",
            "done",
            "index",
            "error");

    private static void collect(JsonNode node, List<JsonNode> places) {
        if (node.isContainerNode()) {
            places.add(node);
            node.forEach(child -> collect(child, places));
        }
    }
}
