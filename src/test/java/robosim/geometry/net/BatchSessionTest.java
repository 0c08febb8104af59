package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Avoidance;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.collision.SignedDistance;
import robosim.geometry.exact.Degrees;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.BatchSamples;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.FreeAnswer;
import robosim.geometry.protocol.batch.FreeEdgesRequest;
import robosim.geometry.protocol.batch.FreePosesRequest;
import robosim.geometry.protocol.batch.MeasureRequest;
import robosim.geometry.protocol.batch.MeasureRequest.Question;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.NoAnswer;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.ScanMotion;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.SenseRequest;

/** A session's answers to batches have the bits of the single calls. */
class BatchSessionTest {
    private static final double INFINITY = Double.POSITIVE_INFINITY;
    private static final Mount MAST = new Mount(
            new Point(0.1, 0.7, -0.05),
            new Numbers(
                    new BoxObject(new Point(), 1, 1, 1).turned(10, 35).pose().rotation()));

    private final Session session = new Session();

    private static List<GeometryObject> scene(SplittableRandom random) {
        List<GeometryObject> objects = new ArrayList<>();
        for (int k = 0; k < 60; k++) {
            Point at =
                    new Point(20 * random.nextDouble() - 10, random.nextDouble() - 0.5, 20 * random.nextDouble() - 10);
            double size = 0.2 + random.nextDouble();
            objects.add(
                    switch (k % 3) {
                        case 0 -> new BoxObject(at, size, 2, 0.5).turned(0, 360 * random.nextDouble());
                        case 1 -> new CylinderObject(at, size / 2, 2);
                        default -> new SphereObject(at, size / 2);
                    });
        }
        objects.add(new CylinderObject(new Point(0.5, 0, 0.25), 0.2, 1)
                .turned(0, 33)
                .moveable("robot"));
        objects.add(new BoxObject(new Point(-3, 0, 2), 0.5, 1, 0.3).moveable("cart"));
        objects.add(new BoxObject(new Point(9, 0, 9), 1, 1, 1).named("wall"));
        return objects;
    }

    private Geometry init(Dimension dimension) {
        WorldSettings settings = new WorldSettings(40, 20, 40, dimension, Accuracy.EXACT);
        session.reply(new InitBundle(scene(new SplittableRandom(7)), settings));
        return Objects.requireNonNull(session.world());
    }

    private List<BatchAnswer> ask(BatchRequest... requests) {
        Reply reply = Objects.requireNonNull(session.reply(new BatchRequestBundle(List.of(requests))));
        return ((BatchAnswerBundle) reply.bundle()).answers();
    }

    private static SenseRequest sense(Mount mount, BeamPattern pattern, double width, boolean seen, boolean normals) {
        return new SenseRequest(
                "robot", mount, pattern, 0.3, 12, width, seen, normals, false, ScanMotion.NONE, false, List.of());
    }

    /** What is nearer than the blind range is marked, and what echoes there or beyond has the same bits as ever. */
    @Test
    void anEchoBeforeTheRangeIsMarkedWhereThatIsAskedFor() {
        for (Dimension dimension : Dimension.values()) {
            init(dimension);
            BeamPattern fan = new BeamPattern.Fan(0, 0.01, 629);
            int near = 0;
            int far = 0;
            for (double width : new double[] {0, 0.2}) {
                SenseAnswer all = (SenseAnswer) ask(range(fan, 0, width)).get(0);
                double min = all.distances().values()[0];
                SenseRequest clamped = range(fan, min, width);
                SenseAnswer marked = (SenseAnswer) ask(clamped.asRep117()).get(0);
                SenseAnswer usual = (SenseAnswer) ask(clamped).get(0);
                assertThat(marked.fits(clamped.asRep117())).isTrue();
                assertThat(usual.fits(clamped)).isTrue();
                assertThat(marked.fits(clamped)).isFalse();
                for (int k = 0; k < fan.size(); k++) {
                    boolean isNear = all.distances().get(k) < min;
                    double expected = isNear
                            ? Double.NEGATIVE_INFINITY
                            : usual.distances().get(k);
                    assertThat(marked.distances().get(k)).as("beam " + k).isEqualTo(expected);
                    near += isNear ? 1 : 0;
                    far += isNear ? 0 : 1;
                }
            }
            assertThat(near).isPositive();
            assertThat(far).isPositive();
        }
    }

    private static SenseRequest range(BeamPattern pattern, double min, double width) {
        return new SenseRequest(
                "robot", Mount.CENTER, pattern, min, 12, width, false, false, false, ScanMotion.NONE, false, List.of());
    }

    private static void same(SenseAnswer answer, Geometry world, SenseRequest request, RayPattern pattern) {
        SenseBuffer seen = request.normals() ? new SenseBuffer(SenseBuffer.Extra.NORMALS) : new SenseBuffer();
        SenseOptions options = SenseOptions.range(request.min(), request.max())
                .withWidth(Degrees.toDegrees(request.width()))
                .withCarrier(request.seesCarrier() ? SenseOptions.Carrier.SEEN : SenseOptions.Carrier.IGNORED);
        world.sense(request.objectName(), request.mount().pose(), pattern, options, seen);
        assertThat(answer.distances().size()).isEqualTo(pattern.size());
        assertThat(answer.normals().size()).isEqualTo(request.normals() ? 3 * pattern.size() : 0);
        int echoes = 0;
        for (int k = 0; k < pattern.size(); k++) {
            assertThat(answer.distances().get(k)).as("%s beam %d", request, k).isEqualTo(seen.distance(k));
            echoes += answer.distances().get(k) < INFINITY ? 1 : 0;
            if (request.normals()) {
                assertThat(answer.normals().get(3 * k)).isEqualTo(seen.normalX(k));
                assertThat(answer.normals().get(3 * k + 1)).isEqualTo(seen.normalY(k));
                assertThat(answer.normals().get(3 * k + 2)).isEqualTo(seen.normalZ(k));
            }
        }
        if (!request.seesCarrier()) { // a sensor within its carrier sees nothing else
            assertThat(echoes).isBetween(pattern.size() / 30, pattern.size() * 99 / 100);
        }
    }

    /** Objects that a sensor or a measurement leaves out, by name and by layer. */
    @Test
    void whatIsIgnored() {
        List<GeometryObject> scene = new ArrayList<>(scene(new SplittableRandom(7)));
        for (int k = 0; k < 60; k++) {
            scene.set(k, k % 3 == 0 ? scene.get(k).withLayers(Set.of("glass")) : scene.get(k));
        }
        session.reply(new InitBundle(scene, new WorldSettings(40, 20, 40, Dimension.SPATIAL, Accuracy.EXACT)));
        Geometry less = new Geometry(40, 20, 40);
        scene.stream().filter(each -> each.layers().isEmpty()).forEach(less::addObjectUnchecked);
        SenseRequest plain = new SenseRequest("robot", new BeamPattern.Fan(0, 0.02, 314));
        SenseAnswer all = (SenseAnswer) ask(plain).get(0);
        SenseAnswer some = (SenseAnswer) ask(plain.ignoring(List.of("glass"))).get(0);
        SenseBuffer seen = new SenseBuffer();
        less.sense(
                "robot",
                Pose.ORIGIN,
                RayPattern.fan(0, Degrees.toDegrees(0.02), 314),
                SenseOptions.range(0, INFINITY),
                seen);
        assertThat(some.distances())
                .isEqualTo(new Numbers(seen.distances().clone()))
                .isNotEqualTo(all.distances());
        assertThat(ask(plain.ignoring(List.of("fog"))).get(0)).isInstanceOf(NoAnswer.class);
        assertThatIllegalArgumentException().isThrownBy(() -> plain.ignoring(List.of("glass", "glass")));
    }

    /** Objects, labels and a scan from a moving robot, as the geometry has them. */
    @Test
    void framesHaveTheBitsOfGeometry() {
        List<GeometryObject> scene = scene(new SplittableRandom(7));
        Material green = Material.of(Color.parse("#00ff00"));
        for (int k = 0; k < 60; k++) {
            scene.set(k, scene.get(k).withMaterial(green.withLabel(k % 5)));
        }
        scene.add(new ObjectGroup(List.of(
                        new BoxObject(new Point(), 1, 3, 1).withMaterial(green.withLabel(7)),
                        new SphereObject(new Point(0, 0, 1), 0.7)))
                .withMaterial(green.withLabel(8))
                .movedTo(new Point(1.5, 0, 2))
                .named("statue"));
        session.reply(new InitBundle(scene, new WorldSettings(40, 20, 40, Dimension.SPATIAL, Accuracy.EXACT)));
        Geometry world = Objects.requireNonNull(session.world());
        ScanMotion motion = new ScanMotion(0.5, 2, 0, 0.5, Math.PI / 2);
        RayPattern camera = RayPattern.pinhole(40, 30, 90);
        int[] labels = new int[9];
        for (boolean normals : new boolean[] {false, true}) {
            for (ScanMotion moving : new ScanMotion[] {ScanMotion.NONE, motion}) {
                for (int turn = 0; turn < 4; turn++) {
                    Numbers rotation =
                            new Numbers(Pose.of(new Point(), 90 * turn).rotation());
                    SenseRequest request = new SenseRequest(
                            "robot",
                            new Mount(new Point(0, 0.2, 0), rotation),
                            new BeamPattern.Pinhole(40, 30, Math.PI / 2),
                            0,
                            15,
                            0,
                            false,
                            normals,
                            true,
                            moving,
                            false,
                            List.of());
                    SenseAnswer answer = (SenseAnswer) ask(request).get(0);
                    assertThat(answer.fits(request)).isTrue();
                    SenseBuffer seen = new SenseBuffer(
                            SenseBuffer.Extra.OBJECTS, SenseBuffer.Extra.PARTS, SenseBuffer.Extra.NORMALS);
                    SenseOptions options = SenseOptions.range(0, 15);
                    boolean isStill = moving.equals(ScanMotion.NONE);
                    world.sense(
                            "robot",
                            request.mount().pose(),
                            isStill ? camera : camera.withDuration(0.5),
                            isStill ? options : options.withMotion(new Twist(2, 0, 0.5, 90)),
                            seen);
                    for (int k = 0; k < camera.size(); k++) {
                        assertThat(answer.distances().get(k)).isEqualTo(seen.distance(k));
                        assertThat(!normals || answer.normals().get(3 * k + 2) == seen.normalZ(k))
                                .isTrue();
                        GeometryObject object = seen.object(k);
                        int index = answer.objects().get(k);
                        assertThat(index < 0 ? null : answer.names().get(index))
                                .isEqualTo(object == null ? null : object.name() == null ? "" : object.name());
                        boolean isStatue = object instanceof ObjectGroup;
                        int label = object == null
                                ? 0
                                : isStatue
                                        ? seen.part(k) == 0 ? 7 : 8
                                        : object.material().label();
                        assertThat(answer.labels().get(k)).isEqualTo(label);
                        labels[label]++;
                    }
                    assertThat(answer.names().stream().filter(String::isEmpty)).hasSizeGreaterThan(2);
                }
            }
        }
        labels[5] = labels[6] = 99; // nothing has these
        assertThat(Arrays.stream(labels).min().getAsInt())
                .as(Arrays.toString(labels))
                .isGreaterThan(20);
    }

    /** A sensor that stands in the world, and one that moves through it. */
    @Test
    void sensorsThatNothingCarriesHaveTheBitsOfGeometry() {
        Geometry world = init(Dimension.SPATIAL);
        Mount tower = new Mount(
                new Point(0.5, 0.3, 1), new Numbers(Pose.of(new Point(), 35).rotation()));
        RayPattern fan = RayPattern.fan(0, Degrees.toDegrees(0.01), 600);
        int robots = 0;
        for (ScanMotion moving : new ScanMotion[] {ScanMotion.NONE, new ScanMotion(0.5, 2, 0, 0.5, Math.PI / 2)}) {
            boolean isStill = moving.equals(ScanMotion.NONE);
            SenseRequest request = new SenseRequest(
                    "",
                    tower,
                    new BeamPattern.Fan(0, 0.01, 600),
                    0,
                    15,
                    0,
                    false,
                    true,
                    true,
                    moving,
                    false,
                    List.of());
            SenseAnswer answer = (SenseAnswer) ask(request).get(0);
            SenseBuffer seen =
                    new SenseBuffer(SenseBuffer.Extra.OBJECTS, SenseBuffer.Extra.PARTS, SenseBuffer.Extra.NORMALS);
            SenseOptions options = SenseOptions.range(0, 15);
            world.sense(
                    tower.pose(),
                    isStill ? fan : fan.withDuration(0.5),
                    isStill ? options : options.withMotion(new Twist(2, 0, 0.5, 90)),
                    seen);
            int echoes = 0;
            for (int k = 0; k < fan.size(); k++) {
                assertThat(answer.distances().get(k)).as(moving + " beam " + k).isEqualTo(seen.distance(k));
                assertThat(answer.normals().get(3 * k)).isEqualTo(seen.normalX(k));
                GeometryObject object = seen.object(k);
                int index = answer.objects().get(k);
                assertThat(index < 0).isEqualTo(object == null);
                echoes += index < 0 ? 0 : 1;
            }
            assertThat(echoes).isBetween(60, 590);
            robots += answer.names().contains("robot") ? 1 : 0;
        }
        assertThat(robots).as("a fixed sensor sees robots too").isPositive();
        Session empty = new Session();
        Reply none = Objects.requireNonNull(empty.reply(new BatchRequestBundle(List.of(new SenseRequest(
                "",
                tower,
                new BeamPattern.Fan(0, 0, 1),
                0,
                1,
                0,
                false,
                false,
                false,
                ScanMotion.NONE,
                false,
                List.of())))));
        assertThat(none.problems()).extracting(Object::toString).containsExactly("0: there is no world yet");
    }

    @Test
    void patternsHaveTheBitsOfGeometry() {
        Geometry world = init(Dimension.SPATIAL);
        double quarter = Math.toRadians(0.25);
        BeamPattern fan = new BeamPattern.Fan(-3 * Math.PI / 4, quarter, 1081);
        RayPattern fanned = RayPattern.fan(-135, Degrees.toDegrees(quarter), 1081);
        BeamPattern layers = new BeamPattern.Layers(Numbers.of(-0.2, 0, 0.1), Math.PI, -0.05, 126);
        double down = Degrees.toDegrees(-0.2);
        double up = Degrees.toDegrees(0.1);
        RayPattern layered = RayPattern.layers(new double[] {down, 0, up}, 180, Degrees.toDegrees(-0.05), 126);
        BeamPattern camera = new BeamPattern.Pinhole(33, 21, Math.PI / 2);
        RayPattern image = RayPattern.pinhole(33, 21, 90);
        double[] directions = new SplittableRandom(5).doubles(300, -1, 1).toArray();
        BeamPattern any = new BeamPattern.Directions(new Numbers(directions));
        RayPattern anyway = RayPattern.of(directions);
        Object[][] patterns = {{fan, fanned}, {layers, layered}, {camera, image}, {any, anyway}};
        for (Object[] pair : patterns) {
            BeamPattern pattern = (BeamPattern) pair[0];
            RayPattern rays = (RayPattern) pair[1];
            for (SenseRequest request : List.of(
                    sense(Mount.CENTER, pattern, 0, false, false),
                    sense(MAST, pattern, 0, false, true),
                    sense(MAST, pattern, 0.1, false, false),
                    sense(new Mount(new Point(0.3, 0, 0)), pattern, 0, true, false))) {
                same((SenseAnswer) ask(request).get(0), world, request, rays);
            }
        }
    }

    @Test
    void aPatternsBeamsAreSonars() {
        for (Dimension dimension : Dimension.values()) {
            init(dimension);
            RayPattern fan = RayPattern.fan(-180, 2.25, 160);
            for (double width : new double[] {0, Math.toRadians(15)}) {
                List<SonarRequest> sonars = new ArrayList<>();
                for (int k = 0; k < fan.size(); k++) {
                    sonars.add(new SonarRequest("cart", fan.x(k), fan.z(k), new Beam(0.1, 9, width)));
                }
                Reply told = Objects.requireNonNull(session.reply(new SonarRequestBundle(sonars)));
                double[] singles = ((DistanceBundle) told.bundle())
                        .distances().stream().mapToDouble(Double::doubleValue).toArray();
                // The nearest double to each angle in radians becomes the double of degrees again.
                BeamPattern pattern = new BeamPattern.Fan(-Math.PI, Degrees.toRadians(2.25), 160);
                assertThat(Degrees.toDegrees(Degrees.toRadians(2.25))).isEqualTo(2.25);
                SenseAnswer all = (SenseAnswer) ask(new SenseRequest(
                                "cart",
                                Mount.CENTER,
                                pattern,
                                0.1,
                                9,
                                width,
                                false,
                                false,
                                false,
                                ScanMotion.NONE,
                                false,
                                List.of()))
                        .get(0);
                assertThat(all.distances()).isEqualTo(new Numbers(singles));
                assertThat(singles).contains(INFINITY);
                assertThat(Arrays.stream(singles)
                                .filter(distance -> distance < 9)
                                .count())
                        .isGreaterThan(20);
            }
        }
    }

    @Test
    void posesAndEdgesHaveTheBitsOfGeometry() {
        for (Dimension dimension : Dimension.values()) {
            Geometry world = init(dimension);
            SplittableRandom random = new SplittableRandom(11);
            for (int count : new int[] {0, 1, 63, 64, 65, 500}) {
                double[] poses = new double[4 * count];
                double[] edges = new double[8 * count];
                place(random, poses, 1);
                place(random, edges, 1);
                for (int k = 0; k < count; k++) { // short ways, level, and a quarter turn
                    edges[8 * k + 4] = edges[8 * k] + random.nextDouble() - 0.5;
                    edges[8 * k + 5] = edges[8 * k + 1];
                    edges[8 * k + 6] = edges[8 * k + 2];
                    edges[8 * k + 7] = edges[8 * k + 3] + (k % 2 == 0 ? 0 : Math.PI / 2);
                }
                FreePosesRequest asked = new FreePosesRequest("cart", new Numbers(poses));
                FreeEdgesRequest moved = new FreeEdgesRequest("cart", new Numbers(edges));
                List<BatchAnswer> answers = ask(asked, moved);
                degrees(poses);
                degrees(edges);
                long[] free = new long[(count + 63) / 64];
                int standing = world.freePoses("cart", poses, free);
                assertThat(answers.get(0)).isEqualTo(FreeAnswer.of(count, free));
                int going = world.freeEdges("cart", edges, free);
                assertThat(answers.get(1)).isEqualTo(FreeAnswer.of(count, free));
                if (count == 500) {
                    assertThat(standing).isBetween(100, 480);
                    assertThat(going).isBetween(50, 450);
                }
            }
        }
    }

    private static void place(SplittableRandom random, double[] poses, double height) {
        for (int k = 0; k < poses.length; k += 4) {
            poses[k] = 20 * random.nextDouble() - 10;
            poses[k + 1] = height * (random.nextDouble() - 0.5);
            poses[k + 2] = 20 * random.nextDouble() - 10;
            poses[k + 3] = random.nextInt(3) == 0 ? Math.PI / 2 : 6 * random.nextDouble() - 3;
        }
    }

    private static void degrees(double[] poses) {
        for (int k = 3; k < poses.length; k += 4) {
            poses[k] = Degrees.toDegrees(poses[k]);
        }
    }

    @Test
    void unknownAndStaticNamesAndWhatTheWorldRefusesHaveNoAnswerAndAReason() {
        SenseRequest early = new SenseRequest("robot", new BeamPattern.Fan(0, 1, 4));
        assertThat(ask(early)).containsExactly(new NoAnswer());
        init(Dimension.PLANAR);
        double[] up = new double[3 * 70];
        for (int k = 0; k < 70; k++) {
            up[3 * k] = k < 66 ? 1 : 0;
            up[3 * k + 1] = 1;
        }
        SenseRequest steep = sense(Mount.CENTER, new BeamPattern.Directions(new Numbers(up)), 0.2, false, false);
        Reply reply = Objects.requireNonNull(session.reply(new BatchRequestBundle(List.of(
                new SenseRequest("rover", new BeamPattern.Fan(0, 1, 4)),
                early,
                new FreePosesRequest("wall", Numbers.of(0, 0, 0, 0)),
                steep,
                early))));
        List<BatchAnswer> answers = ((BatchAnswerBundle) reply.bundle()).answers();
        assertThat(answers.get(0)).isEqualTo(new NoAnswer());
        assertThat(answers.get(1)).isInstanceOf(SenseAnswer.class).isEqualTo(answers.get(4));
        assertThat(answers.get(2)).isEqualTo(new NoAnswer());
        assertThat(answers.get(3)).isEqualTo(new NoAnswer());
        assertThat(reply.problems()).extracting(problem -> problem.index()).containsExactly(0, 2, 3);
        assertThat(reply.problems().get(0).reason()).isEqualTo("no moveable object \"rover\"");
        assertThat(reply.problems().get(1).reason()).isEqualTo("no moveable object \"wall\"");
        assertThat(reply.problems().get(2).reason()).startsWith("from beam 64 on, direction 2 ");
    }

    @Test
    void answersAreNoRequest() {
        assertThatThrownBy(() -> session.reply(BatchSamples.answers()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("(got: BatchAnswerBundle)");
    }

    /** A lidar sees heights in a PLANAR world with every ring, though beams are answered in parts that may be level alone. */
    @Test
    void aLevelRingSeesHeightsAsTheOthersDo() {
        Geometry world = init(Dimension.PLANAR);
        BeamPattern lidar = new BeamPattern.Layers(Numbers.of(0, 0.3), 0, 0.01, 200);
        SenseRequest request = sense(Mount.CENTER, lidar, 0, false, true);
        RayPattern rays = RayPattern.layers(new double[] {0, Degrees.toDegrees(0.3)}, 0, Degrees.toDegrees(0.01), 200);
        same((SenseAnswer) ask(request).get(0), world, request, rays);
    }

    /** However much a message asks for, others wait for no more than a part of it. */
    @Test
    void workIsDoneInParts() {
        init(Dimension.PLANAR);
        int[] breaths = new int[1];
        session.pausing(() -> breaths[0]++, new robosim.geometry.net.session.LogBudget(System::nanoTime));
        ask(new SenseRequest("robot", new BeamPattern.Fan(0, 0.001, 6400)));
        assertThat(breaths[0]).isBetween(100, 110);
        breaths[0] = 0;
        ask(new FreePosesRequest("robot", new Numbers(new double[4 * 6400])));
        assertThat(breaths[0]).isBetween(100, 110);
        breaths[0] = 0;
        ask(new FreeEdgesRequest("robot", new Numbers(new double[8 * 6400])));
        assertThat(breaths[0]).isBetween(100, 110);
    }

    /** Measured places and motions have the bits of the calls in Java, in parts and with what does not count. */
    @Test
    void whatIsMeasuredIsThatOfTheCalls() {
        Geometry world = init(Dimension.SPATIAL);
        SplittableRandom random = new SplittableRandom(3971);
        List<String> ignored = world.objects().stream()
                .map(GeometryObject::name)
                .filter(name -> name != null && !name.equals("cart"))
                .limit(2)
                .toList();
        assertThat(ignored).isNotEmpty();
        Avoidance avoid = Avoidance.margin(0.125).andIgnoring(ignored);
        int clear = 0;
        int within = 0;
        for (int count : new int[] {1, 64, 200}) {
            double[] poses = new double[4 * count];
            double[] drives = new double[9 * count];
            for (int k = 0; k < count; k++) {
                for (int n = 0; n < 3; n++) {
                    poses[4 * k + n] = random.nextDouble(-4, 4);
                    drives[9 * k + n] = poses[4 * k + n];
                }
                poses[4 * k + 3] = random.nextDouble(-3, 3);
                drives[9 * k + 3] = poses[4 * k + 3];
                drives[9 * k + 4] = random.nextDouble(-1, 1);
                drives[9 * k + 7] = random.nextDouble(-1, 1);
                drives[9 * k + 8] = random.nextDouble(0, 2);
            }
            double[] edges = Arrays.copyOf(poses, poses.length / 8 * 8);
            List<BatchAnswer> answers = ask(
                    measure(Question.DISTANCES, poses, 2, 0, ignored),
                    measure(Question.CLEARANCES, poses, INFINITY, 0, List.of()),
                    measure(Question.EDGES, edges, INFINITY, 0.125, ignored),
                    measure(Question.DRIVES, drives, INFINITY, 0.125, ignored));
            degrees(poses);
            degrees(edges);
            for (int k = 0; k < count; k++) {
                drives[9 * k + 3] = Degrees.toDegrees(drives[9 * k + 3]);
                drives[9 * k + 7] = Degrees.toDegrees(drives[9 * k + 7]);
            }
            double[] one = new double[count];
            clear += world.clearances("cart", poses, 2, avoid.withMargin(0), one);
            assertThat(answers.get(0)).isEqualTo(new MeasureRequest.Answer(new Numbers(one)));
            double[] ten = new double[10 * count];
            world.clearances("cart", poses, INFINITY, Avoidance.ALL, ten);
            assertThat(answers.get(1)).isEqualTo(new MeasureRequest.Answer(new Numbers(ten)));
            double[] two = new double[edges.length / 4];
            world.edgeFractions("cart", edges, avoid, two);
            assertThat(answers.get(2)).isEqualTo(new MeasureRequest.Answer(new Numbers(two)));
            within += world.driveFractions("cart", drives, avoid, one);
            assertThat(answers.get(3)).isEqualTo(new MeasureRequest.Answer(new Numbers(one)));
        }
        assertThat(clear).isBetween(20, 260);
        assertThat(within).isBetween(10, 260);
        for (GeometryObject other : world.objects()) {
            String name = other.name();
            if (name != null && !name.equals("cart")) {
                SignedDistance truth = ContactQuery.signedDistance(
                        world.getObject("cart"), other, world.dimension(), Budget.UNLIMITED);
                assertThat(world.signedDistance("cart", name)).isEqualTo(truth);
                assertThat(ask(MeasureRequest.signed("cart", name)).get(0))
                        .isEqualTo(new MeasureRequest.Answer(Numbers.of(
                                truth.low(),
                                truth.high(),
                                truth.onA().x(),
                                truth.onA().y(),
                                truth.onA().z(),
                                truth.onB().x(),
                                truth.onB().y(),
                                truth.onB().z(),
                                truth.direction().x(),
                                truth.direction().y(),
                                truth.direction().z())));
            }
        }
        assertThat(ask(MeasureRequest.signed("cart", "cart"), MeasureRequest.signed("nobody", "cart")))
                .containsExactly(new NoAnswer(), new NoAnswer());
        assertThat(ask(measure(Question.DISTANCES, new double[4], 1, 0, List.of("nobody")))
                        .get(0))
                .isEqualTo(new NoAnswer());
    }

    private static MeasureRequest measure(
            Question question, double[] numbers, double max, double margin, List<String> ignored) {
        return new MeasureRequest("cart", question, new Numbers(numbers), max, margin, ignored);
    }

    /** Patterns that are kept give the same answers as those that are made anew. */
    @Test
    void patternsComeAndGo() {
        Geometry world = init(Dimension.PLANAR);
        for (int round = 0; round < 3; round++) {
            for (int size : new int[] {100, 20_000, 30_000, 100, 40_000}) {
                SenseRequest request = sense(Mount.CENTER, new BeamPattern.Fan(0, 0.0003, size), 0, true, false);
                RayPattern rays = RayPattern.fan(0, Degrees.toDegrees(0.0003), size);
                same((SenseAnswer) ask(request).get(0), world, request, rays);
            }
        }
    }
}
