package robosim.geometry.world.rosmap;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.composer.Composer;
import org.snakeyaml.engine.v2.events.Event;
import org.snakeyaml.engine.v2.exceptions.MarkedYamlEngineException;
import org.snakeyaml.engine.v2.exceptions.YamlEngineException;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import org.snakeyaml.engine.v2.parser.Parser;
import org.snakeyaml.engine.v2.parser.ParserImpl;
import org.snakeyaml.engine.v2.scanner.StreamReader;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Numbers;

/**
 * The settings in the YAML file of a ROS map.
 *
 * @param image      path of the image, relative to the file's folder
 * @param imageLine  the line of that setting
 * @param resolution metres per cell
 * @param x          x of the lower left corner in the map's frame, metres
 * @param y          y of that corner
 * @param yaw        radians, counter-clockwise from above
 * @param isNegated  whether white means a wall
 * @param mode       how a pixel is converted to a cell
 * @param occupied   the fraction above which a cell is a wall
 * @param free       the fraction below which a cell is free, if it is not a wall
 * @param freeLine   the line of that setting
 * @param remarks    what a user should know of the settings
 */
public record MapSettings(
        String image,
        int imageLine,
        double resolution,
        double x,
        double y,
        double yaw,
        boolean isNegated,
        Mode mode,
        double occupied,
        double free,
        int freeLine,
        List<String> remarks) {

    /** Keeps a copy of the list. */
    public MapSettings {
        remarks = List.copyOf(remarks);
    }

    /** The modes, by their ROS names. */
    enum Mode {
        TRINARY,
        SCALE,
        RAW
    }

    private static final Set<String> KEYS =
            Set.of("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode");

    /** Reads the text of a file of at most {@link Limits#MAX_SETTINGS} bytes. */
    static MapSettings parse(String yaml, String source) throws FileProblem {
        return new Reader(source).read(yaml);
    }

    private static final class Reader {
        private final String source;
        private final Map<String, Node> values = new LinkedHashMap<>();
        private final List<String> remarks = new ArrayList<>();

        Reader(String source) {
            this.source = source;
        }

        MapSettings read(String yaml) throws FileProblem {
            Node root;
            try {
                // Composed, not constructed: every value keeps its line, and its text as it was written.
                LoadSettings settings = LoadSettings.builder().build();
                shallow(new ParserImpl(settings, new StreamReader(settings, yaml)));
                root = new Composer(settings, new ParserImpl(settings, new StreamReader(settings, yaml)))
                        .getSingleNode()
                        .orElse(null);
            } catch (MarkedYamlEngineException e) {
                int line = e.getProblemMark().map(mark -> mark.getLine() + 1).orElse(0);
                throw new FileProblem(source, line, 0, "this is not valid YAML: " + e.getProblem(), e);
            } catch (YamlEngineException e) {
                throw new FileProblem(source, "this is not valid YAML: " + e.getMessage(), e);
            }
            if (!(root instanceof MappingNode mapping)) {
                throw new FileProblem(source, "a map must consist of keys with values, such as image: map.pgm");
            }
            for (NodeTuple entry : mapping.getValue()) {
                entry(entry);
            }
            return settings();
        }

        /** Refuses deep nesting, since a composer recurses for each level. */
        private void shallow(Parser events) throws FileProblem {
            int depth = 0;
            while (events.hasNext()) {
                Event event = events.next();
                switch (event.getEventId()) {
                    case SequenceStart, MappingStart -> depth++;
                    case SequenceEnd, MappingEnd -> depth--;
                    default -> {}
                }
                if (depth > Limits.MAX_NESTED) {
                    int line =
                            event.getStartMark().map(mark -> mark.getLine() + 1).orElse(0);
                    throw new FileProblem(
                            source,
                            line,
                            0,
                            "lists and keys must be nested at most " + Limits.MAX_NESTED
                                    + " deep; a map needs two levels (got: one more)");
                }
            }
        }

        private void entry(NodeTuple entry) throws FileProblem {
            Node node = entry.getKeyNode();
            String key = text("a key", node);
            if (!KEYS.contains(key)) {
                remarks.add(wrong(
                                node,
                                "a key should be image, resolution, origin, negate, occupied_thresh, free_thresh or mode;"
                                        + " this one is ignored (got: " + Numbers.shown(key) + ")")
                        .getMessage());
                return;
            }
            if (values.putIfAbsent(key, entry.getValueNode()) != null) {
                throw wrong(node, "a key must occur only once; remove one of them (got twice: " + key + ")");
            }
        }

        private MapSettings settings() throws FileProblem {
            double resolution = number("resolution", value("resolution"));
            if (!(resolution > 0)) {
                throw wrong(
                        value("resolution"), "resolution must be above 0 metres per cell (got: " + resolution + ")");
            }
            double[] origin = origin();
            boolean isNegated = negate();
            double occupied = share("occupied_thresh");
            double free = share("free_thresh");
            Mode mode = mode();
            if (mode == Mode.RAW && isNegated) {
                throw wrong(
                        value("negate"), "negate must be 0 in mode raw, where map servers disagree about it (got: 1)");
            }
            return new MapSettings(
                    text("image", value("image")),
                    line(value("image")),
                    resolution,
                    origin[0],
                    origin[1],
                    origin[2],
                    isNegated,
                    mode,
                    occupied,
                    free,
                    line(value("free_thresh")),
                    remarks);
        }

        private double[] origin() throws FileProblem {
            Node node = value("origin");
            List<Node> parts = node instanceof SequenceNode sequence ? sequence.getValue() : List.of();
            if (parts.size() != 3) {
                throw wrong(node, "origin must be [x, y, yaw] (got: " + parts.size() + " numbers)");
            }
            double[] origin = new double[3];
            for (int k = 0; k < 3; k++) {
                origin[k] = number("origin", parts.get(k));
            }
            return origin;
        }

        private boolean negate() throws FileProblem {
            String text = text("negate", value("negate"));
            return switch (text) {
                case "0", "false" -> false;
                case "1", "true" -> true;
                default -> throw wrong(value("negate"), "negate must be 0, 1, false or true (got: " + text + ")");
            };
        }

        private Mode mode() throws FileProblem {
            Node node = values.get("mode");
            if (node == null) {
                return Mode.TRINARY;
            }
            String text = text("mode", node);
            for (Mode mode : Mode.values()) {
                if (mode.name().equals(text.toUpperCase(Locale.ROOT))) {
                    return mode;
                }
            }
            throw wrong(node, "mode must be trinary, scale or raw (got: " + text + ")");
        }

        private double share(String key) throws FileProblem {
            double share = number(key, value(key));
            if (!(share >= 0 && share <= 1)) {
                throw wrong(value(key), key + " must be from 0 to 1 (got: " + share + ")");
            }
            return share;
        }

        private double number(String key, Node node) throws FileProblem {
            try {
                return Numbers.parse(text(key, node));
            } catch (IllegalArgumentException e) {
                throw wrong(node, key + ": " + e.getMessage());
            }
        }

        private String text(String key, Node node) throws FileProblem {
            if (node instanceof ScalarNode scalar) {
                return scalar.getValue();
            }
            throw wrong(
                    node,
                    key + " must be a single value (got: a "
                            + node.getNodeType().name().toLowerCase(Locale.ROOT) + ")");
        }

        private Node value(String key) throws FileProblem {
            Node node = values.get(key);
            if (node == null) {
                throw new FileProblem(source, "a map must have " + key + "; add it (got: none)");
            }
            return node;
        }

        private static int line(Node node) {
            return node.getStartMark().map(mark -> mark.getLine() + 1).orElse(0);
        }

        private FileProblem wrong(Node node, String problem) {
            return new FileProblem(source, line(node), 0, problem);
        }
    }
}
