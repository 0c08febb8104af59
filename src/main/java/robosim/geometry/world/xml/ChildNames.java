package robosim.geometry.world.xml;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/** By element, the names of some of its children. */
public final class ChildNames {
    private final Map<String, Set<String>> children = new TreeMap<>();

    /** A table: on each line the names of elements, a colon and the names of children, which all of these elements have. */
    public ChildNames(String table) {
        for (String line : table.strip().split("\n", -1)) {
            String[] sides = line.split(":", -1);
            Set<String> names = sides[1].isBlank() ? Set.of() : words(sides[1]);
            words(sides[0])
                    .forEach(each ->
                            children.computeIfAbsent(each, k -> new HashSet<>()).addAll(names));
        }
    }

    /** Words between spaces, each once. */
    public static Set<String> words(String text) {
        return Set.copyOf(Arrays.asList(text.strip().split("\\s+", -1)));
    }

    /** Whether the table has the element. */
    public boolean has(String element) {
        return children.containsKey(element);
    }

    /** The children of an element; none if the table does not have it. */
    public Set<String> of(String element) {
        return children.getOrDefault(element, Set.of());
    }
}
