package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ExamplesTest {
    @Test
    void eachCompilesByItselfWithoutAWarning(@TempDir Path folder) throws Exception {
        List<Path> sources = Examples.sources();
        assertThat(sources).hasSizeGreaterThanOrEqualTo(2);
        for (Path source : sources) {
            Path into = Files.createDirectories(folder.resolve(source.getFileName() + ".classes"));
            assertThat(Examples.compile(List.of(source), into)).as("%s", source).isEmpty();
        }
    }

    @Test
    void aFaultInAnExampleIsSeen(@TempDir Path folder) throws Exception {
        Path source = folder.resolve("Bad.java");
        Files.writeString(source, "class Bad { java.util.List raw; }\n");
        assertThat(Examples.compile(List.of(source), folder)).contains("rawtypes");
    }

    @Test
    void theyImportOnlyWhatIsExported() throws Exception {
        String module = Files.readString(Path.of("src/main/java/module-info.java"));
        for (Path source : Examples.sources()) {
            Matcher imports =
                    Pattern.compile("import (robosim(?:\\.[a-z]+)+)\\.[A-Z]").matcher(Files.readString(source));
            while (imports.find()) {
                assertThat(module).as("%s", source).contains("exports " + imports.group(1) + ";");
            }
        }
    }

    @Test
    void theAuditKnowsOnlyTheValuesAndTheBundles() throws Exception {
        String audit = Files.readString(Examples.FOLDER.resolve("ConversationAudit.java"));
        Matcher uses = Pattern.compile("robosim(?:\\.[a-z]+)+(?:\\.[A-Z]\\w+)?").matcher(audit);
        int seen = 0;
        while (uses.find()) {
            seen++;
            // Of the dynamics the records in which the answer of a step comes, and nothing that computes one.
            assertThat(uses.group())
                    .matches(
                            "robosim\\.geometry\\.(?:(?:model|protocol)\\.\\w+|dynamics\\.(?:BodyContact|StepResult))");
        }
        assertThat(seen).isGreaterThan(10);
    }
}
