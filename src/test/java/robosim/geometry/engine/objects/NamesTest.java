package robosim.geometry.engine.objects;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class NamesTest {
    /** Strings of two letter pairs, "Aa" and "BB", that have one hash code each length: all of them stand in one heap. */
    private static String colliding(int k, int pairs) {
        StringBuilder name = new StringBuilder();
        for (int bit = 0; bit < pairs; bit++) {
            name.append((k >> bit & 1) == 0 ? "Aa" : "BB");
        }
        return name.toString();
    }

    @Test
    void knowsWhatAMapKnows() {
        SplittableRandom random = new SplittableRandom(5);
        Names names = new Names();
        Map<String, Integer> map = new HashMap<>();
        int known = 0;
        int steps = 40_000;
        for (int step = 0; step < steps; step++) {
            int k = random.nextInt(300);
            // Another string of the same letters each time: equal, and not the same.
            String name = k % 2 == 0 ? "robot " + k : colliding(k, 9);
            assertThat(names.find(name)).as(name).isEqualTo(map.getOrDefault(name, -1));
            if (map.containsKey(name)) {
                known++;
                if (random.nextBoolean()) {
                    names.remove(name);
                    map.remove(name);
                }
            } else {
                names.put(name, step);
                map.put(name, step);
            }
        }
        assertThat(known).isBetween(steps / 4, steps * 3 / 4);
        map.forEach((name, id) -> assertThat(names.find(name)).as(name).isEqualTo(id));
    }
}
