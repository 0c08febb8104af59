package robosim.geometry.cli.worlds;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import robosim.geometry.Snapshot;
import robosim.geometry.check.NumberText;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Progress;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.image.GifWriter;
import robosim.geometry.image.PngWriter;
import robosim.geometry.render.ColorFrame;
import robosim.geometry.viewer.draw.Painter;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.playback.Frame;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.viewer.playback.StateHistory;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.Unit;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldException;
import robosim.geometry.world.shared.AtomicFileWriter;

/** Draws a world file, or each step of a recording: as a camera sees it, or as a plan. */
@Command(
        name = "render",
        description = {
            "Takes a picture of a world, in colour and with shadows, as a .png; or draws its plan from above, as an"
                    + " .svg or with --plan. Needs no display.",
            "",
            "The picture shows heights, also of a PLANAR world, and lays the ground under what stands lowest. An orbit"
                    + " is a film, FILE.gif, or a series of pictures, FILE with a number before its ending.",
            "",
            "Of a recording (*.jsonl, or a folder with the demo's to-module.bin and from-module.bin) it takes"
                    + " a picture of each step, FILE with a number before its ending, of which other programs make a"
                    + " video: ffmpeg -i frame-%%03d.png film.mp4"
        },
        footer = {
            "  robosim-geometry render worlds/rooms.xml -o rooms.svg",
            "  robosim-geometry render worlds/rooms.xml --sensors -o rooms.svg",
            "  robosim-geometry render worlds/rooms.xml -o rooms.png",
            "  robosim-geometry render worlds/rooms.xml --camera orbit --frames 36 -o rooms.png",
            "  robosim-geometry render worlds/warehouse.xml --orbit -o film.gif",
            "  robosim-geometry render worlds/meshes.xml --camera 4,2,11 --look-at 0,-1,0 -o meshes.png",
            "  robosim-geometry render worlds/courtyard.sdf --show depth --camera robot:courier -o depth.png",
            "  robosim-geometry render worlds/warehouse.xml --show points --lidar vlp16 -o cloud.png",
            "  robosim-geometry render arena.sdf --camera sensor:front_camera -o seen.png",
            "  robosim-geometry render session.scenario.jsonl --plan --steps 1-500 --every 5 -o frame.png",
            "  robosim-geometry render worlds/maze.xml --plan --dark -o maze.png",
            "  robosim-geometry render worlds/meshes.xml --slice 0.5 -o meshes.svg",
            "  robosim-geometry render arena.world --models ~/.gazebo/models -o arena.svg"
        })
public final class RenderCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Mixin
    private WorldOptions world;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            required = true,
            description =
                    "the picture to write: .svg or .png; or .gif, a film of an orbit or of a recording, also of its plan with --plan")
    private Path output = Path.of("world.svg");

    @Option(names = "--dark", description = "draw the plan on a dark background; an .svg follows its viewer's theme")
    private boolean dark;

    @Option(names = "--plan", description = "draw the plan from above as a .png")
    private boolean plan;

    @Option(
            names = "--sensors",
            description =
                    "draw on the plan what the sonars of the world file measure; a recording shows it in any case")
    private boolean hasSensors;

    @Option(
            names = "--slice",
            paramLabel = "HEIGHT",
            description =
                    "draw the plan at this height, a Y of the world: of each object the section there, of meshes the"
                            + " lines of their faces")
    private @Nullable Double slice;

    @Option(
            names = "--show",
            paramLabel = "WHAT",
            defaultValue = "colour",
            description = "${COMPLETION-CANDIDATES}: the world in its light, how far away surfaces are, which way they"
                    + " face, which object or label each pixel shows, or what a lidar measures (default:"
                    + " ${DEFAULT-VALUE})")
    private PictureStyle show = PictureStyle.COLOUR;

    @Mixin
    private CameraOptions cameras;

    @Mixin
    private CloudOptions clouds;

    @Mixin
    private RecordingOptions recording;

    @Option(
            names = "--world",
            paramLabel = "WORLD",
            description = "for a recording: a world file to take colours and the unit from")
    private @Nullable Path colours;

    private static final List<String> OF_CAMERAS = List.of(
            "--size",
            "--camera",
            "--look-at",
            "--mount",
            "--fov",
            "--samples",
            "--sky-rays",
            "--mirrors",
            "--frames",
            "--orbit",
            "--no-floor",
            "--show",
            "--lidar",
            "--from");

    private static final String FILM = ".gif";

    /** For which each picture of a film is shown. */
    private static final double SECONDS = 0.1;

    /** Of a height in a title. */
    private static final int DIGITS = 6;

    @Override
    public Integer call() throws Exception {
        Arguments.output("FILE", output, ".svg", ".png", FILM);
        boolean isPlan = plan
                || dark
                || slice != null
                || output.toString().toLowerCase(Locale.ROOT).endsWith(".svg");
        if (isPlan) {
            refuseCamera();
        }
        if (hasSensors && (!isPlan || slice != null)) {
            throw new UsageException("--sensors is for a plan of the whole height; write an .svg or add --plan, without"
                    + " --slice (got: --sensors for " + output + ")");
        }
        if (RecordingOptions.isRecording(world.file())) {
            film(isPlan);
            return ExitCodes.FINE;
        }
        recording.refuse();
        if (colours != null) {
            throw new UsageException("--world is for a recording, and WORLD is a world (got: " + colours + ")");
        }
        World read = world.read();
        world.keep("FILE", output);
        if (slice != null) {
            checkSlice(read.height(), slice);
            read = PlanSlice.of(read, slice);
        }
        if (isPlan) {
            Arguments.refuse(
                    isFilm(), "FILE must end in .svg or .png for the plan of a world; recordings become films", output);
            Painter.write(hasSensors ? Pictures.sensed(read, title()) : Pictures.of(read, title()), theme(), output);
            tell(output);
        } else {
            photograph(read);
        }
        return ExitCodes.FINE;
    }

    /** Refuses what a plan would ignore: it has its own size, and no camera. */
    private void refuseCamera() {
        CommandLine.ParseResult given = spec.commandLine().getParseResult();
        for (String option : OF_CAMERAS) {
            if (given.hasMatchedOption(option)) {
                throw new UsageException(
                        option + " is for a picture by a camera; leave it out for a plan, which has a size of its own"
                                + " (got: " + option + " with "
                                + (plan ? "--plan" : dark ? "--dark" : slice != null ? "--slice" : output) + ")");
            }
        }
    }

    private String title() {
        String title = Pictures.title(world.file());
        return slice == null ? title : title + ", at Y " + NumberText.digits(slice, DIGITS);
    }

    /** Refuses a height that is not within a world, which is so tall. */
    private void checkSlice(double tall, double height) {
        Arguments.refuse(
                !(Math.abs(height) <= tall / 2),
                "--slice must be a height within the world, from " + -tall / 2 + " to " + tall / 2,
                height); // written so that NaN fails it
    }

    /** A picture of each step of a recording; an orbit goes once around while it is played. */
    private void film(boolean isPlan) throws IOException, WorldException {
        World lender = colours == null ? null : world.other("--world", colours);
        StateHistory film = RecordingOptions.read(spec, world.file(), lender);
        int[] frames = recording.frames(film, world.file());
        if (slice != null) {
            for (int frame : frames) {
                checkSlice(setting(film, frame).height(), slice);
            }
        }
        Camera camera = isPlan ? null : new Camera(moment(film, frames[0]));
        double metres = metres(lender);
        String unit = Pictures.unit(lender);
        if (isFilm()) {
            try (Progress progress = Progress.of(spec.commandLine(), "rendering", frames.length)) {
                writeFilm(frames.length, k -> {
                    progress.at(k + 1L);
                    if (camera == null) {
                        return Painter.pixels(plan(film, frames[k], unit), theme());
                    }
                    camera.look(moment(film, frames[k]));
                    return camera.shoot(k * camera.pictures.size() / frames.length, metres, percent -> {});
                });
            }
            tell(output + recording.told(frames));
            return;
        }
        try (Progress progress = Progress.of(spec.commandLine(), "rendering", frames.length)) {
            for (int k = 0; k < frames.length; k++) {
                Path file = frames.length == 1 ? output : numbered(k, frames.length);
                if (camera == null) {
                    Painter.write(plan(film, frames[k], unit), theme(), file);
                } else {
                    camera.look(moment(film, frames[k]));
                    camera.write(k * camera.pictures.size() / frames.length, metres, file, percent -> {});
                }
                progress.at(k + 1L);
            }
        }
        String last = frames.length == 1 ? "" : " to " + numbered(frames.length - 1, frames.length);
        tell((frames.length == 1 ? output : numbered(0, frames.length)) + last + recording.told(frames));
    }

    private static double metres(@Nullable World lender) {
        Unit unit = lender == null ? null : lender.unit();
        return unit == null ? 1 : unit.metres();
    }

    private boolean isFilm() {
        return output.toString().toLowerCase(Locale.ROOT).endsWith(FILM);
    }

    /** The plan at a step of a recording. */
    private Scene plan(StateHistory film, int frame, String unit) {
        Scene scene = film.scene(frame);
        if (slice != null) {
            scene = PlanSlice.of(scene, setting(film, frame).height(), slice);
        }
        return scene.titled(title()).described(scene.subtitle(), unit);
    }

    /** Takes or draws a picture of a film. */
    @FunctionalInterface
    private interface Shooting {
        Painter.Pixels take(int k) throws IOException;
    }

    private void writeFilm(int count, Shooting shooting) throws IOException {
        Painter.Pixels first = shooting.take(0);
        AtomicFileWriter.write(output, out -> {
            GifWriter film = new GifWriter(out, first.width, first.height, SECONDS);
            film.add(first.rgb);
            for (int k = 1; k < count; k++) {
                Painter.Pixels next = shooting.take(k);
                if (next.width != first.width || next.height != first.height) {
                    throw new UsageException(
                            "--steps must be within one world for the film of a plan; the recording begins"
                                    + " another before picture " + (k + 1) + " (got: " + output + ")");
                }
                film.add(next.rgb);
            }
            film.end();
        });
    }

    private static World moment(StateHistory film, int frame) {
        return Pictures.world(setting(film, frame), film.movers(frame));
    }

    private static Frame.Setting setting(StateHistory film, int frame) {
        Frame.Setting setting = film.setting(frame);
        if (setting == null) {
            throw new IllegalStateException("every frame must have a world");
        }
        return setting;
    }

    private void tell(Object files) {
        spec.commandLine().getOut().println("Wrote " + files);
    }

    private void photograph(World read) throws IOException, WorldException {
        Camera camera = new Camera(read);
        double metres = metres(read);
        int count = camera.pictures.size();
        if (isFilm()) {
            try (Progress progress = Progress.of(spec.commandLine(), "rendering", 100L * count)) {
                writeFilm(count, k -> camera.shoot(k, metres, percent -> progress.at(100L * k + percent)));
            }
            tell(output);
            return;
        }
        for (int k = 0; k < count; k++) {
            Path file = count == 1 ? output : numbered(k, count);
            long before = 100L * k;
            try (Progress progress = Progress.of(spec.commandLine(), "rendering", 100L * count)) {
                camera.write(k, metres, file, percent -> progress.at(before + percent));
            }
            tell(file);
        }
    }

    /** Takes pictures of a world, or of one after another with the views of the first. */
    private final class Camera {
        private final List<List<CameraOptions.Shot>> pictures;
        private final int[] pixels;
        private final ColorFrame frame = new ColorFrame();
        private CameraWorld studio;
        private Snapshot snapshot;

        Camera(World world) throws WorldException {
            studio = cameras.studio(world, show);
            cameras.find(RenderCommand.this.world);
            pictures = cameras.pictures(studio);
            snapshot = studio.snapshot();
            pixels = new int[cameras.width() * cameras.height()];
        }

        void look(World world) {
            studio = cameras.studio(world, show);
            snapshot = studio.snapshot();
        }

        void write(int picture, double metres, Path file, IntConsumer percent) throws IOException {
            int[] taken = take(picture, metres, percent);
            AtomicFileWriter.write(file, out -> PngWriter.writeColour(out, cameras.width(), cameras.height(), taken));
        }

        Painter.Pixels shoot(int picture, double metres, IntConsumer percent) {
            return new Painter.Pixels(cameras.width(), cameras.height(), take(picture, metres, percent));
        }

        int[] take(int picture, double metres, IntConsumer percent) {
            List<CameraOptions.Shot> shots = pictures.get(picture);
            for (int k = 0; k < shots.size(); k++) {
                CameraOptions.Shot shot = shots.get(k);
                int done = 100 * k / shots.size();
                int[] seen;
                if (show == PictureStyle.COLOUR) {
                    shot.camera().render(snapshot, frame, share -> percent.accept(done + share / shots.size()));
                    seen = frame.pixels();
                } else {
                    seen = show == PictureStyle.POINTS
                            ? clouds.picture(shot.camera(), studio, snapshot, metres)
                            : show.picture(shot.camera(), studio, snapshot);
                }
                int wide = shot.camera().width();
                for (int row = 0; row < shot.camera().height(); row++) {
                    int to = (shot.top() + row) * cameras.width() + shot.left();
                    System.arraycopy(seen, row * wide, pixels, to, wide);
                }
            }
            return pixels;
        }
    }

    /** The file of one of many pictures: a number of as many digits as the last one has, before the ending. */
    private Path numbered(int k, int count) {
        String name = String.valueOf(output.getFileName());
        int digits = Integer.toString(count - 1).length();
        String number = String.format(Locale.ROOT, "-%0" + digits + "d", k);
        return output.resolveSibling(name.substring(0, name.length() - 4) + number + name.substring(name.length() - 4));
    }

    private Theme theme() {
        return dark ? Theme.DARK : Theme.LIGHT;
    }
}
