package robosim.geometry.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NearNamesTest {
    private static final List<String> NAMES =
            List.of("robot cow", "drum 1", "drum 2", "cart 1", "wall", "front_laser", "x");

    @ParameterizedTest
    @CsvSource(delimiter = '|', nullValues = "none", textBlock = """
                    robot        | robot cow
                    drum1        | drum 1;drum 2
                    Cart 1       | cart 1
                    walls        | wall
                    wlal         | wall
                    frontlaser   | front_laser
                    front laser  | front_laser
                    y            | x
                    nobody       | none
                    rover        | none
                    """)
    void theClosestAreFound(String given, String near) {
        assertThat(String.join(";", NearNames.of(given, NAMES))).isEqualTo(near == null ? "" : near);
    }

    @Test
    void atMostThreeTheClosestFirst() {
        List<String> many = IntStream.range(0, 500).mapToObj(k -> "robot " + k).toList();
        assertThat(NearNames.of("robot 30x", many)).containsExactly("robot 30", "robot 300", "robot 301");
        assertThat(NearNames.of("", many)).isEmpty();
        assertThat(NearNames.of("robot", List.of())).isEmpty();
    }
}
