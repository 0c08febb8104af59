package robosim.geometry.junit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.ChildJvm;
import robosim.geometry.Geometry;

/** Tests of a user who has modules: everything on the module path of a process of its own, nothing on its class path. */
@Tag("clock")
@Timeout(120)
class ModulePathTest {
    private static final String MODULE = """
            open module my.robots.tests {
                requires robosim.geometry;
                requires org.junit.jupiter.api;
                requires org.junit.platform.launcher;
            }
            """;
    private static final String TESTS = """
            package my.robots.tests;

            import static org.junit.jupiter.api.Assertions.assertEquals;

            import java.util.random.RandomGenerator;
            import org.junit.jupiter.api.Test;
            import org.junit.platform.engine.TestExecutionResult;
            import org.junit.platform.engine.discovery.DiscoverySelectors;
            import org.junit.platform.launcher.TestExecutionListener;
            import org.junit.platform.launcher.TestIdentifier;
            import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
            import org.junit.platform.launcher.core.LauncherFactory;
            import robosim.geometry.Geometry;
            import robosim.geometry.junit.RobotWorld;
            import robosim.geometry.junit.World;
            import robosim.geometry.model.BoxObject;
            import robosim.geometry.model.CylinderObject;
            import robosim.geometry.model.Point;
            import robosim.geometry.net.GeometryServer;

            class Tests {
                static Geometry built() {
                    Geometry geometry = new Geometry(20, 4, 20);
                    geometry.addObject(new BoxObject(new Point(4, 0, 0), 1, 1, 4).named("wall"));
                    geometry.addObject(new CylinderObject(new Point(), 0.5, 1).moveable("r1"));
                    return geometry;
                }

                @Test
                @World(method = "built")
                void drives(RobotWorld world, RandomGenerator random) {
                    assertEquals(true, RobotWorld.class.getModule().isNamed());
                    world.robot("r1").drives(2).senses(0, 2);
                }

                @Test
                @World("room.xml")
                void reads(RobotWorld world, GeometryServer server) {
                    world.robot("robot").drives(1);
                }

                @Test
                @World(method = "built")
                void fails(RobotWorld world) {
                    world.robot("r1").drives(4);
                }

                public static void main(String[] args) {
                    LauncherFactory.create().execute(
                            LauncherDiscoveryRequestBuilder.request()
                                    .selectors(DiscoverySelectors.selectClass(Tests.class))
                                    .configurationParameter("robosim.evidence", args[0])
                                    .build(),
                            new TestExecutionListener() {
                                @Override
                                public void executionFinished(TestIdentifier test, TestExecutionResult result) {
                                    if (test.isTest()) {
                                        System.out.println(test.getDisplayName().replaceAll("\\\\(.*", "") + ": "
                                                + result.getStatus() + result.getThrowable().map(t -> " " + t).orElse(""));
                                    }
                                }
                            });
                }
            }
            """;
    private static final String ROOM = """
            <world xmlns="urn:robosim:world:1" width="10" height="2" length="6">
              <cylinder name="robot" moveable="true" radius="0.3" height="0.6"/>
            </world>
            """;

    /** The module, and those of JUnit and Jackson that surefire has on the class path here. */
    private static String modulePath() throws Exception {
        List<String> path = new ArrayList<>();
        path.add(Path.of(Geometry.class
                        .getProtectionDomain()
                        .getCodeSource()
                        .getLocation()
                        .toURI())
                .toString());
        Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                .filter(
                        jar -> jar.matches(
                                ".*[/\\\\](junit-(jupiter|platform)-(api|engine|commons|launcher)|opentest4j|jackson-core|jspecify|apiguardian-api)-[^/\\\\]*\\.jar"))
                .forEach(path::add);
        assertThat(path).hasSizeGreaterThanOrEqualTo(8);
        return String.join(File.pathSeparator, path);
    }

    private static Path compile(Path folder, String modulePath) throws IOException {
        Path sources = Files.createDirectories(folder.resolve("src/my/robots/tests"));
        Path classes = folder.resolve("classes");
        Files.writeString(folder.resolve("src/module-info.java"), MODULE);
        Files.writeString(sources.resolve("Tests.java"), TESTS);
        StringWriter said = new StringWriter();
        try (var files = ToolProvider.getSystemJavaCompiler()
                        .getStandardFileManager(null, null, StandardCharsets.UTF_8);
                Stream<Path> all = Files.walk(folder.resolve("src"))) {
            var units = files.getJavaFileObjectsFromPaths(
                    all.filter(file -> file.toString().endsWith(".java")).toList());
            List<String> options = List.of("-proc:none", "-d", classes.toString(), "--module-path", modulePath);
            assertThat(ToolProvider.getSystemJavaCompiler()
                            .getTask(said, files, null, options, null, units)
                            .call())
                    .as("%s", said)
                    .isTrue();
        }
        Files.writeString(classes.resolve("my/robots/tests/room.xml"), ROOM);
        return classes;
    }

    private static String run(Path classes, String modulePath, String more, Path evidence, String... options)
            throws Exception {
        List<String> command = ChildJvm.command(options);
        command.addAll(List.of(
                "--module-path",
                modulePath + File.pathSeparator + classes,
                "--add-modules",
                "org.junit.jupiter.engine" + more,
                "-m",
                "my.robots.tests/my.robots.tests.Tests",
                evidence.toString()));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
        return said;
    }

    @Test
    void testsRunThereAndLeaveTheirEvidence(@TempDir Path folder) throws Exception {
        String modulePath = modulePath();
        Path classes = compile(folder, modulePath);
        Path evidence = folder.resolve("evidence");
        String said = run(classes, modulePath, ",com.fasterxml.jackson.core", evidence);
        assertThat(said)
                .contains("drives: SUCCESSFUL", "reads: SUCCESSFUL")
                .contains("fails: FAILED", "blocked after 3 of 4 by box \"wall\"");
        assertThat(evidence.resolve("my.robots.tests.Tests.fails"))
                .isDirectoryContaining(file -> file.endsWith("replay.scenario.jsonl"))
                .isDirectoryContaining(file -> file.endsWith("last-moments.svg"))
                .isDirectoryContaining(file -> file.endsWith("last-moments.png"));
    }

    /** Optional modules are not looked for: without its name Jackson is not there, and the failure says so. */
    @Test
    void withoutJacksonAFailureStillHasItsPicture(@TempDir Path folder) throws Exception {
        String modulePath = modulePath();
        Path evidence = folder.resolve("evidence");
        String said = run(compile(folder, modulePath), modulePath, "", evidence);
        assertThat(said)
                .contains("drives: SUCCESSFUL")
                .contains("fails: FAILED", "replay: none, for jackson-core is not on the class path");
        // No empty file of a replay, which a folder of scenarios would take for one.
        assertThat(evidence.resolve("my.robots.tests.Tests.fails"))
                .isDirectoryContaining(file -> file.endsWith("last-moments.svg"))
                .isDirectoryNotContaining(file -> file.toString().contains("replay"));
    }

    /** A runtime without java.desktop can draw nothing: the failure stays the test's own, and has its replay. */
    @Test
    void withoutADesktopAFailureIsStillTheTestsOwn(@TempDir Path folder) throws Exception {
        String modulePath = modulePath();
        Path evidence = folder.resolve("evidence");
        String said = run(
                compile(folder, modulePath),
                modulePath,
                ",com.fasterxml.jackson.core",
                evidence,
                "--limit-modules",
                "my.robots.tests,org.junit.jupiter.engine,com.fasterxml.jackson.core");
        assertThat(said)
                .contains("drives: SUCCESSFUL")
                .contains("fails: FAILED", "blocked after 3 of 4 by box \"wall\"")
                .contains("png:    none, for the module java.desktop is not there");
        assertThat(evidence.resolve("my.robots.tests.Tests.fails"))
                .isDirectoryContaining(file -> file.endsWith("replay.scenario.jsonl"))
                .isDirectoryContaining(file -> file.endsWith("failure.txt"));
    }
}
