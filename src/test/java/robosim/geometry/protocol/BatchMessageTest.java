package robosim.geometry.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.FreeEdgesRequest;
import robosim.geometry.protocol.batch.FreePosesRequest;
import robosim.geometry.protocol.batch.MeasureRequest;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.PictureRequest;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.batch.WorldRequest;
import robosim.geometry.protocol.json.JsonLines;

/** Batches in Java serialization. */
class BatchMessageTest {
    private static final String STORED = "batches.ser";
    private static final String FRAMES = "frames.ser";
    private static final String PICTURES = "pictures.ser";
    private static final String WORLD = "world-requests.ser";
    private static final String OBSTACLES = "obstacles.ser";
    private static final String LISTED = "listed.ser";
    private static final String WALKS = "walks.ser";
    private static final String PROOFS = "proofs.ser";
    private static final String MEASURES = "measures.ser";
    private static final String RULES = "rules.ser";

    @Test
    void batchesComeBackAsTheyWere() throws IOException {
        List<Bundle> bundles = new ArrayList<>(BatchSamples.everyBundle());
        bundles.addAll(BatchSamples.frames());
        bundles.addAll(BatchSamples.pictures());
        bundles.addAll(BatchSamples.world());
        bundles.addAll(BatchSamples.obstacles());
        bundles.addAll(BatchSamples.listed());
        bundles.addAll(BatchSamples.copies());
        byte[] bytes = MessageTest.write(bundles.toArray(Bundle[]::new));
        assertThat(MessageTest.readAll(bytes)).isEqualTo(bundles);
    }

    @Test
    void storedBatchesMeanWhatTheyMeant() throws IOException {
        assertThat(MessageTest.readAll(StoredBytesTest.stored(STORED))).isEqualTo(BatchSamples.everyBundle());
        assertThat(MessageTest.readAll(StoredBytesTest.stored(FRAMES))).isEqualTo(BatchSamples.frames());
        assertThat(MessageTest.readAll(StoredBytesTest.stored(PICTURES))).isEqualTo(BatchSamples.pictures());
        assertThat(MessageTest.readAll(StoredBytesTest.stored(WORLD))).isEqualTo(BatchSamples.world());
        List<Bundle> last = new ArrayList<>(BatchSamples.obstacles());
        last.add(BatchSamples.world().get(2));
        last.add(InitBundle.Answered.QUESTION);
        assertThat(MessageTest.readAll(StoredBytesTest.stored(OBSTACLES))).isEqualTo(last);
        assertThat(MessageTest.readAll(StoredBytesTest.stored(LISTED))).isEqualTo(BatchSamples.listed());
    }

    @Test
    void rulesComeBackAsTheyWere() throws IOException {
        List<Bundle> rules = BatchSamples.rules();
        assertThat(MessageTest.readAll(MessageTest.write(rules.toArray(Bundle[]::new))))
                .isEqualTo(rules);
        assertThat(MessageTest.readAll(StoredBytesTest.stored(RULES))).isEqualTo(rules);
        assertThat(JsonLines.readRequest(JsonLines.write(rules.get(0)))).isEqualTo(rules.get(0));
        assertThat(JsonLines.readRequest(JsonLines.write(rules.get(2)))).isEqualTo(rules.get(2));
        Reply answers = new Reply(rules.get(1));
        assertThat(JsonLines.readReply(JsonLines.write(answers))).isEqualTo(answers);
    }

    @Test
    void measuresComeBackAsTheyWere() throws IOException {
        List<Bundle> measures = BatchSamples.measures();
        assertThat(MessageTest.readAll(MessageTest.write(measures.toArray(Bundle[]::new))))
                .isEqualTo(measures);
        assertThat(MessageTest.readAll(StoredBytesTest.stored(MEASURES))).isEqualTo(measures);
        assertThat(JsonLines.readRequest(JsonLines.write(measures.get(0)))).isEqualTo(measures.get(0));
        Reply answers = new Reply(measures.get(1));
        assertThat(JsonLines.readReply(JsonLines.write(answers))).isEqualTo(answers);
    }

    @Test
    void aSignedDistanceIsAskedForByTwoNames() throws IOException {
        BatchRequestBundle asked = new BatchRequestBundle(List.of(MeasureRequest.signed("a", "\u00e9")));
        assertThat(asked.size()).isEqualTo(1);
        assertThat(MessageTest.readAll(MessageTest.write(asked))).containsExactly(asked);
        assertThat(JsonLines.readRequest(JsonLines.write(asked))).isEqualTo(asked);
        assertThat(JsonLines.readRequest("{\"type\":\"batch\",\"requests\":[{\"kind\":\"measure\",\"objectName\":\"a\","
                        + "\"question\":\"SIGNED\",\"other\":\"\u00e9\"}]}"))
                .isEqualTo(asked);
        List<String> none = List.of();
        assertThatThrownBy(() -> new MeasureRequest(
                        "a", MeasureRequest.Question.SIGNED, Numbers.of(1, 2, 3, 4), 1, 0, none, "b"))
                .hasMessageContaining("numbers, margin and ignored must be left out for SIGNED (got: 4 numbers");
        assertThatThrownBy(() -> new MeasureRequest("a", MeasureRequest.Question.SIGNED, Numbers.NONE, 1, 0, none))
                .hasMessageContaining("other must be a name for SIGNED");
        assertThatThrownBy(
                        () -> new MeasureRequest("a", MeasureRequest.Question.DISTANCES, Numbers.NONE, 1, 0, none, "b"))
                .hasMessageContaining("(got: b for DISTANCES)");
    }

    @Test
    void drivesAndLayersComeBackAsTheyWere() throws IOException {
        List<Bundle> drives = BatchSamples.drives();
        assertThat(MessageTest.readAll(MessageTest.write(drives.toArray(Bundle[]::new))))
                .isEqualTo(drives);
        assertThat(JsonLines.readRequest(JsonLines.write(drives.get(0)))).isEqualTo(drives.get(0));
        assertThat(JsonLines.readRequest(JsonLines.write(drives.get(2)))).isEqualTo(drives.get(2));
        Reply answers = new Reply(drives.get(1));
        assertThat(JsonLines.readReply(JsonLines.write(answers))).isEqualTo(answers);
        assertThatThrownBy(() -> new WorldRequest.Drive("a", 0, 0, 0, 0, -1, null))
                .hasMessageContaining("seconds");
        assertThatThrownBy(() -> new WorldRequest.Drive("a", 0, 0, 0, Double.NaN, 1, null))
                .hasMessageContaining("ry");
        assertThatThrownBy(() -> new WorldRequest.Drive("a", 0, 0, 0, 0, 1, -0.5))
                .hasMessageContaining("clearance");
    }

    /** What a request refuses when it is made cannot be read either. */
    @Test
    void measuresThatAreWrongAreRefused() {
        List<String> none = List.of();
        Numbers drive = Numbers.of(0, 0, 0, 0, 0, 0, 0, 0, -1);
        assertThatThrownBy(() -> new MeasureRequest("a", MeasureRequest.Question.DRIVES, drive, 1, 0, none))
                .hasMessageContaining("numbers[8]")
                .hasMessageContaining("(got: -1.0)");
        assertThatThrownBy(() -> new MeasureRequest("a", MeasureRequest.Question.EDGES, drive, 1, 0, none))
                .hasMessageContaining("numbers must have 8 numbers each (got: 9 numbers)");
        Numbers pose = Numbers.of(0, 0, 0, 0);
        assertThatThrownBy(() -> new MeasureRequest("a", MeasureRequest.Question.DISTANCES, pose, Double.NaN, 0, none))
                .hasMessageContaining("max");
        assertThatThrownBy(() -> new MeasureRequest("a", MeasureRequest.Question.DISTANCES, pose, 1, -1, none))
                .hasMessageContaining("(got: -1.0)");
        assertThatThrownBy(
                        () -> new MeasureRequest("a", MeasureRequest.Question.DISTANCES, pose, 1, 0, List.of("b", "b")))
                .hasMessage("ignored must have each name once (got: [b, b])");
    }

    /** The classes that a stream names: a peer that does not know one of them refuses it; fields it does not know it skips. */
    private static Set<String> classes(byte[] bytes) {
        return Pattern.compile("robosim\\.geometry\\.[\\w.$]+")
                .matcher(new String(bytes, StandardCharsets.ISO_8859_1))
                .results()
                .map(MatchResult::group)
                .collect(Collectors.toSet());
    }

    /** Whoever knows none of the later requests, nor of the later fields of others, understands all others. */
    @Test
    void batchesAreWrittenAsEver() throws IOException {
        assertThat(classes(MessageTest.write(BatchSamples.frames().toArray(Bundle[]::new))))
                .isEqualTo(classes(StoredBytesTest.stored(FRAMES)))
                .contains(SenseRequest.class.getName());
        assertThat(classes(MessageTest.write(StepSamples.everyBundle().toArray(Bundle[]::new))))
                .isEqualTo(classes(StoredBytesTest.stored("steps.ser")))
                .contains(StepBundle.class.getName());
        assertThat(MessageTest.write(BatchSamples.world().toArray(Bundle[]::new)))
                .isEqualTo(StoredBytesTest.stored(WORLD));
    }

    @Test
    void anInitThatAsksIsReadAsTwoMessages() throws IOException {
        InitBundle init = (InitBundle) BatchSamples.world().get(2);
        byte[] bytes = MessageTest.write(new InitBundle.Answered(init), BatchSamples.requests());
        assertThat(MessageTest.readAll(bytes))
                .containsExactly(init, InitBundle.Answered.QUESTION, BatchSamples.requests());
        assertThatThrownBy(() -> new InitBundle.Answered(null)).hasMessage("init must be given (got: null)");
    }

    /** A mesh of many triangles costs five bytes each time that it is added again. */
    @Test
    void additionsAreCountedAtEveryReference() throws IOException {
        int faces = 1000;
        int[][] triangles = new int[faces][];
        Arrays.fill(triangles, new int[] {0, 1, 2});
        MeshObject mesh = new MeshObject(List.of(new Point(), new Point(1, 0, 0), new Point(0, 0, 1)), triangles);
        WorldRequest.Add add = new WorldRequest.Add(mesh, true);
        int most = (int) (MessageLimits.MAX_PARTS / faces) - 1; // and once as it comes
        List<Bundle> fits = List.of(new BatchRequestBundle(times(most, add)));
        assertThat(MessageTest.readAll(MessageTest.write(fits.get(0)))).isEqualTo(fits);
        assertThatThrownBy(() -> MessageTest.readAll(MessageTest.write(new BatchRequestBundle(times(most + 1, add)))))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("must have at most 16000000 parts, counted at every reference");
        WorldRequest asking = new WorldRequest.Identify(add);
        assertThatThrownBy(
                        () -> MessageTest.readAll(MessageTest.write(new BatchRequestBundle(times(most + 1, asking)))))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("must have at most 16000000 parts, counted at every reference");
    }

    @Test
    void attachmentsComeBackAsTheyWere() throws IOException {
        Bundle attachments = BatchSamples.attachments();
        assertThat(MessageTest.readAll(MessageTest.write(attachments))).isEqualTo(List.of(attachments));
        assertThat(JsonLines.readRequest(JsonLines.write(attachments))).isEqualTo(attachments);
    }

    @Test
    void proofsComeBackAsTheyWere() throws IOException {
        List<Bundle> proofs = BatchSamples.proofs();
        assertThat(MessageTest.readAll(MessageTest.write(proofs.toArray(Bundle[]::new))))
                .isEqualTo(proofs);
        assertThat(MessageTest.readAll(StoredBytesTest.stored(PROOFS))).isEqualTo(proofs);
        assertThat(JsonLines.readRequest(JsonLines.write(proofs.get(0)))).isEqualTo(proofs.get(0));
        Reply answers = new Reply(proofs.get(1));
        assertThat(JsonLines.readReply(JsonLines.write(answers))).isEqualTo(answers);
    }

    @Test
    void walksComeBackAsTheyWere() throws IOException {
        Bundle walks = BatchSamples.walks();
        assertThat(MessageTest.readAll(MessageTest.write(walks))).isEqualTo(List.of(walks));
        assertThat(MessageTest.readAll(StoredBytesTest.stored(WALKS))).isEqualTo(List.of(walks));
        assertThat(JsonLines.readRequest(JsonLines.write(walks))).isEqualTo(walks);
    }

    /** A few bytes ask for an answer of many contacts: its memory is claimed before the work begins. */
    @Test
    void longAnswersAreCounted() {
        WorldRequest.GoAndSlide slide = new WorldRequest.GoAndSlide("r", 1, 0, 0, 0, 0, 0, 64);
        assertThat(new BatchRequestBundle(times(1000, slide)).workBytes()).isEqualTo(1000L * 65 * 256);
        assertThat(new BatchRequestBundle(times(1000, new WorldRequest.Locate("r"))).workBytes())
                .isEqualTo(1000);
        WorldRequest list = new WorldRequest.ListObjects(0, 1 << 16);
        assertThat(new BatchRequestBundle(times(4, list)).workBytes()).isEqualTo(256L << 18);
        assertThatThrownBy(() -> new BatchRequestBundle(times(5, list)))
                .hasMessageContaining("at most 262144 poses, edges and requests of other kinds together (got: 327680)");
    }

    private static List<BatchRequest> times(int count, BatchRequest request) {
        return Collections.nCopies(count, request);
    }

    @Test
    void batchesHaveTheirLimits() {
        SenseRequest beams = new SenseRequest("r", new BeamPattern.Fan(0, 0, MessageLimits.MAX_BEAMS / 4));
        assertThat(new BatchRequestBundle(times(4, beams)).size()).isEqualTo(MessageLimits.MAX_BEAMS);
        FreePosesRequest poses = new FreePosesRequest("r", new Numbers(new double[MessageLimits.MAX_POSES]));
        assertThat(new BatchRequestBundle(times(4, poses)).size()).isEqualTo(MessageLimits.MAX_POSES);
        FreeEdgesRequest edge = new FreeEdgesRequest("r", new Numbers(new double[8]));
        List<BatchRequest> both = new ArrayList<>(times(4, beams));
        both.addAll(times(4, poses));
        assertThat(new BatchRequestBundle(both).size()).isEqualTo(MessageLimits.MAX_BEAMS + MessageLimits.MAX_POSES);
        both.add(edge);
        assertThatThrownBy(() -> new BatchRequestBundle(both))
                .hasMessage("requests must have at most 262144 poses, edges and requests of other kinds together (got:"
                        + " 262145)");
        assertThatThrownBy(() -> new BatchRequestBundle(times(5, beams)))
                .hasMessage("requests must have at most 1048576 beams together (got: 1310720)");
        assertThatThrownBy(() -> new BatchRequestBundle(
                        times(1_000_000, new SenseRequest("r", new BeamPattern.Pinhole(4096, 4096, 1)))))
                .hasMessageContaining("at most 1048576 beams together (got: 16777216000000)");
        BeamPattern.Pinhole screen = new BeamPattern.Pinhole(1024, 512, 1);
        PictureRequest half = new PictureRequest("", Mount.CENTER, screen);
        assertThat(half.rays()).isEqualTo(1024 * 512 * 2 * 4);
        assertThat(new BatchRequestBundle(times(2, half)).size()).isEqualTo(MessageLimits.MAX_PICTURE_PIXELS);
        assertThat(new BatchRequestBundle(times(2, half)).workBytes()).isEqualTo(40L << 20);
        assertThatThrownBy(() -> new BatchRequestBundle(times(3, half)))
                .hasMessage("requests must have at most 1048576 pixels together (got: 1572864)");
        PictureRequest fine = new PictureRequest("", Mount.CENTER, screen, 3, 3, false, null);
        assertThatThrownBy(() -> new BatchRequestBundle(List.of(fine)))
                .hasMessage(
                        "requests must have at most 33554432 rays for pictures (pixels times samples times sources of"
                                + " light and one times mirrors and one) together (got: 37748736)");
        assertThatThrownBy(() -> new BatchRequestBundle(times(1_000_000, fine)))
                .hasMessageContaining("pixels together");
        assertThatThrownBy(() -> new BatchRequestBundle(null)).hasMessageContaining("requests");
        assertThatThrownBy(() -> new BatchRequestBundle(Arrays.asList(edge, null)))
                .hasMessageContaining("requests[1] must be given");
        assertThatThrownBy(() -> new BatchAnswerBundle(null)).hasMessageContaining("answers");
    }

    /** References to one request in a list cost five bytes each. */
    @Test
    void aFewBytesThatAskForMillionsAreRefused() throws IOException {
        byte[] bytes = MessageTest.write(
                new BatchRequestBundle(times(1000, new SenseRequest("r", new BeamPattern.Fan(0, 0, 1000)))));
        assertThat(bytes.length).isLessThan(7000);
        byte[] more = bytes.clone();
        for (int k = more.length - 1; k > 0; k--) {
            if (more[k - 1] == 3 && more[k] == (byte) 0xe8) {
                more[k - 1] = 127; // of beams alone, which come after the list's length
                break;
            }
        }
        assertThatThrownBy(() -> MessageTest.readAll(more))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("requests must have at most 1048576 beams together (got: 32744000)");
    }

    /** Nobody's class is loaded by its name, wherever it is. */
    @Test
    void onlyKnownPatternsAreRead() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(new float[3]);
        }
        assertThatThrownBy(() -> MessageTest.readAll(bytes.toByteArray()))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("is not on the list");
    }

    /** Wrote the stored bytes; whoever changes what is written adds a file and leaves this one alone. */
    static final class Write {
        private Write() {}

        public static void main(String[] args) throws IOException {
            byte[] bytes = MessageTest.write(BatchSamples.everyBundle().toArray(Bundle[]::new));
            Files.write(Path.of(args[0], STORED), bytes);
            Files.write(
                    Path.of(args[0], FRAMES),
                    MessageTest.write(BatchSamples.frames().toArray(Bundle[]::new)));
            Files.write(
                    Path.of(args[0], PICTURES),
                    MessageTest.write(BatchSamples.pictures().toArray(Bundle[]::new)));
            Files.write(
                    Path.of(args[0], RULES),
                    MessageTest.write(BatchSamples.rules().toArray(Bundle[]::new)));
            Files.write(
                    Path.of(args[0], PROOFS),
                    MessageTest.write(BatchSamples.proofs().toArray(Bundle[]::new)));
            Files.write(Path.of(args[0], WALKS), MessageTest.write(BatchSamples.walks()));
            Files.write(
                    Path.of(args[0], WORLD),
                    MessageTest.write(BatchSamples.world().toArray(Bundle[]::new)));
            List<Bundle> last = new ArrayList<>(BatchSamples.obstacles());
            last.add(new InitBundle.Answered((InitBundle) BatchSamples.world().get(2)));
            Files.write(Path.of(args[0], OBSTACLES), MessageTest.write(last.toArray(Bundle[]::new)));
            Files.write(
                    Path.of(args[0], LISTED),
                    MessageTest.write(BatchSamples.listed().toArray(Bundle[]::new)));
        }
    }
}
