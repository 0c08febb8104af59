package robosim.geometry.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.world.ImportOptions;
import robosim.geometry.world.WorldImport;

/** {@link Frame}: cases computed by hand, rotations by Euler angles, round trips, and what the SDFormat importer does. */
class FrameTest {
    private static final Offset<Double> ROUNDING = within(1e-12);
    private static final double HALF = Math.sqrt(0.5);

    private final SplittableRandom random = new SplittableRandom(42);

    @Test
    void forwardLeftAndUp() {
        Frame ros = Frame.ros(5, 4);
        assertThat(ros.vector(new Point(1, 2, 3))).isEqualTo(new Point(1, -3, 2));
        assertThat(ros.worldVector(new Point(1, -3, 2))).isEqualTo(new Point(1, 2, 3));
        assertThat(ros.point(new Point())).isEqualTo(new Point(5, 4, 0));
        assertThat(ros.point(new Point(-5, 1.5, 4))).isEqualTo(new Point(0, 0, 1.5));
        assertThat(ros.worldPoint(new Point(0, 0, 1.5))).isEqualTo(new Point(-5, 1.5, 4));
    }

    @Test
    void rollPitchAndYaw() {
        // A roll of a quarter turn takes left to up, a pitch forward to down, a yaw forward to left.
        assertAxes(new Quaternion(HALF, 0, 0, HALF), new Point(1, 0, 0), new Point(0, 0, 1));
        assertAxes(new Quaternion(0, HALF, 0, HALF), new Point(0, 0, -1), new Point(0, 1, 0));
        assertAxes(new Quaternion(0, 0, HALF, HALF), new Point(0, 1, 0), new Point(-1, 0, 0));
    }

    private static void assertAxes(Quaternion turn, Point forward, Point left) {
        Frame ros = Frame.ros();
        double[] r = ros.worldPose(new Frame.RosPose(new Point(), turn)).rotation();
        assertNear(ros.vector(new Point(r[0], r[3], r[6])), forward);
        assertNear(ros.vector(new Point(-r[2], -r[5], -r[8])), left);
    }

    @Test
    void placesOnTheFloor() {
        Frame ros = Frame.ros(5, 4);
        Frame.Pose2D place = ros.pose2D(Pose.of(new Point(1, 0.5, -2), 90));
        assertThat(place).isEqualTo(new Frame.Pose2D(6, 6, Math.PI / 2));
        assertThat(ros.worldPose(place, 0.5)).isEqualTo(Pose.of(new Point(1, 0.5, -2), 90));
    }

    @Test
    void velocitiesForcesAndBoxes() {
        Frame ros = Frame.ros(9, 9);
        Frame.Vectors twist = ros.twist(new Twist(1, 0.1, 0.5, 180));
        assertThat(twist).isEqualTo(new Frame.Vectors(new Point(1, -0.5, 0.1), new Point(0, 0, Math.PI)));
        assertThat(ros.worldTwist(twist)).isEqualTo(new Twist(1, 0.1, 0.5, 180));
        assertThat(ros.wrench(new Point(1, 2, 3), new Point(4, 5, 6)))
                .isEqualTo(new Frame.Vectors(new Point(1, -3, 2), new Point(4, -6, 5)));
        assertThat(ros.box(4.5, 1.4, 1.8)).isEqualTo(new Point(4.5, 1.8, 1.4));
        assertThat(ros.worldBox(4.5, 1.8, 1.4)).isEqualTo(new Point(4.5, 1.4, 1.8));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> ros.worldTwist(new Frame.Vectors(new Point(), new Point(0.1, 0, 1))))
                .withMessageContaining("about Z alone");
    }

    @Test
    void posesReturn() {
        for (int k = 0; k < 2000; k++) {
            Frame ros = Frame.ros(random.nextDouble(-9, 9), random.nextDouble(-9, 9));
            Point center = new Point(random.nextDouble(-9, 9), random.nextDouble(-9, 9), random.nextDouble(-9, 9));
            Pose pose = Pose.of(center, k % 8 * 90)
                    .turned(random.nextDouble(-180, 180), k % 3 == 0 ? 0 : random.nextDouble(360));
            Frame.RosPose there = ros.pose(pose);
            assertThat(there.orientation().w()).isGreaterThanOrEqualTo(0);
            Pose back = ros.worldPose(there);
            assertNear(back.center(), center);
            assertThat(back.rotation()).containsExactly(pose.rotation(), ROUNDING);
            // The forward axis is rotated by ROS's quaternion as by the module's matrix.
            double[] q = there.orientation().rotation();
            assertNear(
                    new Point(q[0], q[3], q[6]),
                    ros.vector(new Point(pose.rotation(0), pose.rotation(3), pose.rotation(6))));
        }
    }

    @Test
    void roundedRotationsAreAcceptedOnRequest() {
        int refused = 0;
        for (int k = 0; k < 500; k++) {
            double[] q = unit();
            double[] short8 =
                    DoubleStream.of(q).map(part -> Math.round(part * 1e8) / 1e8).toArray();
            Quaternion again = Quaternion.renormalised(short8[0], short8[1], short8[2], short8[3]);
            assertThat(new double[] {again.x(), again.y(), again.z(), again.w()})
                    .containsExactly(q, within(1e-7));
            try {
                new Quaternion(short8[0], short8[1], short8[2], short8[3]);
            } catch (IllegalArgumentException e) {
                refused++;
            }
        }
        assertThat(refused).isGreaterThan(100);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Quaternion.renormalised(0, 0, 0, 1.00001))
                .withMessageContaining("1e-6 (got: 0.0, 0.0, 0.0, 1.00001)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Quaternion(0, 0, Double.NaN, 1))
                .withMessageContaining("renormalised");
    }

    @Test
    void agreesWithTheImporterOfSdformat(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("box.sdf");
        Files.writeString(file, """
                <sdf version="1.8"><world name="w"><model name="crate"><static>true</static>
                <pose>1 2 0.5 0.1 0.2 0.3</pose><link name="l"><collision name="c"><geometry><box>
                <size>3 2 1</size></box></geometry></collision></link></model></world></sdf>
                """);
        GeometryObject crate = WorldImport.read(file, ImportOptions.DEFAULT)
                .world()
                .objects()
                .get(0)
                .object();
        Frame.RosPose there = Frame.ros().pose(crate.pose());
        assertNear(there.position(), new Point(1, 2, 0.5));
        double[] q = euler(0.1, 0.2, 0.3);
        Quaternion turn = there.orientation();
        assertThat(new double[] {turn.x(), turn.y(), turn.z(), turn.w()}).containsExactly(q, ROUNDING);
        assertThat(crate.sizes()).containsExactly(3, 1, 2);
        assertThat(Frame.ros().worldBox(3, 2, 1)).isEqualTo(new Point(3, 1, 2));
    }

    /** Roll, pitch and yaw as a quaternion, by the formula for intrinsic Z-Y-X angles. */
    private static double[] euler(double roll, double pitch, double yaw) {
        double cr = Math.cos(roll / 2), sr = Math.sin(roll / 2);
        double cp = Math.cos(pitch / 2), sp = Math.sin(pitch / 2);
        double cy = Math.cos(yaw / 2), sy = Math.sin(yaw / 2);
        return new double[] {
            sr * cp * cy - cr * sp * sy,
            cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy,
            cr * cp * cy + sr * sp * sy
        };
    }

    private double[] unit() {
        double[] q = random.doubles(4, -1, 1).toArray();
        double length = Math.sqrt(DoubleStream.of(q).map(part -> part * part).sum());
        return DoubleStream.of(q).map(part -> part / length).toArray();
    }

    private static void assertNear(Point got, Point expected) {
        assertThat(new double[] {got.x(), got.y(), got.z()})
                .containsExactly(new double[] {expected.x(), expected.y(), expected.z()}, ROUNDING);
    }
}
