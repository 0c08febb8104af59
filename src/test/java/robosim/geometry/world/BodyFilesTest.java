package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.AckermannDrive;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.Drive;
import robosim.geometry.dynamics.ForceDrive;
import robosim.geometry.dynamics.Motor;
import robosim.geometry.dynamics.OmnidirectionalDrive;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.dynamics.SwerveDrive;
import robosim.geometry.dynamics.VelocityDrive;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;
import robosim.geometry.world.body.ObjectBody;

/** Bodies, surfaces and drives in world files. */
class BodyFilesTest {
    private static final double NONE = Double.POSITIVE_INFINITY;

    private static World read(String objects) throws WorldException {
        String xml =
                "<world xmlns=\"urn:robosim:world:1\" width=\"9\" height=\"9\" length=\"9\">" + objects + "</world>";
        return WorldReader.read(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "test", null);
    }

    private static @Nullable ObjectBody body(String inside) throws WorldException {
        return read("<box name=\"b\" moveable=\"true\" width=\"1\" height=\"1\" length=\"2\" heading=\"30\">" + inside
                        + "</box>")
                .objects()
                .get(0)
                .body();
    }

    private static Drive drive(String attributes) throws WorldException {
        return Objects.requireNonNull(Objects.requireNonNull(body("<body><drive " + attributes + "/></body>"))
                .drive());
    }

    @Test
    void whatIsAttachedIsReadWrittenAndCarried() throws IOException {
        World world = WorldReader.read(Path.of("worlds", "yard.xml"));
        assertThat(world.objects().stream()
                        .filter(each -> each.attached() != null)
                        .map(each -> each.object().name() + " to " + each.attached()))
                .containsExactly("trailer to tractor");
        byte[] written = WorldWriter.toXml(world).getBytes(StandardCharsets.UTF_8);
        assertThat(WorldReader.read(new ByteArrayInputStream(written), "written", null))
                .isEqualTo(world);
        Geometry geometry = world.toGeometry();
        assertThat(geometry.carrierOf("trailer")).isEqualTo("tractor");
        assertThat(geometry.simpleMove("tractor", 6, 0, 0)).isTrue();
        assertThat(geometry.getObject("trailer").center().x()).isEqualTo(0.45, within(1e-12));
        assertThat(geometry.simpleTurn("tractor", 90))
                .as("the trailer hits the gate")
                .isFalse();
        geometry.detach("trailer");
        assertThat(geometry.simpleMove("tractor", 1, 0, 0)).isTrue();
        assertThat(geometry.simpleTurn("tractor", 90)).isTrue();
        assertThat(world.joined()).hasSize(world.objects().size() - 1);
    }

    @Test
    void whatCannotBeAttachedIsRefusedWithItsName() {
        String box = "<box name=\"%s\" moveable=\"true\" attached=\"%s\" width=\"1\" height=\"1\" length=\"2\"/>";
        for (String objects : List.of(
                box.formatted("a", "a"),
                box.formatted("a", "nobody"),
                box.formatted("a", "b") + box.formatted("b", "a"),
                "<box name=\"wall\" width=\"1\" height=\"1\" length=\"2\"/>" + box.formatted("a", "wall"),
                "<box name=\"a\" attached=\"b\" width=\"1\" height=\"1\" length=\"2\"/>"
                        + "<box name=\"b\" moveable=\"true\" width=\"1\" height=\"1\" length=\"2\"/>",
                "<group name=\"g\" moveable=\"true\">" + box.formatted("a", "g") + "</group>")) {
            assertThatThrownBy(() -> read(objects))
                    .as(objects)
                    .isInstanceOf(WorldException.class)
                    .hasMessageContaining("attached");
        }
    }

    @Test
    void aBodyIsReadAsItStands() throws WorldException {
        assertThat(body("")).isNull();
        assertThat(body("<body/>")).isEqualTo(ObjectBody.DEFAULT);
        assertThat(body("<sonar count=\"2\"/><body mass=\"5\" inertia=\"0.5\" restitution=\"0.25\" friction=\"0.5\""
                        + " slidingFriction=\"0.4\" floorFriction=\"0\" damping=\"1\" turnDamping=\"2\" maxSpeed=\"3\""
                        + " maxTurn=\"90\"/>"))
                .isEqualTo(new ObjectBody(5, 0.5, new Surface(0.25, 0.5, 0.4), 0, 1, 2, 3, 90, 0, 0, Set.of(), null));
        assertThat(Objects.requireNonNull(body("<body ignored=\" glass  wall\"/>"))
                        .ignored())
                .containsExactlyInAnyOrder("glass", "wall");
        assertThatThrownBy(() -> new ObjectBody(0, 0, Surface.SMOOTH, 0, 0, 0, NONE, NONE, 0, 0, Set.of("a b"), null))
                .hasMessageContaining("put the object into a layer (got: \"a b\")");
        assertThat(Objects.requireNonNull(body("<body friction=\"0.5\"/>")).surface())
                .isEqualTo(new Surface(0, 0.5, 0.5));
    }

    @Test
    void aDriveIsReadAsItStands() throws WorldException {
        assertThat(drive("kind=\"differential\" base=\"0.4\" maxSpeed=\"1\" maxAcceleration=\"2\""))
                .isEqualTo(new DifferentialDrive(0.4, 1, 2));
        assertThat(drive("kind=\"omnidirectional\" maxTurn=\"90\" maxTurnAcceleration=\"8\""))
                .isEqualTo(new OmnidirectionalDrive(NONE, NONE, 90, 8));
        assertThat(drive("kind=\"ackermann\" base=\"2.5\" maxTurn=\"35\""))
                .isEqualTo(new AckermannDrive(2.5, 35, NONE, NONE));
        assertThat(drive("kind=\"velocity\"")).isEqualTo(new VelocityDrive(new Twist(0, 0, 0, 0)));
        assertThat(drive("kind=\"force\"")).isEqualTo(new ForceDrive(0, 0, 0));
        // As wide, or as long, as the object is, however it is turned.
        assertThat(((DifferentialDrive) drive("kind=\"differential\"")).track())
                .isCloseTo(2, org.assertj.core.data.Offset.offset(1e-12));
        assertThat(((AckermannDrive) drive("kind=\"ackermann\"")).wheelbase())
                .isCloseTo(1, org.assertj.core.data.Offset.offset(1e-12));
    }

    @Test
    void aStaticObjectHasASurfaceAlone() throws WorldException {
        World world = read("<box name=\"w\" width=\"1\" height=\"1\" length=\"1\"><body restitution=\"0.5\"/></box>");
        assertThat(world.objects().get(0).body()).isEqualTo(ObjectBody.of(new Surface(0.5, 0, 0)));
        assertThatThrownBy(() -> read("<box name=\"w\" width=\"1\" height=\"1\" length=\"1\"><body mass=\"5\"/></box>"))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("static object must be its surface alone");
        assertThatThrownBy(() -> read("<box width=\"1\" height=\"1\" length=\"1\"><body/></box>"))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("must have a name");
    }

    private static void refuses(String inside, String words) {
        assertThatThrownBy(() -> body(inside))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining(words);
    }

    @Test
    void whatCannotBeIsRefusedWithTheReason() {
        refuses("<body mass=\"-1\"/>", "mass of <body> must be");
        refuses("<body restitution=\"2\"/>", "restitution must be from 0 to 1 (got: 2.0)");
        refuses("<body slidingFriction=\"2\"/>", "slidingFriction must be at most staticFriction");
        refuses("<body weight=\"2\"/>", "<body> has no attribute weight");
        refuses("<body/><body/>", "<body> is not allowed");
        refuses("<body/><sonar count=\"1\"/>", "<sonar> is not allowed");
        refuses("<drive kind=\"force\"/>", "<drive> is not allowed");
        refuses("<body><drive/></body>", "<drive> needs the attribute kind");
        refuses("<body><drive kind=\"legs\"/></body>", "differential, omnidirectional, ackermann, velocity or force");
        refuses("<body><drive kind=\"force\" base=\"1\"/></body>", "base must be left out for a drive of kind force");
        refuses("<body><drive kind=\"differential\" maxTurn=\"1\"/></body>", "maxTurn must be left out");
        refuses("<body><drive kind=\"differential\" base=\"0\"/></body>", "track must be");
    }

    private static double limit(SplittableRandom random) {
        return random.nextBoolean() ? NONE : random.nextDouble() * 9;
    }

    private static @Nullable Drive drive(SplittableRandom random) {
        return switch (random.nextInt(7)) {
            case 0 -> new DifferentialDrive(0.1 + random.nextDouble(), limit(random), limit(random));
            case 1 -> new OmnidirectionalDrive(limit(random), limit(random), limit(random), limit(random));
            case 2 -> new AckermannDrive(1, random.nextBoolean() ? 60 : 30 * random.nextDouble(), limit(random), 1);
            case 3 -> new VelocityDrive(new Twist(0, 0, 0, 0));
            case 4 -> new ForceDrive(0, 0, 0);
            case 5 ->
                new SwerveDrive(
                        List.of(
                                new SwerveDrive.Module(random.nextDouble(), -random.nextDouble()),
                                new SwerveDrive.Module(0, 0.5)),
                        random.nextBoolean()
                                ? null
                                : new Motor(7, 6000, 366, 6.75, 0.05, limit(random), random.nextInt(2)),
                        random.nextDouble(),
                        limit(random));
            default -> null;
        };
    }

    @Test
    void whatIsWrittenIsReadBack() throws IOException {
        SplittableRandom random = new SplittableRandom(22);
        List<WorldObject> objects = new ArrayList<>();
        for (int k = 0; k < 200; k++) {
            double friction = random.nextBoolean() ? 0 : random.nextDouble();
            Surface surface = new Surface(random.nextBoolean() ? 0 : random.nextDouble(), friction, friction * 0.5);
            BoxObject box = new BoxObject(new Point(), 1, 1, 1);
            boolean isMoveable = random.nextInt(4) > 0;
            objects.add(new WorldObject(
                    isMoveable ? box.moveable("box " + k) : box.named("box " + k),
                    null,
                    List.of(),
                    !isMoveable
                            ? ObjectBody.of(surface)
                            : new ObjectBody(
                                    random.nextInt(3),
                                    random.nextInt(2),
                                    surface,
                                    random.nextBoolean() ? 0.5 : random.nextDouble(),
                                    random.nextInt(2),
                                    random.nextInt(2),
                                    limit(random),
                                    limit(random),
                                    random.nextInt(2),
                                    random.nextInt(2),
                                    random.nextBoolean() ? Set.of() : Set.of("glass", "box" + k),
                                    drive(random))));
        }
        World world = new World(9, 9, 9, objects);
        String xml = WorldWriter.toXml(world);
        assertThat(WorldReader.read(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "written", null))
                .isEqualTo(world);
    }

    @Test
    void theWorldOfPushingHasWhatItSays() throws WorldException {
        World world = WorldReader.read(Path.of("worlds", "pushing.xml"));
        assertThat(world.objects().stream().filter(each -> each.body() != null)).hasSize(7);
        assertThat(world.objects().stream()
                        .filter(each -> each.body() != null && each.body().drive() != null))
                .hasSize(2);
    }
}
