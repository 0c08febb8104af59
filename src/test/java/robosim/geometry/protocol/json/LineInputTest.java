package robosim.geometry.protocol.json;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.pace.MessagePace;

/** Lines as they come from a stream: where each stands in the buffer, and which of its bytes is told to be wrong. */
class LineInputTest {
    private static LineInput over(String text) {
        return new LineInput(new ByteArrayInputStream(text.getBytes(StandardCharsets.ISO_8859_1)), MessagePace.NONE);
    }

    private static String line(LineInput in) throws IOException {
        assertThat(in.await(100)).isTrue();
        return new String(in.buffer(), in.start(), in.length(), StandardCharsets.ISO_8859_1);
    }

    @Test
    void linesAreCountedFromOne() throws IOException {
        LineInput in = over("one\n\nthird\n");
        assertThat(line(in)).isEqualTo("one");
        assertThat(line(in)).isEmpty();
        assertThat(line(in)).isEqualTo("third");
        assertThat(in.number()).isEqualTo(3);
        assertThat(in.count()).isEqualTo(5);
        assertThat(in.await(100)).isFalse();
    }

    /** Bytes are counted from 1 within their own line, whatever came before it. */
    @Test
    void whatIsNoTextIsToldByItsByte() throws IOException {
        LineInput in = over("first line\nab\u0007d\n");
        line(in);
        assertThatThrownBy(() -> in.await(100))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("(got: 07 in byte 3)");
        LineInput broken = over("first line\nabc\u00ff\n");
        line(broken);
        assertThatThrownBy(() -> broken.await(100))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("other bytes at byte 4");
        LineInput marked = over("first line\n\u00ef\u00bb\u00bfx\n");
        line(marked);
        assertThatThrownBy(() -> marked.await(100)).hasMessageContaining("byte order mark");
        LineInput allowed = over("\t \u007f\r\n");
        assertThat(line(allowed)).isEqualTo("\t \u007f\r");
    }

    @Test
    void aLineOfTheMostBytesIsRead() throws IOException {
        assertThat(line(over("x".repeat(100) + "\n"))).hasSize(100);
        assertThatThrownBy(() -> over("x".repeat(101) + "\n").await(100))
                .hasMessageContaining("a line must have at most 100 bytes");
    }

    /** A secret that was in a line is nowhere in the buffer afterwards; the lines behind it are. */
    @Test
    void aLineThatIsWipedIsGone() throws IOException {
        LineInput in = over("before\nsecret\nafter\n");
        line(in);
        line(in);
        in.wipe();
        String all = new String(Arrays.copyOf(in.buffer(), 40), StandardCharsets.ISO_8859_1);
        assertThat(all).contains("before\n").doesNotContain("s", "c").contains("\nafter");
        assertThat(line(in)).isEqualTo("after");
    }
}
