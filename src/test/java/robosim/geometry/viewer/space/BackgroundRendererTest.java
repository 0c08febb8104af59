package robosim.geometry.viewer.space;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.render.ColorFrame;
import robosim.geometry.viewer.scene.Scene;

@Tag("clock")
class BackgroundRendererTest {
    private static final GeometryObject WALL = new BoxObject(new Point(2, 0, 0), 1, 1, 4).named("wall");
    private static final GeometryObject DRUM = new CylinderObject(new Point(-5, 0, 0), 0.5, 1).moveable("drum");
    private static final Scene.View BORDER = Scene.View.world(20, 10);
    private static final int WIDE = 101;
    private static final int HIGH = 67;

    private final Deque<Runnable> waiting = new ArrayDeque<>();
    private final List<Picture> pictures = new ArrayList<>();
    private final BackgroundRenderer studio = new BackgroundRenderer(waiting::add, this::keep, 2);

    private Runnable meanwhile = () -> {};

    private void keep() {
        Picture picture = studio.picture(0);
        if (picture != null) {
            pictures.add(picture);
        }
        meanwhile.run();
    }

    private void work() {
        while (!waiting.isEmpty()) {
            waiting.remove().run();
        }
    }

    static Moment moment(GeometryObject... movers) {
        List<Scene.Thing> things = new ArrayList<>();
        for (GeometryObject mover : movers) {
            things.add(new Scene.Thing(mover, null));
        }
        return new Moment(
                0, Dimension.SPATIAL, BORDER, List.of(new Scene.Thing(WALL, 0xff0000)), Scene.of("", BORDER, things));
    }

    private static SpaceCamera camera() {
        SpaceCamera camera = SpaceCamera.usual();
        camera.resize(WIDE, HIGH);
        camera.look(moment(DRUM).bounds());
        return camera;
    }

    private static Shot shot() {
        return new Shot(camera().view(), null);
    }

    @Test
    void theLastStepIsWhatACameraSees() {
        studio.order(moment(DRUM), List.of(shot()), BackgroundRenderer.LIGHT);
        work();
        assertThat(studio.problem()).isEmpty();
        Picture last = studio.picture(0);
        assertThat(last.isFinest()).isTrue();
        ColorFrame frame = new ColorFrame();
        ColorCamera.of(WIDE, HIGH, shot().view().fieldOfView())
                .at(shot().view().pose())
                .withLighting(BackgroundRenderer.LIGHT)
                .withSamples(2)
                .render(last.world().toGeometry(), frame);
        assertThat(last.pixels()).isEqualTo(frame.pixels());
    }

    @Test
    void eachStepIsFinerThanTheOneBefore() {
        studio.order(moment(DRUM), List.of(shot()), BackgroundRenderer.LIGHT);
        work();
        double error = Double.POSITIVE_INFINITY;
        List<Refinement.Step> steps = new ArrayList<>();
        for (Picture picture : pictures) {
            if (steps.contains(picture.step())) {
                continue;
            }
            steps.add(picture.step());
            double off = difference(picture, studio.picture(0));
            assertThat(off).as("%s", picture.step()).isLessThan(error);
            error = off;
        }
        assertThat(steps).isEqualTo(Refinement.from(steps.get(0)));
        assertThat(error).isZero();
    }

    /** The mean difference of colours, each square counted where it is in the view. */
    private static double difference(Picture coarse, Picture fine) {
        long sum = 0;
        for (int y = 0; y < HIGH; y++) {
            for (int x = 0; x < WIDE; x++) {
                int a = at(coarse, x, y);
                int b = at(fine, x, y);
                for (int shift = 0; shift <= 16; shift += 8) {
                    sum += Math.abs((a >> shift & 0xff) - (b >> shift & 0xff));
                }
            }
        }
        return (double) sum / WIDE / HIGH;
    }

    private static int at(Picture picture, int x, int y) {
        int column = (int) ((x + 0.5 - picture.left()) / picture.step().side());
        int row = (int) ((y + 0.5 - picture.top()) / picture.step().side());
        return picture.pixels()[row * picture.columns() + column];
    }

    @Test
    void aNewerViewCancelsAllButTheFirstStep() {
        SpaceCamera moved = camera();
        moved.orbit(100, 0);
        Shot second = new Shot(moved.view(), null);
        // The hand moves on after the first step of the first view, while the second is at work.
        meanwhile = () -> {
            meanwhile = () -> {};
            studio.order(moment(DRUM), List.of(second), BackgroundRenderer.LIGHT);
        };
        studio.order(moment(DRUM), List.of(shot()), BackgroundRenderer.LIGHT);
        work();
        assertThat(pictures.get(0).view()).isEqualTo(shot().view());
        assertThat(pictures.subList(1, pictures.size()))
                .allMatch(each -> each.view().equals(second.view()));
        assertThat(studio.picture(0).isFinest()).isTrue();
    }

    @Test
    void theSameOrderAgainIsNoWork() {
        studio.order(moment(DRUM), List.of(shot()), BackgroundRenderer.LIGHT);
        work();
        pictures.clear();
        studio.order(moment(DRUM), List.of(shot()), BackgroundRenderer.LIGHT);
        assertThat(waiting).isEmpty();
        studio.order(moment(DRUM), List.of(shot()), BackgroundRenderer.DARK);
        assertThat(waiting).hasSize(1);
        work();
        assertThat(pictures).isNotEmpty();
    }

    @Test
    void whatIsSelectedIsDrawnOverTheSamePicture() {
        studio.order(moment(DRUM), List.of(shot()), BackgroundRenderer.LIGHT);
        work();
        Picture before = studio.picture(0);
        Moment plain = moment(DRUM);
        Scene marked = plain.life().marked(List.of(new Scene.Mark(DRUM, Scene.Mark.Why.PICKED)), 0);
        studio.order(
                new Moment(0, plain.dimension(), plain.border(), plain.statics(), marked),
                List.of(shot()),
                BackgroundRenderer.LIGHT);
        work();
        Picture after = studio.picture(0);
        assertThat(after.pixels()).isSameAs(before.pixels());
        assertThat(before.traces()).isEmpty();
        assertThat(after.traces()).hasSize(12); // the edges of a box
    }

    @Test
    void aRobotIsSeenWhereItIs() {
        studio.order(moment(DRUM), List.of(shot()), BackgroundRenderer.LIGHT);
        work();
        Picture before = studio.picture(0);
        assertThat(seen(before, DRUM.center())).isEqualTo("drum");
        GeometryObject driven = DRUM.movedTo(new Point(-2, 0, 2));
        studio.order(moment(driven), List.of(shot()), BackgroundRenderer.LIGHT);
        work();
        Picture after = studio.picture(0);
        assertThat(seen(after, driven.center())).isEqualTo("drum");
        assertThat(seen(after, DRUM.center())).isEqualTo("floor");
        assertThat(difference(before, after)).isGreaterThan(0.5);
        assertThat(after.at(0.5, 0.5).point()).isNull(); // the sky
    }

    private static String seen(Picture picture, Point place) {
        double[] pixel = new double[3];
        assertThat(picture.view().project(place.x(), place.y(), place.z(), pixel))
                .isTrue();
        Picture.Seen seen = picture.at(pixel[0], pixel[1]);
        assertThat(seen.point()).isNotNull();
        return seen.object() == null ? "floor" : seen.object().name();
    }

    @Test
    void aRobotSeesWhatIsBeforeItAndNotItself() {
        Shot own = new Shot(SpaceView.of(Pose.ORIGIN, WIDE, HIGH), "drum");
        studio.order(moment(DRUM), List.of(own, shot()), BackgroundRenderer.LIGHT);
        work();
        Picture picture = studio.picture(0);
        int middle = at(picture, WIDE / 2, HIGH / 2);
        assertThat(middle >> 16).isGreaterThan(100 + (middle & 0xff)); // the red wall
        assertThat(picture.view().pose().center()).isEqualTo(DRUM.center());
        assertThat(studio.picture(1).isFinest()).isTrue();
        // Where the robot is no more, there is no picture, and the other one is there all the same.
        studio.order(moment(), List.of(own, shot()), BackgroundRenderer.LIGHT);
        work();
        assertThat(studio.picture(0)).isNull();
        assertThat(studio.picture(1).isFinest()).isTrue();
    }

    @Test
    void somethingOfAllCamerasIsThereBeforeAnyIsFine() {
        List<Shot> shots = List.of(shot(), new Shot(SpaceView.of(Pose.ORIGIN, WIDE, HIGH), "drum"), shot());
        meanwhile = () -> {
            if (studio.picture(2) == null) {
                Picture first = studio.picture(0);
                assertThat(first == null || !first.isFinest()).isTrue();
            }
        };
        studio.order(moment(DRUM), shots, BackgroundRenderer.LIGHT);
        work();
        for (int k = 0; k < 3; k++) {
            assertThat(studio.picture(k).isFinest()).isTrue();
        }
        assertThat(studio.picture(3)).isNull();
    }

    @Test
    void ordersFromAnotherThreadWhileItWorksAreAllMet() throws Exception {
        ExecutorService one = Executors.newSingleThreadExecutor();
        BackgroundRenderer busy = new BackgroundRenderer(one, () -> {}, 2);
        SpaceCamera camera = camera();
        for (int k = 0; k < 60; k++) {
            camera.orbit(7, 1);
            busy.order(
                    moment(DRUM.movedTo(new Point(-5 + 0.05 * k, 0, 0))),
                    List.of(new Shot(camera.view(), null)),
                    BackgroundRenderer.LIGHT);
            Thread.sleep(k % 5);
        }
        one.shutdown();
        assertThat(one.awaitTermination(60, TimeUnit.SECONDS)).isTrue();
        assertThat(busy.problem()).isEmpty();
        Picture last = busy.picture(0);
        assertThat(last.view()).isEqualTo(camera.view());
        assertThat(last.isFinest()).isTrue();
        assertThat(last.moment().mover("drum").center().x()).isEqualTo(-5 + 0.05 * 59);
    }
}
