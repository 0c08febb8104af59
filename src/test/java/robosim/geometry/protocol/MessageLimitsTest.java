package robosim.geometry.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectOutputStream;
import java.io.SequenceInputStream;
import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.Allocated;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Messages that are small to send and large to read. */
@Tag("clock")
@Timeout(60)
class MessageLimitsTest {
    private static final GeometryObject BALL = new SphereObject(new Point(), 1);

    private static void refused(byte[] bytes, String reason) {
        assertThatThrownBy(() -> MessageTest.readAll(bytes))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining(reason);
    }

    private static GeometryObject nested(int levels, int copies) {
        GeometryObject object = BALL;
        for (int k = 0; k < levels; k++) {
            object = new ObjectGroup(Collections.nCopies(copies, object));
        }
        return object;
    }

    @Test
    void groupsNestAsDeepAsPromisedAndNoDeeper() throws IOException {
        InitBundle deep = new InitBundle(List.of(nested(28, 1)));
        assertThat(MessageTest.readAll(MessageTest.write(deep))).containsExactly(deep);
        refused(MessageTest.write(new InitBundle(List.of(nested(32, 1)))), "nesting");
        refused(MessageTest.write(new InitBundle(List.of(nested(ObjectGroup.MAX_DEPTH, 1)))), "nesting");
    }

    @Test
    void aMaterialIsALevelOfItsOwn() throws IOException {
        GeometryObject deep = BALL;
        for (int k = 0; k < 19; k++) {
            deep = new ObjectGroup(List.of(deep)).withMaterial(Material.DEFAULT.withLabel(k + 1));
        }
        InitBundle fair = new InitBundle(List.of(deep));
        assertThat(MessageTest.readAll(MessageTest.write(fair))).containsExactly(fair);
        GeometryObject deeper = new ObjectGroup(List.of(deep)).withMaterial(Material.DEFAULT.withLabel(20));
        refused(MessageTest.write(new InitBundle(List.of(deeper))), "nesting");
    }

    /** Some 3 kB name 2^25 balls. */
    @Test
    void membersNamedTwiceOnEveryLevelAreCountedTwice() throws IOException {
        byte[] bytes = MessageTest.write(new InitBundle(List.of(nested(25, 2))));
        assertThat(bytes).hasSizeLessThan(5000);
        assertThat(Allocated.once(() -> refused(bytes, "parts"))).isLessThan(10_000_000);
        InitBundle fair = new InitBundle(List.of(nested(10, 2)));
        assertThat(MessageTest.readAll(MessageTest.write(fair))).containsExactly(fair);
    }

    /** Every list claims a million items before its first one has come. */
    @Test
    void claimedLengthsMustFitTogetherIntoAMessage() throws IOException {
        byte[] bytes = MessageTest.write(new InitBundle(List.of(nested(25, 1))));
        int forged = 0;
        for (int k = 0; k + 6 < bytes.length; k++) {
            if (Arrays.equals(bytes, k, k + 6, new byte[] {0x77, 4, 0, 0, 0, 1}, 0, 6)) {
                System.arraycopy(new byte[] {0, 0x0F, 0x42, 0x40}, 0, bytes, k + 2, 4);
                forged++;
            }
        }
        assertThat(forged).isEqualTo(26);
        assertThat(Allocated.once(() -> refused(bytes, "must fit into"))).isLessThan(150_000_000);
    }

    /** Many meshes that share one array of faces on the wire, but would each have corners of their own in memory. */
    @Test
    void meshesAreCountedByTheirTriangles() throws IOException {
        int[][] faces = new int[20_000][];
        Arrays.fill(faces, new int[] {0, 1, 2});
        List<Point> corners = List.of(new Point(), new Point(1, 0, 0), new Point(0, 0, 1));
        MeshObject mesh = new MeshObject(corners, faces);
        List<GeometryObject> meshes = new ArrayList<>();
        for (int k = 0; k < 410; k++) {
            meshes.add(mesh.movedTo(new Point(k, 0, 0)));
        }
        byte[] bytes = sharing(new InitBundle(meshes), int[][].class);
        assertThat(bytes).hasSizeLessThan(3_000_000);
        assertThat(Allocated.once(() -> refused(bytes, "parts"))).isLessThan(1_000_000_000);
        List<Bundle> fair = MessageTest.readAll(sharing(new InitBundle(meshes.subList(0, 20)), int[][].class));
        assertThat(((InitBundle) fair.get(0)).objects()).hasSize(20);
    }

    /** Texture coordinates that share their arrays on the wire: each makes corners of its own for the same triangles. */
    @Test
    void texturedMeshesAreCountedByTheirTrianglesToo() throws IOException {
        int[][] faces = new int[20_000][];
        Arrays.fill(faces, new int[] {0, 1, 2});
        MeshObject mesh = new MeshObject(List.of(new Point(), new Point(1, 0, 0), new Point(0, 0, 1)), faces);
        List<GeometryObject> meshes = new ArrayList<>();
        for (int k = 0; k < 300; k++) {
            meshes.add(mesh.withTextureCoordinates(new TextureCoordinates(new double[] {k, 0}, new int[60_000])));
        }
        byte[] bytes = sharing(new InitBundle(meshes), int[].class, int[][].class);
        assertThat(bytes).hasSizeLessThan(3_000_000);
        assertThat(Allocated.once(() -> refused(bytes, "parts"))).isLessThan(1_000_000_000);
        List<GeometryObject> some = meshes.subList(0, 20);
        List<Bundle> fair = MessageTest.readAll(sharing(new InitBundle(some), int[].class, int[][].class));
        assertThat(fair).hasSize(1);
    }

    /** Pictures that share their bytes on the wire, but would each have pixels of their own in memory. */
    @Test
    void picturesAreCountedByTheirPixels() throws IOException {
        ImageTexture image = new ImageTexture(1024, 1024, new int[1 << 20], 1, 1);
        List<GeometryObject> balls = new ArrayList<>();
        for (int k = 1; k <= 17; k++) {
            balls.add(BALL.withMaterial(Material.DEFAULT.withTexture(image.tiled(k, 1))));
        }
        byte[] bytes = sharing(new InitBundle(balls), byte[].class);
        assertThat(bytes).hasSizeLessThan(4_000_000);
        assertThat(Allocated.once(() -> refused(bytes, "16777216 pixels"))).isLessThan(200_000_000);
        InitBundle fair = new InitBundle(balls.subList(0, 16));
        assertThat(MessageTest.readAll(sharing(fair, byte[].class))).containsExactly(fair);
        ImageTexture large = new ImageTexture(1155, 1155, new int[1155 * 1155], 1, 1);
        refused(
                MessageTest.write(new InitBundle(List.of(BALL.withMaterial(Material.DEFAULT.withTexture(large))))),
                "an array must have at most 4000000 items");
    }

    /** One picture of many objects takes its bytes once. */
    @Test
    void aMaterialIsSentOnce() throws IOException {
        Material material = Material.DEFAULT.withTexture(new ImageTexture(100, 100, new int[10_000], 1, 1));
        List<GeometryObject> balls = new ArrayList<>();
        for (int k = 0; k < 100; k++) {
            balls.add(BALL.movedTo(new Point(k, 0, 0)).withMaterial(material));
        }
        byte[] bytes = MessageTest.write(new InitBundle(balls));
        assertThat(bytes).hasSizeLessThan(100_000);
        List<GeometryObject> read = ((InitBundle) MessageTest.readAll(bytes).get(0)).objects();
        assertThat(read).isEqualTo(balls);
        assertThat(read.get(99).material()).isSameAs(read.get(0).material());
    }

    /** Writes every array of some types as the first one of that type. */
    private static byte[] sharing(Bundle bundle, Class<?>... types) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Map<Class<?>, Object> first = new HashMap<>();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes) {
            {
                enableReplaceObject(true);
            }

            @Override
            protected Object replaceObject(Object object) {
                boolean isFace = object instanceof int[] corners && corners.length < 5;
                return Arrays.asList(types).contains(object.getClass()) && !isFace
                        ? first.computeIfAbsent(object.getClass(), type -> object)
                        : object;
            }
        }) {
            out.writeObject(bundle);
        }
        return bytes.toByteArray();
    }

    @Test
    void aMessageHasAnEnd() throws IOException {
        MoveRequest request = new MoveRequest("x".repeat(60_000), 0, 0, 0, 0, 0);
        List<MoveRequest> requests = new ArrayList<>();
        for (int k = 0; k < 1200; k++) {
            requests.add(new MoveRequest(request.objectName() + k, 0, 0, 0, 0, 0));
        }
        byte[] bytes = MessageTest.write(new MoveBundle(requests));
        assertThat(bytes.length).isGreaterThan(MessageLimits.MAX_MESSAGE_BYTES);
        refused(bytes, "at most " + MessageLimits.MAX_MESSAGE_BYTES + " bytes");
        MoveBundle half = new MoveBundle(requests.subList(0, 600));
        byte[] fair = MessageTest.write(half, half);
        MessageReader reader = new MessageReader(new ByteArrayInputStream(fair));
        for (int k = 0; k < 2; k++) {
            assertThat(((MoveBundle) reader.read()).moves()).hasSize(600);
            assertThat(reader.messageBytes()).isBetween(36_000_000, 37_000_000);
        }
    }

    @Test
    void aLongTextIsRefusedAndTheLongestNameIsNot() throws IOException {
        MoveBundle longest = new MoveBundle(List.of(new MoveRequest("x".repeat(65_535), 0, 0, 0, 0, 0)));
        assertThat(MessageTest.readAll(MessageTest.write(longest))).containsExactly(longest);
        refused(
                MessageTest.write(new MoveBundle(List.of(new MoveRequest("x".repeat(65_536), 0, 0, 0, 0, 0)))),
                "a string must have at most 65535 bytes");
        MoveBundle bars = new MoveBundle(List.of(new MoveRequest("||||", 0, 0, 0, 0, 0)));
        assertThat(MessageTest.readAll(MessageTest.write(bars)))
                .as("'|' is the code of a long text")
                .containsExactly(bars);
    }

    /** The limit counts from the last reset, not over the stream's life. */
    @Test
    void objectsCountFromTheLastReset() throws IOException {
        MoveRequest request = new MoveRequest("robot", 1, 0, 0, 0, 0);
        MoveBundle many = new MoveBundle(Collections.nCopies(1_000_000, request));
        byte[] resets = MessageTest.write(many);
        int header = 4;
        MessageReader patient = new MessageReader(repeated(resets, header, 5));
        for (int k = 0; k < 5; k++) {
            assertThat(((MoveBundle) patient.read()).moves()).hasSize(1_000_000);
        }
        assertThat(patient.read()).isNull();

        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            for (int k = 0; k < 5; k++) {
                out.writeObject(new MoveBundle(many.moves().subList(0, 999_000)));
            }
        }
        refused(bytes.toByteArray(), "before it resets its stream");
    }

    private static InputStream repeated(byte[] stream, int header, int times) {
        List<InputStream> parts = new ArrayList<>();
        parts.add(new ByteArrayInputStream(stream, 0, header));
        for (int k = 0; k < times; k++) {
            parts.add(new ByteArrayInputStream(stream, header, stream.length - header));
        }
        return new SequenceInputStream(Collections.enumeration(parts));
    }

    /** What is read and written is not kept: 20,000 bundles, and the first of them is gone. */
    @Test
    void streamsKeepNothing() throws Exception {
        byte[] bytes = MessageTest.write(new SonarRequestBundle(List.of(new SonarRequest("robot", 1, 0))));
        MessageReader reader = new MessageReader(repeated(bytes, 4, 20_000));
        WeakReference<Bundle> read = new WeakReference<>(reader.read());
        for (int k = 1; k < 20_000; k++) {
            reader.read();
        }
        MessageWriter writer = new MessageWriter(OutputSink.INSTANCE);
        WeakReference<Bundle> written = write(writer);
        for (int k = 0; k < 20 && (read.get() != null || written.get() != null); k++) {
            System.gc();
            Thread.sleep(10);
        }
        assertThat(read.get()).isNull();
        assertThat(written.get()).isNull();
        assertThat(reader.read()).isNull();
        writer.write(new MoveBundle(List.of()));
    }

    private static WeakReference<Bundle> write(MessageWriter writer) throws IOException {
        Bundle bundle = new DistanceBundle(new ArrayList<>(List.of(1.5)));
        writer.write(bundle);
        return new WeakReference<>(bundle);
    }

    private static final class OutputSink extends java.io.OutputStream {
        static final OutputSink INSTANCE = new OutputSink();

        @Override
        public void write(int b) {}

        @Override
        public void write(byte[] bytes, int at, int length) {}
    }

    /** Only the protocol's own exception, whatever bytes come, and never much memory. */
    @Test
    void garbledBytesHaveOneKindOfFailure() throws IOException {
        byte[] whole = MessageTest.write(Samples.everyBundle().toArray(Bundle[]::new));
        SplittableRandom random = new SplittableRandom(20261121);
        int read = 0;
        int refused = 0;
        for (int round = 0; round < 2000; round++) {
            byte[] bytes = whole.clone();
            int changes = 1 + random.nextInt(4);
            for (int k = 0; k < changes; k++) {
                bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
            }
            int length = random.nextInt(4) == 0 ? random.nextInt(bytes.length) : bytes.length;
            try {
                MessageTest.readAll(Arrays.copyOf(bytes, length));
                read++;
            } catch (ProtocolException e) {
                assertThat(e.getMessage()).isNotBlank().doesNotContain("\n");
                refused++;
            }
        }
        assertThat(read).isBetween(100, 1900);
        assertThat(refused).isBetween(100, 1900);
    }
}
