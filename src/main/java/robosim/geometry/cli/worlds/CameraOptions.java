package robosim.geometry.cli.worlds;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.sensor.Intrinsics;
import robosim.geometry.world.SdfSensor;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldException;

/** The options of a picture in three dimensions. */
public final class CameraOptions {
    /** What names a robot as a place. */
    static final String ROBOT = "robot:";

    private static final String SENSOR = "sensor:";

    private static final String OVERVIEW = "overview";
    private static final String ORBIT = "orbit";
    private static final String USUAL_SIZE = "960x640";

    private static final double AZIMUTH = -62;
    private static final double ELEVATION = 38;

    @Option(
            names = "--camera",
            paramLabel = "CAMERA",
            description = "overview (three-quarter view of all, the default), top, front, side, four (these four in"
                    + " one picture), orbit (a picture from each of --frames places around), robot:NAME (from a robot),"
                    + " sensor:NAME (a camera that WORLD, in SDFormat, describes, with its size and field of view), or"
                    + " X,Y,Z (from a point)")
    private String camera = OVERVIEW;

    @Option(
            names = "--look-at",
            paramLabel = "X,Y,Z",
            description = "the point in the middle of the picture; else the middle of the world")
    private @Nullable String target;

    @Option(
            names = "--mount",
            paramLabel = "X,Y,Z",
            description = "where the camera is on a robot, in its own frame; else on top of it, looking ahead")
    private @Nullable String mount;

    @Option(
            names = "--size",
            paramLabel = "WxH",
            description = "size of the picture; else 960x640, of a sensor its own")
    private @Nullable String size;

    @Option(names = "--fov", paramLabel = "DEGREES", description = "horizontal field of view; else 40, of a robot 80")
    private @Nullable Double fieldOfView;

    @Option(
            names = "--samples",
            paramLabel = "N",
            description =
                    "N x N rays for each pixel at an edge, and for each one with --show (default: ${DEFAULT-VALUE})")
    private int samples = 2;

    @Option(
            names = "--sky-rays",
            paramLabel = "N",
            description =
                    "rays for each pixel that look for the sky, for soft shadows and indirect light; 0 for none (default:"
                            + " ${DEFAULT-VALUE})")
    private int skyRays = 1;

    @Option(
            names = "--mirrors",
            paramLabel = "N",
            description = "how many mirrors a ray may meet (default: ${DEFAULT-VALUE})")
    private int mirrors = 3;

    @Option(names = "--frames", paramLabel = "N", description = "pictures of an orbit (default: ${DEFAULT-VALUE})")
    private int frames = 24;

    @Option(names = "--orbit", description = "the same as --camera orbit")
    private boolean isOrbit;

    @Option(names = "--no-floor", description = "lay no floor under the world")
    private boolean noFloor;

    private @Nullable SdfSensor sensor;

    /** That of the sensor, unless it has been given another size or field of view. */
    private @Nullable Intrinsics lens;

    /** A camera, and where its picture stands in the whole. */
    record Shot(ColorCamera camera, int left, int top) {}

    /** The world as these cameras see it. */
    CameraWorld studio(World world, PictureStyle show) {
        CameraWorld.Ground ground = noFloor
                ? CameraWorld.Ground.NONE
                : show == PictureStyle.COLOUR ? CameraWorld.Ground.WIDE : CameraWorld.Ground.FLOOR;
        return new CameraWorld(world, ground);
    }

    int width() {
        return side(0);
    }

    int height() {
        return side(1);
    }

    /** Looks up the sensor that is the camera, if one is. */
    void find(WorldOptions world) throws WorldException {
        if (camera.startsWith(SENSOR)) {
            SdfSensor found = world.sensor("--camera sensor:NAME", camera.substring(SENSOR.length()));
            if (!found.kind().isCamera()) {
                throw new UsageException("--camera sensor:NAME must name a camera (got: " + found.name() + " of type "
                        + found.type() + ")");
            }
            try {
                Intrinsics own = found.intrinsics();
                lens = size == null && fieldOfView == null ? own : null;
                size = size == null ? own.width() + "x" + own.height() : size;
                fieldOfView = fieldOfView(found.fieldOfView());
            } catch (IllegalArgumentException e) {
                throw new UsageException(String.valueOf(e.getMessage()));
            }
            sensor = found;
        }
    }

    private int side(int k) {
        String[] sides = (size == null ? USUAL_SIZE : size).split("x", -1);
        if (sides.length == 2) {
            try {
                int side = Integer.parseInt(sides[k]);
                if (side > 0) {
                    return side;
                }
            } catch (NumberFormatException e) {
                // told below
            }
        }
        throw new UsageException("--size must be WxH, two numbers of pixels above 0 (got: " + size + ")");
    }

    /** The pictures to take, each made of one shot or of four. */
    List<List<Shot>> pictures(CameraWorld studio) {
        try {
            Arguments.refuse(frames < 1 || frames > 10_000, "--frames must be from 1 to 10000", frames);
            return shots(studio);
        } catch (IllegalArgumentException e) {
            throw new UsageException(String.valueOf(e.getMessage()));
        }
    }

    private List<List<Shot>> shots(CameraWorld studio) {
        SdfSensor found = sensor;
        if (found != null) {
            Intrinsics own = lens;
            ColorCamera plain = own == null ? camera(studio, width(), height(), 40) : lit(ColorCamera.of(own), studio);
            String carrier = found.carrier();
            return List.of(List.of(
                    new Shot(carrier == null ? plain.at(found.pose()) : plain.on(carrier, found.pose()), 0, 0)));
        }
        if (isOrbit) {
            Arguments.refuse(
                    !camera.equals(OVERVIEW) && !camera.equals(ORBIT),
                    "--camera must be left out with --orbit",
                    camera);
            camera = ORBIT;
        }
        if (camera.startsWith(ROBOT)) {
            return List.of(List.of(new Shot(onRobot(studio, camera.substring(ROBOT.length())), 0, 0)));
        }
        switch (camera) {
            case ORBIT -> {
                List<List<Shot>> pictures = new ArrayList<>();
                for (int k = 0; k < frames; k++) {
                    pictures.add(one(studio, around(studio, AZIMUTH + 360.0 * k / frames, ELEVATION)));
                }
                return pictures;
            }
            case "four" -> {
                return List.of(four(studio));
            }
            case OVERVIEW, "top", "front", "side" -> {
                return List.of(one(studio, named(studio, camera)));
            }
            default -> {
                Point eye = point("--camera", camera);
                return List.of(one(studio, Pose.lookAt(eye, target(studio))));
            }
        }
    }

    private Pose named(CameraWorld studio, String view) {
        return switch (view) {
            case "top" -> around(studio, -90, 90);
            case "front" -> around(studio, -90, 12);
            case "side" -> around(studio, 0, 12);
            default -> around(studio, AZIMUTH, ELEVATION);
        };
    }

    private Pose around(CameraWorld studio, double azimuth, double elevation) {
        double aspect = (double) width() / height();
        Pose pose = Pose.around(studio.outline(), azimuth, elevation, fieldOfView(40), aspect);
        return target == null ? pose : Pose.lookAt(pose.center(), target(studio));
    }

    private Point target(CameraWorld studio) {
        return target == null ? CameraWorld.middle(studio.content()) : point("--look-at", target);
    }

    private double fieldOfView(double usual) {
        return fieldOfView == null ? usual : fieldOfView;
    }

    private ColorCamera camera(CameraWorld studio, int width, int height, double usualFieldOfView) {
        return lit(ColorCamera.of(width, height, fieldOfView(usualFieldOfView)), studio);
    }

    private ColorCamera lit(ColorCamera camera, CameraWorld studio) {
        return camera.withLighting(studio.light())
                .withSmoothEdges(samples)
                .withMirrors(mirrors)
                .withIndirectLight(skyRays, studio.skyReach())
                .withThreads(Runtime.getRuntime().availableProcessors());
    }

    private List<Shot> one(CameraWorld studio, Pose pose) {
        return List.of(new Shot(camera(studio, width(), height(), 40).at(pose), 0, 0));
    }

    private List<Shot> four(CameraWorld studio) {
        List<Shot> shots = new ArrayList<>();
        for (String view : List.of("top", "front", "side", "overview")) {
            int left = shots.size() % 2 * (width() / 2);
            int top = shots.size() / 2 * (height() / 2);
            int wide = left == 0 ? width() / 2 : width() - left;
            int high = top == 0 ? height() / 2 : height() - top;
            shots.add(new Shot(camera(studio, wide, high, 40).at(named(studio, view)), left, top));
        }
        return shots;
    }

    private ColorCamera onRobot(CameraWorld studio, String name) {
        GeometryObject robot = studio.find(name);
        if (robot == null || !robot.isMoveable()) {
            throw new UsageException("--camera robot:NAME must name a moveable object of the world, "
                    + studio.choice(name) + " (got: " + name + ")");
        }
        Point place = mount == null ? new Point(0, studio.top(name), 0) : point("--mount", mount);
        return camera(studio, width(), height(), 80).on(name, Pose.of(place, 0));
    }

    private static Point point(String option, String text) {
        String form = option.equals("--camera")
                ? "overview, top, front, side, four, orbit, robot:NAME, sensor:NAME or X,Y,Z"
                : "X,Y,Z, three numbers";
        return Arguments.point(option, form, text);
    }
}
