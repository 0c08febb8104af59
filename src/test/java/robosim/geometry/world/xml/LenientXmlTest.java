package robosim.geometry.world.xml;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LenientXmlTest {
    private static byte[] mended(byte[] bytes) throws IOException {
        try (LenientXml in = new LenientXml(new ByteArrayInputStream(bytes))) {
            return in.readAllBytes();
        }
    }

    private static String mended(String text) throws IOException {
        return new String(mended(text.getBytes(StandardCharsets.UTF_8)), StandardCharsets.UTF_8);
    }

    /** Parts of documents with nothing to mend, of which any sequence has nothing to mend. */
    private static final List<String> RIGHT = List.of(
            "<a b=\"-- '\" c='&lt;'>",
            "</a>",
            "<!-- - & < ' -->",
            "<![CDATA[ & -- <!-- ]] > ]]>",
            "<?p & -- ?>",
            "&amp;&#10;&#xfF;",
            "text -- \r\n",
            "\u00e9\u20ac\ud83d\ude00",
            "]",
            "-",
            "\n");

    @Test
    void whatIsRightStays() throws IOException {
        SplittableRandom random = new SplittableRandom(1);
        for (int k = 0; k < 2000; k++) {
            StringBuilder text = new StringBuilder(random.nextBoolean() ? "<?xml version='1.0'?>" : "\ufeff<a>");
            for (int n = random.nextInt(40); n >= 0; n--) {
                text.append(RIGHT.get(random.nextInt(RIGHT.size())));
            }
            text.append("x".repeat(random.nextInt(20_000)));
            assertThat(mended(text.toString())).isEqualTo(text.toString());
        }
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '^',
            value = {
                "a & b &c &; &#; &x;,a &amp; b &amp;c &amp;; &amp;#; &x;",
                "<a b='&'/>&,<a b='&amp;'/>&amp;",
                "<a b='<C>' c=\"<'>\"/>,<a b='&lt;C>' c=\"&lt;'>\"/>",
                "<a b='<C>/>,<a b='<C>/>",
                "<!----><!-- a---b --->,<!----><!-- a  -b  -->",
                "<!-- -- <?xml ?> & -->,<!--  - <?xml ?> & -->",
                "^ <?xml a='é'?>b^,^               b^",
                "<a><?xml b?>,<a><?xml b?>",
                "<!-- --,<!-- ^ ^-"
            })
    void whatIsMended(String text, String result) throws IOException {
        assertThat(mended(text)).isEqualTo(result.replace("^", ""));
    }

    @Test
    void bytesThatAreNoUtf8() throws IOException {
        SplittableRandom random = new SplittableRandom(2);
        int valid = 0;
        for (int k = 0; k < 20_000; k++) {
            byte[] bytes = new byte[6];
            for (int n = 0; n < bytes.length; n++) {
                // Mostly bytes of characters of several.
                bytes[n] = (byte) (random.nextInt(3) == 0 ? random.nextInt('a', 'z') : random.nextInt(0x80, 0x100));
            }
            if (bytes[0] < 0 && bytes[1] < 0) {
                bytes[0] = 'a'; // not the mark of UTF-16
            }
            String read = new String(bytes, StandardCharsets.UTF_8);
            byte[] result = mended(bytes);
            assertThat(result).hasSameSizeAs(bytes);
            if (!read.contains("\ufffd")) {
                assertThat(result).isEqualTo(bytes);
                valid++;
            } else {
                String mended = new String(result, StandardCharsets.UTF_8);
                assertThat(mended).contains("?").doesNotContain("\ufffd");
            }
        }
        assertThat(valid).isBetween(100, 19_000);
    }

    @Test
    void otherEncodingsStay() throws IOException {
        for (String name : List.of("UTF-16", "UTF-16LE", "UTF-16BE")) {
            byte[] bytes = "<a>--&<!-- -- --></a>".getBytes(Charset.forName(name));
            assertThat(mended(bytes)).isEqualTo(bytes);
        }
        byte[] latin =
                "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><a>\u00fc</a>".getBytes(StandardCharsets.ISO_8859_1);
        assertThat(mended(latin)).isEqualTo(latin);
    }
}
