package robosim.geometry.limits;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchSamples;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageTranslator;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.Samples;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.StepSamples;
import robosim.geometry.protocol.channel.MessageChannel;
import robosim.geometry.protocol.json.JsonLines;
import robosim.geometry.protocol.json.PeerAdmission;
import robosim.geometry.protocol.pace.MessagePace;

/**
 * Gives bytes to a decoder and judges what becomes of them: bundles, or the protocol's own exception, within a second and
 * within the memory that the limits allow. What is read means the same when it is written and read again.
 */
final class Hostile {
    private static final long MOST_NANOS = 1_000_000_000;

    /** What lists, arrays and buffers of a message of full size may take, several times over. */
    private static final long MOST_BYTES = 4L * MessageLimits.MAX_MESSAGE_BYTES;

    private static final byte[] HELLO = "{\"type\":\"hello\",\"version\":1}\n".getBytes(StandardCharsets.UTF_8);

    private final String name;
    private final Decoder decoder;
    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private long inputs;
    private long understood;
    private long bundles;
    private long slowestNanos;
    private long largestBytes;

    /** Reads all that there is. */
    private interface Decoder {
        List<Bundle> read(byte[] bytes) throws IOException;
    }

    private Hostile(String name, Decoder decoder) {
        this.name = name;
        this.decoder = decoder;
    }

    static Hostile javaSerialization() {
        return new Hostile("java-serialization", Hostile::readJava).understanding(javaSeeds());
    }

    static Hostile jsonLines() {
        return new Hostile("json-lines", Hostile::readJson).understanding(jsonSeeds());
    }

    /** A decoder to which all is rubbish, for one that a tool has tampered with, would pass every test. */
    private Hostile understanding(List<byte[]> seeds) {
        for (byte[] seed : seeds) {
            assertThat(accepts(seed)).isTrue();
        }
        assertThat(bundles).isGreaterThanOrEqualTo(5);
        return this;
    }

    /** Streams of one message each, and one of all. */
    static List<byte[]> javaSeeds() {
        try {
            List<byte[]> seeds = new ArrayList<>();
            ByteArrayOutputStream all = new ByteArrayOutputStream();
            MessageWriter together = new MessageWriter(all);
            for (Bundle bundle : Samples.everyBundle()) {
                ByteArrayOutputStream one = new ByteArrayOutputStream();
                new MessageWriter(one).write(bundle);
                seeds.add(one.toByteArray());
                together.write(bundle);
            }
            List<Bundle> batches = new ArrayList<>(BatchSamples.everyBundle());
            batches.addAll(BatchSamples.frames());
            batches.addAll(BatchSamples.pictures());
            batches.addAll(BatchSamples.measures());
            batches.addAll(BatchSamples.drives());
            batches.addAll(BatchSamples.world());
            batches.addAll(BatchSamples.obstacles());
            batches.addAll(BatchSamples.listed());
            batches.addAll(BatchSamples.copies());
            batches.add(BatchSamples.walks());
            batches.add(BatchSamples.attachments());
            batches.addAll(BatchSamples.proofs());
            batches.addAll(BatchSamples.rules());
            batches.addAll(StepSamples.later());
            batches.add(
                    new InitBundle.Answered((InitBundle) BatchSamples.world().get(3)));
            for (Bundle bundle : batches) {
                ByteArrayOutputStream one = new ByteArrayOutputStream();
                new MessageWriter(one).write(bundle);
                seeds.add(one.toByteArray());
            }
            seeds.add(all.toByteArray());
            return seeds;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Lines of one message each, requests and answers, and some at once. */
    static List<byte[]> jsonSeeds() {
        List<String> lines = new ArrayList<>();
        lines.add("{\"type\":\"hello\",\"version\":1,\"secret\":\"s\"}");
        lines.add("{\"type\":\"ping\",\"id\":17}");
        for (Bundle bundle : Samples.everyBundle()) {
            if (bundle instanceof DistanceBundle distances) {
                lines.add(JsonLines.write(new Reply(distances, List.of(Problem.of(3, "why")))));
            } else {
                lines.add(JsonLines.write(bundle));
            }
        }
        lines.add(JsonLines.write(BatchSamples.requests()));
        lines.add(JsonLines.write(new Reply(BatchSamples.answers(), List.of(Problem.of(5, "why")))));
        lines.add(JsonLines.write(BatchSamples.frames().get(0)));
        lines.add(JsonLines.write(new Reply(BatchSamples.frames().get(1))));
        lines.add(JsonLines.write(BatchSamples.pictures().get(0)));
        lines.add(JsonLines.write(new Reply(BatchSamples.pictures().get(1))));
        lines.add(JsonLines.write(BatchSamples.measures().get(0)));
        lines.add(JsonLines.write(BatchSamples.drives().get(0)));
        lines.add(JsonLines.write(new Reply(BatchSamples.measures().get(1))));
        lines.add(JsonLines.write(BatchSamples.world().get(0)));
        lines.add(JsonLines.write(new Reply(BatchSamples.world().get(1))));
        lines.add(JsonLines.write(BatchSamples.world().get(3)));
        lines.add(JsonLines.write(BatchSamples.world().get(3)).replaceFirst("\\{", "{\"answer\":true,"));
        lines.add(JsonLines.write(BatchSamples.obstacles().get(0)));
        lines.add(JsonLines.write(new Reply(BatchSamples.obstacles().get(1))));
        lines.add(JsonLines.write(BatchSamples.listed().get(0)));
        lines.add(JsonLines.write(BatchSamples.copies().get(0)));
        lines.add(JsonLines.write(new Reply(BatchSamples.copies().get(1))));
        lines.add("{\"type\":\"hello\",\"version\":1,\"resume\":\"\"}");
        lines.add(JsonLines.write(BatchSamples.walks()));
        lines.add(JsonLines.write(BatchSamples.attachments()));
        lines.add(JsonLines.write(BatchSamples.proofs().get(0)));
        lines.add(JsonLines.write(new Reply(BatchSamples.proofs().get(1))));
        lines.add(JsonLines.write(BatchSamples.rules().get(0)));
        lines.add(JsonLines.write(new Reply(BatchSamples.rules().get(1))));
        lines.add(JsonLines.write(BatchSamples.rules().get(2)));
        lines.add(JsonLines.write(StepSamples.later().get(0)));
        lines.add(JsonLines.write(new Reply(StepSamples.later().get(1))));
        lines.add(JsonLines.write(new Reply(BatchSamples.listed().get(1))));
        lines.add(JsonLines.write(new Reply(new MoveBundle(List.of()), List.of(Problem.of(0, "why")))));
        lines.add(lines.get(1) + "\n" + lines.get(4) + "\n" + lines.get(1));
        return lines.stream()
                .map(line -> (line + "\n").getBytes(StandardCharsets.UTF_8))
                .toList();
    }

    private static List<Bundle> readJava(byte[] bytes) throws IOException {
        List<Bundle> read = new ArrayList<>();
        MessageReader reader = new MessageReader(new ByteArrayInputStream(bytes));
        for (Bundle bundle = reader.read(); bundle != null; bundle = reader.read()) {
            read.add(bundle);
        }
        return read;
    }

    /** By what it seems to be: a conversation from its hello on, an answer, or what follows a hello. */
    private static List<Bundle> readJson(byte[] bytes) throws IOException {
        String text = new String(bytes, StandardCharsets.UTF_8);
        if (text.contains("\"hello\"")) {
            return speak(bytes);
        }
        if (text.contains("\"distances\"") || text.contains("\"answers\"") || text.contains("\"refused\"")) {
            Reply reply = JsonLines.readReply(text.endsWith("\n") ? text.substring(0, text.length() - 1) : text);
            assertThat(JsonLines.readReply(JsonLines.write(reply)).bundle()).isEqualTo(reply.bundle());
            return List.of();
        }
        byte[] greeted = new byte[HELLO.length + bytes.length];
        System.arraycopy(HELLO, 0, greeted, 0, HELLO.length);
        System.arraycopy(bytes, 0, greeted, HELLO.length, bytes.length);
        return speak(greeted);
    }

    private static List<Bundle> speak(byte[] bytes) throws IOException {
        List<Bundle> read = new ArrayList<>();
        MessageChannel channel = new MessageChannel(
                new ByteArrayInputStream(bytes),
                OutputStream.nullOutputStream(),
                MessageTranslator.RECORDS,
                MessagePace.NONE,
                PeerAdmission.OPEN);
        List<String> wrong = new ArrayList<>();
        channel.onWrongRequest(wrong::add);
        for (Bundle bundle = channel.read(); bundle != null; bundle = channel.read()) {
            read.add(bundle);
        }
        if (!wrong.isEmpty()) {
            throw new ProtocolException(wrong.get(0)); // it was answered, and the reading went on to the end
        }
        return read;
    }

    private static void judge(ProtocolException e) {
        assertThat(e.getMessage()).isNotBlank().doesNotContain("\n").hasSizeLessThan(2000);
    }

    /** Whether the bytes are understood; fails where anything but the protocol's exception comes of them. */
    boolean accepts(byte[] bytes) {
        List<Bundle> read = List.of();
        boolean accepted = false;
        long allocated = threads.getCurrentThreadAllocatedBytes();
        long time = threads.getCurrentThreadCpuTime();
        try {
            read = decoder.read(bytes);
            accepted = true;
        } catch (ProtocolException e) {
            judge(e);
        } catch (IOException e) {
            throw new AssertionError("only a ProtocolException may come", e);
        }
        time = threads.getCurrentThreadCpuTime() - time;
        allocated = threads.getCurrentThreadAllocatedBytes() - allocated;
        note(accepted, time, allocated);
        assertThat(time).as("nanoseconds").isLessThan(MOST_NANOS);
        assertThat(allocated).as("bytes allocated").isLessThan(MOST_BYTES);
        for (Bundle bundle : read) {
            meansTheSameAgain(bundle);
            bundles++;
        }
        return accepted;
    }

    private static void meansTheSameAgain(Bundle bundle) {
        try {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            new MessageWriter(bytes).write(bundle);
            assertThat(readJava(bytes.toByteArray())).containsExactly(bundle);
            if (bundle instanceof BatchAnswerBundle || bundle instanceof StepBundle.Answer) {
                assertThat(JsonLines.readReply(JsonLines.write(new Reply(bundle)))
                                .bundle())
                        .isEqualTo(bundle);
            } else if (!(bundle instanceof DistanceBundle)) {
                assertThat(JsonLines.readRequest(JsonLines.write(bundle))).isEqualTo(bundle);
            }
        } catch (ProtocolException e) {
            // What only one of the encodings can say: half a surrogate pair, one more level of groups.
            assertThat(e.getMessage()).containsAnyOf("surrogate", "nesting", "parts", "65535");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void note(boolean accepted, long nanos, long bytes) {
        inputs++;
        understood += accepted ? 1 : 0;
        slowestNanos = Math.max(slowestNanos, nanos);
        largestBytes = Math.max(largestBytes, bytes);
        if (inputs % 50_000 == 0) {
            write();
        }
    }

    /** The figures so far, for who runs a million. */
    private void write() {
        String line = String.format(
                Locale.ROOT,
                "%s: %,d inputs, %,d understood (%,d bundles), slowest %.1f ms, most memory %.1f MB%n",
                name,
                inputs,
                understood,
                bundles,
                slowestNanos / 1e6,
                largestBytes / 1e6);
        try {
            Path folder = Files.createDirectories(Path.of("target", "fuzz"));
            Files.writeString(folder.resolve(name + ".txt"), line);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
