package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.bench.Answers;
import robosim.geometry.bench.Digest;

/** The same bits with and without the compilers, and on every JDK that runs this test. */
@Tag("slow")
class DigestTest {
    private static final int ANSWERS = 20_000;
    private static final String DIGEST = Digest.of(ANSWERS);

    /** An ordinary build has only the JVM's first compiler here, as the pom says. */
    @Test
    void withTheOptimisingCompilerAlone() throws IOException {
        assertThat(Answers.run(
                        List.of("-XX:-TieredCompilation", "-Xbatch", "-XX:+UseSerialGC"),
                        Digest.class,
                        List.of("" + ANSWERS)))
                .isEqualToIgnoringNewLines(DIGEST);
    }

    @Test
    void interpreted() throws IOException {
        assertThat(Answers.run(List.of("-Xint", "-XX:+UseSerialGC"), Digest.class, List.of("300")))
                .isEqualToIgnoringNewLines(Digest.of(300));
    }

    /** Where answers are meant to change, {@code Digest 20000} tells the new number. */
    @Test
    void onEveryJdk() throws IOException {
        try (InputStream in = DigestTest.class.getResourceAsStream("digest.txt")) {
            assertThat(in).isNotNull();
            String stored = new String(in.readAllBytes(), StandardCharsets.UTF_8).strip();
            assertThat(DIGEST).isEqualTo(stored);
        }
        assertThat(Digest.of(1001)).isNotEqualTo(Digest.of(1000));
    }
}
