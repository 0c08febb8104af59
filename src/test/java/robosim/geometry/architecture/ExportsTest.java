package robosim.geometry.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaModifier;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** What the module exports: few packages, few types, and no type that users cannot name. */
@Tag("slow")
@Tag("sources")
class ExportsTest {
    private static final String ROOT = "robosim.geometry";

    /** Most exported packages, and most public types in them, nested ones included. */
    private static final int MOST_PACKAGES = 14;

    private static final int MOST_TYPES = 216;

    /** Doors to what is internal, for other packages of the module; programs have no use for them. */
    private static final Set<String> DOORS = Set.of(
            "Geometry.engine",
            "GridObject.cells",
            "GridObject.placed",
            "MeshObject.triangles",
            "MessageReader.<init>",
            "NetOptions.withWorlds",
            "WorldObject.<init>",
            "WorldObject.body");

    /** Bundles whose parts are internal: they come over the wire only, or are made and read by methods for values of other packages. */
    private static final Set<String> WIRE =
            Set.of("BatchRequestBundle", "BatchAnswerBundle", "StepBundle", "StepBundle$Answer");

    private static final Set<String> EXPORTED = exported();

    private static Set<String> exported() {
        try {
            return Pattern.compile("exports ([\\w.]+);")
                    .matcher(Files.readString(Path.of("src/main/java/module-info.java")))
                    .results()
                    .map((MatchResult match) -> match.group(1))
                    .collect(Collectors.toCollection(TreeSet::new));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static List<JavaClass> types() {
        return Imported.CLASSES.stream()
                .filter(type -> EXPORTED.contains(type.getPackageName()) && isVisible(type))
                .toList();
    }

    private static boolean isVisible(JavaClass type) {
        boolean isOpen = type.getModifiers().contains(JavaModifier.PUBLIC)
                || type.getModifiers().contains(JavaModifier.PROTECTED);
        return isOpen
                && !type.getModifiers().contains(JavaModifier.SYNTHETIC)
                && !type.isAnonymousClass()
                && !type.isLocalClass()
                && type.getEnclosingClass().map(ExportsTest::isVisible).orElse(true);
    }

    @Test
    void fewPackagesAndTypesAreExported() {
        assertThat(EXPORTED).hasSizeBetween(1, MOST_PACKAGES);
        assertThat(types()).as("public types").hasSizeBetween(MOST_TYPES / 2, MOST_TYPES);
    }

    @Test
    void whatIsPublicNamesOnlyWhatIsExported() {
        Set<String> doors = new TreeSet<>();
        List<String> wrong = new ArrayList<>();
        for (JavaClass type : types()) {
            for (JavaCodeUnit unit : type.getCodeUnits()) {
                String name = type.getSimpleName() + "." + unit.getName();
                if (!isInternal(unit)
                        || WIRE.contains(type.getName().substring(type.getName().lastIndexOf('.') + 1))) {
                    continue;
                }
                doors.add(name);
                if (!DOORS.contains(name)) {
                    wrong.add(unit.getFullName());
                }
            }
        }
        assertThat(wrong).as("public methods that name internal types").isEmpty();
        assertThat(doors).isEqualTo(new TreeSet<>(DOORS));
    }

    /** Whether users can call it, but not name one of its types. */
    private static boolean isInternal(JavaCodeUnit unit) {
        return unit.getModifiers().contains(JavaModifier.PUBLIC)
                && !unit.getModifiers().contains(JavaModifier.SYNTHETIC)
                && Stream.concat(Stream.of(unit.getReturnType()), unit.getParameterTypes().stream())
                        .flatMap(type -> type.getAllInvolvedRawTypes().stream())
                        .map(JavaClass::getBaseComponentType)
                        .anyMatch(type ->
                                type.getPackageName().startsWith(ROOT) && !EXPORTED.contains(type.getPackageName()));
    }
}
