package robosim.geometry.limits;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.Effort;

/** Files of other programs with random faults: bytes changed, cut off, repeated, and numbers that are far too large. */
@Tag("slow")
@Timeout(120)
class FilesWithFaultsTest {
    private static final String[] NUMBERS = {
        "0",
        "-1",
        "1",
        "3",
        "255",
        "65536",
        "2147483647",
        "2147483648",
        "4294967295",
        "9999999999999999999",
        "1e308",
        "1e-320",
        "nan",
        "0.5"
    };

    @TempDir
    Path folder;

    @Test
    void areReadOrRefused() {
        SplittableRandom random = new SplittableRandom(22_004);
        HostileFiles readers = new HostileFiles(folder);
        List<byte[]> seeds = HostileFiles.seeds();
        for (byte[] seed : seeds) {
            assertThat(readers.accepts(seed)).as("format %d", seed[0]).isTrue();
        }
        int count = Integer.getInteger("faults", Effort.cases(4000));
        int whole = 0;
        for (int k = 0; k < count; k++) {
            byte[] bytes = seeds.get(k % seeds.size());
            for (int n = random.nextInt(3); n >= 0; n--) {
                bytes = changed(bytes, random);
            }
            byte[] input = bytes;
            try {
                whole += readers.accepts(input) ? 1 : 0;
            } catch (RuntimeException | AssertionError | StackOverflowError e) {
                throw new AssertionError(
                        "case " + k + ", format " + input[0] + ": "
                                + new String(input, 1, input.length - 1, StandardCharsets.ISO_8859_1),
                        e);
            }
        }
        assertThat(whole).as("a sample of refusals alone proves little").isBetween(count / 20, count * 19 / 20);
    }

    private static byte[] changed(byte[] bytes, SplittableRandom random) {
        if (bytes.length < 3) {
            return bytes;
        }
        int at = 1 + random.nextInt(bytes.length - 1);
        switch (random.nextInt(5)) {
            case 0 -> {
                return Arrays.copyOf(bytes, at);
            }
            case 1 -> {
                byte[] changed = bytes.clone();
                changed[at] = (byte) random.nextInt(256);
                return changed;
            }
            case 2 -> {
                byte[] changed = bytes.clone();
                changed[at] ^= (byte) (1 << random.nextInt(8));
                return changed;
            }
            case 3 -> {
                int length = Math.min(1 + random.nextInt(40), bytes.length - at);
                return replaced(bytes, at, 0, Arrays.copyOfRange(bytes, at, at + length));
            }
            default -> {
                int end = at;
                while (end < bytes.length && (Character.isDigit(bytes[end]) || bytes[end] == '.')) {
                    end++;
                }
                byte[] number = NUMBERS[random.nextInt(NUMBERS.length)].getBytes(StandardCharsets.US_ASCII);
                return end > at ? replaced(bytes, at, end - at, number) : bytes;
            }
        }
    }

    private static byte[] replaced(byte[] bytes, int at, int length, byte[] by) {
        byte[] changed = new byte[bytes.length - length + by.length];
        System.arraycopy(bytes, 0, changed, 0, at);
        System.arraycopy(by, 0, changed, at, by.length);
        System.arraycopy(bytes, at + length, changed, at + by.length, bytes.length - at - length);
        return changed;
    }
}
