package robosim.geometry.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectOutputStream;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.protocol.pace.MessagePace;

public class MessageTest {
    @Test
    void everyBundleComesBackAsItWas() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        MessageWriter writer = new MessageWriter(bytes);
        for (int round = 0; round < 3; round++) {
            for (Bundle bundle : Samples.everyBundle()) {
                writer.write(bundle);
            }
        }
        MessageReader reader = new MessageReader(new ByteArrayInputStream(bytes.toByteArray()));
        for (int round = 0; round < 3; round++) {
            for (Bundle bundle : Samples.everyBundle()) {
                Bundle read = reader.read();
                assertThat(read).isEqualTo(bundle);
                assertThat(read).hasToString(bundle.toString());
                assertThat(reader.messageBytes()).isPositive();
            }
        }
        assertThat(reader.read()).isNull();
    }

    @Test
    void shapesKeepEveryBit() throws IOException {
        InitBundle read = (InitBundle)
                readAll(write(new InitBundle(Samples.everyShape()))).get(0);
        for (int k = 0; k < read.objects().size(); k++) {
            GeometryObject was = Samples.everyShape().get(k);
            GeometryObject is = read.objects().get(k);
            assertThat(is).isEqualTo(was);
            assertThat(is.rotation()).containsExactly(was.rotation());
            assertThat(is.heading()).isEqualTo(was.heading());
            assertThat(is.turned(0, 0.1)).as("the heading's lost rounding").isEqualTo(was.turned(0, 0.1));
        }
    }

    @Test
    void headerIsFlushedBeforeAnythingIsRead() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        new MessageWriter(bytes);
        assertThat(bytes.toByteArray()).containsExactly(0xAC, 0xED, 0x00, 0x05);
        new MessageReader(new InputStream() {
            @Override
            public int read() {
                throw new AssertionError("read too early");
            }
        });
    }

    @Test
    void bytesThatComeOneByOneAreAMessageToo() throws IOException {
        byte[] bytes = write(Samples.everyBundle().toArray(Bundle[]::new));
        InputStream dripping = new ByteArrayInputStream(bytes) {
            @Override
            public synchronized int read(byte[] into, int at, int length) {
                return super.read(into, at, Math.min(1, length));
            }
        };
        MessageReader reader = new MessageReader(dripping);
        for (Bundle bundle : Samples.everyBundle()) {
            assertThat(reader.read()).isEqualTo(bundle);
        }
        assertThat(reader.read()).isNull();
    }

    @Test
    void aSenderThatNeverResetsIsUnderstood() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            for (Bundle bundle : Samples.everyBundle()) {
                out.writeObject(bundle);
                out.writeObject(bundle);
            }
        }
        List<Bundle> read = readAll(bytes.toByteArray());
        assertThat(read).hasSize(2 * Samples.everyBundle().size());
        for (int k = 0; k < read.size(); k++) {
            assertThat(read.get(k)).isEqualTo(Samples.everyBundle().get(k / 2));
        }
    }

    /** The pace hears of idleness while a reset, but no message, is in sight. */
    @Test
    void paceTellsBetweenFromInside() throws IOException {
        List<String> heard = new ArrayList<>();
        MessagePace pace = new MessagePace() {
            @Override
            public void idle() {
                heard.add("idle");
            }

            @Override
            public void begun() {
                heard.add("begun");
            }
        };
        byte[] bytes = write(new MoveBundle(List.of()), new MoveBundle(List.of()));
        InputStream loud = new ByteArrayInputStream(bytes) {
            @Override
            public synchronized int read(byte[] into, int at, int length) {
                heard.add("byte");
                return super.read(into, at, Math.min(1, length));
            }
        };
        MessageReader reader = new MessageReader(loud, MessageTranslator.RECORDS, pace);
        while (reader.read() != null) {
            heard.add("message");
        }
        String story = String.join(" ", heard).replaceAll("byte( byte)*", "bytes");
        assertThat(story)
                .isEqualTo("idle bytes begun bytes idle bytes begun bytes message"
                        + " idle bytes begun bytes message idle bytes");
    }

    public static byte[] write(Bundle... bundles) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        MessageWriter writer = new MessageWriter(bytes);
        for (Bundle bundle : bundles) {
            writer.write(bundle);
        }
        return bytes.toByteArray();
    }

    public static List<Bundle> readAll(byte[] bytes) throws IOException {
        MessageReader reader = new MessageReader(new ByteArrayInputStream(bytes));
        List<Bundle> read = new ArrayList<>();
        for (Bundle bundle = reader.read(); bundle != null; bundle = reader.read()) {
            read.add(bundle);
        }
        return read;
    }
}
