package robosim.geometry.protocol.json;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.material.Color;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.FreeEdgesRequest;
import robosim.geometry.protocol.batch.FreePosesRequest;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.PictureRequest;
import robosim.geometry.protocol.batch.ScanMotion;
import robosim.geometry.protocol.batch.SceneLight;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.batch.WorldRequest;

/** Reads requests with packed numbers from JSON. */
final class JsonBatches {
    private static final Fields BATCH = Fields.of("type requests", "");
    private static final Fields REQUEST = Fields.of(
            "kind",
            "objectName mount pattern min max width seesCarrier normals poses edges objects motion samples mirrors"
                    + " light center heading~ object overlapping x y z rx~ ry~ clearance bends identify first count"
                    + " stepHeight maxSlope~ snap rep117");
    private static final JsonKinds REQUESTS = new JsonKinds(
            REQUEST,
            new String[] {"sense", "pattern", "objectName mount min max width seesCarrier normals objects motion rep117"
            },
            new String[] {"poses", "objectName poses", ""},
            new String[] {"edges", "objectName edges", ""},
            new String[] {"picture", "pattern", "objectName mount samples mirrors seesCarrier light"},
            new String[] {"world", "", ""},
            new String[] {"pose", "objectName", ""},
            new String[] {"place", "objectName center", "heading identify"},
            new String[] {"add", "object", "overlapping identify"},
            new String[] {"remove", "objectName", ""},
            new String[] {"move", "objectName", "x y z rx ry identify"},
            new String[] {"moveToContact", "objectName", "x y z rx ry clearance"},
            new String[] {"moveAndSlide", "objectName", "x y z rx ry clearance bends stepHeight maxSlope snap"},
            new String[] {"list", "", "first count"},
            new String[] {"separate", "objectName max", ""});
    private static final Fields MOTION = Fields.of("duration", "x y z ry~");
    private static final Fields LIGHT = Fields.of("zenith horizon ground strength", "sources");
    private static final Fields SOURCE = Fields.of("kind strength", "color direction place angle");
    private static final JsonKinds SOURCES = new JsonKinds(
            SOURCE, new String[] {"sun", "direction", "color"}, new String[] {"lamp", "place", "color"}, new String[] {
                "spot", "place direction angle", "color"
            });
    private static final Fields MOUNT = Fields.of("place", "rotation heading~");
    private static final Fields PATTERN =
            Fields.of("kind", "first step count elevations width height fieldOfView directions");
    private static final JsonKinds PATTERNS = new JsonKinds(
            PATTERN,
            new String[] {"fan", "first step count", ""},
            new String[] {"layers", "elevations first step count", ""},
            new String[] {"pinhole", "width height fieldOfView", ""},
            new String[] {"directions", "directions", ""});

    private static final int OVERLAPPING = 19;
    private static final int BENDS = OVERLAPPING + 7;

    private final JsonInput in;
    private final JsonMaterials colors;
    private final JsonObjects objects;

    JsonBatches(JsonInput in) {
        this.in = in;
        colors = new JsonMaterials(in);
        objects = new JsonObjects(in);
    }

    BatchRequestBundle batch() throws IOException {
        List<BatchRequest> requests = new ArrayList<>();
        var message = in.message(BATCH);
        for (int field = message.next(); field >= 0; field = message.next()) {
            if (field == 0) {
                in.text();
                continue;
            }
            in.list();
            while (in.more(requests.size(), MessageLimits.MAX_LIST_LENGTH)) {
                requests.add(request());
            }
        }
        in.end();
        return in.make(() -> new BatchRequestBundle(requests));
    }

    /** The fields of a request, as far as they are read. */
    private static final class Draft {
        private int kind;
        private String name = "";
        private Mount mount = Mount.CENTER;
        private BeamPattern pattern = new BeamPattern.Fan(0, 0, 1);
        private double min;
        private double max = Double.POSITIVE_INFINITY;
        private double width;
        private boolean seesCarrier;
        private boolean normals;
        private boolean objects;
        private boolean rep117;
        private ScanMotion motion = ScanMotion.NONE;
        private Numbers places = Numbers.NONE;
        private Point center = new Point();
        private double heading;
        private @Nullable GeometryObject object;
        private boolean overlapping;
        private final double[] move = new double[6]; // and the clearance
        private int bends = WorldRequest.GoAndSlide.USUAL_BENDS;
        private boolean identify;
        private final double[] walk = {0, Math.PI / 2, 0};
        private long first;
        private int count = WorldRequest.ListObjects.USUAL_LISTED;
        private int samples = 1;
        private int mirrors = PictureRequest.USUAL_MIRRORS;
        private @Nullable SceneLight light;

        private BeamPattern.Pinhole camera() {
            if (pattern instanceof BeamPattern.Pinhole camera) {
                return camera;
            }
            throw new IllegalArgumentException("pattern of a picture must be of kind \"pinhole\" (got: another)");
        }

        private WorldRequest.@Nullable Walk walk() {
            WorldRequest.Walk made = new WorldRequest.Walk(walk[0], walk[1], walk[2]);
            return made.equals(WorldRequest.Walk.NONE) ? null : made;
        }

        private BatchRequest make() {
            BatchRequest plain = plain();
            return identify ? new WorldRequest.Identify((WorldRequest) plain) : plain;
        }

        private BatchRequest plain() {
            return switch (kind) {
                case 0 ->
                    new SenseRequest(
                            name, mount, pattern, min, max, width, seesCarrier, normals, objects, motion, rep117);
                case 1 -> new FreePosesRequest(name, places);
                case 2 -> new FreeEdgesRequest(name, places);
                case 3 -> new PictureRequest(name, mount, camera(), samples, mirrors, seesCarrier, light);
                case 4 -> new WorldRequest.Describe();
                case 5 -> new WorldRequest.Locate(name);
                case 6 -> new WorldRequest.Place(name, center, heading);
                case 7 -> new WorldRequest.Add(Checks.present("object", object), overlapping);
                case 8 -> new WorldRequest.Remove(name);
                case 9 -> new WorldRequest.Go(name, move[0], move[1], move[2], move[3], move[4]);
                case 10 -> new WorldRequest.GoToContact(name, move[0], move[1], move[2], move[3], move[4], move[5]);
                case 11 ->
                    new WorldRequest.GoAndSlide(
                            name, move[0], move[1], move[2], move[3], move[4], move[5], bends, walk());
                case 12 -> new WorldRequest.ListObjects(first, count);
                default -> new WorldRequest.Separate(name, max);
            };
        }
    }

    private SceneLight light() throws IOException {
        Color[] sky = {Color.BLACK, Color.BLACK, Color.BLACK};
        double[] strength = new double[1];
        List<SceneLight.Source> sources = new ArrayList<>();
        var members = in.object(LIGHT);
        for (int field = members.next(); field >= 0; field = members.next()) {
            switch (field) {
                case 0, 1, 2 -> sky[field] = colors.color();
                case 3 -> strength[0] = in.number();
                default -> {
                    in.list();
                    while (in.more(sources.size(), SceneLight.MOST_SOURCES)) {
                        sources.add(source());
                    }
                }
            }
        }
        return in.make(() -> new SceneLight(sky[0], sky[1], sky[2], strength[0], sources));
    }

    private SceneLight.Source source() throws IOException {
        int kind = 0;
        double[] numbers = new double[SOURCE.count()];
        Color[] color = {Color.WHITE};
        double[][] points = {new double[3], new double[3]};
        var members = in.object(SOURCE);
        for (int field = members.next(); field >= 0; field = members.next()) {
            switch (field) {
                case 0 -> kind = SOURCES.read(in);
                case 2 -> color[0] = colors.color();
                case 3, 4 -> points[field - 3] = in.numbers(3);
                default -> numbers[field] = in.number();
            }
        }
        SOURCES.check(in, kind, members::has);
        int made = kind;
        return in.make(() -> {
            Point direction = new Point(points[0][0], points[0][1], points[0][2]);
            Point place = new Point(points[1][0], points[1][1], points[1][2]);
            return switch (made) {
                case 0 -> new SceneLight.Sun(direction, color[0], numbers[1]);
                case 1 -> new SceneLight.Lamp(place, color[0], numbers[1]);
                default -> new SceneLight.Spot(place, direction, numbers[5], color[0], numbers[1]);
            };
        });
    }

    private BatchRequest request() throws IOException {
        Draft draft = new Draft();
        var members = in.object(REQUEST);
        for (int field = members.next(); field >= 0; field = members.next()) {
            switch (field) {
                case 0 -> draft.kind = REQUESTS.read(in);
                case 1 -> draft.name = in.text();
                case 2 -> draft.mount = mount();
                case 3 -> draft.pattern = pattern();
                case 4 -> draft.min = in.number();
                case 5 -> draft.max = in.isNull() ? Double.POSITIVE_INFINITY : in.number();
                case 6 -> draft.width = in.number();
                case 7 -> draft.seesCarrier = in.flag();
                case 8 -> draft.normals = in.flag();
                case 9 -> draft.places = packed(FreePosesRequest.STRIDE, MessageLimits.MAX_POSES);
                case 10 -> draft.places = packed(FreeEdgesRequest.STRIDE, MessageLimits.MAX_POSES);
                case 11 -> draft.objects = in.flag();
                case 12 -> draft.motion = motion();
                case 13 -> draft.samples = (int) in.whole(1, PictureRequest.MOST_SAMPLES);
                case 14 -> draft.mirrors = (int) in.whole(0, PictureRequest.MOST_MIRRORS);
                case 15 -> draft.light = light();
                case 16 -> draft.center = objects.point();
                case 17 -> draft.heading = JsonObjects.heading(in);
                case 18 -> draft.object = objects.one();
                case OVERLAPPING -> draft.overlapping = in.flag();
                case BENDS -> draft.bends = (int) in.whole(0, WorldRequest.GoAndSlide.MOST_BENDS);
                case BENDS + 1 -> draft.identify = in.flag();
                case BENDS + 2 -> draft.first = in.whole(0, JsonInput.MAX_ID);
                case BENDS + 3 -> draft.count = (int) in.whole(1, WorldRequest.ListObjects.MOST_LISTED);
                case BENDS + 4, BENDS + 5, BENDS + 6 -> draft.walk[field - BENDS - 4] = in.number();
                case BENDS + 7 -> draft.rep117 = in.flag();
                default -> draft.move[field - OVERLAPPING - 1] = in.number();
            }
        }
        REQUESTS.check(in, draft.kind, members::has);
        return in.make(draft::make);
    }

    private Numbers packed(int stride, int most) throws IOException {
        return PackedNumbers.numbers(in.base64(stride * Double.BYTES, most));
    }

    private ScanMotion motion() throws IOException {
        double[] numbers = new double[MOTION.count()];
        var members = in.object(MOTION);
        for (int field = members.next(); field >= 0; field = members.next()) {
            numbers[field] = in.number();
        }
        return in.make(() -> new ScanMotion(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]));
    }

    private Mount mount() throws IOException {
        double[] place = new double[3];
        Numbers[] rotation = {Mount.CENTER.rotation()};
        var members = in.object(MOUNT);
        for (int field = members.next(); field >= 0; field = members.next()) {
            switch (field) {
                case 0 -> place = in.numbers(3);
                case 1 -> rotation[0] = new Numbers(in.numbers(9));
                default -> {
                    Pose facing = Pose.of(new Point(), Degrees.toDegrees(JsonObjects.heading(in)));
                    rotation[0] = new Numbers(facing.rotation());
                }
            }
        }
        if (members.has(1) && members.has(2)) {
            throw in.refused("heading and rotation must not both be given (got: both)");
        }
        double[] at = place;
        return in.make(() -> new Mount(new Point(at[0], at[1], at[2]), rotation[0]));
    }

    private BeamPattern pattern() throws IOException {
        int kind = 0;
        double[] numbers = new double[PATTERN.count()];
        Numbers[] many = {Numbers.NONE};
        var members = in.object(PATTERN);
        for (int field = members.next(); field >= 0; field = members.next()) {
            switch (field) {
                case 0 -> kind = PATTERNS.read(in);
                case 4 -> many[0] = elevations();
                case 8 -> many[0] = packed(3, MessageLimits.MAX_BEAMS);
                case 1, 2, 7 -> numbers[field] = in.number();
                default -> numbers[field] = in.whole(1, RayPattern.MAX_SIZE);
            }
        }
        PATTERNS.check(in, kind, members::has);
        int made = kind;
        return in.make(() -> switch (made) {
            case 0 -> new BeamPattern.Fan(numbers[1], numbers[2], (int) numbers[3]);
            case 1 -> new BeamPattern.Layers(many[0], numbers[1], numbers[2], (int) numbers[3]);
            case 2 -> new BeamPattern.Pinhole((int) numbers[5], (int) numbers[6], numbers[7]);
            default -> new BeamPattern.Directions(many[0]);
        });
    }

    private Numbers elevations() throws IOException {
        List<Double> elevations = new ArrayList<>();
        in.list();
        while (in.more(elevations.size(), MessageLimits.MAX_BEAMS)) {
            elevations.add(in.number());
        }
        return new Numbers(elevations.stream().mapToDouble(Double::doubleValue).toArray());
    }
}
