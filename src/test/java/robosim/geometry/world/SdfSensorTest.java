package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.sensor.DepthCamera;
import robosim.geometry.sensor.DepthFrame;
import robosim.geometry.sensor.Intrinsics;
import robosim.geometry.sensor.Lidar;
import robosim.geometry.sensor.LidarFrame;
import robosim.geometry.sensor.Noise;

/** Sensors as worlds of Gazebo describe them. */
public class SdfSensorTest {
    private static final Path REAL = Path.of("src/test/resources/robosim/geometry/world/sdf/export_occupancy_grid.sdf");

    /** A robot with one box, whose object is the box itself, two links with sensors, and a wall ahead of it. */
    public static final String ROBOT = """
            <sdf version="1.9"><world name="w">
              <model name="wall"><static>true</static><pose>6 0 1 0 0 0</pose><link name="l">
                <collision name="c"><geometry><box><size>0.5 20 2</size></box></geometry></collision></link></model>
              <model name="rover"><pose>1 2 0.5 0 0 1.5707963267948966</pose>
                <link name="base"><pose>0 0 0.25 0 0 0</pose>
                  <collision name="c"><pose>0 0 0.1 0 0 0</pose>
                    <geometry><box><size>1 0.6 0.4</size></box></geometry></collision>
                  <sensor name="laser" type="gpu_lidar">
                    <pose>0.1 0 0.4 0 0 -1.5707963267948966</pose>
                    <update_rate>12.5</update_rate><topic>scan</topic>
                    <lidar>
                      <scan>
                        <horizontal><samples>90</samples><resolution>2</resolution>
                          <min_angle>-0.7853981633974483</min_angle><max_angle>0.7853981633974483</max_angle></horizontal>
                        <vertical><samples>3</samples><min_angle>-0.1</min_angle><max_angle>0.1</max_angle></vertical>
                      </scan>
                      <range><min>0.12</min><max>inf</max><resolution>0.015</resolution></range>
                      <noise><type>gaussian</type><mean>0.01</mean><stddev>0.02</stddev></noise>
                    </lidar>
                  </sensor>
                  <sensor name="imu" type="imu"><update_rate>100</update_rate></sensor>
                </link>
                <link name="head"><pose relative_to="base">0 0 1 0 0 0</pose>
                  <sensor name="eye" type="depth_camera"><pose>0 0 0 0 0.5 0</pose>
                    <camera><horizontal_fov>1.5707963267948966</horizontal_fov>
                      <image><width>40</width><height>30</height><format>R_FLOAT32</format></image>
                      <clip><near>0.2</near><far>8</far></clip>
                      <noise type="gaussian"><mean>0</mean><stddev>0.007</stddev><bias_mean>0.5</bias_mean></noise>
                    </camera></sensor>
                  <sensor name="photo" type="camera"><camera/></sensor>
                  <sensor name="labels" type="segmentation_camera"><camera/></sensor>
                  <sensor name="normals" type="normal_camera"><camera/></sensor>
                </link>
              </model>
              <model name="post"><static>1</static><pose>0 0 3 0 0 0</pose><link name="l">
                <sensor name="photo" type="camera"><pose>0 1 0 0 0 0</pose></sensor></link></model>
            </world></sdf>
            """;

    @TempDir
    Path folder;

    private List<SdfSensor> found(String sdf) throws IOException, WorldException {
        return SdfSensor.read(Files.writeString(folder.resolve("world.sdf"), sdf), List.of());
    }

    @Test
    void theLaserOfARealWorld() throws WorldException {
        List<SdfSensor> all = SdfSensor.read(REAL, List.of());
        assertThat(all).hasSize(1);
        SdfSensor laser = all.get(0);
        assertThat(laser.name()).endsWith("::link::gpu_lidar");
        assertThat(laser.carrier()).isNull(); // its model has no collision
        assertThat(laser.line()).isEqualTo(82);
        assertThat(laser.kind()).isEqualTo(SdfSensor.Kind.LIDAR);
        assertThat(laser.updateRate()).isEqualTo(10);
        assertThat(laser.noise()).isEqualTo(Noise.NONE);
        Lidar lidar = laser.lidar();
        assertThat(lidar.pattern().size()).isEqualTo(640);
        assertThat(lidar.options()).isEqualTo(SenseOptions.range(0.08, 9));
        assertThat(lidar).isEqualTo(lidar.withRep117()).isNotEqualTo(lidar.withClampedRanges());
        Geometry world = SdfReader.read(REAL, List.of()).world().toGeometry();
        LidarFrame frame = new LidarFrame();
        lidar.read(world, frame);
        int echoes = 0;
        for (int k = 0; k < frame.size(); k++) {
            echoes += frame.range(k) < Double.POSITIVE_INFINITY ? 1 : 0;
        }
        assertThat(echoes).isGreaterThan(20);
    }

    @Test
    void whereSensorsOfARobotAre() throws IOException, WorldException {
        List<SdfSensor> all = found(ROBOT);
        assertThat(all.stream().map(SdfSensor::name))
                .containsExactly(
                        "rover::base::laser",
                        "rover::base::imu",
                        "rover::head::eye",
                        "rover::head::photo",
                        "rover::head::labels",
                        "rover::head::normals",
                        "post::l::photo");
        Geometry world =
                SdfReader.read(folder.resolve("world.sdf"), List.of()).world().toGeometry();
        GeometryObject rover = world.getObject("rover");
        assertThat(rover).isInstanceOf(BoxObject.class); // whose frame is not that of the model
        Lidar lidar = all.get(0).lidar();
        assertThat(lidar.carrier()).isEqualTo("rover");
        // In the file's axes: model at (1, 2, 0.5) turned to its left, link 0.25 up, sensor 0.1 ahead and 0.4 up.
        Pose inWorld = lidar.mount().within(rover.pose());
        assertThat(inWorld.center().x()).isCloseTo(1, within(1e-15));
        assertThat(inWorld.center().y()).isCloseTo(1.15, within(1e-15));
        assertThat(inWorld.center().z()).isCloseTo(-2.1, within(1e-15));
        assertThat(inWorld.heading()).isCloseTo(0, within(1e-12)); // towards the wall
        RayPattern pattern = lidar.pattern();
        assertThat(pattern.rows()).isEqualTo(3);
        assertThat(pattern.columns()).isEqualTo(180);
        assertThat(pattern.direction(0).y()).isCloseTo(-StrictMath.sin(0.1), within(1e-15));
        assertThat(pattern.direction(0).z()).isPositive(); // to the right, which is where negative angles are
        assertThat(lidar.options()).isEqualTo(SenseOptions.range(0.12, Double.POSITIVE_INFINITY));
        assertThat(all.get(0).noise()).isEqualTo(Noise.gaussian(0.01, 0.02));
        assertThat(all.get(0).updateRate()).isEqualTo(12.5);
        LidarFrame frame = new LidarFrame();
        lidar.read(world, frame);
        double middle = Math.min(frame.range(180 + 89), frame.range(180 + 90));
        assertThat(middle).isCloseTo(4.75, within(1e-3)); // the wall's near face is at 5.75
        assertThat(all.get(1).kind()).isEqualTo(SdfSensor.Kind.OTHER);

        DepthCamera eye = all.get(2).depthCamera();
        assertThat(eye.intrinsics()).isEqualTo(Intrinsics.fieldOfView(40, 30, 90));
        assertThat(eye.options()).isEqualTo(SenseOptions.range(0.2, 8));
        assertThat(all.get(2).noise()).isEqualTo(Noise.gaussian(0, 0.007).and(Noise.bias(0.5, 0)));
        assertThat(eye.mount().within(rover.pose()).center().y()).isCloseTo(1.75, within(1e-15));
        double[] r = eye.mount().within(rover.pose()).rotation();
        assertThat(r[3]).isCloseTo(-StrictMath.sin(0.5), within(1e-15)); // it looks down
        DepthFrame seen = new DepthFrame();
        eye.withNoise(all.get(2).noise(), 3, 0).read(world, 0, seen);
        assertThat(all.get(3).fieldOfView()).isCloseTo(60, within(0.02)); // 1.047 radians
        assertThat(all.get(3).intrinsics().width()).isEqualTo(320);
        assertThat(all.get(4).segmentationCamera().carrier()).isEqualTo("rover");
        assertThat(all.get(5).normalCamera().options()).isEqualTo(SenseOptions.range(0.1, 100));
        assertThat(all.get(6).carrier()).isNull();
        assertThat(all.get(6).pose().center()).isEqualTo(new Point(0, 3, -1));
    }

    /** A robot of two shapes is a group, in the frame of its model. */
    @Test
    void aGroupKeepsTheFrameOfItsModel() throws IOException, WorldException {
        String two = ROBOT.replace(
                "<link name=\"head\"><pose relative_to=\"base\">0 0 1 0 0 0</pose>",
                "<link name=\"head\"><pose relative_to=\"base\">0 0 1 0 0 0</pose><collision name=\"c\"><geometry><sphere>"
                        + "<radius>0.1</radius></sphere></geometry></collision>");
        List<SdfSensor> all = found(two);
        Geometry world =
                SdfReader.read(folder.resolve("world.sdf"), List.of()).world().toGeometry();
        Pose inWorld = all.get(0).pose().within(world.getObject("rover").pose());
        assertThat(inWorld.center().y()).isCloseTo(1.15, within(1e-15));
        assertThat(inWorld.center().z()).isCloseTo(-2.1, within(1e-15));
        assertThat(all.get(0).pose().center().x()).isCloseTo(0.1, within(1e-15));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            <samples>90</samples> | <samples>1.5</samples> | <scan/horizontal/samples> must be a whole number (got: 1.5)
            <samples>90</samples> | <samples>many</samples> | <scan/horizontal/samples> must be a number (got: "many")
            <samples>90</samples> | <samples>0</samples> | <samples> times <resolution> must be from 1 to 16777216 (got: 0.0)
            <samples>90</samples> | <samples>90000000</samples> | (got: 1.8E8)
            <min>0.12</min> | <min>-1</min> | min must be
            <max_angle>0.1</max_angle> | <max_angle>-0.2</max_angle> | <min_angle> must be at most <max_angle>
            <max_angle>0.1</max_angle> | <max_angle>2</max_angle> | elevation
            """)
    void whatNoLidarHas(String before, String after, String reason) throws IOException, WorldException {
        SdfSensor laser = found(ROBOT.replace(before, after)).get(0);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> laser.lidar())
                .withMessageContaining("world.sdf:8: sensor rover::base::laser: ")
                .withMessageContaining(reason);
    }

    /** Intrinsics and distortion are applied; elements of a lens that are not applied here are named with the sensor. */
    @Test
    void whatIsIgnoredOfALensIsNamed() throws IOException, WorldException {
        String[][] cases = {
            {"<lens><intrinsics><fx>277</fx><fy>277</fy><cx>80</cx><s>0.0</s></intrinsics></lens>", ""},
            {"<lens><intrinsics><s>0.1</s></intrinsics></lens>", "<s> of <lens><intrinsics>"},
            {"<distortion><k1>-0.3</k1><center>0.5 0.5</center></distortion>", ""},
            {"<distortion><k1>-0.3</k1><center>0.4 0.5</center></distortion>", "<center> of <distortion>"},
            {"<lens><type>stereographic</type><intrinsics/></lens>", ""},
            {
                "<lens><projection><p_fx>2</p_fx></projection></lens><distortion><center>0 0</center></distortion>",
                "<center> of <distortion>, <lens><projection>"
            },
            {"", ""}
        };
        for (String[] each : cases) {
            String sdf = ROBOT.replace(
                    "<sensor name=\"photo\" type=\"camera\"><camera/>",
                    "<sensor name=\"photo\" type=\"camera\"><camera>" + each[0] + "</camera>");
            List<String> ignored = new ArrayList<>();
            found(sdf).forEach(sensor -> sensor.ignored().ifPresent(ignored::add));
            List<String> remarks =
                    SdfReader.read(folder.resolve("world.sdf"), List.of()).remarks();
            if (each[1].isEmpty()) {
                assertThat(ignored).isEmpty();
            } else {
                assertThat(ignored).hasSize(1);
                assertThat(ignored.get(0))
                        .startsWith(folder.resolve("world.sdf").toString())
                        .contains(": sensor rover::head::photo: " + each[1] + " is ignored");
                assertThat(remarks).containsAll(ignored);
            }
            assertThat(remarks.stream().filter(remark -> remark.contains("is ignored")))
                    .hasSameSizeAs(ignored);
        }
    }

    /** Each number of the file is that of the image, and what is left out follows from the field of view. */
    @Test
    void lensAndDistortion() throws IOException, WorldException {
        String lens = "<camera><horizontal_fov>1.5707963267948966</horizontal_fov><image><width>320</width>"
                + "<height>240</height></image><lens><intrinsics><fx>277</fx><cx>80</cx></intrinsics></lens><distortion>"
                + "<k1>-0.03</k1><k2>0.02</k2><k3>0.005</k3><p1>0.001</p1><p2>-0.002</p2></distortion></camera>";
        SdfSensor photo = found(ROBOT.replace(
                        "<sensor name=\"photo\" type=\"camera\"><camera/>",
                        "<sensor name=\"photo\" type=\"camera\">" + lens))
                .get(3);
        Intrinsics seen = photo.intrinsics();
        Intrinsics usual = Intrinsics.fieldOfView(320, 240, photo.fieldOfView());
        assertThat(seen)
                .isEqualTo(new Intrinsics(
                        320,
                        240,
                        277,
                        usual.fy(),
                        80,
                        usual.cy(),
                        Intrinsics.Distortion.brownConrady(-0.03, 0.02, 0.001, -0.002, 0.005)));
        assertThat(usual.fy()).isCloseTo(160, within(1e-9)); // a quarter turn is as wide as twice its distance
        assertThat(found(ROBOT).get(3).intrinsics().distortion().isNone()).isTrue();
    }

    @Test
    void refusals() throws IOException, WorldException {
        List<SdfSensor> all = found(ROBOT.replace("<width>40</width>", "<width>0</width>")
                .replace("<type>gaussian</type>", "<type>pink</type>"));
        assertThatThrownBy(() -> all.get(0).noise())
                .hasMessageContaining("type must be none, gaussian or gaussian_quantized (got: \"pink\")");
        assertThatThrownBy(() -> all.get(2).depthCamera())
                .hasMessageContaining("sensor rover::head::eye: width must be from 1 to");
        assertThatThrownBy(() -> all.get(1).lidar())
                .hasMessage("sensor must be one of LIDAR (got: rover::base::imu of type imu)");
        assertThatThrownBy(() -> all.get(0).intrinsics())
                .hasMessage("sensor must be a camera (got: rover::base::laser of type gpu_lidar)");
        assertThatThrownBy(() -> SdfSensor.read(folder.resolve("none.sdf"), List.of()))
                .isInstanceOf(WorldException.class);
    }
}
