package robosim.geometry.protocol.batch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleFunction;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import robosim.geometry.material.Color;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.RayPattern;

/** What requests with packed numbers, and their answers, may hold. */
class BatchValuesTest {
    private static final BeamPattern FAN = new BeamPattern.Fan(0, 1, 4);
    private static final double[] NO_ANGLES = {Double.NaN, Double.POSITIVE_INFINITY, -Math.nextUp(0x1p100)};

    private static void refuses(String argument, ThrowingCallable made) {
        assertThatThrownBy(made)
                .as(argument)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(argument)
                .hasMessageContaining("(got: ");
    }

    private static void refuses(String argument, DoubleFunction<?> make, double... values) {
        for (double value : values) {
            refuses(argument, () -> make.apply(value));
        }
    }

    @Test
    void patternsRefuseWhatNoPatternHas() {
        refuses("first ", v -> new BeamPattern.Fan(v, 1, 4), NO_ANGLES);
        refuses("step ", v -> new BeamPattern.Fan(0, v, 4), NO_ANGLES);
        refuses("count ", v -> new BeamPattern.Fan(0, 1, (int) v), 0, -1, RayPattern.MAX_SIZE + 1, Integer.MIN_VALUE);
        refuses("first ", v -> new BeamPattern.Layers(Numbers.of(0), v, 1, 4), NO_ANGLES);
        refuses("step ", v -> new BeamPattern.Layers(Numbers.of(0), 0, v, 4), NO_ANGLES);
        double steep = Math.nextUp(Math.PI / 2);
        refuses("elevations[1] ", v -> new BeamPattern.Layers(Numbers.of(0, v), 0, 1, 4), Double.NaN, steep, -steep, 9);
        refuses("number of elevations", () -> new BeamPattern.Layers(Numbers.NONE, 0, 1, 4));
        refuses(
                "count ",
                v -> new BeamPattern.Layers(Numbers.of(0, 0.1, 0.2), 0, 1, (int) v),
                0,
                RayPattern.MAX_SIZE / 3 + 1,
                Integer.MAX_VALUE);
        refuses("width ", v -> new BeamPattern.Pinhole((int) v, 1, 1), 0, -1, RayPattern.MAX_SIZE + 1);
        refuses("height ", v -> new BeamPattern.Pinhole(1 << 16, (int) v, 1), 0, -1, 257, Integer.MAX_VALUE);
        refuses("fieldOfView ", v -> new BeamPattern.Pinhole(2, 2, v), 0, -1, Math.PI, Double.NaN);
        refuses("directions ", () -> new BeamPattern.Directions(Numbers.NONE));
        refuses("directions ", () -> new BeamPattern.Directions(Numbers.of(1, 2, 3, 4)));
        refuses("direction 1 ", () -> new BeamPattern.Directions(Numbers.of(1, 2, 3, 0, -0.0, 0)));
        refuses("directions[2] ", v -> new BeamPattern.Directions(Numbers.of(1, 2, v)), NO_ANGLES);
        refuses("elevations ", () -> new BeamPattern.Layers(null, 0, 1, 4));
        assertThat(new BeamPattern.Layers(Numbers.of(-Math.PI / 2, Math.PI / 2), -0x1p100, 0x1p100, 4).size())
                .isEqualTo(8);
        assertThat(new BeamPattern.Pinhole(4096, 4096, 1).size()).isEqualTo(RayPattern.MAX_SIZE);
    }

    private static SenseRequest frame(double width, boolean seesCarrier, ScanMotion motion) {
        return new SenseRequest(
                "a", Mount.CENTER, FAN, 0, 9, width, seesCarrier, false, true, motion, false, List.of());
    }

    private static SenseAnswer frame(List<String> names, Integers objects, Integers labels) {
        return new SenseAnswer(Numbers.of(1, 2), Numbers.NONE, names, objects, labels);
    }

    @Test
    void requestsRefuseWhatNoSensorHas() {
        refuses("objectName", () -> new SenseRequest(null, FAN));
        refuses("pattern", () -> new SenseRequest("a", null));
        refuses(
                "mount",
                () -> new SenseRequest(
                        "a", null, FAN, 0, 1, 0, false, false, false, ScanMotion.NONE, false, List.of()));
        refuses(
                "min ",
                v -> new SenseRequest(
                        "a", Mount.CENTER, FAN, v, 9, 0, false, false, false, ScanMotion.NONE, false, List.of()),
                Double.NaN,
                -1);
        refuses(
                "max ",
                v -> new SenseRequest(
                        "a", Mount.CENTER, FAN, 2, v, 0, false, false, false, ScanMotion.NONE, false, List.of()),
                Double.NaN,
                1.9);
        refuses(
                "width ",
                v -> new SenseRequest(
                        "a", Mount.CENTER, FAN, 0, 9, v, false, false, false, ScanMotion.NONE, false, List.of()),
                Double.NaN,
                -1,
                Math.PI);
        refuses(
                "width ",
                v -> new SenseRequest(
                        "a", Mount.CENTER, FAN, 0, 9, v, false, true, false, ScanMotion.NONE, false, List.of()),
                0.1);
        refuses("width ", v -> frame(v, false, ScanMotion.NONE), 0.1);
        refuses("seesCarrier ", () -> frame(0, true, new ScanMotion(1, 1, 0, 0, 0)));
        assertThat(frame(0, true, null)).isEqualTo(frame(0, true, ScanMotion.NONE)); // as before there was one
        refuses("duration ", v -> new ScanMotion(v, 0, 0, 0, 0), Double.NaN, -1, Double.POSITIVE_INFINITY);
        refuses("x ", v -> new ScanMotion(1, v, 0, 0, 0), Double.NaN, 1e300);
        refuses("z ", v -> new ScanMotion(1, 0, 0, v, 0), Double.NaN, 1e300);
        refuses("ry ", v -> new ScanMotion(1, 0, 0, 0, v), Double.NaN, 1e300);
        refuses("place", () -> new Mount(null));
        refuses("rotation", () -> new Mount(new Point(), Numbers.of(1, 0, 0)));
        refuses("rotation", v -> new Mount(new Point(), Numbers.of(v, 0, 0, 0, 1, 0, 0, 0, 1)), -1, 2, Double.NaN);
        refuses("poses ", () -> new FreePosesRequest("a", Numbers.of(1, 2, 3)));
        refuses("poses[2] ", v -> new FreePosesRequest("a", Numbers.of(1, 2, v, 4)), NO_ANGLES);
        refuses("poses[3] must be an angle", v -> new FreePosesRequest("a", Numbers.of(1, 2, 3, v)), NO_ANGLES);
        refuses("edges ", () -> new FreeEdgesRequest("a", Numbers.of(1, 2, 3, 4)));
        refuses("edges[4] ", v -> new FreeEdgesRequest("a", Numbers.of(0, 0, 0, 0, v, 0, 0, 0)), NO_ANGLES);
        refuses(
                "edges[7] must be an angle",
                v -> new FreeEdgesRequest("a", Numbers.of(0, 0, 0, 0, 0, 0, 0, v)),
                NO_ANGLES);
    }

    @Test
    void answersRefuseWhatNoAnswerHas() {
        refuses(
                "distances[1] ",
                v -> new SenseAnswer(Numbers.of(0, v), Numbers.NONE),
                Double.NaN,
                -1,
                -Double.MIN_VALUE);
        refuses("normals ", () -> new SenseAnswer(Numbers.of(0, 1), Numbers.of(1, 0, 0)));
        refuses("normals[2] ", v -> new SenseAnswer(Numbers.of(1), Numbers.of(0, 0, v)), Double.NaN, 1.1, -2);
        List<String> wall = List.of("wall");
        refuses("objects and labels ", () -> frame(wall, Integers.of(0, -1), Integers.of(0)));
        refuses("objects and labels ", () -> frame(wall, Integers.of(0), Integers.of(0)));
        refuses("objects[1] ", v -> frame(wall, Integers.of(0, (int) v), Integers.of(0, 0)), -2, 1);
        refuses("labels[0] ", () -> frame(wall, Integers.of(0, 0), Integers.of(-1, 0)));
        refuses("names[1] ", () -> frame(Arrays.asList("a", null), Integers.of(0, 0), Integers.of(0, 0)));
        assertThat(frame(null, null, null)).isEqualTo(new SenseAnswer(Numbers.of(1, 2), Numbers.NONE));
        refuses("index ", v -> Integers.of(3).get((int) v), -1, 1);
        int[] whole = {1, 2};
        Integers integers = new Integers(whole);
        whole[0] = 3;
        integers.values()[1] = 3;
        assertThat(integers)
                .isEqualTo(Integers.of(1, 2))
                .hasSameHashCodeAs(Integers.of(1, 2))
                .hasToString("[1, 2]");
        assertThat(new Integers(new int[20])).hasToString("[0, 0, 0, 0, 0, 0, 0, 0, 0, ... 20 numbers]");
        BeamPattern.Pinhole camera = new BeamPattern.Pinhole(2, 1, 1);
        refuses("camera", () -> new PictureRequest("", Mount.CENTER, null));
        refuses("mount", () -> new PictureRequest("", null, camera));
        refuses("objectName", () -> new PictureRequest(null, Mount.CENTER, camera));
        refuses(
                "samples must be from 1 to 16",
                v -> new PictureRequest("", Mount.CENTER, camera, (int) v, 0, false, null),
                0,
                17);
        refuses(
                "mirrors must be from 0 to 16",
                v -> new PictureRequest("", Mount.CENTER, camera, 1, (int) v, false, null),
                -1,
                17);
        Color white = Color.WHITE;
        refuses("strength ", v -> new SceneLight(white, white, white, v, List.of()), -1, Double.NaN, 1e300);
        refuses(
                "sources must be at most 16",
                () -> new SceneLight(
                        white,
                        white,
                        white,
                        1,
                        Collections.nCopies(17, new SceneLight.Sun(new Point(1, 0, 0), white, 1))));
        refuses("direction ", () -> new SceneLight.Sun(new Point(), white, 1));
        refuses("color", () -> new SceneLight.Lamp(new Point(), null, 1));
        refuses("angle ", v -> new SceneLight.Spot(new Point(), new Point(1, 0, 0), v, white, 1), 0, Math.PI);
        refuses("rgb must have 6 bytes for 2 x 1 pixels", () -> new PictureAnswer(2, 1, new byte[5]));
        refuses("width and height ", v -> new PictureAnswer((int) v, 1, new byte[0]), 0, -1, 1 << 25);
        PictureAnswer picture = PictureAnswer.of(2, 1, new int[] {0x010203, 0xfffefd});
        assertThat(picture).isEqualTo(new PictureAnswer(2, 1, new byte[] {1, 2, 3, -1, -2, -3}));
        assertThat(picture.pixel(1, 0)).isEqualTo(0xfffefd);
        picture.rgb()[0] = 7;
        assertThat(picture.pixel(0, 0)).isEqualTo(0x010203);
        refuses("column and row ", v -> picture.pixel((int) v, 0), -1, 2);
        assertThat(picture.fits(new PictureRequest("", Mount.CENTER, camera))).isTrue();
        assertThat(picture.fits(new PictureRequest("", Mount.CENTER, new BeamPattern.Pinhole(1, 2, 1))))
                .isFalse();
        assertThat(new FreeAnswer(2, new byte[1]).fits(new PictureRequest("", Mount.CENTER, camera)))
                .isFalse();
        refuses("count ", () -> new FreeAnswer(-1, new byte[0]));
        refuses("free ", () -> new FreeAnswer(9, new byte[1]));
        refuses("free ", () -> new FreeAnswer(8, new byte[2]));
        refuses("free ", () -> new FreeAnswer(3, new byte[] {8}));
        refuses("free ", () -> new FreeAnswer(15, new byte[] {0, (byte) 0x80}));
        refuses("index ", v -> new FreeAnswer(3, new byte[] {7}).isFree((int) v), -1, 3);
    }

    @Test
    void whatIsInTheWayIsRefusedWhereItCannotBe() {
        refuses("clearance ", v -> new WorldRequest.GoToContact("r", 0, 0, 0, 0, 0, v), Double.NaN, -1, 1e300);
        refuses("rx ", v -> new WorldRequest.GoToContact("r", 0, 0, 0, v, 0, 0), NO_ANGLES);
        refuses("objectName", () -> new WorldRequest.GoToContact(null, 0, 0, 0, 0, 0, 0));
        refuses("clearance ", v -> new WorldRequest.GoAndSlide("r", 0, 0, 0, 0, 0, v, 1), Double.NaN, -1, 1e300);
        refuses("ry ", v -> new WorldRequest.GoAndSlide("r", 0, 0, 0, 0, v, 0, 1), NO_ANGLES);
        refuses("stepHeight ", v -> new WorldRequest.Walk(v, 1, 0), Double.NaN, -1, 1e300);
        refuses("maxSlope must be from 0 to pi / 2", v -> new WorldRequest.Walk(0, v, 0), Double.NaN, -0.1, 1.6, 45);
        refuses("max ", v -> new WorldRequest.Separate("r", v), Double.NaN, -1, 1e300, Double.POSITIVE_INFINITY);
        refuses("objectName", () -> new WorldRequest.Separate(null, 1));
        refuses("objectName", () -> new WorldRequest.Attach(null, "r", null));
        refuses("carrier", () -> new WorldRequest.Attach("b", null, null));
        refuses("objectName", () -> new WorldRequest.Detach(null));
        refuses("request must be a Locate", () -> new WorldRequest.Prove(new WorldRequest.Detach("r")));
        refuses("request must be a Locate", () -> new WorldRequest.Prove(null));
        refuses(
                "request must have at most 1024 beams",
                () -> new WorldRequest.Prove(new SenseRequest("r", new BeamPattern.Fan(0, 0.001, 1025))));
        refuses("index must be from 0 to 2^53", () -> new Obstacle(1L << 53, "", GeometryObject.Kind.BOX, new Point()));
        refuses("either a proof or a reason", () -> new WorldAnswer.Evidence(List.of(), ""));
        refuses("either a proof or a reason", () -> new WorldAnswer.Evidence(List.of("{}"), "why"));
        refuses("displacement", () -> new WorldAnswer.Separated(null));
        refuses("snap ", v -> new WorldRequest.Walk(0, 1, v), Double.NaN, -1, 1e300);
        refuses("bends must be from 0 to 64", v -> new WorldRequest.GoAndSlide("r", 0, 0, 0, 0, 0, 0, (int) v), -1, 65);
        WorldRequest.Go go = new WorldRequest.Go("r", 1, 0, 0, 0, 0);
        refuses(
                "request must be a Place, an Add or a Go",
                () -> new WorldRequest.Identify(new WorldRequest.Describe()));
        refuses("request must be ", () -> new WorldRequest.Identify(new WorldRequest.Identify(go)));
        refuses("request must be ", () -> new WorldRequest.Identify(null));
        Point point = new Point();
        refuses("index ", v -> new Obstacle((long) v, "", GeometryObject.Kind.BOX, point), -1);
        refuses("name", () -> new Obstacle(0, null, GeometryObject.Kind.BOX, point));
        refuses("kind", () -> new Obstacle(0, "", null, point));
        refuses("center", () -> new Obstacle(0, "", GeometryObject.Kind.BOX, null));
        Obstacle wall = new Obstacle(0, "wall", GeometryObject.Kind.BOX, point);
        WorldAnswer.Changed blocked = new WorldAnswer.Changed(false, "wall");
        refuses("obstacles must be at most 16", () -> new WorldAnswer.Identified(blocked, List.of()));
        refuses("obstacles ", () -> new WorldAnswer.Identified(new WorldAnswer.Changed(false, ""), List.of(wall)));
        refuses("obstacles ", () -> new WorldAnswer.Identified(blocked, Collections.nCopies(17, wall)));
        refuses(
                "obstacles must be at most 1,",
                () -> new WorldAnswer.Identified(
                        new WorldAnswer.Went(false, 0, 0, "wall", point, point), List.of(wall, wall)));
        refuses("obstacles[0] ", () -> new WorldAnswer.Identified(blocked, Arrays.asList((Obstacle) null)));
        refuses("answer must be a Changed or a Went", () -> new WorldAnswer.Identified(null, List.of()));
        WorldAnswer.Identified told = new WorldAnswer.Identified(blocked, List.of(wall));
        refuses("answer must be a Changed or a Went", () -> new WorldAnswer.Identified(told, List.of()));
        WorldRequest place = new WorldRequest.Place("r", point, 0);
        assertThat(told.fits(new WorldRequest.Identify(place))).isTrue();
        assertThat(told.fits(new WorldRequest.Identify(go))).isFalse();
        assertThat(told.fits(place)).isFalse();
        WorldAnswer.Identified went = new WorldAnswer.Identified(WorldAnswer.Went.MADE, List.of());
        WorldRequest docking = new WorldRequest.GoToContact("r", 1, 0, 0, 0, 0, 0);
        assertThat(went.fits(docking)).isTrue();
        assertThat(told.fits(docking)).isFalse();
        refuses("length ", v -> new WorldAnswer.Slid(point, v, point, 0, List.of()), Double.NaN, -1, 1.0 / 0);
        refuses("turnFraction ", v -> new WorldAnswer.Slid(point, 0, point, v, List.of()), Double.NaN, -1, 1.1);
        refuses("displacement", () -> new WorldAnswer.Slid(null, 0, point, 0, List.of()));
        refuses("left", () -> new WorldAnswer.Slid(point, 0, null, 0, List.of()));
        refuses("point", () -> new WorldAnswer.Contact(null, null, point));
        refuses("normal", () -> new WorldAnswer.Contact(null, point, null));
        WorldAnswer.Contact border = new WorldAnswer.Contact(null, point, point);
        WorldAnswer.Slid slid = new WorldAnswer.Slid(point, 0, point, 0, List.of(border, border));
        assertThat(slid.fits(new WorldRequest.GoAndSlide("r", 1, 0, 0, 0, 0, 0, 1)))
                .isTrue();
        assertThat(slid.fits(new WorldRequest.GoAndSlide("r", 1, 0, 0, 0, 0, 0, 0)))
                .isFalse();
        assertThat(slid.fits(docking)).isFalse();
    }

    @Test
    void aListIsInOrder() {
        Point point = new Point();
        Point above = new Point(0, 1, 0);
        GeometryObject.Kind box = GeometryObject.Kind.BOX;
        refuses("first must be from 0 to 2^53 - 1", v -> new WorldRequest.ListObjects((long) v, 1), -1, 0x1p53);
        refuses("count must be from 1 to 65536", v -> new WorldRequest.ListObjects(0, (int) v), 0, -1, 65537);
        refuses("index ", v -> new ListedObject((long) v, "", box, point, 0, true, point, point), -1, 0x1p53);
        refuses("heading ", v -> new ListedObject(0, "", box, point, v, true, point, point), Double.NaN, 4, -4);
        refuses("low must not be above high", () -> new ListedObject(0, "", box, point, 0, true, above, point));
        refuses("name", () -> new ListedObject(0, null, box, point, 0, true, point, point));
        refuses("kind", () -> new ListedObject(0, "", null, point, 0, true, point, point));
        refuses("center", () -> new ListedObject(0, "", box, null, 0, true, point, point));
        refuses("low", () -> new ListedObject(0, "", box, point, 0, true, null, point));
        refuses("high", () -> new ListedObject(0, "", box, point, 0, true, point, null));
        ListedObject one = new ListedObject(3, "", box, point, 0, true, point, above);
        refuses("objects must be in the order", () -> new WorldAnswer.Listed(List.of(one, one), -1));
        refuses("objects[0] ", () -> new WorldAnswer.Listed(Arrays.asList((ListedObject) null), -1));
        refuses("next must be ", v -> new WorldAnswer.Listed(List.of(one), (long) v), -2, 0, 3, 0x1p53);
        refuses("next must be ", () -> new WorldAnswer.Listed(List.of(), 4));
        WorldAnswer.Listed listed = new WorldAnswer.Listed(List.of(one), 4);
        assertThat(listed.fits(new WorldRequest.ListObjects(3, 1))).isTrue();
        assertThat(listed.fits(new WorldRequest.ListObjects(4, 1))).isFalse();
        assertThat(listed.fits(new WorldRequest.Describe())).isFalse();
        ListedObject other = new ListedObject(5, "", box, point, 0, true, point, above);
        assertThat(new WorldAnswer.Listed(List.of(one, other), -1).fits(new WorldRequest.ListObjects(0, 1)))
                .isFalse();
    }

    @Test
    void arraysAreOfTheirOwnAndComparedByTheirBits() {
        double[] given = {1, 2};
        Numbers numbers = new Numbers(given);
        given[0] = 3;
        numbers.values()[1] = 3;
        assertThat(numbers).isEqualTo(Numbers.of(1, 2)).hasSameHashCodeAs(Numbers.of(1, 2));
        assertThat(Numbers.of(0.0)).isNotEqualTo(Numbers.of(-0.0));
        assertThat(Numbers.of(Double.NaN)).isEqualTo(Numbers.of(Double.NaN));
        byte[] bits = {5};
        FreeAnswer answer = new FreeAnswer(3, bits);
        bits[0] = 0;
        answer.free()[0] = 0;
        assertThat(answer).isEqualTo(new FreeAnswer(3, new byte[] {5})).isNotEqualTo(new FreeAnswer(4, new byte[] {5}));
        assertThat(new Numbers(new double[1000]))
                .hasToString("[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, ... 1000 numbers]");
    }

    @Test
    void bitsAreThoseOfABitSet() {
        SplittableRandom random = new SplittableRandom(19);
        for (int count = 0; count < 200; count++) {
            BitSet set = new BitSet();
            for (int k = 0; k < count; k++) {
                set.set(k, random.nextBoolean());
            }
            long[] words = new long[(count + 63) / 64];
            System.arraycopy(set.toLongArray(), 0, words, 0, set.toLongArray().length);
            FreeAnswer answer = FreeAnswer.of(count, words);
            assertThat(BitSet.valueOf(answer.free())).isEqualTo(set);
            for (int k = 0; k < count; k++) {
                assertThat(answer.isFree(k)).isEqualTo(set.get(k));
            }
        }
    }
}
