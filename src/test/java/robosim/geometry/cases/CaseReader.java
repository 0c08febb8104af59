package robosim.geometry.cases;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.snakeyaml.engine.v2.api.Load;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.schema.FailsafeSchema;
import robosim.geometry.cases.HardCase.Question;
import robosim.geometry.model.GeometryObject;

/** Reads the files of hard cases. Every scalar is read as text, so that a number is the nearest double of what it says. */
public final class CaseReader {
    /** The families, a file each, in the order of the report. */
    public static final List<String> FAMILIES = List.of(
            "parallel",
            "touching",
            "containment",
            "degenerate",
            "triangles",
            "scale",
            "moves",
            "starts",
            "grazing",
            "inside",
            "axes",
            "bad",
            "sensors");

    private static final Set<String> KEYS = Set.of(
            "id", "title", "source", "link", "version", "there", "today", "numbers", "hard", "meaning", "up", "reach",
            "objects", "ask");

    private CaseReader() {}

    /** All cases of all families. */
    public static List<HardCase> all() {
        return FAMILIES.stream().flatMap(family -> family(family).stream()).toList();
    }

    /** The cases of one file. */
    @SuppressWarnings("unchecked")
    public static List<HardCase> family(String name) {
        LoadSettings settings = LoadSettings.builder()
                .setSchema(new FailsafeSchema())
                .setLabel(name)
                .build();
        try (InputStream in = CaseReader.class.getResourceAsStream(name + ".yaml")) {
            if (in == null) {
                throw new IllegalArgumentException("a family must have a file (got: " + name + ")");
            }
            List<HardCase> cases = new ArrayList<>();
            for (Object each : (List<Object>) new Load(settings).loadFromInputStream(in)) {
                cases.add(hardCase((Map<String, Object>) each));
            }
            return cases;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @SuppressWarnings("unchecked")
    private static HardCase hardCase(Map<String, Object> text) {
        String id = required(text, "id");
        try {
            for (String key : text.keySet()) {
                if (!KEYS.contains(key)) {
                    throw new IllegalArgumentException("a case must have known attributes (got: " + key + ")");
                }
            }
            ShapeReader shapes = new ShapeReader(optional(text, "up", "y").equals("z"));
            Map<String, GeometryObject> objects = new LinkedHashMap<>();
            ((Map<String, Map<String, Object>>) text.getOrDefault("objects", Map.of()))
                    .forEach((name, shape) -> objects.put(name, shapes.object(shape)));
            List<Question> questions = new ArrayList<>();
            for (Map<String, Object> each : (List<Map<String, Object>>) text.get("ask")) {
                questions.add(question(each, shapes, List.copyOf(objects.keySet())));
            }
            return new HardCase(
                    id,
                    required(text, "title"),
                    required(text, "source"),
                    optional(text, "link", ""),
                    optional(text, "version", ""),
                    required(text, "there"),
                    required(text, "today"),
                    required(text, "numbers"),
                    required(text, "hard"),
                    optional(text, "meaning", ""),
                    Integer.parseInt(optional(text, "reach", "40")),
                    objects,
                    questions);
        } catch (RuntimeException e) {
            throw new IllegalArgumentException("case " + id + ": " + e.getMessage(), e);
        }
    }

    @SuppressWarnings("unchecked")
    private static Question question(Map<String, Object> text, ShapeReader shapes, List<String> all) {
        String truth = required(text, "truth").trim();
        String how = optional(text, "how", text.containsKey("refused") ? "by contract" : HardCase.RECOMPUTED);
        String planar = optional(text, "planar", "");
        String inPlane = planar.isEmpty() ? null : planar;
        double within = number(text, "within", 0);
        String kind = text.keySet().iterator().next();
        List<String> others = text.containsKey("of") ? names(text, "of") : all;
        return switch (kind) {
            case "overlap" -> {
                List<String> pair = names(text, kind);
                yield new HardCase.Overlap(pair.get(0), pair.get(1), truth, how, inPlane);
            }
            case "gap" -> {
                List<String> pair = names(text, kind);
                yield new HardCase.Gap(pair.get(0), pair.get(1), truth, within, how, inPlane);
            }
            case "ray" -> {
                Map<String, Object> ray = (Map<String, Object>) text.get(kind);
                double[] from = shapes.vector(required(ray, "from"));
                double[] direction = shapes.vector(required(ray, ray.containsKey("to") ? "to" : "direction"));
                if (ray.containsKey("to")) {
                    for (int k = 0; k < 3; k++) {
                        direction[k] -= from[k];
                    }
                }
                yield new HardCase.Beam(
                        from,
                        direction,
                        others,
                        number(text, "min", 0),
                        number(text, "max", Double.POSITIVE_INFINITY),
                        number(text, "width", 0),
                        truth,
                        within,
                        how,
                        inPlane);
            }
            case "move" -> {
                String mover = required(text, "move");
                List<String> rest =
                        others.stream().filter(o -> !o.equals(mover)).toList();
                double[] way = shapes.vector(optional(text, "by", "0 0 0"));
                yield new HardCase.Drive(mover, way, number(text, "turn", 0), rest, truth, within, how, inPlane);
            }
            case "refused" -> new HardCase.Refusal((Map<String, Object>) text.get(kind), truth, how);
            case "spin" -> {
                double[] spin = ShapeReader.numbers(required(text, "spin"));
                yield new HardCase.Spin(spin[0], spin[1], (int) spin[2], truth, within, how);
            }
            case "scan" -> {
                String scanner = required(text, "scan");
                List<String> rest =
                        others.stream().filter(o -> !o.equals(scanner)).toList();
                yield new HardCase.Scan(
                        scanner,
                        number(text, "first", 0),
                        number(text, "step", 0),
                        (int) number(text, "count", 1),
                        number(text, "max", Double.POSITIVE_INFINITY),
                        rest,
                        truth,
                        within,
                        how,
                        inPlane);
            }
            default -> throw new IllegalArgumentException("a question must be of a known kind (got: " + kind + ")");
        };
    }

    private static List<String> names(Map<String, Object> text, String key) {
        return List.of(required(text, key).trim().split("\\s+"));
    }

    private static double number(Map<String, Object> text, String key, double otherwise) {
        Object value = text.get(key);
        return value == null ? otherwise : ShapeReader.numbers(value)[0];
    }

    private static String required(Map<String, Object> text, String key) {
        @Nullable Object value = text.get(key);
        if (value == null) {
            throw new IllegalArgumentException(key + " must be given (got: " + text + ")");
        }
        return value.toString().trim();
    }

    private static String optional(Map<String, Object> text, String key, String otherwise) {
        Object value = text.get(key);
        return value == null ? otherwise : value.toString().trim();
    }
}
