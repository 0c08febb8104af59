package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Element;
import robosim.geometry.ChildJvm;
import robosim.geometry.Geometry;
import robosim.geometry.cli.demo.Program;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.world.WorldReader;

/** The programs of examples/, each started by the one command that its header names. */
@Tag("clock")
@Timeout(120)
class ExampleProgramsTest {
    @TempDir
    private static Path compiled;

    /** What a program printed that was run as its header says, and its exit code at the end. */
    private static String run(String name, String... arguments) throws IOException, InterruptedException {
        Path source = Examples.FOLDER.resolve(name + ".java");
        String command = "java -cp target/classes " + source;
        assertThat(Files.readString(source)).as("the header of %s", source).contains(command);
        return started(Program.home().toString(), source.toString(), arguments);
    }

    private static String started(String classes, String program, String... arguments)
            throws IOException, InterruptedException {
        List<String> words = ChildJvm.command("-cp", classes, program);
        words.addAll(List.of(arguments));
        Process process = new ProcessBuilder(words).redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
        return said + "exit " + process.exitValue();
    }

    private static Matcher match(String pattern, String text) {
        Matcher matcher = Pattern.compile(pattern).matcher(text);
        assertThat(matcher.find()).as("%s in %s", pattern, text).isTrue();
        return matcher;
    }

    private static Element picture(Path file) throws Exception {
        return DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(file.toFile())
                .getDocumentElement();
    }

    /** A run that was ended and continued, on another number of threads, writes the same files as one in one piece. */
    @Test
    void theDatasetIsTheSameInPieces(@TempDir Path folder) throws Exception {
        Path whole = folder.resolve("whole");
        Path pieces = folder.resolve("pieces");
        assertThat(run("VisionDataset", "worlds/rooms.xml", whole.toString(), "3", "1"))
                .contains("3 new frames of 3");
        assertThat(run("VisionDataset", "worlds/rooms.xml", pieces.toString(), "1", "1"))
                .contains("1 new frames of 1");
        assertThat(run("VisionDataset", "worlds/rooms.xml", pieces.toString(), "3", "2"))
                .contains("2 new frames of 3");
        try (Stream<Path> files = Files.walk(whole)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                assertThat(pieces.resolve(whole.relativize(file))).hasSameBinaryContentAs(file);
            }
        }
        Matcher box = Pattern.compile(
                        "\"area\":(\\d+),\"bbox\":\\[(\\d+),(\\d+),(\\d+),(\\d+)],\"visible_fraction\":([\\d.E-]+),"
                                + ".*\"counts\":\\[([^]]*)]")
                .matcher(Files.readString(whole.resolve("coco.json")));
        int hidden = 0;
        int count = 0;
        for (; box.find(); count++) {
            int[] runs = Stream.of(box.group(7).split(", ", -1))
                    .mapToInt(Integer::parseInt)
                    .toArray();
            assertThat(IntStream.of(runs).sum()).isEqualTo(320 * 240);
            int inside = IntStream.range(0, runs.length / 2)
                    .map(k -> runs[2 * k + 1])
                    .sum();
            assertThat(inside).isEqualTo(Integer.parseInt(box.group(1)));
            int wide = Integer.parseInt(box.group(4));
            int left = Integer.parseInt(box.group(2));
            assertThat(runs[0] / 240).isEqualTo(left); // the first column with a pixel
            assertThat(left + wide).isBetween(1, 320);
            assertThat(inside).isBetween(1, wide * Integer.parseInt(box.group(5)));
            double visible = Double.parseDouble(box.group(6));
            assertThat(visible).isBetween(0.0, 1.0);
            hidden += visible < 1 ? 1 : 0;
        }
        assertThat(hidden).isBetween(1, count);
    }

    /** Both find a path, and the pictures show the robot along it. */
    @Test
    void plannersFindTheirWay(@TempDir Path folder) throws Exception {
        String said = run("Planner", folder.toString(), "1");
        for (String robot : List.of("car", "drone")) {
            int poses = Integer.parseInt(
                    match(robot + ": (\\d+) poses, \\d+ drives swept", said).group(1));
            int drawn = picture(folder.resolve(robot + ".svg"))
                    .getElementsByTagName("rect")
                    .getLength();
            assertThat(poses).isGreaterThan(20);
            assertThat(drawn).isGreaterThan(poses);
        }
        assertThat(said).endsWith("exit 0");
    }

    @Test
    void embeddingTakesTenLines() throws Exception {
        String said = run("EmbedInTenLines");
        assertThat(said.lines())
                .containsExactly(
                        "sonar hears:   3.9",
                        "moves forward: true",
                        "through walls: false",
                        match("up to it: .*", said).group(),
                        match("gap left:      0\\.05.*", said).group(),
                        "exit 0");
        String source = Files.readString(Examples.FOLDER.resolve("EmbedInTenLines.java"));
        String body = source.substring(source.indexOf("main(String[] args) {"), source.lastIndexOf("    }"));
        assertThat(body.lines().skip(1).count()).isLessThanOrEqualTo(10);
    }

    @Test
    void contactsAreNamedByTheirFaces() throws Exception {
        assertThat(run("ContactTriangles"))
                .contains("meets face", "after 3 steps: from ", "do they touch? YES", "exit 0");
    }

    /** Each circle of the picture stands where a ray of its own, asked for here, meets something. */
    @Test
    void theScanPlotsWhatTheRaysMet(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("new/scan.svg");
        String said = run("LaserScan", "worlds/rooms.xml", "drum 2", file.toString());
        Matcher told = match("(\\d+) rays from \"drum 2\", (\\d+) echoes within 10\\.0", said);
        int rays = Integer.parseInt(told.group(1));
        int echoes = Integer.parseInt(told.group(2));
        assertThat(said).endsWith("exit 0");
        assertThat(said.lines().filter(line -> line.contains("R") && line.contains("#")))
                .isNotEmpty();

        Geometry geometry = WorldReader.read(Path.of("worlds/rooms.xml")).toGeometry();
        Point at = geometry.getObject("drum 2").center();
        double heading = Math.toRadians(geometry.getObject("drum 2").heading());
        List<Point> expected = new ArrayList<>();
        for (int k = 0; k < rays; k++) {
            double angle = heading + k * 2 * Math.PI / rays;
            Point towards = new Point(Math.cos(angle), 0, -Math.sin(angle));
            double distance = geometry.getRayDistance(new Ray(at, towards), 0, 10, 0, "drum 2");
            if (Double.isFinite(distance)) {
                expected.add(new Point(at.x() + distance * towards.x(), 0, at.z() + distance * towards.z()));
            }
        }
        assertThat(echoes).isBetween(rays / 10, rays - 1).isEqualTo(expected.size());
        var circles = picture(file).getElementsByTagName("circle");
        List<Point> drawn = IntStream.range(0, circles.getLength())
                .mapToObj(k -> (Element) circles.item(k))
                .filter(circle -> circle.getParentNode() instanceof Element group
                        && group.getAttribute("class").equals("echoes"))
                .map(circle -> new Point(
                        Double.parseDouble(circle.getAttribute("cx")),
                        0,
                        Double.parseDouble(circle.getAttribute("cy"))))
                .toList();
        assertThat(drawn).hasSize(echoes);
        for (int k = 0; k < echoes; k++) {
            Point a = drawn.get(k);
            Point b = expected.get(k);
            assertThat(Math.hypot(a.x() - b.x(), a.z() - b.z()))
                    .as("echo %d", k)
                    .isLessThan(0.01);
        }
    }

    /** The first as the header says; it is compiled but once for the others. */
    @ParameterizedTest
    @ValueSource(strings = {"mouse 3", "mouse 1", "cart"})
    void theMazeIsLeft(String robot, @TempDir Path folder) throws Exception {
        Path file = folder.resolve("maze.svg");
        String said;
        if (robot.equals("mouse 3")) {
            said = run("MazeSolver", robot, file.toString());
        } else {
            if (!Files.exists(compiled.resolve("MazeSolver.class"))) {
                Path source = Examples.FOLDER.resolve("MazeSolver.java");
                assertThat(Examples.compile(List.of(source), compiled)).isEmpty();
            }
            said = started(Program.home() + File.pathSeparator + compiled, "MazeSolver", robot, file.toString());
        }
        Matcher told = match("left the maze at .* after (\\d+) drives .* has (\\d+) drives", said);
        int drives = Integer.parseInt(told.group(1));
        int found = Integer.parseInt(told.group(2));
        assertThat(found).isBetween(5, drives);
        assertThat(said).contains("checked: it never came nearer than 0.").endsWith("exit 0");
        var lines = picture(file).getElementsByTagName("polyline");
        assertThat(lines.getLength()).isEqualTo(2);
        assertThat(((Element) lines.item(0)).getAttribute("points").split(" ")).hasSize(drives + 1);
        assertThat(((Element) lines.item(1)).getAttribute("points").split(" ")).hasSize(found + 1);
        if (robot.equals("mouse 3")) {
            assertThat(file)
                    .as("docs/images/maze.svg, which is this picture")
                    .hasSameTextualContentAs(Path.of("docs", "images", "maze.svg"));
        }
    }

    @Test
    void theSwarmNeverTouches() throws Exception {
        String said = run("Swarm", "400", "300", "7");
        Matcher told = match("400 robots, 300 steps: ([\\d,]+) moves made, ([\\d,]+) refused", said);
        int made = Integer.parseInt(told.group(1).replace(",", ""));
        int refused = Integer.parseInt(told.group(2).replace(",", ""));
        assertThat(made + refused).isEqualTo(400 * 300);
        assertThat(refused).as("a crowd that is in its own way").isBetween(6_000, 60_000);
        // 400 robots and 20 pillars.
        assertThat(said).contains("checked: of 87,990 pairs 0 touch or overlap").endsWith("exit 0");
    }
}
