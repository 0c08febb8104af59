package robosim.geometry.protocol.json;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.WorldSettings;

/** Reads messages of known type from JSON. */
final class JsonMessages {
    private static final Fields INIT = Fields.of("type objects", "settings answer");
    private static final Fields LOAD = Fields.of("type file", "files settings named");
    private static final Fields SETTINGS = Fields.of("", "width height length dimension accuracy");
    private static final Fields MOVES = Fields.of("type moves", "");
    private static final Fields MOVE = Fields.of("objectName x y z rx ry", "");
    private static final Fields SONARS = Fields.of("type requests", "");
    private static final Fields SONAR = Fields.of("objectName xOffset zOffset", "beam");
    private static final Fields BEAM = Fields.of("min max width", "");
    private static final Fields MADE = Fields.of("type moves refused", "");
    private static final Fields REFUSED = Fields.of("index reason", "");
    private static final Fields DISTANCES = Fields.of("type distances", "");
    private static final Fields ERROR = Fields.of("error", "");
    private static final Fields HELLO = Fields.of("type version", "secret");
    private static final Fields PING = Fields.of("type", "");

    /** Most files of a world: a model of a robot with a mesh for each of its links has some 30. */
    private static final int MAX_FILES = 1_000;

    /** Most bytes of one of them; all must fit into a line as base64. */
    private static final int MAX_FILE_BYTES = 3 * MessageLimits.MAX_MESSAGE_BYTES / 8;

    private final JsonInput in;
    private boolean wantsAnswer;

    JsonMessages(JsonInput in) {
        this.in = in;
    }

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

    /** The first message of a peer. */
    record Hello(@Nullable String secret) {
        @Override
        public String toString() {
            return "hello"; // the secret appears nowhere
        }
    }

    /** A ping: asks whether the peer is alive. */
    record Ping() {}

    Hello hello() throws IOException {
        String secret = null;
        in.begin();
        JsonMembers message = in.object(HELLO);
        for (int field = message.next(); field >= 0; field = message.next()) {
            switch (field) {
                case 0 -> in.text();
                case 1 -> version();
                default -> secret = in.text();
            }
        }
        in.end();
        return new Hello(secret);
    }

    private void version() throws IOException {
        double version = in.number();
        if (version != JsonLines.VERSION) {
            throw in.refused("version must be " + JsonLines.VERSION + " (got: another)");
        }
    }

    Ping ping() throws IOException {
        JsonMembers message = in.message(PING);
        while (message.next() >= 0) {
            in.text();
        }
        in.end();
        return new Ping();
    }

    InitBundle init() throws IOException {
        List<GeometryObject> objects = new ArrayList<>();
        WorldSettings settings = null;
        JsonMembers message = in.message(INIT);
        for (int field = message.next(); field >= 0; field = message.next()) {
            switch (field) {
                case 0 -> in.text();
                case 1 -> objects = new JsonObjects(in).list();
                case 2 -> settings = settings();
                default -> wantsAnswer = in.flag();
            }
        }
        in.end();
        return new InitBundle(objects, settings);
    }

    InitBundle.Load load() throws IOException {
        String file = "";
        Map<String, byte[]> files = new LinkedHashMap<>();
        WorldSettings settings = null;
        boolean isNaming = false;
        JsonMembers message = in.message(LOAD);
        for (int field = message.next(); field >= 0; field = message.next()) {
            switch (field) {
                case 0 -> in.text();
                case 1 -> file = in.text();
                case 2 -> files(files);
                case 3 -> settings = settings();
                default -> isNaming = in.flag();
            }
        }
        in.end();
        return new InitBundle.Load(file, files, settings, isNaming);
    }

    private void files(Map<String, byte[]> files) throws IOException {
        in.beginObject();
        for (String name = in.nextField(); name != null; name = in.nextField()) {
            if (files.size() >= MAX_FILES || files.containsKey(name)) {
                throw in.refused(
                        "there must be at most " + MAX_FILES + " files, each once (got: " + in.told(name) + ")");
            }
            files.put(name, in.base64(1, MAX_FILE_BYTES));
        }
    }

    /** Whether the init that was read asks what becomes of it. */
    boolean wantsAnswer() {
        return wantsAnswer;
    }

    private WorldSettings settings() throws IOException {
        WorldSettings none = WorldSettings.NONE;
        double[] sizes = {none.width(), none.height(), none.length()};
        Dimension dimension = none.dimension();
        Accuracy accuracy = none.accuracy();
        JsonMembers members = in.object(SETTINGS);
        for (int next = members.next(); next >= 0; next = members.next()) {
            int field = next;
            switch (field) {
                case 3 -> dimension = in.constant(Dimension.class);
                case 4 -> accuracy = in.constant(Accuracy.class);
                default -> {
                    double size = in.number();
                    sizes[field] = in.make(() -> Checks.worldSize(SETTINGS.name(field), size));
                }
            }
        }
        return new WorldSettings(sizes[0], sizes[1], sizes[2], dimension, accuracy);
    }

    MoveBundle moves() throws IOException {
        List<MoveRequest> moves = new ArrayList<>();
        JsonMembers message = in.message(MOVES);
        for (int field = message.next(); field >= 0; field = message.next()) {
            if (field == 0) {
                in.text();
            } else {
                moves = moveList();
            }
        }
        in.end();
        return new MoveBundle(moves);
    }

    private List<MoveRequest> moveList() throws IOException {
        List<MoveRequest> moves = new ArrayList<>();
        in.list();
        while (in.more(moves.size(), MessageLimits.MAX_LIST_LENGTH)) {
            moves.add(move());
        }
        return moves;
    }

    private MoveRequest move() throws IOException {
        String[] name = {""};
        double[] numbers = new double[5];
        JsonMembers members = in.object(MOVE);
        for (int field = members.next(); field >= 0; field = members.next()) {
            if (field == 0) {
                name[0] = in.text();
            } else {
                numbers[field - 1] = in.number();
            }
        }
        return in.make(() -> new MoveRequest(name[0], numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]));
    }

    SonarRequestBundle sonars() throws IOException {
        List<SonarRequest> requests = new ArrayList<>();
        JsonMembers message = in.message(SONARS);
        for (int field = message.next(); field >= 0; field = message.next()) {
            if (field == 0) {
                in.text();
                continue;
            }
            in.list();
            while (in.more(requests.size(), MessageLimits.MAX_LIST_LENGTH)) {
                requests.add(sonar());
            }
        }
        in.end();
        return new SonarRequestBundle(requests);
    }

    private SonarRequest sonar() throws IOException {
        String[] name = {""};
        double[] offset = new double[2];
        Beam[] beam = new Beam[1];
        JsonMembers members = in.object(SONAR);
        for (int field = members.next(); field >= 0; field = members.next()) {
            switch (field) {
                case 0 -> name[0] = in.text();
                case 3 -> beam[0] = beam();
                default -> offset[field - 1] = in.number();
            }
        }
        return in.make(() -> new SonarRequest(name[0], offset[0], offset[1], beam[0]));
    }

    private Beam beam() throws IOException {
        double[] numbers = new double[3];
        JsonMembers members = in.object(BEAM);
        for (int field = members.next(); field >= 0; field = members.next()) {
            numbers[field] = field == 1 && in.isNull() ? Double.POSITIVE_INFINITY : in.number();
        }
        return in.make(() -> new Beam(numbers[0], numbers[1], numbers[2]));
    }

    /** An answer to moves. */
    Reply made() throws IOException {
        List<MoveRequest> moves = new ArrayList<>();
        List<Problem> problems = new ArrayList<>();
        JsonMembers message = in.message(MADE);
        for (int field = message.next(); field >= 0; field = message.next()) {
            switch (field) {
                case 0 -> in.text();
                case 1 -> moves = moveList();
                default -> {
                    in.list();
                    while (in.more(problems.size(), MessageLimits.MAX_LIST_LENGTH)) {
                        problems.add(problem());
                    }
                }
            }
        }
        in.end();
        return new Reply(new MoveBundle(moves), problems);
    }

    Problem problem() throws IOException {
        int index = 0;
        String reason = "";
        JsonMembers members = in.object(REFUSED);
        for (int field = members.next(); field >= 0; field = members.next()) {
            if (field == 0) {
                index = (int) in.whole(0, MessageLimits.MAX_LIST_LENGTH);
            } else {
                reason = in.text();
            }
        }
        return Problem.of(index, reason);
    }

    /** An answer to sonar requests. */
    Reply distances() throws IOException {
        List<Double> distances = new ArrayList<>();
        List<Problem> problems = new ArrayList<>();
        JsonMembers message = in.message(DISTANCES);
        for (int field = message.next(); field >= 0; field = message.next()) {
            if (field == 0) {
                in.text();
                continue;
            }
            in.list();
            while (in.more(distances.size(), MessageLimits.MAX_LIST_LENGTH)) {
                distances.add(distance(distances.size(), problems));
            }
        }
        in.end();
        return in.make(() -> new Reply(new DistanceBundle(distances), problems));
    }

    private double distance(int index, List<Problem> problems) throws IOException {
        if (in.isNull()) {
            return Double.POSITIVE_INFINITY;
        }
        if (!in.isObject()) {
            double distance = in.number();
            if (distance < 0) {
                throw in.refused("a distance must be at least 0 (got: " + distance + ")");
            }
            return distance;
        }
        JsonMembers members = in.object(ERROR);
        for (int field = members.next(); field >= 0; field = members.next()) {
            problems.add(Problem.of(index, in.text()));
        }
        return Double.NaN;
    }
}
