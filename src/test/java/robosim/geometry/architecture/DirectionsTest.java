package robosim.geometry.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * An import points down only: who may know whom, as the one table of {@code CONTRIBUTING.md}, each room above those that it
 * knows; and how large rooms and circles of classes may be.
 */
@Tag("slow")
@Tag("sources")
class DirectionsTest {
    private static final String ROOT = "robosim.geometry";
    private static final Path SOURCES = Path.of("src/main/java");

    /** The base package, as the table calls it. */
    private static final String BASE = "(base)";

    /** Most files of a room. */
    private static final int MOST_FILES = 24;

    /** Most classes that may know each other in a circle. */
    private static final int MOST_IN_CIRCLE = 3;

    /**
     * Larger circles that are left, each by the first of its classes; that of the model is a sealed type, its kinds and their
     * bounds, that of JUnit's support a world, its robots and what they are told to do.
     */
    private static final Set<String> CIRCLES = Set.of("junit.Arrival", "model.Bounds");

    private static final Map<String, List<String>> MAY_IMPORT = table();

    /** Rooms whose use of a library or of a part of the JDK is theirs alone. */
    private static final Map<String, Set<String>> ONLY_IN = Map.ofEntries(
            Map.entry("java.net.", Set.of("net", "cli", "junit", "viewer")),
            Map.entry("javax.net.", Set.of("net")),
            Map.entry("java.lang.management.", Set.of("net")),
            Map.entry("javax.management.", Set.of("net")),
            Map.entry("com.sun.net.httpserver.", Set.of("cli", "viewer")),
            Map.entry("java.util.logging.", Set.of("cli")),
            Map.entry("javax.xml.", Set.of("world", "viewer")),
            Map.entry("org.xml.", Set.of("world", "viewer", "sensor")),
            Map.entry("javax.imageio.", Set.of("world", "viewer")),
            Map.entry("java.awt.image.", Set.of("world", "viewer")),
            Map.entry("java.awt.", Set.of("viewer")),
            Map.entry("javax.swing.", Set.of()),
            Map.entry("com.fasterxml.jackson.", Set.of("protocol")),
            Map.entry("org.snakeyaml.", Set.of("world")),
            Map.entry("org.junit.", Set.of("junit")),
            Map.entry("org.opentest4j.", Set.of("junit")),
            Map.entry("picocli.", Set.of("cli")));

    private static final JavaClasses CLASSES = Imported.CLASSES;

    private static Map<String, List<String>> table() {
        Matcher block = Pattern.compile("<!-- rooms -->\\s*```\\n(.*?)```", Pattern.DOTALL)
                .matcher(page());
        assertThat(block.find()).as("the table of rooms in CONTRIBUTING.md").isTrue();
        Map<String, List<String>> table = new LinkedHashMap<>();
        for (String line : block.group(1).split("\\n", -1)) {
            List<String> words = List.of(line.strip().split("\\s+"));
            if (!words.get(0).isEmpty()) {
                table.put(words.get(0), words.subList(1, words.size()));
            }
        }
        return table;
    }

    private static String page() {
        try {
            return Files.readString(Path.of("CONTRIBUTING.md"));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String room(JavaClass type) {
        return room(type.getPackageName());
    }

    private static String room(String name) {
        return name.equals(ROOT) ? BASE : name.substring(ROOT.length() + 1);
    }

    /** The outermost room of one, as the special rules are about. */
    private static String house(JavaClass type) {
        return room(type).split("\\.", -1)[0];
    }

    /** A class with all that are within it, by its room and its name. */
    private static String file(JavaClass type) {
        JavaClass outer = type;
        while (outer.getEnclosingClass().isPresent()) {
            outer = outer.getEnclosingClass().get();
        }
        return room(outer) + "." + outer.getSimpleName();
    }

    private static boolean isOurs(JavaClass type) {
        return type.getPackageName().equals(ROOT) || type.getPackageName().startsWith(ROOT + ".");
    }

    @Test
    void theTableIsAboutTheRoomsThatThereAre() {
        Set<String> rooms = CLASSES.stream().map(DirectionsTest::room).collect(Collectors.toCollection(TreeSet::new));
        assertThat(rooms).isEqualTo(new TreeSet<>(MAY_IMPORT.keySet()));
    }

    @Test
    void everyFileWasSeen() throws IOException {
        Set<String> seen = CLASSES.stream().map(DirectionsTest::file).collect(Collectors.toCollection(TreeSet::new));
        seen.removeIf(name -> name.endsWith("package-info"));
        try (Stream<Path> files = Files.walk(SOURCES)) {
            Set<String> there = files.filter(file -> file.toString().endsWith(".java")
                            && !file.toString().endsWith("-info.java"))
                    .map(file -> SOURCES.relativize(file).toString().replace(File.separatorChar, '.'))
                    .map(name -> name.substring(ROOT.length() + 1, name.length() - ".java".length()))
                    .map(name -> name.contains(".") ? name : BASE + "." + name)
                    .collect(Collectors.toCollection(TreeSet::new));
            assertThat(seen).isEqualTo(there);
        }
    }

    @Test
    void roomsAreSmall() throws IOException {
        Set<String> large = new TreeSet<>();
        try (Stream<Path> folders = Files.walk(SOURCES).filter(Files::isDirectory)) {
            for (Path folder : folders.toList()) {
                try (Stream<Path> files = Files.list(folder)) {
                    if (files.filter(file -> file.toString().endsWith(".java")).count() > MOST_FILES) {
                        large.add(String.valueOf(folder.getFileName()));
                    }
                }
            }
        }
        assertThat(large).isEmpty();
    }

    /** What a source imports, for whatever: constants are no longer seen in a class file, nor what only a comment links. */
    private static void addImports(Set<String> used) throws IOException {
        Pattern statement = Pattern.compile("import (?:static )?(robosim\\.geometry(?:\\.[a-z]+)*)\\.[A-Z].*");
        try (Stream<Path> files = Files.walk(SOURCES)) {
            for (Path file :
                    files.filter(path -> path.toString().endsWith(".java")).toList()) {
                for (String line : Files.readAllLines(file)) {
                    Matcher match = statement.matcher(line);
                    String folder = SOURCES.relativize(file.getParent()).toString();
                    if (match.matches()) {
                        used.add(room(folder.replace(File.separatorChar, '.')) + " -> " + room(match.group(1)));
                    }
                }
            }
        }
    }

    @Test
    void importsPointDown() throws IOException {
        List<String> wrong = new ArrayList<>();
        Set<String> used = new TreeSet<>();
        for (JavaClass type : CLASSES) {
            for (var dependency : type.getDirectDependenciesFromSelf()) {
                JavaClass target = dependency.getTargetClass().getBaseComponentType();
                if (isOurs(target) && !room(type).equals(room(target))) {
                    used.add(room(type) + " -> " + room(target));
                    if (!MAY_IMPORT.getOrDefault(room(type), List.of()).contains(room(target))) {
                        wrong.add(type.getName() + " -> " + target.getName());
                    }
                }
            }
        }
        assertThat(wrong).as("imports that the table does not know").isEmpty();
        addImports(used);
        used.removeIf(each -> each.split(" -> ", -1)[0].equals(each.split(" -> ", -1)[1])); // a class within another
        Set<String> told = new TreeSet<>();
        MAY_IMPORT.forEach((from, all) -> all.forEach(to -> told.add(from + " -> " + to)));
        assertThat(used).as("imports that the table tells").isEqualTo(told);
    }

    @Test
    void eachRoomStandsAboveThoseThatItKnows() {
        List<String> order = List.copyOf(MAY_IMPORT.keySet());
        MAY_IMPORT.forEach((from, all) -> {
            for (String to : all) {
                assertThat(order.indexOf(to)).as(from + " knows " + to).isGreaterThan(order.indexOf(from));
            }
        });
    }

    @Test
    void circlesOfClassesAreSmall() {
        Map<String, Set<String>> knows = new TreeMap<>();
        for (JavaClass type : CLASSES) {
            Set<String> targets = knows.computeIfAbsent(file(type), name -> new TreeSet<>());
            for (var dependency : type.getDirectDependenciesFromSelf()) {
                JavaClass target = dependency.getTargetClass().getBaseComponentType();
                if (isOurs(target) && !file(target).equals(file(type))) {
                    targets.add(file(target));
                }
            }
        }
        Map<String, Set<String>> reached = new TreeMap<>();
        knows.keySet().forEach(name -> reached.put(name, reachedFrom(name, knows)));
        Set<String> large = new TreeSet<>();
        for (String name : knows.keySet()) {
            Set<String> circle = new TreeSet<>(reached.getOrDefault(name, Set.of()));
            circle.removeIf(other -> !reached.getOrDefault(other, Set.of()).contains(name));
            if (circle.size() > MOST_IN_CIRCLE) {
                large.add(circle.iterator().next());
            }
        }
        assertThat(large).isEqualTo(new TreeSet<>(CIRCLES));
    }

    private static Set<String> reachedFrom(String start, Map<String, Set<String>> knows) {
        Set<String> reached = new HashSet<>();
        Deque<String> open = new ArrayDeque<>(knows.getOrDefault(start, Set.of()));
        while (!open.isEmpty()) {
            String next = open.pop();
            if (reached.add(next)) {
                open.addAll(knows.getOrDefault(next, Set.of()));
            }
        }
        return reached;
    }

    @Test
    void whatIsSpecialStaysInItsRoom() {
        List<String> wrong = new ArrayList<>();
        for (JavaClass type : CLASSES) {
            for (var dependency : type.getDirectDependenciesFromSelf()) {
                String target =
                        dependency.getTargetClass().getBaseComponentType().getName();
                // The longest prefix decides: pixels are for the importers too, windows are not.
                ONLY_IN.keySet().stream()
                        .filter(target::startsWith)
                        .max(Comparator.comparingInt(String::length))
                        .filter(prefix -> !ONLY_IN.get(prefix).contains(house(type)))
                        .ifPresent(prefix -> wrong.add(type.getName() + " -> " + target));
            }
        }
        assertThat(wrong).isEmpty();
    }

    @Test
    void whoEmbedsTheJarNeedsTheJdkAlone() {
        List<String> wrong = new ArrayList<>();
        for (JavaClass type : CLASSES) {
            for (var dependency : type.getDirectDependenciesFromSelf()) {
                String target =
                        dependency.getTargetClass().getBaseComponentType().getName();
                boolean known = !target.contains(".")
                        || target.startsWith("java.")
                        || target.startsWith("javax.")
                        || target.startsWith("org.xml.sax.")
                        || target.startsWith("org.w3c.dom.")
                        || target.startsWith("org.jspecify.annotations.")
                        || target.startsWith(ROOT)
                        || (target.startsWith("com.fasterxml.jackson.core.")
                                && type.getName().startsWith(ROOT + ".protocol.json."))
                        || ((target.startsWith("org.junit.") || target.startsWith("org.opentest4j."))
                                && house(type).equals("junit"))
                        || (target.startsWith("org.snakeyaml.engine.")
                                && type.getName().startsWith(ROOT + ".world.rosmap.MapSettings"))
                        || (target.startsWith("com.sun.net.httpserver.")
                                && (type.getName().equals(ROOT + ".cli.network.AdminPort")
                                        || type.getName().equals(ROOT + ".viewer.web.PageServer")))
                        || (target.startsWith("picocli.") && house(type).equals("cli"));
                if (!known) {
                    wrong.add(type.getName() + " -> " + target);
                }
            }
        }
        assertThat(wrong).isEmpty();
    }
}
