package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.SlideResult;
import robosim.geometry.Snapshot;
import robosim.geometry.dynamics.AckermannDrive;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.Drive;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.ForceDrive;
import robosim.geometry.dynamics.Odometry;
import robosim.geometry.dynamics.OmnidirectionalDrive;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.dynamics.VelocityDrive;
import robosim.geometry.junit.Goal;
import robosim.geometry.junit.Robot;
import robosim.geometry.junit.RobotWorld;
import robosim.geometry.junit.Scenarios;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;
import robosim.geometry.sweep.Outcome;
import robosim.geometry.sweep.ParameterSweep;
import robosim.geometry.sweep.Result;
import robosim.geometry.sweep.ScenarioSweep;
import robosim.geometry.sweep.Shard;
import robosim.geometry.sweep.SweepResults;
import robosim.geometry.sweep.SweepRun;
import robosim.geometry.sweep.SweepSummary;
import robosim.geometry.sweep.SweepWorld;
import robosim.geometry.viewer.draw.Painter;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.viewer.web.LiveFilm;
import robosim.geometry.viewer.web.PageServer;
import robosim.geometry.world.ImportOptions;
import robosim.geometry.world.SdfSensor;
import robosim.geometry.world.Unit;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldImport;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;
import robosim.geometry.world.WorldWriter;
import robosim.geometry.world.check.WorldCheck;
import robosim.geometry.world.shared.AtomicFileWriter;

/** Where a value must be given, null is refused as every other bad argument: by its name, and not by the JVM. */
@SuppressWarnings("NullAway")
class NullsTest {
    private final Map<String, ThrowingCallable> calls = new LinkedHashMap<>();

    @TempDir
    Path folder;

    /** @param argument what the message must begin with, and anything that tells the call from others behind a space */
    private void call(String argument, ThrowingCallable call) {
        calls.put(argument + " #" + calls.size(), call);
    }

    private static <T> List<T> holding(T one) {
        return new ArrayList<>(Arrays.asList(one, null));
    }

    private void check() {
        List<String> wrong = new ArrayList<>();
        calls.forEach((name, call) -> {
            String argument = name.substring(0, name.lastIndexOf(' '));
            Throwable thrown = catchThrowable(call);
            boolean right = thrown instanceof IllegalArgumentException
                    && String.valueOf(thrown.getMessage()).startsWith(argument)
                    && thrown.getMessage().endsWith("(got: null)");
            if (!right) {
                wrong.add(name + ": " + thrown);
            }
        });
        assertThat(wrong).isEmpty();
    }

    @Test
    void ofMoves() {
        Geometry world = new Geometry();
        world.addObject(new SphereObject(new Point(), 1).moveable("ball"));
        call("name", () -> world.moveAndSlide(null, new Move(), 0, 1));
        call("move", () -> world.moveAndSlide("ball", null, 0, 1));
        call("made", () -> new SlideResult(null, 0, new Point(), 1, List.of()));
        call("left", () -> new SlideResult(new Point(), 0, null, 1, List.of()));
        call("contacts", () -> new SlideResult(new Point(), 0, new Point(), 1, null));
        check();
    }

    @Test
    void ofDynamics() {
        Body body = Body.of(1, 1);
        Twist still = new Twist(0, 0, 0, 0);
        call("surface", () -> body.withSurface(null));
        call("shape", () -> Body.ofMass(null, 1));
        call("shape", () -> Body.ofDensity(null, 1));
        call("velocity", () -> body.limited(null));
        call("other", () -> Surface.SMOOTH.against(null));
        call("velocity", () -> new VelocityDrive(null));
        call("command", () -> new OmnidirectionalDrive(1, 1, 1, 1, null));
        for (Drive drive : List.of(
                new VelocityDrive(still),
                new ForceDrive(1, 1, 1),
                new DifferentialDrive(1, 1, 1),
                new OmnidirectionalDrive(1, 1, 1, 1),
                new AckermannDrive(1, 1, 1, 1))) {
            call("now", () -> drive.next(null, body, 1));
            call("body", () -> drive.next(still, null, 1));
        }
        Odometry odometry = new Odometry(1, 1, 1, 1, 1);
        Geometry flat = new Geometry(9, 9, 9, Dimension.PLANAR, Accuracy.EXACT);
        flat.addObject(new SphereObject(new Point(), 1).moveable("ball"));
        Dynamics dynamics = new Dynamics(flat, Surface.SMOOTH);
        dynamics.add("ball", body);
        call("world", () -> new Dynamics(null, Surface.SMOOTH));
        call("ground", () -> new Dynamics(flat, null));
        call("name", () -> dynamics.add(null, body));
        call("body", () -> dynamics.add("ball", null));
        call("name", () -> dynamics.velocity(null));
        call("velocity", () -> dynamics.setVelocity("ball", null));
        call("drive", () -> dynamics.drive("ball", null));
        call("contacts", () -> new StepResult(null, List.of()));
        call("stopped", () -> new StepResult(List.of(), null));
        call("had", () -> odometry.measured(null, 1, "cart", 1));
        call("robot", () -> odometry.measured(still, 1, null, 1));
        check();
    }

    @Test
    void ofWorlds() {
        InputStream in = new ByteArrayInputStream(new byte[0]);
        Path file = folder.resolve("none.xml");
        World world = new World(1, 1, 1, List.of());
        call("models", () -> ImportOptions.DEFAULT.withModels(null));
        call("models[1]", () -> ImportOptions.DEFAULT.withModels(holding(file)));
        call("file", () -> WorldReader.readMesh(null));
        call("file", () -> WorldReader.readMesh(null, 1));
        call("in", () -> WorldReader.readMesh(null, "t", 1));
        call("source", () -> WorldReader.readMesh(in, null, 1));
        call("world", () -> WorldWriter.writeObj(null, file, done -> {}));
        call("file", () -> WorldWriter.writeObj(world, null, done -> {}));
        call("progress", () -> WorldWriter.writeObj(world, file, null));
        call("file", () -> SdfSensor.read(null, List.of()));
        call("models", () -> SdfSensor.read(file, null));
        call("models[1]", () -> SdfSensor.read(file, holding(folder)));
        call("file", () -> AtomicFileWriter.write(null, out -> {}));
        call("content", () -> AtomicFileWriter.write(file, null));
        call("dimension", () -> new World(1, 1, 1, Unit.METRE, null, Accuracy.EXACT, List.of()));
        call("accuracy", () -> new World(1, 1, 1, Unit.METRE, Dimension.PLANAR, null, List.of()));
        call("objects", () -> new World(1, 1, 1, null));
        call("objects[0]", () -> new World(1, 1, 1, Arrays.asList((WorldObject) null)));
        call("refused", () -> world.toGeometry(null));
        call("world", () -> WorldCheck.of(null));
        call("watch", () -> WorldCheck.of(world, null));
        call("read", () -> WorldCheck.of((WorldImport) null, (work, done, total) -> {}));
        call("file", () -> WorldImport.read(null, ImportOptions.DEFAULT));
        call("options", () -> WorldImport.read(file, null));
        call("object", () -> new WorldObject(null));
        call("file", () -> WorldReader.read(null));
        call("in", () -> WorldReader.read(null, "t", null));
        call("source", () -> WorldReader.read(in, null, null));
        call("file", () -> WorldReader.problems(null));
        call("options", () -> WorldReader.problems(file, null));
        call("world", () -> WorldWriter.write(null, file));
        call("file", () -> WorldWriter.write(world, null));
        call("world", () -> WorldWriter.toXml(null));
        check();
    }

    @Test
    void ofPatternsAndBatches() {
        Geometry world = new Geometry(9, 9, 9);
        world.addObject(new SphereObject(new Point(), 1).moveable("r"));
        Snapshot snapshot = world.snapshot();
        RayPattern fan = RayPattern.fan(0, 1, 3);
        SenseOptions options = SenseOptions.range(0, 9);
        SenseBuffer out = new SenseBuffer();
        Pose pose = Pose.ORIGIN;
        call("elevationsDegrees", () -> RayPattern.layers(null, 0, 1, 2));
        call("directions", () -> RayPattern.of(null));
        call("out", () -> fan.directions(0, 1, null, 0));
        call("carrier", () -> options.withCarrier(null));
        call("extras", () -> new SenseBuffer((SenseBuffer.Extra[]) null));
        call("extra", () -> new SenseBuffer((SenseBuffer.Extra) null));
        call("name", () -> world.sense(null, pose, fan, options, out));
        call("mount", () -> world.sense("r", null, fan, options, out));
        call("sensor", () -> world.sense(null, fan, options, out));
        call("pattern", () -> world.sense(pose, null, options, out));
        call("options", () -> world.sense(pose, fan, null, out));
        call("out", () -> world.sense(pose, fan, options, null));
        call("name", () -> snapshot.sense(null, pose, fan, options, out));
        call("mount", () -> snapshot.sense("r", null, fan, options, out));
        call("sensor", () -> snapshot.sense(null, fan, options, out));
        call("pattern", () -> snapshot.sense(pose, null, options, out));
        call("options", () -> snapshot.sense(pose, fan, null, out));
        call("out", () -> snapshot.sense(pose, fan, options, null));
        double[] ray = {0, 0, 0, 1, 0, 0, 9};
        call("rays", () -> world.castRays(null, 1, out));
        call("out", () -> world.castRays(ray, 1, null));
        call("rays", () -> world.freeRays(null, 1, new long[1]));
        call("free", () -> world.freeRays(ray, 1, null));
        call("ignored", () -> world.freeRays(ray, 1, null, new long[1]));
        call("rays", () -> snapshot.castRays(null, 1, out));
        call("out", () -> snapshot.castRays(ray, 1, null));
        call("rays", () -> snapshot.freeRays(null, 1, new long[1]));
        call("free", () -> snapshot.freeRays(ray, 1, null));
        call("ignored", () -> snapshot.freeRays(ray, 1, null, new long[1]));
        call("name", () -> world.freePoses(null, new double[4], new long[1]));
        call("poses", () -> world.freePoses("r", null, new long[1]));
        call("free", () -> world.freePoses("r", new double[4], null));
        call("name", () -> snapshot.freePoses(null, new double[4], new long[1]));
        call("poses", () -> snapshot.freePoses("r", null, new long[1]));
        call("free", () -> snapshot.freePoses("r", new double[4], null));
        call("name", () -> world.freeEdges(null, new double[8], new long[1]));
        call("edges", () -> world.freeEdges("r", null, new long[1]));
        call("free", () -> snapshot.freeEdges("r", new double[8], null));
        check();
    }

    @Test
    void ofSweeps() throws Exception {
        Path file = folder.resolve("none.jsonl");
        ParameterSweep sweep = ParameterSweep.of("a", replicate -> Result.of("x", 1))
                .over(new SweepWorld("w", new Geometry().snapshot()));
        SweepResults results = SweepRun.of(sweep, folder.resolve("some.jsonl")).run();
        call("scenario", () -> ParameterSweep.of(null));
        call("scenario", () -> ParameterSweep.of("a", null));
        call("name of a scenario", () -> ParameterSweep.of(null, replicate -> Result.of("x", 1)));
        call("world", () -> sweep.over(null));
        call("name of a parameter", () -> sweep.vary(null, "1"));
        call("values", () -> sweep.vary("p", (String[]) null));
        call("value of p", () -> sweep.vary("p", (String) null));
        call("shard", () -> sweep.isOf(null, 0));
        call("sweep", () -> SweepRun.of(null, file));
        call("file", () -> SweepRun.of(sweep, null));
        call("shard", () -> SweepRun.of(sweep, file).shard(null));
        call("progress", () -> SweepRun.of(sweep, file).progress(null));
        call("files", () -> SweepResults.read(null));
        call("files[1]", () -> SweepResults.read(holding(folder.resolve("some.jsonl"))));
        call("consumer", () -> results.forEach(null));
        call("file", () -> results.write(null));
        call("name of a world", () -> new SweepWorld(null, new Geometry().snapshot()));
        call("snapshot", () -> new SweepWorld("w", null));
        call("file", () -> SweepWorld.read(null));
        call("file", () -> ScenarioSweep.read(null));
        call("text", () -> Shard.parse(null));
        call("name", () -> Result.of(null, 1));
        call("line", () -> Outcome.of(null));
        call("outcomes", () -> results.header().digest(null));
        call("outcome", () -> results.header().digest(Collections.singletonList(null)));
        call("header", () -> new SweepSummary().svg(null));
        call("file", () -> results.writeCsv(null));
        call("outcome", () -> new SweepSummary().accept(null));
        call("other", () -> results.header().isOfSame(null));
        check();
    }

    @Test
    void ofTestsAndPictures() {
        Path file = folder.resolve("a.svg");
        Scene scene = Scene.of("t", Scene.View.world(1, 1), List.of());
        call("object", () -> Goal.near(null, 1));
        call("folder", () -> Scenarios.in(null));
        call("root", () -> Scenarios.in(folder, null));
        Geometry geometry = new Geometry();
        geometry.addObject(new SphereObject(new Point(), 1).moveable("r"));
        RobotWorld robots = RobotWorld.of(geometry);
        Robot robot = robots.robot("r");
        call("geometry", () -> RobotWorld.of(null));
        call("name", () -> robots.robot(null));
        call("title", () -> robots.scenario(null));
        call("move", () -> robot.moves(null));
        call("move", () -> robot.tries(null));
        call("obstacle", () -> robot.isBlockedBy(null, 1));
        call("other", () -> robot.neverTouches(null));
        call("other", () -> robot.neverTouchesAnythingBut((String) null));
        call("others", () -> robot.neverTouchesAnythingBut((String[]) null));
        call("other", () -> robot.rangeTo(null));
        call("behaviour", () -> robot.follows(null));
        call("goal", () -> robot.reaches(null));
        call("address", () -> PageServer.live(null, new LiveFilm("t", ""), null));
        call("scene", () -> Painter.svg(null));
        call("scene", () -> Painter.image(null, Theme.LIGHT));
        call("theme", () -> Painter.image(scene, null));
        call("scene", () -> Painter.write(null, Theme.LIGHT, file));
        call("theme", () -> Painter.write(scene, null, folder.resolve("a.png")));
        call("file", () -> Painter.write(scene, Theme.LIGHT, null));
        call("world", () -> Pictures.of(null, "t"));
        call("title", () -> Pictures.of(new World(1, 1, 1, List.of()), null));
        call("view", () -> Scene.of("t", null, List.of()));
        call("title", () -> Scene.of(null, Scene.View.world(1, 1), List.of()));
        call("things", () -> Scene.of("t", Scene.View.world(1, 1), null));
        call("object", () -> new Scene.Thing(null, null));
        check();
    }
}
