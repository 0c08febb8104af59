package robosim.geometry.limits;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Some 20,000 messages with faults in them, the same in every build; {@code -Pfuzz} tries a million of each decoder. */
@Tag("slow")
@Timeout(120)
class MutationTest {
    private static final int INPUTS = 10_000;

    private static final List<byte[]> JAVA_WORDS = Stream.of(
                    "pqrstuvwxyz{|}~",
                    "\u0000\u0000\u0000\u0000",
                    "\u007f\u00ff\u00ff\u00ff",
                    "\u00ff\u00ff\u00ff\u00ff",
                    "\u0000\u000f\u0042\u0040",
                    "\u007f\u00f8\u0000\u0000\u0000\u0000\u0000\u0000",
                    "q\u0000~\u0000\u0000",
                    "t\u0000\u0003abc",
                    "w\u0004\u0000\u0000\u0000\u0001",
                    "sr\u0000\u0011java.util.HashSet",
                    "ur\u0000\u0002[D")
            .map(word -> word.getBytes(StandardCharsets.ISO_8859_1))
            .toList();

    private static final List<byte[]> JSON_WORDS = Stream.of(
                    "{",
                    "}",
                    "[",
                    "]",
                    ",",
                    ":",
                    "\"",
                    "\\",
                    "\n",
                    "\r\n",
                    "\t",
                    " ",
                    "null",
                    "true",
                    "NaN",
                    "-",
                    "1e999",
                    "1e-999",
                    "-0.0",
                    "0.1",
                    "1267650600228229401496703205377",
                    "\\u0000",
                    "\\ud83e",
                    "\u00e9",
                    "\u0000",
                    "\"type\":",
                    "\"hello\"",
                    "\"objects\":[",
                    "\"kind\":\"group\",\"members\":[{",
                    "\"solid\":true,",
                    "\"boundingVolume\":{",
                    "\"x\":1,",
                    "/**/",
                    "'")
            .map(word -> word.getBytes(StandardCharsets.UTF_8))
            .toList();

    @Test
    void faultyJavaSerializationIsRefusedInOrder() {
        mutate(Hostile.javaSerialization(), Hostile.javaSeeds(), JAVA_WORDS);
    }

    @Test
    void faultyJsonLinesAreRefusedInOrder() {
        mutate(Hostile.jsonLines(), Hostile.jsonSeeds(), JSON_WORDS);
    }

    private static void mutate(Hostile decoder, List<byte[]> seeds, List<byte[]> words) {
        SplittableRandom random = new SplittableRandom(20261121);
        int accepted = 0;
        for (int k = 0; k < INPUTS; k++) {
            byte[] bytes = seeds.get(random.nextInt(seeds.size()));
            for (int changes = random.nextInt(3); changes >= 0; changes--) {
                bytes = change(bytes, seeds, words, random);
            }
            accepted += decoder.accepts(bytes) ? 1 : 0;
        }
        // All refused would mean that nothing was looked into, all accepted that nothing was changed.
        assertThat(accepted).isBetween(INPUTS / 100, INPUTS / 2);
    }

    private static byte[] change(byte[] bytes, List<byte[]> seeds, List<byte[]> words, SplittableRandom random) {
        if (bytes.length == 0) {
            return words.get(random.nextInt(words.size()));
        }
        byte[] changed = bytes.clone();
        int at = random.nextInt(bytes.length);
        int to = Math.min(bytes.length, at + 1 + random.nextInt(40));
        return switch (random.nextInt(9)) {
            case 0, 1 -> {
                changed[at] = (byte) random.nextInt(256);
                yield changed;
            }
            case 2 -> {
                changed[at] ^= (byte) (1 << random.nextInt(8));
                yield changed;
            }
            case 7 -> {
                while (at < bytes.length - 1 && !Character.isDigit(bytes[at])) {
                    at++;
                }
                changed[at] = (byte) ('0' + random.nextInt(10));
                yield changed;
            }
            case 3 -> splice(bytes, at, words.get(random.nextInt(words.size())), at);
            case 4 -> splice(bytes, at, words.get(random.nextInt(words.size())), to);
            case 5 -> splice(bytes, to, Arrays.copyOfRange(bytes, at, to), to);
            case 6 -> splice(bytes, at, new byte[0], to);
            default -> {
                byte[] other = seeds.get(random.nextInt(seeds.size()));
                int from = random.nextInt(other.length);
                yield splice(bytes, at, Arrays.copyOfRange(other, from, other.length), bytes.length);
            }
        };
    }

    /** The bytes before one place, then others, then the bytes from another place on. */
    private static byte[] splice(byte[] bytes, int end, byte[] middle, int start) {
        ByteArrayOutputStream spliced = new ByteArrayOutputStream();
        spliced.write(bytes, 0, end);
        spliced.writeBytes(middle);
        spliced.write(bytes, start, bytes.length - start);
        return spliced.toByteArray();
    }
}
