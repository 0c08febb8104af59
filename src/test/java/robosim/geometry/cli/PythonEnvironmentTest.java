package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.net.GeometryClient;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.NetOptions;
import robosim.geometry.net.SessionListener;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.scenario.drive.WorldLoading;

/** examples/environment.py, a process of its own, against the module in this one. */
@Tag("clock")
@Timeout(120)
class PythonEnvironmentTest {
    private static final Pattern SUMMARY =
            Pattern.compile("environment +([\\d,]+) steps? of (\\d+) robots?: ([\\d,]+) moves? asked, ([\\d,]+) made;"
                    + " ([\\d,]+) distances, ([\\d,]+) of them echoes");

    private final AtomicInteger carriedOut = new AtomicInteger();
    private final NetOptions options = NetOptions.defaults().withListeners(connection -> new SessionListener() {
        @Override
        public void answered(Bundle request, @Nullable Bundle answer, long nanoseconds) {
            carriedOut.incrementAndGet();
        }
    });

    @BeforeAll
    static void pythonIsThere() {
        boolean found;
        try {
            Process process =
                    new ProcessBuilder("python3", "-c", "import sys; sys.exit(sys.version_info < (3, 9))").start();
            found = process.waitFor(30, TimeUnit.SECONDS) && process.exitValue() == 0;
        } catch (IOException | InterruptedException e) {
            found = false;
        }
        assumeTrue(found, "python3 of at least 3.9 must be on the path to try the Python package and examples");
    }

    private static Process start(String... arguments) throws IOException {
        List<String> command = new ArrayList<>(
                List.of("python3", Examples.FOLDER.resolve("environment.py").toString()));
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command).redirectErrorStream(true).start();
    }

    private static String rest(BufferedReader output) {
        return String.join("\n", output.lines().toList());
    }

    private static BufferedReader output(Process process) {
        return new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    }

    private void checkSummary(String text, int steps, int robots) {
        Matcher summary = SUMMARY.matcher(text);
        assertThat(summary.find()).as(text).isTrue();
        int asked = number(summary, 3);
        assertThat(number(summary, 1)).isEqualTo(steps);
        assertThat(number(summary, 2)).isEqualTo(robots);
        assertThat(asked).isEqualTo(steps * robots);
        // A walk that meets nothing, or goes nowhere, would prove nothing.
        assertThat(number(summary, 4)).isBetween(asked / 2, asked - 1);
        assertThat(number(summary, 6)).isBetween(number(summary, 5) / 10, number(summary, 5) - 1);
        assertThat(text).contains("every answer kept to the protocol", "times blocked by");
        assertThat(carriedOut).hasValue(1 + 2 * steps + 1);
    }

    private static int number(Matcher summary, int group) {
        return Integer.parseInt(summary.group(group).replace(",", ""));
    }

    @Test
    void dialsAModuleThatListens() throws Exception {
        try (GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options)) {
            String place = InetAddress.getLoopbackAddress().getHostAddress() + ":" + server.port();
            Process process =
                    start("--world", "worlds/rooms.xml", "--connect", place, "--steps", "150", "--speed", "0.1");
            String text = rest(output(process));
            assertThat(process.waitFor()).as(text).isZero();
            checkSummary(text, 150, 8);
        }
    }

    /** Each world in worlds/: what cannot be read of one is told, and the rest is driven through. */
    @ParameterizedTest
    @MethodSource("worlds")
    void everyWorldCanBeDrivenThrough(Path world) throws Exception {
        try (GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options)) {
            Process process =
                    start("--world", world.toString(), "--connect", "127.0.0.1:" + server.port(), "--steps", "3");
            String text = rest(output(process));
            assertThat(process.waitFor()).as(text).isZero();
            assertThat(text).contains("3 steps of ", "every answer kept to the protocol");
            boolean isRound = world.endsWith("meshes.xml"); // has a face of eight corners
            assertThat(text.lines().filter(line -> line.startsWith("left out: ")))
                    .hasSize(isRound ? 1 : 0);
        }
    }

    /** What `add` writes includes the world that it was given; only the module reads that. */
    @Test
    void aWorldThatIncludesAnotherIsLoadedByTheModule(@TempDir Path folder) throws Exception {
        Files.copy(Path.of("worlds", "hard.xml"), folder.resolve("hard.xml"));
        Path world = folder.resolve("more.xml");
        Files.writeString(world, """
            <world xmlns="urn:robosim:world:1" width="60" height="10" length="60">
              <include file="hard.xml"/>
              <cylinder name="one more" center="25 0 25" moveable="true" radius="0.3" height="1"/>
            </world>
            """);
        NetOptions loading = options.withWorlds(WorldLoading.of(null, List.of()));
        try (GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, loading)) {
            Process process =
                    start("--world", world.toString(), "--connect", "127.0.0.1:" + server.port(), "--steps", "20");
            String text = rest(output(process));
            assertThat(process.waitFor()).as(text).isZero();
            assertThat(text).contains("20 steps of ", "every answer kept to the protocol");
        }
    }

    static List<Path> worlds() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("worlds"))) {
            List<Path> worlds = files.filter(file -> file.toString().endsWith(".xml"))
                    .sorted()
                    .toList();
            assertThat(worlds).hasSizeGreaterThan(5);
            return worlds;
        }
    }

    @Test
    void listensForAModuleThatDials() throws Exception {
        Process process = start("--world", "worlds/hard.xml", "--listen", "0", "--steps", "150", "--speed", "0.1");
        BufferedReader output = output(process);
        String line = output.readLine();
        assertThat(line).matches("Listening on port \\d+");
        try (GeometryClient client =
                new GeometryClient("127.0.0.1", Integer.parseInt(line.replaceAll("\\D", "")), options)) {
            Thread thread = new Thread(client);
            thread.start();
            String text = rest(output);
            assertThat(process.waitFor()).as(text).isZero();
            checkSummary(text, 150, 5);
            thread.join(10_000);
            assertThat(thread.isAlive()).isFalse();
        }
    }

    /** The program of docs/guide-robosim.md, but for its port. */
    @Test
    void theProgramOfTheGuideTalks() throws Exception {
        String page = Files.readString(Path.of("docs", "guide-robosim.md"));
        Matcher block = Pattern.compile("```python\n(.*?)```", Pattern.DOTALL).matcher(page);
        assertThat(block.find()).isTrue();
        try (GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options)) {
            String program = block.group(1).replace("7575", String.valueOf(server.port()));
            Process process = new ProcessBuilder("python3", "-c", program)
                    .redirectErrorStream(true)
                    .start();
            String text = rest(output(process));
            assertThat(process.waitFor()).as(text).isZero();
            assertThat(text.lines())
                    .containsExactly(
                            "robosim-geometry 1.0.0-rc.1",
                            "[2.9]",
                            "[{'index': 0, 'reason': 'blocked by \"wall\" after 0.529 of the way'}]");
        }
    }

    /** Of a file the module and the environment take the first line, as it is. */
    @Test
    void tellsTheSecretOfAFile(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("secret");
        Files.writeString(file, "a secret of \u00e9leven words \nand a remark\n");
        char[] secret = "a secret of \u00e9leven words ".toCharArray();
        try (GeometryServer server =
                new GeometryServer(InetAddress.getLoopbackAddress(), 0, options.withAccess(null, secret))) {
            Process process = start(
                    "--world",
                    "worlds/rooms.xml",
                    "--connect",
                    "127.0.0.1:" + server.port(),
                    "--steps",
                    "150",
                    "--speed",
                    "0.1",
                    "--secret-file",
                    file.toString());
            String text = rest(output(process));
            assertThat(process.waitFor()).as(text).isZero();
            checkSummary(text, 150, 8);
        }
    }

    /** Objects of every kind from a world file are what the module takes them for. */
    @Test
    void understandsTheWorldFormat(@TempDir Path folder) throws Exception {
        Path world = folder.resolve("all.xml");
        Files.writeString(folder.resolve("tent.obj"), """
            v 0 0 0
            v 1 0 0
            v 1 1 0.5
            v 0 1 0.5
            f 1/1 2/2 3/3 4/4
            f -4 -3 -2
            """);
        Files.writeString(world, """
            <world xmlns="urn:robosim:world:1" width="20" height="4" length="20" unit="m">
              <material name="tiles" diffuse="0.8" label="3"><checker first="#ffffff" second="#204060" size="0.5"/></material>
              <box center="0 0 -3" width="3" height="1" length="20cm" turned="30 40" material="tiles"/>
              <mesh center="3 0 0" heading="90" solid="true">
                <bounds><sphere radius="3"/></bounds>
                <vertices>0 0 0 1 0 0 0 1 0 0 0 1</vertices>
                <triangles>0 1 2 0 2 3 0 3 1 1 3 2</triangles>
              </mesh>
              <mesh center="-3 0 0" file="tent.obj" scale="0.5"/>
              <group center="0 0 3" rotation="0 0 1 0 1 0 -1 0 0">
                <sphere center="0 0 0" radius="0.5"/><cylinder center="1 0 0" radius="0.2" height="1"/>
              </group>
              <capsule center="-6 0 -4" radius="0.3" segment="1" turned="50 20"/>
              <grid name="map" center="0 0 5" heading="90" cell="25cm" height="2" columns="7" rows="2">1 3 3 0 2 4 1</grid>
              <cylinder name="robot" moveable="true" radius="0.3" height="1"><sonar count="12" max="5" width="20"/></cylinder>
            </world>
            """);
        try (GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options)) {
            Process process = start(
                    "--world",
                    world.toString(),
                    "--connect",
                    "127.0.0.1:" + server.port(),
                    "--steps",
                    "200",
                    "--speed",
                    "0.2");
            String text = rest(output(process));
            assertThat(process.waitFor()).as(text).isZero();
            checkSummary(text, 200, 1);
        }
    }

    private static final String ROBOT =
            "<cylinder name='r' moveable='true' radius='0.3' height='1'><sonar count='8'/></cylinder>";

    /** What stands in a world of 20 x 4 x 20 m, and what is told of it. */
    static List<Arguments> faults() {
        return List.of(
                Arguments.of(
                        "<box width='-1' height='1' length='1'/>", ":2: width of <box> must be at least 0 (got: -1)"),
                Arguments.of(
                        "<box width='1' height='1' length='1' centre='3 0 0'/>", ":2: <box> has no attribute centre"),
                Arguments.of("<ball radius='1'/>", ":2: there is no <ball> in a world"),
                Arguments.of("<box width='1' length='1'/>", ":2: <box> needs the attribute height"),
                Arguments.of(
                        "<box width='1' height='1' length='x'/>", ":2: length of <box> must be a number like 0.25 or"),
                Arguments.of("<box width='1' height='1e999' length='1'/>", ":2: height of <box> must be at most 2^100"),
                Arguments.of("<box width='1' height='1' length='1' center='3 0'/>", "must be 3 numbers (got: 2)"),
                Arguments.of(
                        "<box width='1' height='1' length='1' moveable='yes'/>", "moveable must be one of true, false"),
                Arguments.of(
                        "<box width='1' height='1' length='1' moveable='true'/>", "a moveable object needs a name"),
                Arguments.of(
                        "<sphere radius='1' heading='1' turned='0 1'/>",
                        "must have at most one of heading, turned and"),
                Arguments.of("<sphere name='r' radius='1' center='3 0 0'/>", "must be unique in a world; "),
                Arguments.of("<sphere radius='1' center='-300 0 0'/>", ":2: this <sphere> reaches beyond the world;"),
                Arguments.of(
                        "<box width='1' height='1' length='20' heading='3'/>",
                        ":2: this <box> reaches beyond the world;"),
                Arguments.of(
                        "<group center='9 0 0' heading='90'><cylinder center='0 0 -1' radius='0.1'"
                                + " height='1'/></group>",
                        "1 step of 1 robot: 1 move asked"),
                Arguments.of(
                        "<group center='9 0 0' heading='90'><cylinder center='0 0 1' radius='0.1' height='1'/></group>",
                        ":2: this <group> reaches beyond the world;"),
                Arguments.of(
                        "<grid cell='1' height='1' columns='3' rows='2'>1 2 0 2</grid>",
                        ":2: the runs of row 1 of <grid> must add up to 3 cells, in turn free and occupied"),
                Arguments.of(
                        "<grid cell='1' height='1' columns='3' rows='1'>1 2 3</grid>",
                        ":2: the runs of <grid> must end with the last of 1 rows"),
                Arguments.of(
                        "<grid cell='1' height='1' columns='3' rows='1'>1 two</grid>",
                        ":2: <grid> must hold run lengths, whole numbers from 0"),
                Arguments.of(
                        "<grid cell='1' height='1' columns='99999' rows='99999'>1</grid>",
                        ":2: columns and rows of <grid> must be whole numbers, of 16777216 cells at most"),
                Arguments.of(
                        "<grid cell='1' height='1' columns='3' rows='1' moveable='true' name='g'>3</grid>",
                        ":2: <grid> has no attribute moveable"),
                Arguments.of(
                        "<grid cell='1' height='1' columns='3' rows='1'>3</grid>",
                        ":2: the module refused it: line 2, at /objects/0/occupied: occupied must have a bit"),
                Arguments.of(
                        "<box name='b' width='1' height='1' length='1'><body mass='3'/></box>",
                        ":2: <body> of a static object must have a surface alone: restitution, friction,"),
                Arguments.of(
                        "<sphere radius='1'><body restitution='1'/></sphere>",
                        ":2: <sphere> must have one <body> at most, and a name with it"),
                Arguments.of(
                        "<sphere name='b' moveable='true' radius='1'><body><drive kind='jet'/></body></sphere>",
                        ":2: a drive must be one of DIFFERENTIAL, OMNIDIRECTIONAL, ACKERMANN, SWERVE, VELOCITY, FORCE"),
                Arguments.of("<group/>", ":2: <group> must have a member"),
                Arguments.of("<mesh file='../up.obj'/>", ":2: file must lead to a file under the folder of the world"),
                Arguments.of("<mesh file='no.obj'/>", "no.obj cannot be read (No such file or directory)"),
                Arguments.of("<mesh file='no.stl'/>", "reads meshes of OBJ files alone (got: no.stl)"),
                Arguments.of(
                        "<mesh><vertices>0 0 0 1 0 0 0 1 0</vertices><triangles>0 1 3</triangles></mesh>",
                        ":2: an index must be from 0 to 2, the last vertex (got: [0, 1, 3])"),
                Arguments.of(
                        "<mesh solid='true'><vertices>0 0 0 1 0 0 0 1 0</vertices><triangles>0 1 2</triangles></mesh>",
                        ":2: the module refused it: line 2, at /objects/0: a solid mesh must be closed"),
                Arguments.of("<box width='1'", "this is no well-formed XML"));
    }

    /** The program, once for each world, in one process: the folder, the address of the module, the worlds. */
    private static final String EACH = """
            import contextlib, io, os, runpy, sys, traceback
            program, place, *worlds = sys.argv[1:]
            sys.path.insert(0, os.path.dirname(program))
            for world in worlds:
                sys.argv = [program, "--world", world, "--connect", place, "--steps", "1"]
                said, code = io.StringIO(), 0
                with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
                    try:
                        runpy.run_path(program, run_name="__main__")
                    except SystemExit as end:
                        code = end.code or 0
                    except BaseException:
                        traceback.print_exc()
                print(code, said.getvalue(), sep="\\n", end="\\f")
            """;

    /** A module is there: what is told is the world's fault, and not that of a connection. */
    @Test
    void aFaultyWorldIsToldWithItsLine(@TempDir Path folder) throws Exception {
        List<Arguments> faults = faults();
        List<String> command = new ArrayList<>(List.of(
                "python3", "-c", EACH, Examples.FOLDER.resolve("environment.py").toString()));
        try (GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options)) {
            command.add("127.0.0.1:" + server.port());
            for (int k = 0; k < faults.size(); k++) {
                Path world = Files.writeString(
                        folder.resolve("faulty" + k + ".xml"),
                        "<world xmlns='urn:robosim:world:1' width='20' height='4' length='20' unit='m'>\n"
                                + faults.get(k).get()[0] + "\n" + ROBOT + "</world>");
                command.add(world.toString());
            }
            String[] said = rest(output(new ProcessBuilder(command)
                            .redirectErrorStream(true)
                            .start()))
                    .split("\f");
            assertThat(said).hasSameSizeAs(faults);
            for (int k = 0; k < said.length; k++) {
                String what = String.valueOf(faults.get(k).get()[0]);
                String told = String.valueOf(faults.get(k).get()[1]);
                int line = said[k].indexOf('\n');
                String text = said[k].substring(line + 1);
                boolean done = told.startsWith("1 step ");
                assertThat(text).as(what).contains(told).doesNotContain("Traceback");
                if (!done) {
                    assertThat(text).as(what).startsWith("Not done: " + folder).hasLineCount(1);
                }
                assertThat(said[k].substring(0, line))
                        .as(what)
                        .isEqualTo("" + (done ? ExitCodes.FINE : ExitCodes.UNUSABLE));
            }
        }
    }

    @Test
    void whatElseCannotBeDoneIsToldWithItsRemedy(@TempDir Path folder) throws Exception {
        Path secret = Files.writeString(folder.resolve("secret"), "of another\n");
        Path still = Files.writeString(
                folder.resolve("still.xml"), "<world xmlns='urn:robosim:world:1' width='2' height='4' length='2'/>");
        String rooms = "worlds/rooms.xml";
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                GeometryServer server = new GeometryServer(
                        InetAddress.getLoopbackAddress(),
                        0,
                        options.withAccess(null, "a secret of many words".toCharArray()))) {
            String port = String.valueOf(taken.getLocalPort());
            String place = "127.0.0.1:" + server.port();
            refused("port " + port + " cannot be listened on", "--world", rooms, "--listen", port);
            refused("must hold a moveable object", "--world", still.toString(), "--connect", place);
            refused("the world cannot be read; check the path", "--world", "nowhere.xml", "--connect", place);
            refused("check --secret-file", "--world", rooms, "--connect", place, "--secret-file", "nowhere");
            refused("the module refused it: ", "--world", rooms, "--connect", place);
            refused(
                    "the module refused it: ",
                    "--world",
                    rooms,
                    "--connect",
                    place,
                    "--secret-file",
                    secret.toString());
            refused("must be HOST:PORT", "--world", rooms, "--connect", "localhost");
            refused("a port must be 1 to 65535 (got: 0)", "--world", rooms, "--connect", "localhost:0");
            refused("must be a number above 0 (got: nan)", "--world", rooms, "--connect", place, "--speed", "nan");
            refused("at least 0 (got: -1)", "--world", rooms, "--connect", place, "--steps=-1");
            taken.close();
            refused(
                    "nobody listens at 127.0.0.1:" + port + "; start the module first, in another terminal: mvn -q"
                            + " compile exec:java -Dexec.args=\"serve " + port + "\"",
                    "--world",
                    rooms,
                    "--connect",
                    "127.0.0.1:" + port);
        }
    }

    private static void refused(String told, String... arguments) throws Exception {
        Process process = start(arguments);
        String text = rest(output(process));
        assertThat(text).contains(told).doesNotContain("Traceback");
        assertThat(process.waitFor()).as(text).isEqualTo(ExitCodes.UNUSABLE);
    }

    /** What is no module answers otherwise; that is a fault of the protocol, and no finding of ours. */
    @Test
    void whatIsNoModuleIsToldSo() throws Exception {
        try (ServerSocket web = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            Process process = start("--world", "worlds/rooms.xml", "--connect", "127.0.0.1:" + web.getLocalPort());
            try (Socket socket = web.accept()) {
                socket.getInputStream().read();
                String bad = "HTTP/1.1 400 Bad Request\r\nConnection: close\r\n\r\n";
                socket.getOutputStream().write(bad.getBytes(StandardCharsets.US_ASCII));
                String text = rest(output(process));
                assertThat(text)
                        .startsWith("The module broke the protocol: ")
                        .contains("is it the geometry module that listens there?")
                        .hasLineCount(1);
                assertThat(process.waitFor()).isEqualTo(ExitCodes.FINDINGS);
            }
        }
    }
}
