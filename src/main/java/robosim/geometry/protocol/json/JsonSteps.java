package robosim.geometry.protocol.json;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.protocol.motion.StopAnswer;
import robosim.geometry.protocol.motion.SurfaceMixing;
import robosim.geometry.protocol.motion.SurfaceSettings;
import robosim.geometry.protocol.motion.Velocity;

/** Reads steps of bodies, and their answers, from JSON. */
final class JsonSteps {
    private static final Fields STEP = Fields.of("type seconds", "bodies commands mixing");
    private static final Fields MIXING = Fields.of("restitution friction", "");
    private static final Fields BODY = Fields.of(
            "objectName",
            "mass inertia restitution staticFriction slidingFriction damping turnDamping maxSpeed maxTurn~"
                    + " floorFriction drive velocity");
    private static final int MAX_SPEED = BODY.indexOf("maxSpeed");
    private static final int FLOOR = BODY.indexOf("floorFriction");
    private static final int DRIVE = BODY.indexOf("drive");
    private static final Fields DRIVES =
            Fields.of("kind", "base maxSpeed maxAcceleration maxTurn~ maxTurnAcceleration~ centreAhead");
    private static final int CENTRE = DRIVES.indexOf("centreAhead");
    private static final Fields COMMAND = Fields.of("objectName", "forward right turn~");
    private static final Fields VELOCITY = Fields.of("x y z ry", "");
    private static final Fields ANSWER = Fields.of("type bodies contacts stopped refused", "stops");
    private static final Fields PLACED = Fields.of("objectName center heading velocity", "rotation");
    private static final Fields STOP = Fields.of("objectName reason", "other");
    private static final Fields CONTACT = Fields.of("objectName point normal impulse phase", "other fall");

    private final JsonInput in;

    JsonSteps(JsonInput in) {
        this.in = in;
    }

    StepBundle step() throws IOException {
        double[] seconds = new double[1];
        List<BodyRequest> bodies = new ArrayList<>();
        List<DriveCommand> commands = new ArrayList<>();
        @Nullable SurfaceMixing[] mixing = new SurfaceMixing[1];
        var message = in.message(STEP);
        for (int field = message.next(); field >= 0; field = message.next()) {
            switch (field) {
                case 0 -> in.text();
                case 1 -> seconds[0] = in.number();
                case 2 -> items(bodies, this::body);
                case 3 -> items(commands, this::command);
                default -> mixing[0] = mixing();
            }
        }
        in.end();
        return in.make(() -> new StepBundle(seconds[0], bodies, commands, mixing[0]));
    }

    private SurfaceMixing mixing() throws IOException {
        SurfaceMixing.Rule[] rules = new SurfaceMixing.Rule[MIXING.count()];
        var members = in.object(MIXING);
        for (int field = members.next(); field >= 0; field = members.next()) {
            rules[field] = in.constant(SurfaceMixing.Rule.class);
        }
        return in.make(() -> new SurfaceMixing(rules[0], rules[1]));
    }

    private <T> void items(List<T> items, JsonLines.Reading<T> item) throws IOException {
        in.list();
        while (in.more(items.size(), MessageLimits.MAX_LIST_LENGTH)) {
            items.add(item.read());
        }
    }

    private BodyRequest body() throws IOException {
        String[] name = {""};
        double[] numbers = new double[BODY.count()];
        Arrays.fill(numbers, MAX_SPEED, FLOOR, Double.POSITIVE_INFINITY);
        numbers[FLOOR] = BodyRequest.FLOOR_FRICTION;
        @Nullable DriveSettings[] drive = new DriveSettings[1];
        @Nullable Velocity[] velocity = new Velocity[1];
        var members = in.object(BODY);
        for (int field = members.next(); field >= 0; field = members.next()) {
            if (field == 0) {
                name[0] = in.text();
            } else if (field < DRIVE) {
                numbers[field] = in.number();
            } else if (field == DRIVE) {
                drive[0] = drive();
            } else {
                velocity[0] = velocity();
            }
        }
        return in.make(() -> new BodyRequest(
                name[0],
                numbers[1],
                numbers[2],
                new SurfaceSettings(numbers[3], numbers[4], numbers[5]),
                numbers[6],
                numbers[7],
                numbers[8],
                numbers[9],
                numbers[FLOOR],
                drive[0],
                velocity[0]));
    }

    private DriveSettings drive() throws IOException {
        DriveSettings.Kind[] kind = {DriveSettings.Kind.DIFFERENTIAL};
        double[] numbers = new double[DRIVES.count()];
        Arrays.fill(numbers, 2, CENTRE, Double.POSITIVE_INFINITY);
        var members = in.object(DRIVES);
        for (int field = members.next(); field >= 0; field = members.next()) {
            if (field == 0) {
                kind[0] = kind();
            } else {
                numbers[field] = in.number();
            }
        }
        return in.make(() -> new DriveSettings(
                kind[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5], numbers[CENTRE]));
    }

    /** A kind in capitals, or in small letters as in a world file. */
    private DriveSettings.Kind kind() throws IOException {
        String text = in.text();
        for (DriveSettings.Kind kind : DriveSettings.Kind.values()) {
            if (kind.name().toLowerCase(Locale.ROOT).equals(text)) {
                return kind;
            }
        }
        return in.constant(DriveSettings.Kind.class);
    }

    private DriveCommand command() throws IOException {
        String[] name = {""};
        double[] numbers = new double[COMMAND.count()];
        var members = in.object(COMMAND);
        for (int field = members.next(); field >= 0; field = members.next()) {
            if (field == 0) {
                name[0] = in.text();
            } else {
                numbers[field] = in.number();
            }
        }
        return in.make(() -> new DriveCommand(name[0], numbers[1], numbers[2], numbers[3]));
    }

    private Velocity velocity() throws IOException {
        double[] numbers = new double[VELOCITY.count()];
        var members = in.object(VELOCITY);
        for (int field = members.next(); field >= 0; field = members.next()) {
            numbers[field] = in.number();
        }
        return in.make(() -> new Velocity(numbers[0], numbers[1], numbers[2], numbers[3]));
    }

    Reply answer() throws IOException {
        List<BodyAnswer> bodies = new ArrayList<>();
        List<ContactAnswer> contacts = new ArrayList<>();
        List<String> stopped = new ArrayList<>();
        List<StopAnswer> stops = new ArrayList<>();
        List<Problem> problems = new ArrayList<>();
        JsonMessages messages = new JsonMessages(in);
        var message = in.message(ANSWER);
        for (int field = message.next(); field >= 0; field = message.next()) {
            switch (field) {
                case 0 -> in.text();
                case 1 -> items(bodies, this::placed);
                case 2 -> items(contacts, this::contact);
                case 3 -> items(stopped, in::text);
                case 4 -> items(problems, messages::problem);
                default -> items(stops, this::stop);
            }
        }
        in.end();
        return in.make(() -> new Reply(new StepBundle.Answer(bodies, contacts, stopped, stops), problems));
    }

    private StopAnswer stop() throws IOException {
        String[] name = {""};
        StopAnswer.Reason[] reason = {StopAnswer.Reason.BLOCKED};
        @Nullable String[] other = new String[1];
        var members = in.object(STOP);
        for (int field = members.next(); field >= 0; field = members.next()) {
            switch (field) {
                case 0 -> name[0] = in.text();
                case 1 -> reason[0] = in.constant(StopAnswer.Reason.class);
                default -> other[0] = in.text();
            }
        }
        return in.make(() -> new StopAnswer(name[0], reason[0], other[0]));
    }

    private BodyAnswer placed() throws IOException {
        String[] name = {""};
        Point[] center = {new Point()};
        double[] heading = new double[1];
        Velocity[] velocity = {new Velocity(0, 0, 0, 0)};
        Numbers[] rotation = {Numbers.NONE};
        var members = in.object(PLACED);
        for (int field = members.next(); field >= 0; field = members.next()) {
            switch (field) {
                case 0 -> name[0] = in.text();
                case 1 -> center[0] = point();
                case 2 -> heading[0] = in.number();
                case 3 -> velocity[0] = velocity();
                default -> rotation[0] = new Numbers(in.numbers(9));
            }
        }
        return in.make(() -> new BodyAnswer(name[0], center[0], heading[0], rotation[0], velocity[0]));
    }

    private Point point() throws IOException {
        double[] at = in.numbers(3);
        return in.make(() -> new Point(at[0], at[1], at[2]));
    }

    private ContactAnswer contact() throws IOException {
        String[] name = {""};
        Point[] point = {new Point()};
        Point[] normal = {new Point()};
        double[] impulse = new double[1];
        double[] fall = new double[1];
        ContactAnswer.Phase[] phase = {ContactAnswer.Phase.BEGIN};
        @Nullable String[] other = new String[1];
        var members = in.object(CONTACT);
        for (int field = members.next(); field >= 0; field = members.next()) {
            switch (field) {
                case 0 -> name[0] = in.text();
                case 1 -> point[0] = point();
                case 2 -> normal[0] = point();
                case 3 -> impulse[0] = in.number();
                case 4 -> phase[0] = in.constant(ContactAnswer.Phase.class);
                case 5 -> other[0] = in.text();
                default -> fall[0] = in.number();
            }
        }
        return in.make(() -> new ContactAnswer(name[0], other[0], point[0], normal[0], impulse[0], phase[0], fall[0]));
    }
}
