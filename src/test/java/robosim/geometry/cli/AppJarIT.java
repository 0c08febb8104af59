package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.ChildJvm;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Version;

/** The jars that were built, run as a user runs them: in an empty folder whose name has a space. */
@Timeout(300)
class AppJarIT {
    private static final Path APP = Path.of(System.getProperty("robosim.app", "none"));
    private static final Path PLAIN = Path.of(System.getProperty("robosim.plain", "none"));
    private static final Path WORLDS = Path.of("worlds").toAbsolutePath();

    @TempDir
    Path temporary;

    private Path folder = Path.of("");

    /** What a process left. */
    private record Run(int code, String out, String err) {}

    @BeforeEach
    void makeAnEmptyFolder() throws IOException {
        folder = Files.createDirectory(temporary.resolve("an empty folder"));
    }

    private Run app(Object... arguments) throws Exception {
        return java(List.of("-jar", APP.toString()), arguments);
    }

    private Run java(List<String> how, Object... arguments) throws Exception {
        List<String> command = ChildJvm.command();
        command.addAll(how);
        return run(Map.of(), command, arguments);
    }

    private Run run(Map<String, String> environment, List<String> program, Object... arguments) throws Exception {
        List<String> command = new ArrayList<>(program);
        for (Object argument : arguments) {
            command.add(argument.toString());
        }
        Path out = temporary.resolve("out");
        Path err = temporary.resolve("err");
        ProcessBuilder builder = new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectOutput(out.toFile())
                .redirectError(err.toFile());
        builder.environment().putAll(environment);
        Process process = builder.start();
        try {
            process.getOutputStream().close();
            assertThat(process.waitFor(120, TimeUnit.SECONDS)).isTrue();
        } finally {
            process.destroyForcibly();
        }
        return new Run(
                process.exitValue(),
                Files.readString(out, StandardCharsets.UTF_8),
                Files.readString(err, StandardCharsets.UTF_8));
    }

    @Test
    void helpAndVersionComeFromTheJarAlone() throws Exception {
        Run help = app("--help");
        assertThat(help.code()).isZero();
        assertThat(help.out()).contains("demo", "check", "render", "serve", "connect", "replay", "Exit codes:");
        assertThat(app("--version").out()).startsWith("robosim-geometry " + Version.NUMBER);
        assertThat(app().code()).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(app("completion").out()).startsWith("#!/usr/bin/env bash");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void theLauncherRunsTheSameAndMapsItsArchive() throws Exception {
        Path home = Files.createDirectory(
                temporary.resolve("home")); // JDK 17 maps no class of a jar whose path has a space
        Path launcher = home.resolve("robosim-geometry");
        Files.copy(Path.of("src/app/robosim-geometry"), launcher, StandardCopyOption.COPY_ATTRIBUTES);
        Map<String, String> environment = Map.of(
                "JAVA_HOME", System.getProperty("java.home"),
                "ROBOSIM_CACHE", temporary.resolve("a cache").toString(),
                "ROBOSIM_JAVA_OPTIONS", "-Xlog:class+load:file=loaded.txt");
        List<String> program = List.of(launcher.toString());
        Run none = run(environment, program, "--version");
        assertThat(none.err()).contains("robosim-geometry-*-app.jar must lie beside");
        assertThat(none.code()).isEqualTo(ExitCodes.UNUSABLE);

        Files.copy(APP, home.resolve(APP.getFileName()));
        Run before = run(environment, program, "--help");
        assertThat(before.out()).isEqualTo(app("--help").out());
        assertThat(folder.resolve("loaded.txt")).content().doesNotContain("cli.Commands source: shared objects file");

        Run prepared = run(environment, program, "--prepare");
        assertThat(prepared.code()).as(prepared.err()).isZero();
        Run after = run(environment, program, "--help");
        assertThat(after.err()).isEmpty();
        assertThat(after.out()).isEqualTo(before.out());
        assertThat(folder.resolve("loaded.txt")).content().contains("cli.Commands source: shared objects file");
    }

    @Test
    void theDemoNeedsNothingButTheJar() throws Exception {
        Run demo = app("demo", "--steps", 30);
        assertThat(demo.err()).isEmpty();
        assertThat(demo.out()).contains("30 steps of 8 robots", "nothing is wrong", "robosim-demo");
        assertThat(demo.code()).isZero();
        Path left = folder.resolve("robosim-demo");
        assertThat(left.resolve("rooms.xml")).hasSameTextualContentAs(WORLDS.resolve("rooms.xml"));
        assertThat(left.resolve("world.svg")).content().contains("drum 1");
        assertThat(left.resolve("world.png")).isNotEmptyFile();
    }

    @Test
    void worldsAreDrawnAndChecked() throws Exception {
        Run render = app("render", WORLDS.resolve("rooms.xml"), "-o", "rooms.svg");
        assertThat(render.err()).isEmpty();
        assertThat(render.code()).isZero();
        assertThat(folder.resolve("rooms.svg")).content().contains(">rooms<");
        Run check = app("check", WORLDS.resolve("rooms.xml"));
        assertThat(check.err()).isEmpty();
        assertThat(check.out()).contains("rooms.xml", "robots");
        assertThat(check.code()).isZero();
        Run missing = app("check", "nowhere.xml");
        assertThat(missing.code()).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(missing.err()).contains("WORLD must be a file that exists; check the path (got: nowhere.xml)");
    }

    @Test
    void recordingsAreReplayedWithTheJacksonInside() throws Exception {
        Run replay = app("replay", WORLDS.resolve("scenarios"));
        assertThat(replay.err()).isEmpty();
        assertThat(replay.out()).contains("all the same, bit for bit");
        assertThat(replay.code()).isZero();
    }

    @Test
    void thePlainJarSaysWhatItLacks() throws Exception {
        Run plain = java(List.of("-jar", PLAIN.toString()), "demo");
        assertThat(plain.code()).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(plain.err()).contains("-app.jar").doesNotContain("\tat ").hasLineCount(1);
        String both = PLAIN + System.getProperty("path.separator") + picocli();
        Run replay = java(
                List.of("-cp", both, Main.class.getName()),
                "replay",
                WORLDS.resolve("scenarios/by-hand.scenario.jsonl"));
        assertThat(replay.code()).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(replay.err()).contains("need Jackson").doesNotContain("\tat ");
    }

    private static Path picocli() throws Exception {
        return Path.of(picocli.CommandLine.class
                .getProtectionDomain()
                .getCodeSource()
                .getLocation()
                .toURI());
    }

    @Test
    void theAppHasLicencesServicesAndNoModule() throws Exception {
        try (JarFile jar = new JarFile(APP.toFile())) {
            Manifest manifest = jar.getManifest();
            assertThat(manifest.getMainAttributes().getValue("Main-Class")).isEqualTo(Main.class.getName());
            assertThat(manifest.getMainAttributes().getValue("Multi-Release")).isEqualTo("true");
            List<String> names = jar.stream().map(entry -> entry.getName()).toList();
            assertThat(names)
                    .doesNotHaveDuplicates()
                    .contains(
                            "META-INF/LICENSE",
                            "META-INF/NOTICE",
                            "META-INF/FastDoubleParser-LICENSE",
                            "META-INF/Schubfach-LICENSE",
                            "META-INF/services/com.fasterxml.jackson.core.JsonFactory")
                    .noneMatch(name -> name.endsWith("module-info.class"))
                    .anyMatch(name -> name.startsWith("META-INF/versions/17/"))
                    .noneMatch(name -> name.startsWith("org/junit/") || name.startsWith("org/jspecify/"));
            // One date for all, whenever they were built.
            assertThat(jar.stream()
                            .filter(entry -> entry.getName().startsWith("robosim/"))
                            .map(entry -> entry.getTimeLocal())
                            .distinct())
                    .hasSize(1);
            String inside = new String(
                    jar.getInputStream(jar.getEntry("META-INF/THIRD-PARTY.txt")).readAllBytes(),
                    StandardCharsets.UTF_8);
            String pom = Files.readString(Path.of("pom.xml"));
            for (String library : List.of("picocli", "jackson-core", "snakeyaml-engine")) {
                String property = library.replaceAll("-.*", "") + ".version>";
                String version = pom.substring(pom.indexOf(property) + property.length(), pom.indexOf("</" + property));
                assertThat(inside).contains(library + " " + version);
            }
        }
    }

    @Test
    void thePlainJarIsAModuleWithoutAnyDependencyInside() throws Exception {
        try (JarFile jar = new JarFile(PLAIN.toFile())) {
            List<String> names = jar.stream().map(entry -> entry.getName()).toList();
            assertThat(names).contains("module-info.class", "META-INF/LICENSE", "META-INF/demo/rooms.xml");
            assertThat(names)
                    .allMatch(name -> name.equals("module-info.class")
                            || "robosim/geometry/".startsWith(name)
                            || name.startsWith("robosim/geometry/")
                            || name.startsWith("META-INF/"));
        }
    }
}
