package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.json.JsonAnswers.Failed;

/** Messages as JSON, by their types; every double has the shortest digits that identify it. */
final class JsonMessages {
    /** Most files of a world: a model of a robot with a mesh for each of its links has some 30. */
    private static final int MAX_FILES = 1_000;

    /** Most bytes of one of them; all must fit into a line as base64. */
    private static final int MAX_FILE_BYTES = 3 * MessageLimits.MAX_MESSAGE_BYTES / 8;

    private static final JsonObject<WorldSettings> SETTINGS = JsonObject.of(WorldSettings.class)
            .form("width", size("width"))
            .form("height", size("height"))
            .form("length", size("length"))
            .omitting(0.0, "width height length")
            .omitting(null, "dimension accuracy");

    private static final JsonObject<Bundle> INIT = JsonObject.of(Init.class)
            .form("objects", JsonForm.list(JsonShapes.OBJECT))
            .form("settings", SETTINGS)
            .omitting(null, "settings")
            .omitting(false, "answer")
            .as(Init::bundle, Init::of);

    private static final JsonObject<MoveBundle> MOVES =
            JsonObject.of(MoveBundle.class).form("moves", JsonForm.list(JsonObject.of(MoveRequest.class)));

    private static final JsonObject<SonarRequestBundle> SONARS = JsonObject.of(SonarRequestBundle.class)
            .form(
                    "requests",
                    JsonForm.list(JsonObject.of(SonarRequest.class)
                            .form("beam", JsonObject.of(Beam.class).form("max", JsonForm.RANGE))
                            .omitting(null, "beam")));

    private static final JsonObject<Reply> MADE = JsonObject.of(Made.class)
            .inline("made", MOVES)
            .form("refused", JsonAnswers.REFUSED)
            .as(
                    made -> new Reply(made.made, made.refused),
                    reply -> new Made((MoveBundle) reply.bundle(), reply.problems()));

    private static final JsonObject<Failed> FAILED = JsonObject.of(Failed.class);

    /** A distance, null for none, or why there is no answer. */
    private static final JsonForm<Object> DISTANCE = JsonForm.of(JsonMessages::distance, (out, told) -> {
        if (told instanceof Failed failed) {
            FAILED.write(out, failed);
        } else {
            JsonForm.RANGE.write(out, (Double) told);
        }
    });

    private static final JsonObject<Reply> DISTANCES = JsonObject.of(Distances.class)
            .form("distances", JsonForm.list(DISTANCE))
            .as(Distances::reply, Distances::of);

    private static final JsonObject<Ping> PING = JsonObject.of(Ping.class);

    private static final Map<String, JsonObject<?>> REQUESTS = Map.of(
            "init",
            INIT,
            "load",
            JsonObject.of(WorldLoader.Load.class)
                    .form("files", JsonForm.of(JsonMessages::files, (out, files) -> {}))
                    .optional(Map.of(), "files")
                    .form("settings", SETTINGS)
                    .omitting(null, "settings")
                    .named("isNaming", "named")
                    .omitting(false, "named"),
            "moves",
            MOVES,
            "sonars",
            SONARS,
            "batch",
            JsonBatches.BATCH,
            "step",
            JsonSteps.STEP,
            "ping",
            PING);

    private static final Map<String, JsonObject<Reply>> REPLIES =
            Map.of("moves", MADE, "distances", DISTANCES, "answers", JsonAnswers.ANSWERS, "bodies", JsonSteps.BODIES);

    private static final JsonObject<Hello> HELLO = JsonObject.of(Hello.class).omitting(null, "secret resume");

    private static final JsonObject<Welcome> WELCOME = JsonObject.of(Welcome.class)
            .form("limits", JsonObject.of(Limits.class))
            .omitting(null, "token");

    /** Most characters of a token that is worth looking up. */
    private static final int MAX_TOKEN = 64;

    private static final JsonObject<Failure> FAILURE = JsonObject.of(Failure.class);

    private JsonMessages() {}

    /** The {@code type} of a message, at any position; what follows it is not read. */
    static String typeOf(JsonInput message) throws IOException {
        try (JsonInput in = message) {
            if (in.find("type")) {
                return in.text();
            }
            throw in.refused("must have the field \"type\" (got: none)");
        }
    }

    /** The {@code type} of a message, given its beginning, if that field is the first; else null. */
    static @Nullable String firstTypeOf(JsonInput beginning) {
        try (JsonInput in = beginning) {
            in.begin();
            return in.isObject() && "type".equals(in.nextField()) && in.isText() ? in.text() : null;
        } catch (IOException e) {
            return null; // reading the whole message will report what is wrong
        }
    }

    /** Reads a request: a Bundle, an {@link WorldLoader.Load} or a {@link Ping}. */
    static Object request(String type, JsonInput in) throws IOException {
        JsonObject<?> form = REQUESTS.get(type);
        if (form == null) {
            throw ProtocolException.ofRequest(
                    "a request's type must be init, load, moves, sonars, batch, step or ping (got: " + Text.quoted(type)
                            + ")",
                    null);
        }
        return form.readMessage(in);
    }

    /** Reads an answer. */
    static Reply reply(String type, JsonInput in) throws IOException {
        JsonObject<Reply> form = REPLIES.get(type);
        if (form == null) {
            throw new ProtocolException(
                    "an answer's type must be moves, distances, answers or bodies (got: " + Text.quoted(type) + ")");
        }
        return form.readMessage(in);
    }

    /** Reads the first message of a peer. */
    static Hello hello(JsonInput in) throws IOException {
        in.begin();
        Hello hello = HELLO.read(in);
        in.end();
        return hello;
    }

    /** Writes a request. */
    static void write(JsonGenerator out, Bundle request) throws IOException {
        if (request instanceof InitBundle || request instanceof InitBundle.Answered) {
            write(out, "init", null, INIT, request);
        } else if (request instanceof MoveBundle moves) {
            write(out, "moves", null, MOVES, moves);
        } else if (request instanceof SonarRequestBundle sonars) {
            write(out, "sonars", null, SONARS, sonars);
        } else if (request instanceof BatchRequestBundle batch) {
            write(out, "batch", null, JsonBatches.BATCH, batch);
        } else if (request instanceof StepBundle step) {
            write(out, "step", null, JsonSteps.STEP, step);
        } else {
            throw new IllegalArgumentException(
                    "a request must be an InitBundle, an InitBundle.Answered, a MoveBundle, a"
                            + " SonarRequestBundle, a BatchRequestBundle or a StepBundle (got: "
                            + request.getClass().getSimpleName() + ")");
        }
    }

    /** Writes an answer, with the id of its request if that has one. */
    static void write(JsonGenerator out, Reply reply, @Nullable Object id) throws IOException {
        String type = reply.bundle() instanceof MoveBundle
                ? "moves"
                : reply.bundle() instanceof StepBundle.Answer
                        ? "bodies"
                        : reply.bundle() instanceof BatchAnswerBundle ? "answers" : "distances";
        write(out, type, id, Checks.present("form", REPLIES.get(type)), reply);
    }

    /** Writes the answer to a peer's hello. */
    static void writeHello(JsonGenerator out, PeerAdmission.@Nullable Resumption resumption) throws IOException {
        Object lastId = resumption == null ? null : resumption.lastId();
        String token = resumption == null ? null : resumption.token();
        write(out, "hello", lastId, WELCOME, new Welcome(JsonLines.VERSION, JsonLines.MODULE, Limits.ALL, token));
    }

    /** Writes the answer to a ping. */
    static void writePong(JsonGenerator out, @Nullable Object id) throws IOException {
        write(out, "pong", id, PING, new Ping());
    }

    /** Writes why a request is not carried out, in a conversation that goes on. */
    static void writeError(JsonGenerator out, String message, @Nullable Object id) throws IOException {
        write(out, "error", id, FAILURE, new Failure(true, message));
    }

    private static <T> void write(JsonGenerator out, String type, @Nullable Object id, JsonObject<T> form, T message)
            throws IOException {
        out.writeStartObject();
        out.writeStringField("type", type);
        if (id instanceof Long number) {
            out.writeNumberField("id", number);
        } else if (id != null) {
            out.writeStringField("id", id.toString());
        }
        form.writeMembers(out, message);
        out.writeEndObject();
    }

    private static Map<String, byte[]> files(JsonInput in) throws IOException {
        Map<String, byte[]> files = new LinkedHashMap<>();
        in.beginObject();
        for (String name = in.nextField(); name != null; name = in.nextField()) {
            if (files.size() >= MAX_FILES || files.containsKey(name)) {
                throw in.refused(
                        "there must be at most " + MAX_FILES + " files, each once (got: " + in.told(name) + ")");
            }
            files.put(name, in.base64(1, MAX_FILE_BYTES));
        }
        return files;
    }

    private static JsonForm<Double> size(String name) {
        return JsonForm.NUMBER.as(size -> Checks.worldSize(name, size), size -> size);
    }

    private static Object distance(JsonInput in) throws IOException {
        if (in.isObject()) {
            return FAILED.read(in);
        }
        Double distance = JsonForm.RANGE.read(in);
        if (distance < 0) {
            throw in.refused("a distance must be at least 0 (got: " + distance + ")");
        }
        return distance;
    }

    /** A ping: asks whether the peer is alive. */
    record Ping() {}

    /** The first message of a peer. */
    record Hello(
            String type,
            double version,
            @Nullable String secret,
            @Nullable String resume) {
        Hello {
            if (resume != null && resume.length() > MAX_TOKEN) {
                throw new IllegalArgumentException("resume must be the token of a session, or empty (got: another)");
            }
            if (version != JsonLines.VERSION) {
                throw new IllegalArgumentException("version must be " + JsonLines.VERSION + " (got: another)");
            }
        }

        @Override
        public String toString() {
            return "hello"; // neither the secret nor a token appears anywhere
        }
    }

    record Welcome(
            int version,
            String module,
            Limits limits,
            @Nullable String token) {}

    record Limits(
            int messageBytes, int depth, int references, int arrayLength, int listLength, long parts, int textBytes) {
        private static final Limits ALL = new Limits(
                MessageLimits.MAX_MESSAGE_BYTES,
                MessageLimits.MAX_DEPTH,
                MessageLimits.MAX_REFERENCES,
                MessageLimits.MAX_ARRAY_LENGTH,
                MessageLimits.MAX_LIST_LENGTH,
                MessageLimits.MAX_PARTS,
                MessageLimits.MAX_TEXT_BYTES);
    }

    record Failure(boolean continues, String message) {}

    record Made(MoveBundle made, List<Problem> refused) {}

    record Init(List<GeometryObject> objects, @Nullable WorldSettings settings, boolean answer) {
        static Init of(Bundle bundle) {
            InitBundle init = bundle instanceof InitBundle.Answered asked ? asked.init() : (InitBundle) bundle;
            return new Init(init.objects(), init.settings(), bundle != init);
        }

        Bundle bundle() {
            InitBundle init = new InitBundle(objects, settings);
            return answer ? new InitBundle.Answered(init) : init;
        }
    }

    record Distances(List<Object> distances) {
        static Distances of(Reply reply) {
            List<Double> distances = ((DistanceBundle) reply.bundle()).distances();
            return new Distances(Failed.in(distances, Double.NaN, reply.problems(), "no distance"));
        }

        Reply reply() {
            List<Double> all = new ArrayList<>();
            List<Problem> problems = Failed.out(distances, Double.NaN, Double.class, all);
            return new Reply(new DistanceBundle(all), problems);
        }
    }
}
