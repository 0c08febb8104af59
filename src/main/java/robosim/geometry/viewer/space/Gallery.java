package robosim.geometry.viewer.space;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/**
 * The cameras of a window, how their pictures share its area, and what a hand does to them. Independent of any window:
 * pixels are passed in. May be used by one thread at a time.
 */
public final class Gallery {
    /** Pixels between two pictures. */
    static final int GAP = 2;

    /** The limits of the field of view of a robot's own camera, in degrees. */
    private static final double NARROWEST = 5;

    private static final double WIDEST = 120;

    private static final double USUAL = 75;

    private final SpaceCamera overview = SpaceCamera.usual();
    private final SpaceCamera above = new SpaceCamera(-90, 90);
    private final SpaceCamera side = new SpaceCamera(30, 22);

    private Arrangement arrangement = Arrangement.ONE;
    private int width = 800;
    private int height = 600;
    private int world = Integer.MIN_VALUE;
    private int active;
    private @Nullable String robot;
    private boolean following;

    // Where the robot's own camera looks, in degrees from straight ahead, and how much it sees.
    private double yaw;
    private double pitch;
    private double field = USUAL;

    /** Which cameras are shown. */
    public enum Arrangement {
        /** One that can be moved anywhere. */
        ONE,
        /** That of a robot. */
        OWN,
        /** Both. */
        TWO,
        /** These, and one from above and one from the side. */
        FOUR;

        /** What a key press leads to. */
        Arrangement next() {
            return switch (this) {
                case ONE -> OWN;
                case OWN -> TWO;
                case TWO -> FOUR;
                case FOUR -> ONE;
            };
        }
    }

    /** What a drag does. */
    public enum Hand {
        /** Circles the point that the camera looks at. */
        ORBIT,
        /** Moves across. */
        PAN,
        /** Looks around. */
        LOOK
    }

    /**
     * The part of the area with one camera's picture.
     *
     * @param label what the picture shows
     */
    public record Cell(int x, int y, int width, int height, String label) {
        boolean contains(double px, double py) {
            return px >= x && px < x + width && py >= y && py < y + height;
        }
    }

    /** Changes the size of the area. */
    public void resize(int newWidth, int newHeight) {
        width = Math.max(1, newWidth);
        height = Math.max(1, newHeight);
    }

    public Arrangement arrangement() {
        return arrangement;
    }

    /** Shows more cameras, or begins again with one. */
    public void next() {
        show(arrangement.next());
    }

    /** Shows other cameras. */
    public void show(Arrangement other) {
        arrangement = other;
        active = 0;
    }

    /** Whether the camera that goes anywhere goes along with a robot. */
    public boolean isFollowing() {
        return following;
    }

    /** Lets the camera that goes anywhere go along with the robot whose view is wanted, or stay where it is. */
    public void follow(boolean follow) {
        following = follow;
    }

    /** The areas of all pictures, in the order of the shots. */
    public List<Cell> cells() {
        String own = robot == null ? "no robot" : "what " + robot + " sees";
        int right = (width - GAP) / 2;
        int lower = (height - GAP) / 2;
        return switch (arrangement) {
            case ONE -> List.of(new Cell(0, 0, width, height, ""));
            case OWN -> List.of(new Cell(0, 0, width, height, own));
            case TWO ->
                width >= height
                        ? List.of(cell(0, 0, right, height, ""), cell(right + GAP, 0, width - right - GAP, height, own))
                        : List.of(cell(0, 0, width, lower, ""), cell(0, lower + GAP, width, height - lower - GAP, own));
            case FOUR ->
                List.of(
                        cell(0, 0, right, lower, ""),
                        cell(right + GAP, 0, width - right - GAP, lower, own),
                        cell(0, lower + GAP, right, height - lower - GAP, "from above"),
                        cell(right + GAP, lower + GAP, width - right - GAP, height - lower - GAP, "from the side"));
        };
    }

    private static Cell cell(int x, int y, int width, int height, String label) {
        return new Cell(x, y, Math.max(1, width), Math.max(1, height), label);
    }

    /** The camera of a picture; null for the robot's own. */
    private @Nullable SpaceCamera camera(int number) {
        return switch (arrangement) {
            case ONE -> overview;
            case OWN -> null;
            case TWO -> number == 0 ? overview : null;
            case FOUR -> number == 0 ? overview : number == 1 ? null : number == 2 ? above : side;
        };
    }

    /**
     * The pictures to be taken.
     *
     * @param selected the name of the robot whose view is wanted; if there is none of that name, it is that of the first
     */
    public List<Shot> shots(Moment moment, @Nullable String selected) {
        if (moment.world() != world) {
            world = moment.world();
            overview.look(moment.bounds());
            above.look(moment.bounds());
            side.look(moment.bounds());
        }
        robot = robot(moment, selected);
        GeometryObject followed = !following || robot == null ? null : moment.mover(robot);
        if (followed != null) {
            overview.center(followed.center());
        }
        List<Shot> shots = new ArrayList<>();
        List<Cell> cells = cells();
        for (int k = 0; k < cells.size(); k++) {
            Cell cell = cells.get(k);
            SpaceCamera camera = camera(k);
            if (camera != null) {
                camera.resize(cell.width(), cell.height());
                shots.add(new Shot(camera.view(), null));
            } else {
                shots.add(own(cell));
            }
        }
        return shots;
    }

    /** The robot whose view was wanted last stays, as long as it exists, until another one is selected. */
    private @Nullable String robot(Moment moment, @Nullable String selected) {
        if (selected != null && moment.mover(selected) != null) {
            return selected;
        }
        if (robot != null && moment.mover(robot) != null) {
            return robot;
        }
        return moment.life().things().stream()
                .map(thing -> thing.object().name())
                .filter(name -> name != null)
                .findFirst()
                .orElse(null);
    }

    private Shot own(Cell cell) {
        Pose pose = Pose.ORIGIN.oriented(SpaceCamera.rotation(yaw + 180, -pitch));
        // The wider side has the field of view.
        double horizontal = SpaceView.horizontal(cell.width(), cell.height(), field);
        return new Shot(new SpaceView(pose, horizontal, cell.width(), cell.height()), robot == null ? "" : robot);
    }

    /** The number of the picture at a point; -1 between two of them. */
    public int at(double x, double y) {
        List<Cell> cells = cells();
        for (int k = 0; k < cells.size(); k++) {
            if (cells.get(k).contains(x, y)) {
                return k;
            }
        }
        return -1;
    }

    /** Takes hold of the camera whose picture is at a point. */
    public void press(double x, double y) {
        int number = at(x, y);
        if (number >= 0) {
            active = number;
        }
    }

    /** Moves the camera that was taken hold of, by pixels. */
    public void drag(double dx, double dy, Hand hand) {
        SpaceCamera camera = camera(active);
        if (camera == null) {
            yaw = (yaw + SpaceCamera.DEGREES_PER_PIXEL / 2 * dx) % 360;
            pitch = Math.max(-90, Math.min(90, pitch + SpaceCamera.DEGREES_PER_PIXEL / 2 * dy));
            return;
        }
        switch (hand) {
            case ORBIT -> camera.orbit(dx, dy);
            case PAN -> camera.pan(dx, dy);
            case LOOK -> camera.lookAround(dx, dy);
        }
    }

    /** Comes nearer to what is at a point; a robot's own camera sees less, but larger. */
    public void zoom(double x, double y, double factor) {
        press(x, y);
        Cell cell = cells().get(active);
        SpaceCamera camera = camera(active);
        if (camera == null) {
            field = Math.max(NARROWEST, Math.min(WIDEST, field / factor));
        } else {
            camera.zoom(x - cell.x(), y - cell.y(), factor);
        }
    }

    /** Comes nearer to the middle of the picture that was used last. */
    public void zoom(double factor) {
        Cell cell = cells().get(active);
        zoom(cell.x() + cell.width() / 2.0, cell.y() + cell.height() / 2.0, factor);
    }

    /** Flies with the camera that was used last; a robot's own stays on the robot. */
    public void fly(double ahead, double up, double right) {
        SpaceCamera camera = camera(active);
        if (camera != null) {
            camera.fly(ahead, up, right);
        }
    }

    /** Lets the camera that was used last look at a point. */
    public void center(Point target) {
        SpaceCamera camera = camera(active);
        if (camera != null) {
            camera.center(target);
        }
    }

    /** Shows everything with the camera that was used last; a robot's own looks straight ahead. */
    public void fit() {
        SpaceCamera camera = camera(active);
        if (camera != null) {
            camera.fit();
        } else {
            yaw = 0;
            pitch = 0;
            field = USUAL;
        }
    }
}
