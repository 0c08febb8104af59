package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SenseOptions.Carrier;
import robosim.geometry.model.SphereObject;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.NoAnswer;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.PictureAnswer;
import robosim.geometry.protocol.batch.PictureRequest;
import robosim.geometry.protocol.batch.SceneLight;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.render.ColorFrame;
import robosim.geometry.render.Light;
import robosim.geometry.render.Lighting;
import robosim.geometry.render.Sky;

/** A session's pictures are those of the camera, pixel by pixel. */
class PictureSessionTest {
    private static final BeamPattern.Pinhole CAMERA = new BeamPattern.Pinhole(70, 50, Math.PI / 2);

    private final Session session = new Session();

    private static List<GeometryObject> scene() {
        Material mirror = Material.of(Color.parse("#204080")).withMirror(0.7);
        return List.of(
                new BoxObject(new Point(0, -1, 0), 30, 1, 30),
                new BoxObject(new Point(6, 1, 0), 1, 3, 8).withMaterial(mirror),
                new BoxObject(new Point(0, 1, -6), 8, 3, 1).withMaterial(mirror),
                new SphereObject(new Point(3, 0.5, -2), 0.8).withMaterial(Material.of(Color.parse("#d03020"))),
                new CylinderObject(new Point(0, 0.5, 0), 0.4, 1).moveable("robot"));
    }

    private void init(Dimension dimension) {
        session.reply(new InitBundle(scene(), new WorldSettings(40, 20, 40, dimension, Accuracy.EXACT)));
    }

    private Reply ask(BatchRequest... requests) {
        return Objects.requireNonNull(session.reply(new BatchRequestBundle(List.of(requests))));
    }

    private PictureAnswer picture(PictureRequest request) {
        return (PictureAnswer)
                ((BatchAnswerBundle) ask(request).bundle()).answers().get(0);
    }

    private static PictureAnswer rendered(ColorCamera camera, Geometry world) {
        ColorFrame frame = new ColorFrame();
        camera.render(world, frame);
        assertThat(java.util.Arrays.stream(frame.pixels()).distinct().count()).isGreaterThan(100);
        return PictureAnswer.of(frame.width(), frame.height(), frame.pixels());
    }

    @Test
    void picturesHaveTheBitsOfTheCamera() {
        init(Dimension.SPATIAL);
        Geometry world = Objects.requireNonNull(session.world());
        ColorCamera plain = ColorCamera.of(70, 50, 90);
        Pose mount = Pose.of(new Point(0.5, 0.2, 0), 20);
        Mount carried = new Mount(mount.center(), new Numbers(mount.rotation()));
        PictureRequest byRobot = new PictureRequest("robot", carried, CAMERA);
        assertThat(picture(byRobot)).isEqualTo(rendered(plain.on("robot", mount), world));

        Pose eye = Pose.lookAt(new Point(-4, 3, 5), new Point(1, 0, -1));
        Mount free = new Mount(eye.center(), new Numbers(eye.rotation()));
        SceneLight light = new SceneLight(
                Color.parse("#102030"),
                Color.parse("#405060"),
                Color.BLACK,
                0.3,
                List.of(
                        new SceneLight.Sun(new Point(0.3, -1, 0.2), Color.WHITE, 0.5),
                        new SceneLight.Lamp(new Point(0, 3, 2), Color.parse("#ffd0a0"), 4),
                        new SceneLight.Spot(new Point(2, 5, 0), new Point(0, -1, 0), Math.PI / 3, Color.WHITE, 9)));
        Lighting same = new Lighting(
                new Sky(Color.parse("#102030"), Color.parse("#405060"), Color.BLACK, 0.3),
                List.of(
                        new Light.Sun(new Point(0.3, -1, 0.2), Color.WHITE, 0.5),
                        new Light.Lamp(new Point(0, 3, 2), Color.parse("#ffd0a0"), 4),
                        new Light.Spot(new Point(2, 5, 0), new Point(0, -1, 0), 60, Color.WHITE, 9)));
        PictureAnswer lit = picture(new PictureRequest("", free, CAMERA, 2, 1, false, light));
        assertThat(lit)
                .isEqualTo(rendered(plain.at(eye).withSamples(2).withMirrors(1).withLighting(same), world));
        assertThat(lit).isNotEqualTo(picture(new PictureRequest("", free, CAMERA, 2, 0, false, light)));
        assertThat(lit).isNotEqualTo(picture(new PictureRequest("", free, CAMERA, 2, 1, false, null)));

        // The next frame of the robot is from where it then is, and the next world has none of the last one.
        session.reply(new MoveBundle(List.of(new MoveRequest("robot", 1, 0, 0, 0, Math.PI / 2))));
        PictureAnswer moved = picture(byRobot);
        assertThat(moved).isEqualTo(rendered(plain.on("robot", mount), world));
        PictureRequest over = new PictureRequest("robot", new Mount(new Point(0, 0.2, 0)), CAMERA, 1, 3, true, null);
        ColorFrame inside = new ColorFrame();
        plain.on("robot", Pose.of(new Point(0, 0.2, 0), 0))
                .withCarrier(Carrier.SEEN)
                .render(world, inside);
        assertThat(picture(over)).isEqualTo(PictureAnswer.of(70, 50, inside.pixels()));
        init(Dimension.SPATIAL);
        assertThat(picture(byRobot)).isNotEqualTo(moved);
        assertThat(picture(byRobot))
                .isEqualTo(rendered(plain.on("robot", mount), Objects.requireNonNull(session.world())));
    }

    @Test
    void whatHasNoPicture() {
        PictureRequest free = new PictureRequest("", Mount.CENTER, CAMERA);
        Reply early = ask(free);
        assertThat(((BatchAnswerBundle) early.bundle()).answers()).containsExactly(new NoAnswer());
        assertThat(early.problems().get(0).reason()).contains("there is no world yet");
        init(Dimension.SPATIAL);
        Reply reply = ask(new PictureRequest("rover", Mount.CENTER, CAMERA), free);
        assertThat(((BatchAnswerBundle) reply.bundle()).answers().get(0)).isEqualTo(new NoAnswer());
        assertThat(((BatchAnswerBundle) reply.bundle()).answers().get(1)).isInstanceOf(PictureAnswer.class);
        assertThat(reply.problems()).hasSize(1);
        assertThat(reply.problems().get(0).reason()).isEqualTo("no moveable object \"rover\"");
        init(Dimension.PLANAR);
        assertThat(((BatchAnswerBundle) ask(free).bundle()).answers().get(0)).isInstanceOf(PictureAnswer.class);
    }

    /** Other sessions are let in between two blocks of a picture. */
    @Test
    void aPictureTakesItsBreath() {
        int[] breaths = new int[1];
        session.pausing(() -> breaths[0]++, new robosim.geometry.net.session.LogBudget(System::nanoTime));
        init(Dimension.SPATIAL);
        breaths[0] = 0;
        picture(new PictureRequest("", Mount.CENTER, new BeamPattern.Pinhole(512, 128, 1)));
        assertThat(breaths[0]).isGreaterThanOrEqualTo(512 * 128 / 4096);
    }
}
