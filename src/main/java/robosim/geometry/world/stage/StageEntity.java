package robosim.geometry.world.stage;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Numbers;

/** An entity of a Stage world: its type, its properties, and the entities within it. */
final class StageEntity {
    final String type;
    final Path file;
    final int line;
    final Map<String, List<String>> properties = new HashMap<>();
    final List<StageEntity> children = new ArrayList<>(2);

    StageEntity(String type, Path file, int line) {
        this.type = type;
        this.file = file;
        this.line = line;
    }

    boolean has(String property) {
        return properties.containsKey(property);
    }

    /** A property as one text; another one if it was left out. */
    String text(String property, String otherwise) {
        List<String> values = properties.get(property);
        return values == null || values.isEmpty() ? otherwise : values.get(0);
    }

    double number(String property, double otherwise) throws FileProblem {
        return numbers(property, otherwise)[0];
    }

    /** A property as numbers; those that it leaves out at its end, or all of them, are the other ones. */
    double[] numbers(String property, double... otherwise) throws FileProblem {
        List<String> values = properties.getOrDefault(property, List.of());
        double[] numbers = otherwise.clone();
        for (int k = 0; k < Math.min(values.size(), numbers.length); k++) {
            try {
                numbers[k] = Numbers.parse(values.get(k));
            } catch (IllegalArgumentException e) {
                throw wrong(property + ": " + e.getMessage());
            }
        }
        return numbers;
    }

    /** How many values a property has; as many as it needs if it was left out. */
    int count(String property, int needed) {
        List<String> values = properties.get(property);
        return values == null ? needed : values.size();
    }

    FileProblem wrong(String problem) {
        return new FileProblem(file.toString(), line, 0, problem);
    }
}
