package robosim.geometry.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;

/** Each limit is itself allowed, and what is next to it is not; a message tells the value. */
class ChecksTest {
    private static final double MOST = Checks.LIMIT;
    private static final double MORE = Math.nextUp(Checks.LIMIT);

    private static void refused(ThrowingCallable call, String... words) {
        assertThatIllegalArgumentException().isThrownBy(call).withMessageContainingAll(words);
    }

    @Test
    void coordinatesSizesAndAngles() {
        assertThat(Checks.coordinate("x", MOST)).isEqualTo(MOST);
        assertThat(Checks.coordinate("x", -MOST)).isEqualTo(-MOST);
        assertThat(1 / Checks.coordinate("x", -0.0)).isPositive();
        for (double bad : new double[] {MORE, -MORE, Double.NaN, Double.POSITIVE_INFINITY}) {
            refused(() -> Checks.coordinate("x", bad), "x must be", "(got: " + bad + ")");
            refused(() -> Checks.radians("turn", bad), "turn must be", "(got: " + bad + ")");
        }
        assertThatCode(() -> Checks.radians("turn", -MOST)).doesNotThrowAnyException();
        assertThat(Checks.size("radius", 0)).isZero();
        assertThat(1 / Checks.size("radius", -0.0)).isPositive();
        assertThat(Checks.size("radius", MOST)).isEqualTo(MOST);
        assertThat(Checks.clearance(0)).isZero();
        assertThat(Checks.clearance(MOST)).isEqualTo(MOST);
        for (double bad : new double[] {-Double.MIN_VALUE, MORE, Double.NaN}) {
            refused(() -> Checks.size("radius", bad), "radius must be", "(got: " + bad + ")");
            refused(() -> Checks.clearance(bad), "clearance must be", "(got: " + bad + ")");
        }
        assertThat(Checks.worldSize("width", Double.MIN_VALUE)).isEqualTo(Double.MIN_VALUE);
        assertThat(Checks.worldSize("width", 2 * MOST)).isEqualTo(2 * MOST);
        for (double bad : new double[] {0, Math.nextUp(2 * MOST), Double.NaN}) {
            refused(() -> Checks.worldSize("width", bad), "width must be", "(got: " + bad + ")");
        }
        assertThat(Checks.angle("ry", 1e300)).isEqualTo(1e300);
        assertThat(1 / Checks.angle("ry", -0.0)).isPositive();
        refused(() -> Checks.angle("ry", Double.NEGATIVE_INFINITY), "ry must be", "-Infinity");
    }

    @Test
    void rangesAndBeams() {
        assertThatCode(() -> Checks.range(0, 0)).doesNotThrowAnyException();
        assertThatCode(() -> Checks.range(MOST, Double.POSITIVE_INFINITY)).doesNotThrowAnyException();
        refused(() -> Checks.range(-Double.MIN_VALUE, 1), "min must be");
        refused(() -> Checks.range(MORE, Double.POSITIVE_INFINITY), "min must be");
        refused(() -> Checks.range(2, Math.nextDown(2.0)), "max must be at least min, 2.0");
        refused(() -> Checks.range(2, Double.NaN), "max must be", "NaN");
        assertThat(Checks.width(0)).isZero();
        assertThat(Checks.width(Math.nextDown(180.0))).isLessThan(180);
        for (double bad : new double[] {-Double.MIN_VALUE, 180, Double.NaN}) {
            refused(() -> Checks.width(bad), "width must be", "(got: " + bad + ")");
        }
    }

    @Test
    void wholeNumbersAndTimes() {
        assertThat(Checks.count(0)).isZero();
        refused(() -> Checks.count(-1), "count must be", "(got: -1)");
        assertThat(Checks.port(1, 1)).isEqualTo(1);
        assertThat(Checks.port(65535, 0)).isEqualTo(65535);
        refused(() -> Checks.port(0, 1), "port must be 1 to 65535 (got: 0)");
        refused(() -> Checks.port(65536, 1), "(got: 65536)");
        assertThatCode(() -> Checks.atLeastOne("threads", 1)).doesNotThrowAnyException();
        refused(() -> Checks.atLeastOne("threads", 0), "threads must be at least 1 (got: 0)");
        Duration day = Duration.ofDays(1);
        assertThatCode(() -> Checks.time("silence", Duration.ofMillis(1), day)).doesNotThrowAnyException();
        assertThatCode(() -> Checks.time("silence", day, day)).doesNotThrowAnyException();
        refused(() -> Checks.time("silence", Duration.ofNanos(999_999), day), "silence must be");
        refused(() -> Checks.time("silence", day.plusNanos(1), day), "silence must be");
    }

    @Test
    void namesAndLists() {
        assertThat(Checks.name("a")).isEqualTo("a");
        refused(() -> Checks.name(" \t"), "name must have a visible character");
        List<String> some = new ArrayList<>(List.of("a", "b"));
        List<String> copy = Checks.list("names", some);
        List<String> typed = Checks.copy("names", some, String.class);
        some.set(0, "c");
        assertThat(copy).containsExactly("a", "b");
        assertThat(typed).containsExactly("a", "b");
        refused(() -> Checks.list("names", Arrays.asList("a", null)), "names[1] must be given (got: null)");
        refused(() -> Checks.list("names", null), "names must be given");
        refused(() -> Checks.copy("names", Arrays.asList("a", "b", null), String.class), "names[2] must be given");
        @SuppressWarnings({"unchecked", "rawtypes"}) // as what was deserialized may be
        List<String> other = (List) List.of("a", 7);
        refused(() -> Checks.copy("names", other, String.class), "names[1] must be a String", "java.lang.Integer");
    }
}
