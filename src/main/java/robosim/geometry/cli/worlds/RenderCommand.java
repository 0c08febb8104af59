package robosim.geometry.cli.worlds;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import robosim.geometry.Snapshot;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Progress;
import robosim.geometry.cli.terminal.Version;
import robosim.geometry.image.PngWriter;
import robosim.geometry.render.ColorFrame;
import robosim.geometry.viewer.draw.Painter;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.world.AtomicFileWriter;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldException;

/** Draws a world file: as a camera sees it, or as a plan. */
@Command(
        name = "render",
        description = {
            "Takes a picture of a world, in colour and with shadows, as a .png; or draws its plan from above, as an .svg or"
                    + " with --plan. Needs no display.",
            "",
            "The picture shows heights, also of a PLANAR world, and lays a floor under what stands lowest. An orbit is a"
                    + " series of pictures, FILE with a number before its ending."
        },
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        exitCodeListHeading = ExitCodes.HEADING,
        exitCodeList = {ExitCodes.DONE, ExitCodes.REFUSED},
        footerHeading = "%nExamples:%n",
        footer = {
            "  robosim-geometry render worlds/rooms.xml -o rooms.svg",
            "  robosim-geometry render worlds/rooms.xml -o rooms.png",
            "  robosim-geometry render worlds/rooms.xml --camera orbit --frames 36 -o rooms.png",
            "  robosim-geometry render worlds/meshes.xml --camera 4,2,11 --look-at 0,-1,0 -o meshes.png",
            "  robosim-geometry render worlds/courtyard.sdf --show depth --camera robot:courier -o depth.png",
            "  robosim-geometry render worlds/warehouse.xml --show points --lidar vlp16 -o cloud.png",
            "  robosim-geometry render arena.sdf --camera sensor:front_camera -o seen.png",
            "  robosim-geometry render worlds/maze.xml --plan --dark -o maze.png",
            "  robosim-geometry render arena.world --models ~/.gazebo/models -o arena.svg"
        })
public final class RenderCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private CommandSpec spec;

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private WorldOptions world;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            required = true,
            description = "the picture to write: .svg or .png")
    private Path output = Path.of("world.svg");

    @Option(names = "--dark", description = "draw the plan on a dark background; an .svg follows its viewer's theme")
    private boolean dark;

    @Option(names = "--plan", description = "draw the plan from above as a .png")
    private boolean plan;

    @Option(
            names = "--show",
            paramLabel = "WHAT",
            defaultValue = "colour",
            completionCandidates = Look.Names.class,
            converter = Look.Converter.class,
            description = "${COMPLETION-CANDIDATES}: the world in its light, how far away surfaces are, which way they"
                    + " face, which object or label each pixel shows, or what a lidar measures (default:"
                    + " ${DEFAULT-VALUE})")
    private Look show = Look.COLOUR;

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private CameraOptions cameras;

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private CloudOptions clouds;

    private RenderCommand() {}

    @Override
    public Integer call() throws Exception {
        String name = output.toString().toLowerCase(Locale.ROOT);
        if (!name.endsWith(".svg") && !name.endsWith(".png")) {
            throw new ParameterException(spec.commandLine(), "FILE must end in .svg or .png (got: " + output + ")");
        }
        World read = world.read();
        world.keep("FILE", output);
        if (plan || dark || name.endsWith(".svg")) {
            Painter.write(Pictures.of(read, Pictures.title(world.file())), theme(), output);
            tell(output);
        } else {
            photograph(read);
        }
        return 0;
    }

    private void tell(Path file) {
        spec.commandLine().getOut().println("Wrote " + file);
    }

    private void photograph(World read) throws IOException, WorldException {
        Studio studio = new Studio(read, cameras.hasFloor());
        cameras.find(world);
        List<List<CameraOptions.Shot>> pictures = cameras.pictures(studio);
        Snapshot snapshot = studio.snapshot();
        int[] pixels = new int[cameras.width() * cameras.height()];
        ColorFrame frame = new ColorFrame();
        double metres = read.unit() == null ? 1 : read.unit().metres();
        long shots = pictures.stream().mapToLong(List::size).sum();
        int taken = 0;
        for (int k = 0; k < pictures.size(); k++) {
            try (Progress progress = Progress.of(spec.commandLine(), "rendering", 100 * shots)) {
                for (CameraOptions.Shot shot : pictures.get(k)) {
                    long before = 100L * taken++;
                    int[] seen;
                    if (show == Look.COLOUR) {
                        shot.camera().render(snapshot, frame, percent -> progress.at(before + percent));
                        seen = frame.pixels();
                    } else {
                        seen = show == Look.POINTS
                                ? clouds.picture(shot.camera(), studio, snapshot, metres)
                                : show.picture(shot.camera(), studio, snapshot);
                    }
                    int wide = shot.camera().width();
                    for (int row = 0; row < shot.camera().height(); row++) {
                        int to = (shot.top() + row) * cameras.width() + shot.left();
                        System.arraycopy(seen, row * wide, pixels, to, wide);
                    }
                }
            }
            Path file = pictures.size() == 1 ? output : numbered(k, pictures.size());
            AtomicFileWriter.write(file, out -> PngWriter.writeColour(out, cameras.width(), cameras.height(), pixels));
            tell(file);
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
