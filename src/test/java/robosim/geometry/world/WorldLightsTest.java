package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.material.Color;
import robosim.geometry.model.Point;
import robosim.geometry.render.Light;
import robosim.geometry.render.Light.Falloff;
import robosim.geometry.render.Light.Shadows;
import robosim.geometry.render.Lighting;
import robosim.geometry.render.Sky;

/** The light of SDFormat, and that of our own files. */
class WorldLightsTest {
    private static final Offset<Double> NEAR = Offset.offset(1e-12);

    @TempDir
    private Path folder;

    private WorldImport sdf(String inWorld) throws IOException, WorldException {
        Path file = folder.resolve("w.sdf");
        Files.writeString(
                file,
                "<sdf version=\"1.9\"><world name=\"w\">" + inWorld
                        + "<model name=\"ball\"><link name=\"l\"><collision name=\"c\"><geometry><sphere><radius>1</radius></sphere>"
                        + "</geometry></collision></link></model></world></sdf>");
        return WorldImport.read(file, ImportOptions.DEFAULT);
    }

    private static World xml(String lighting) throws WorldException {
        String text = "<world xmlns=\"" + WorldWriter.NAMESPACE + "\" width=\"9\" height=\"9\" length=\"9\" unit=\"m\">"
                + lighting + "</world>";
        return WorldReader.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "w.xml", null);
    }

    private static void near(Point point, double x, double y, double z) {
        assertThat(point.x()).isCloseTo(x, NEAR);
        assertThat(point.y()).isCloseTo(y, NEAR);
        assertThat(point.z()).isCloseTo(z, NEAR);
    }

    @Test
    void aWorldThatSaysNothingOfLightIsShownOnAClearDay() throws Exception {
        World world = sdf("<gravity>0 0 -9.8</gravity>").world();
        assertThat(world.lighting()).isNull();
        assertThat(world.light()).isEqualTo(Lighting.DAY);
        assertThat(WorldWriter.toXml(world)).doesNotContain("lighting");
    }

    @Test
    void eachTypeOfLightIsWhereItsPosesPutIt() throws Exception {
        WorldImport read = sdf("""
                <light name="sun" type="directional"><cast_shadows>true</cast_shadows><diffuse>0.8 0.4 0 1</diffuse>
                  <direction>-0.5 0.1 -0.9</direction></light>
                <light name="lamp" type="point"><pose>1 2 3 0 0 0</pose><diffuse>2 2 2 1</diffuse><intensity>0.5</intensity>
                  <attenuation><range>20</range><constant>0.3</constant><linear>0.01</linear><quadratic>0.03</quadratic></attenuation>
                </light>
                <model name="m"><static>true</static><pose>5 0 0 0 0 1.5707963267948966</pose><link name="l"><pose>1 0 0 0 0 0</pose>
                  <light name="spot" type="spot"><pose>0 0 2 0 0 0</pose><direction>1 0 -1</direction>
                    <spot><inner_angle>0.1</inner_angle><outer_angle>0.5</outer_angle><falloff>1</falloff></spot></light>
                  <light name="off" type="point"><light_on>false</light_on></light>
                  <collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision></link></model>
                """);
        assertThat(read.remarks()).isEmpty();
        assertThat(read.passedOver()).containsEntry("light", 4);
        List<Light> lights = read.world().light().lights();
        assertThat(lights).hasSize(3);
        assertThat(lights.get(0))
                .isEqualTo(new Light.Sun(new Point(-0.5, -0.9, -0.1), Color.ofLinear(1, 0.5, 0), 0.8, Shadows.HARD));
        assertThat(lights.get(1))
                .isEqualTo(new Light.Lamp(
                        new Point(1, 3, -2), Color.WHITE, 1, new Falloff(20, 0.3, 0.01, 0.03), Shadows.NONE));
        Light.Spot spot = (Light.Spot) lights.get(2);
        near(spot.place(), 5, 2, -1); // a metre along the model's X, which is SDFormat's Y
        near(spot.direction(), 0, -1, -1);
        assertThat(spot.degrees()).isCloseTo(Math.toDegrees(0.5), NEAR);
        assertThat(spot.falloff()).isEqualTo(new Falloff(10, 1, 1, 0));
    }

    @Test
    void aSceneHasItsBackgroundAndItsAmbientLight() throws Exception {
        String sun = "<include><uri>model://sun</uri></include>";
        Lighting grey = sdf("<scene><ambient>0.4 0.2 0 1</ambient><background>0.7 0.7 0.7 1</background></scene>" + sun)
                .world()
                .light();
        Color background = new Color(0.7, 0.7, 0.7);
        assertThat(grey.sky()).isEqualTo(new Sky(background, background, background, 0.4, Color.ofLinear(1, 0.5, 0)));
        assertThat(grey.lights())
                .containsExactly(new Light.Sun(new Point(-0.5, -0.9, -0.1), Color.WHITE, 0.8, Shadows.HARD));
        Lighting blue =
                sdf("<scene><sky/><shadows>0</shadows></scene>" + sun).world().light();
        assertThat(blue.sky()).isEqualTo(Sky.DAY.withStrength(0.4).withLight(Color.WHITE));
        assertThat(blue.lights().get(0).shadows()).isEqualTo(Shadows.NONE);
    }

    @Test
    void aFileOfOneLightIsIncluded() throws Exception {
        Files.createDirectories(folder.resolve("evening"));
        Files.writeString(folder.resolve("evening/model.sdf"), """
                <sdf version="1.9"><light name="evening" type="point"><pose>0 0 9 0 0 0</pose></light></sdf>""");
        String uri = "<uri>model://evening</uri>";
        Lighting read = sdf("<include>" + uri + "</include><include>" + uri + "<pose>0 1 0 0 0 0</pose></include>")
                .world()
                .light();
        assertThat(read.lights())
                .extracting(each -> ((Light.Lamp) each).place())
                .containsExactly(new Point(0, 9, 0), new Point(0, 0, -1));
    }

    @Test
    void aBadLightCostsThatLight() throws Exception {
        WorldImport read = sdf("""
                <light name="a" type="laser"/>
                <light name="b" type="spot"/>
                <light name="c" type="directional"><direction>0 0 0</direction></light>
                <light name="d" type="point"><pose relative_to="nowhere"/></light>
                <light name="e" type="point"/>
                """);
        assertThat(read.skipped()).isEmpty();
        assertThat(read.world().light().lights()).hasSize(1);
        assertThat(read.remarks())
                .singleElement()
                .asString()
                .contains(
                        "4 lights are not lit; the first one: ", "type of <light> must be directional, point or spot");
    }

    @Test
    void readsBackAsItWasWritten() throws Exception {
        SplittableRandom random = new SplittableRandom(5);
        for (int k = 0; k < 50; k++) {
            Lighting lighting = new Lighting(
                    new Sky(
                            color(random),
                            color(random),
                            Color.WHITE,
                            random.nextDouble(),
                            k % 2 == 0 ? null : color(random)),
                    List.of());
            for (int light = 0; light < k % 7; light++) {
                lighting = lighting.withLight(light(random, light));
            }
            World world = new World(9, 9, 9, List.of()).withLighting(lighting);
            String text = WorldWriter.toXml(world);
            World read = WorldReader.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "w", null);
            assertThat(read).as(text).isEqualTo(world);
            assertThat(read.planar().spatial().withObjects(List.of())).isEqualTo(world);
        }
    }

    private static Color color(SplittableRandom random) {
        return new Color(random.nextDouble(), random.nextDouble(), random.nextDouble());
    }

    private static Light light(SplittableRandom random, int kind) {
        Point place = new Point(random.nextDouble(), random.nextDouble(), random.nextDouble());
        Shadows shadows = random.nextBoolean() ? Shadows.HARD : Shadows.NONE;
        Falloff falloff = random.nextBoolean() ? Falloff.SQUARE : new Falloff(random.nextDouble(), 0, 0.5, 0);
        double strength = random.nextDouble(9);
        return switch (kind % 3) {
            case 0 -> new Light.Sun(place, color(random), strength, shadows);
            case 1 -> new Light.Lamp(place, color(random), strength, falloff, shadows);
            default ->
                new Light.Spot(place, place, random.nextDouble(1, 179), color(random), strength, falloff, shadows);
        };
    }

    @Test
    void whatAFileLeavesOutIsThatOfAClearDay() throws Exception {
        assertThat(xml("<lighting/>").light()).isEqualTo(Lighting.DAY.withoutLights());
        assertThat(
                        xml("<lighting><sky strength=\"0.1\"/><sun direction=\"0 -1 0\"/><lamp center=\"25cm 0 0\" constant=\"2\"/>"
                                        + "</lighting>")
                                .light())
                .isEqualTo(new Lighting(
                        Sky.DAY.withStrength(0.1),
                        List.of(
                                new Light.Sun(new Point(0, -1, 0), Color.WHITE, 1),
                                new Light.Lamp(
                                        new Point(0.25, 0, 0),
                                        Color.WHITE,
                                        1,
                                        new Falloff(Double.POSITIVE_INFINITY, 2, 0, 0),
                                        Shadows.HARD))));
    }

    @Test
    void wrongLightIsRefusedWithItsPlace() {
        refused("<lighting><sun direction=\"0 0 0\"/></lighting>", "direction must not be zero");
        refused(
                "<lighting><spot direction=\"0 1 0\" angle=\"180\"/></lighting>",
                "degrees must be above 0 and below 180");
        refused("<lighting><lamp range=\"0\"/></lighting>", "range must be above 0");
        refused("<lighting><lamp quadratic=\"0\"/></lighting>", "their sum above 0");
        refused("<lighting><moon/></lighting>", "<moon>");
        refused("<lighting/><lighting/>", "<lighting>");
    }

    private static void refused(String lighting, String reason) {
        assertThatThrownBy(() -> xml(lighting))
                .isInstanceOf(WorldException.class)
                .hasMessageStartingWith("w.xml:1:")
                .hasMessageContaining(reason);
    }
}
