package robosim.geometry.world.mesh;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Numbers;

/** An object of a glTF file's JSON, with its path, such as {@code meshes[2].primitives[0]}, for messages. */
final class GltfPart {
    final String path;
    private final String source;
    private final Map<?, ?> values;

    private GltfPart(String source, String path, Map<?, ?> values) {
        this.source = source;
        this.path = path;
        this.values = values;
    }

    static GltfPart root(String source, @Nullable Object json) throws FileProblem {
        if (json instanceof Map<?, ?> values) {
            return new GltfPart(source, "", values);
        }
        throw new FileProblem(source, "a glTF file must be one object, which begins with { (got: another value)");
    }

    boolean has(String name) {
        return values.get(name) != null;
    }

    private String path(String name) {
        return path.isEmpty() ? name : path + "." + name;
    }

    /** An object of this one; null if there is none. */
    @Nullable
    GltfPart child(String name) throws FileProblem {
        Object value = values.get(name);
        if (value == null) {
            return null;
        }
        if (value instanceof Map<?, ?> object) {
            return new GltfPart(source, path(name), object);
        }
        throw wrong(name, "must be an object (got: another value)");
    }

    GltfPart required(String name) throws FileProblem {
        GltfPart child = child(name);
        if (child == null) {
            throw wrong(name, "must be there (got: none)");
        }
        return child;
    }

    private List<?> list(String name) throws FileProblem {
        Object value = values.get(name);
        if (value == null) {
            return List.of();
        }
        if (value instanceof List<?> list) {
            return list;
        }
        throw wrong(name, "must be a list (got: another value)");
    }

    /** How many values a list has; 0 if there is none. */
    int size(String name) throws FileProblem {
        return list(name).size();
    }

    /** An object of a list, which must have it. */
    GltfPart item(String name, int index) throws FileProblem {
        List<?> list = list(name);
        if (index < 0 || index >= list.size()) {
            throw wrong(name, "must have one of number " + index + " (got: " + list.size() + ", counted from 0)");
        }
        if (list.get(index) instanceof Map<?, ?> object) {
            return new GltfPart(source, path(name) + "[" + index + "]", object);
        }
        throw wrong(name + "[" + index + "]", "must be an object (got: another value)");
    }

    /** The names of a list of texts. */
    List<String> texts(String name) throws FileProblem {
        List<String> texts = new ArrayList<>();
        for (Object each : list(name)) {
            texts.add(String.valueOf(each));
        }
        return texts;
    }

    /** The names of an object's values. */
    List<String> names() {
        List<String> names = new ArrayList<>();
        for (Object each : values.keySet()) {
            names.add(String.valueOf(each));
        }
        return names;
    }

    /** A list of numbers of this size; the other one if there is none. */
    double[] numbers(String name, double... otherwise) throws FileProblem {
        List<?> list = list(name);
        if (!has(name)) {
            return otherwise;
        }
        if (list.size() != otherwise.length) {
            throw wrong(name, "must have " + otherwise.length + " numbers (got: " + list.size() + ")");
        }
        double[] numbers = new double[list.size()];
        for (int k = 0; k < numbers.length; k++) {
            if (!(list.get(k) instanceof Double number)) {
                throw wrong(name, "must have only numbers (got: another value)");
            }
            numbers[k] = number;
        }
        return numbers;
    }

    /** A number; another one if it was left out. */
    double number(String name, double otherwise) throws FileProblem {
        Object value = values.get(name);
        if (value == null) {
            return otherwise;
        }
        if (value instanceof Double number) {
            return number;
        }
        throw wrong(name, "must be a number (got: another value)");
    }

    /** A list of indices. */
    int[] indices(String name) throws FileProblem {
        List<?> list = list(name);
        int[] indices = new int[list.size()];
        for (int k = 0; k < indices.length; k++) {
            indices[k] = whole(name + "[" + k + "]", list.get(k), Integer.MAX_VALUE);
        }
        return indices;
    }

    /** A whole number of at least 0, which must be there. */
    int whole(String name) throws FileProblem {
        return whole(name, values.get(name), Integer.MAX_VALUE);
    }

    /** A whole number of at least 0; another one if it was left out. */
    int whole(String name, int otherwise) throws FileProblem {
        return has(name) ? whole(name) : otherwise;
    }

    private int whole(String name, @Nullable Object value, int most) throws FileProblem {
        if (value instanceof Double number && number >= 0 && number <= most && number == Math.rint(number)) {
            return number.intValue();
        }
        throw wrong(
                name,
                "must be a whole number of at least 0 (got: "
                        + (value == null ? "none" : Numbers.shown(String.valueOf(value))) + ")");
    }

    /** A text; empty if there is none. */
    String text(String name) {
        return values.get(name) instanceof String text ? text : "";
    }

    boolean isTrue(String name) {
        return Boolean.TRUE.equals(values.get(name));
    }

    private FileProblem wrong(String name, String problem) {
        return new FileProblem(source, path(name) + " " + problem);
    }

    /** What is wrong with this part. */
    FileProblem wrong(String problem) {
        return new FileProblem(source, path + ": " + problem);
    }
}
