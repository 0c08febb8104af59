package robosim.geometry.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** An import points down only: who may know whom, as one table. */
class DirectionsTest {
    private static final String ROOT = "robosim.geometry";

    /** Each room and the rooms that it may import; "" is the base package. */
    private static final Map<String, Set<String>> MAY_IMPORT = Map.ofEntries(
            Map.entry("exact", Set.of()),
            Map.entry("index", Set.of()),
            Map.entry("model", Set.of("exact", "index")),
            Map.entry("narrow", Set.of("model", "exact", "index")),
            Map.entry("collision", Set.of("narrow", "model", "exact", "index")),
            Map.entry("", Set.of("collision", "narrow", "model", "exact", "index")),
            Map.entry("world", Set.of("", "collision", "narrow", "model", "exact", "index")),
            Map.entry("protocol", Set.of("model")),
            Map.entry("net", Set.of("", "protocol", "model", "exact")),
            Map.entry("scenario", Set.of("", "net", "world", "protocol", "model")),
            Map.entry(
                    "junit",
                    Set.of("", "viewer", "scenario", "net", "protocol", "world", "collision", "model", "exact")),
            Map.entry("viewer", Set.of("", "scenario", "net", "protocol", "world", "model", "exact")),
            Map.entry("sweep", Set.of("", "scenario", "net", "protocol", "world", "model", "exact")),
            Map.entry("cli", Set.of("", "sweep", "viewer", "scenario", "net", "protocol", "world", "model")));

    /** Rooms whose use of a library or of a part of the JDK is theirs alone. */
    private static final Map<String, Set<String>> ONLY_IN = Map.ofEntries(
            Map.entry("java.net.", Set.of("net", "cli", "junit")),
            Map.entry("javax.net.", Set.of("net")),
            Map.entry("java.lang.management.", Set.of("net")),
            Map.entry("javax.management.", Set.of("net")),
            Map.entry("javax.xml.", Set.of("world", "viewer")),
            Map.entry("org.xml.", Set.of("world", "viewer")),
            Map.entry("javax.imageio.", Set.of("world", "viewer")),
            Map.entry("java.awt.image.", Set.of("world", "viewer")),
            Map.entry("java.awt.", Set.of("viewer")),
            Map.entry("javax.swing.", Set.of("viewer")),
            Map.entry("com.fasterxml.jackson.", Set.of("protocol")),
            Map.entry("org.snakeyaml.", Set.of("world")),
            Map.entry("org.junit.", Set.of("junit")),
            Map.entry("org.opentest4j.", Set.of("junit")),
            Map.entry("picocli.", Set.of("cli")));

    private static final JavaClasses CLASSES = new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
            .importPackages(ROOT);

    private static String room(JavaClass type) {
        String name = type.getPackageName();
        return name.equals(ROOT) ? "" : name.substring(ROOT.length() + 1).split("\\.")[0];
    }

    @Test
    void theTableIsAboutTheRoomsThatThereAre() {
        Set<String> rooms = CLASSES.stream().map(DirectionsTest::room).collect(Collectors.toCollection(TreeSet::new));
        assertThat(rooms).isEqualTo(new TreeSet<>(MAY_IMPORT.keySet()));
        assertThat(CLASSES.size()).as("classes seen").isGreaterThan(60);
    }

    @Test
    void importsPointDown() {
        List<String> wrong = new ArrayList<>();
        int seen = 0;
        for (JavaClass type : CLASSES) {
            for (var dependency : type.getDirectDependenciesFromSelf()) {
                JavaClass target = dependency.getTargetClass().getBaseComponentType();
                if (!target.getPackageName().startsWith(ROOT)) {
                    continue;
                }
                seen++;
                String from = room(type);
                String to = room(target);
                if (!from.equals(to) && !MAY_IMPORT.get(from).contains(to)) {
                    wrong.add(type.getName() + " -> " + target.getName());
                }
            }
        }
        assertThat(wrong).as("imports that do not point down").isEmpty();
        assertThat(seen).as("imports seen").isGreaterThan(200);
    }

    @Test
    void theTableItselfHasNoCircle() {
        List<String> order = new ArrayList<>();
        boolean grows = true;
        while (grows) {
            grows = false;
            for (var entry : MAY_IMPORT.entrySet()) {
                if (!order.contains(entry.getKey()) && order.containsAll(entry.getValue())) {
                    order.add(entry.getKey());
                    grows = true;
                }
            }
        }
        assertThat(order).containsExactlyInAnyOrderElementsOf(MAY_IMPORT.keySet());
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
                        .filter(prefix -> !ONLY_IN.get(prefix).contains(room(type)))
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
                                && type.getName().startsWith(ROOT + ".protocol.Json"))
                        || ((target.startsWith("org.junit.") || target.startsWith("org.opentest4j."))
                                && room(type).equals("junit"))
                        || (target.startsWith("org.snakeyaml.engine.")
                                && type.getName().startsWith(ROOT + ".world.MapSettings"))
                        || (target.startsWith("picocli.") && room(type).equals("cli"));
                if (!known) {
                    wrong.add(type.getName() + " -> " + target);
                }
            }
        }
        assertThat(wrong).isEmpty();
    }
}
