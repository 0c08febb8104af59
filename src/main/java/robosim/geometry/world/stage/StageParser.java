package robosim.geometry.world.stage;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.Folder;
import robosim.geometry.world.shared.LeftOut;
import robosim.geometry.world.shared.LimitProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Numbers;
import robosim.geometry.world.shared.RegularFile;

/** Parses a Stage world with the files that it includes, which lie below its folder, and expands what these define. */
final class StageParser {
    private static final int MOST_BYTES = 16 << 20;

    /** What a {@code define} has said: a type of Stage, with properties and children. */
    private final Map<String, StageEntity> macros = new HashMap<>();

    private final Path folder;
    private final List<LeftOut> leftOut;
    private int entities;
    private int files;

    StageParser(Path main, List<LeftOut> leftOut) {
        folder = main.toAbsolutePath().resolveSibling("").normalize();
        this.leftOut = leftOut;
    }

    /** One file while it is read. */
    private static final class Text {
        private final Path file;
        private final String text;
        private int at;
        private int line = 1;

        Text(Path file, String text) {
            this.file = file;
            this.text = text;
        }

        /** The next token, which is not taken: a bracket, a text with its quotes, or a word; empty at the end. */
        String peek() throws FileProblem {
            int before = at;
            int lineBefore = line;
            String token = next();
            at = before;
            line = lineBefore;
            return token;
        }

        String next() throws FileProblem {
            while (at < text.length()) {
                char c = text.charAt(at);
                if (c == '#') {
                    int end = text.indexOf('\n', at);
                    at = end < 0 ? text.length() : end;
                } else if (Character.isWhitespace(c)) {
                    line += c == '\n' ? 1 : 0;
                    at++;
                } else {
                    return token(c);
                }
            }
            return "";
        }

        private String token(char first) throws FileProblem {
            int begin = at++;
            if ("()[]".indexOf(first) >= 0) {
                return text.substring(begin, at);
            }
            if (first == '"') {
                int end = text.indexOf('"', at);
                if (end < 0 || text.substring(at, end).indexOf('\n') >= 0) {
                    throw wrong("a text must end with quotes in its line (got: none)");
                }
                at = end + 1;
                return text.substring(begin, at);
            }
            while (at < text.length()
                    && !Character.isWhitespace(text.charAt(at))
                    && "()[]#\"".indexOf(text.charAt(at)) < 0) {
                at++;
            }
            // The index of a property, as in point[0], belongs to its name.
            int end = text.indexOf(']', at);
            if (at < text.length()
                    && text.charAt(at) == '['
                    && end > at + 1
                    && text.substring(at + 1, end).chars().allMatch(Character::isDigit)
                    && Character.isLetter(first)) {
                at = end + 1;
            }
            return text.substring(begin, at);
        }

        FileProblem wrong(String problem) {
            return new FileProblem(file.toString(), line, 0, problem);
        }
    }

    /** The entities of a file. */
    List<StageEntity> read(Path file) throws FileProblem {
        StageEntity world = new StageEntity("world", file, 0);
        read(file, world, 0);
        return world.children;
    }

    private void read(Path file, StageEntity world, int depth) throws FileProblem {
        if (depth > Limits.MAX_GROUPS || ++files > 1000) {
            throw new LimitProblem(
                    file.toString(),
                    0,
                    0,
                    "files must be included at most " + Limits.MAX_GROUPS
                            + " deep, and at most 1000 in all; no file may include itself (got: more)");
        }
        byte[] bytes = RegularFile.bytes(file, MOST_BYTES);
        Text text = new Text(file, new String(bytes, StandardCharsets.UTF_8));
        while (true) {
            String word = text.next();
            switch (word) {
                case "" -> {
                    return;
                }
                case "include" -> include(text, world, depth);
                case "define" -> define(text);
                default -> {
                    if (text.peek().equals("(")) {
                        world.children.add(entity(text, word, 0));
                    } else {
                        property(text, word, world);
                    }
                }
            }
        }
    }

    private void include(Text text, StageEntity world, int depth) throws FileProblem {
        int line = text.line;
        String name = unquoted(text.next());
        Path file;
        try {
            Path from = text.file.toAbsolutePath().resolveSibling("").normalize();
            file = Folder.locate(
                    folder, folder.relativize(from.resolve(name).normalize()).toString(), "world", "Stage");
        } catch (IllegalArgumentException | IOException e) {
            leftOut.add(new LeftOut(
                    text.file.toString(), line, "include of " + Numbers.shown(name), String.valueOf(e.getMessage())));
            return;
        }
        read(file, world, depth + 1);
    }

    private void define(Text text) throws FileProblem {
        String name = text.next();
        String base = text.next();
        if (!text.peek().equals("(")) {
            throw text.wrong(
                    "define must be followed by a name, a type and ( (got: " + Numbers.shown(text.peek()) + ")");
        }
        macros.put(name, entity(text, base, 0));
    }

    /** An entity from its bracket on, with all that its type was defined as. */
    private StageEntity entity(Text text, String type, int depth) throws FileProblem {
        if (depth > Limits.MAX_GROUPS) {
            throw text.wrong(
                    "entities must be nested at most " + Limits.MAX_GROUPS + " deep; nest less (got: one more)");
        }
        StageEntity macro = macros.get(type);
        StageEntity entity = new StageEntity(macro == null ? type : macro.type, text.file, text.line);
        if (macro != null) {
            entity.properties.putAll(macro.properties);
            entity.children.addAll(macro.children); // they do not change any more
            count(text, size(macro));
        }
        count(text, 1);
        text.next();
        while (true) {
            String word = text.next();
            if (word.equals(")")) {
                return entity;
            }
            if (word.isEmpty()) {
                throw text.wrong("an entity must end with ) (got: the end of the file)");
            }
            if (text.peek().equals("(")) {
                entity.children.add(entity(text, word, depth + 1));
            } else {
                property(text, word, entity);
            }
        }
    }

    private static int size(StageEntity entity) {
        int size = 1;
        for (StageEntity child : entity.children) {
            size = Math.min(Limits.MAX_OBJECTS, size + size(child));
        }
        return size;
    }

    private void count(Text text, int more) throws FileProblem {
        FileWork.take(more);
        entities += more;
        if (entities > Limits.MAX_OBJECTS) {
            throw new LimitProblem(
                    text.file.toString(),
                    text.line,
                    0,
                    "a world must have at most " + Limits.MAX_OBJECTS
                            + " entities, with all that is defined; leave some out (got: more)");
        }
    }

    private static void property(Text text, String name, StageEntity entity) throws FileProblem {
        if (!Character.isLetter(name.charAt(0))) {
            throw text.wrong("a property or an entity must begin with a letter (got: " + Numbers.shown(name) + ")");
        }
        FileWork.take(1);
        String value = text.next();
        List<String> values = new ArrayList<>();
        if (value.equals("[")) {
            for (value = text.next(); !value.equals("]"); value = text.next()) {
                if (value.isEmpty() || "()[".contains(value) || values.size() > Limits.MAX_CORNERS) {
                    throw text.wrong(name + " must have values and then ] (got: " + Numbers.shown(value) + ")");
                }
                values.add(unquoted(value));
            }
        } else if (value.isEmpty() || "()]".contains(value)) {
            throw text.wrong(Numbers.shown(name) + " must have a value (got: " + value + ")");
        } else {
            values.add(unquoted(value));
        }
        entity.properties.put(name, values);
    }

    private static String unquoted(String value) {
        return value.length() > 1 && value.startsWith("\"") ? value.substring(1, value.length() - 1) : value;
    }
}
