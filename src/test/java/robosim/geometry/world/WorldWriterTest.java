package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

class WorldWriterTest {
    private static World reread(String xml) throws WorldException {
        return WorldReader.read(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "test", null);
    }

    @Test
    void readsBackToAnEqualWorld() throws WorldException {
        int worlds = 300;
        int[] seen = new int[features("").length];
        for (int seed = 0; seed < worlds; seed++) {
            World world = new RandomWorlds(seed).next();
            String xml = WorldWriter.toXml(world);
            World again = reread(xml);
            assertThat(again).as("seed %d:\n%s", seed, xml).isEqualTo(world);
            assertThat(WorldWriter.toXml(again)).as("seed %d", seed).isEqualTo(xml);
            boolean[] features = features(xml);
            for (int k = 0; k < seen.length; k++) {
                seen[k] += features[k] ? 1 : 0;
            }
        }
        for (int k = 0; k < seen.length; k++) {
            assertThat(seen[k]).as("feature %d", k).isBetween(worlds / 50, worlds * 49 / 50);
        }
    }

    private static boolean[] features(String xml) {
        String[] texts = {
            "<box", "<cylinder", "<sphere", "<mesh", "<group", "<bounds>", "<quads>", "<triangles>", "solid=", "color=",
            "<sonar", "max=", "heading=", "rotation=", "moveable=", "center=", "unit=", "PLANAR", "SPATIAL", "&quot;",
            "&lt;", "&amp;", "&#9;", "&#10;", "\ud83e\udd16", "  <group", "      <group", "0.00"
        };
        boolean[] found = new boolean[texts.length];
        for (int k = 0; k < texts.length; k++) {
            found[k] = xml.contains(texts[k]);
        }
        return found;
    }

    @Test
    void writesAHeadingWhereItGivesTheRotationBack() {
        GeometryObject turned = new BoxObject(new Point(), 1, 1, 1).turned(0, 33.3);
        assertThat(WorldWriter.toXml(new World(9, 9, 9, List.of(new WorldObject(turned)))))
                .contains("heading=\"33.3\"")
                .doesNotContain("rotation");
    }

    /** A heading that is a sum has a low part, which no single number tells; so has what was turned in a world. */
    @Test
    void whatIsReadBackTurnsOnAsWhatWasWritten() throws WorldException {
        SplittableRandom random = new SplittableRandom(24);
        int sums = 0;
        int rotations = 0;
        for (int run = 0; run < 500; run++) {
            GeometryObject object = new BoxObject(new Point(), 1, 2, 3);
            for (int k = random.nextInt(4); k > 0; k--) {
                object = object.turned(0, random.nextDouble() * random.nextDouble() * 40);
            }
            if (random.nextInt(3) == 0) {
                object = object.oriented(
                        object.turned(0, 0.1 * random.nextInt(3600)).rotation());
            }
            if (random.nextInt(8) == 0) {
                object = object.turned(random.nextDouble(-90, 90), 3);
            }
            GeometryObject group =
                    new ObjectGroup(List.of(object)).turned(0, 0.1).turned(0, 0.2);
            World world = new World(99, 99, 99, List.of(new WorldObject(object), new WorldObject(group)));
            String xml = WorldWriter.toXml(world);
            World again = reread(xml);
            assertThat(again).isEqualTo(world);
            assertThat(WorldWriter.toXml(again)).isEqualTo(xml);
            sums += object.pose().lostHeading() != 0 ? 1 : 0;
            rotations += xml.contains("rotation=") ? 1 : 0;
            for (int k = 0; k < 2; k++) {
                GeometryObject written = world.objects().get(k).object();
                GeometryObject read = again.objects().get(k).object();
                for (int turn = 0; turn < 20; turn++) {
                    double degrees = random.nextDouble() * random.nextDouble() * 80 - 40;
                    written = written.turned(0, degrees);
                    read = read.turned(0, degrees);
                    assertThat(read.rotation())
                            .as("run %d, turn %d of\n%s", run, turn, xml)
                            .isEqualTo(written.rotation());
                    assertThat(read.pose().lostHeading())
                            .isEqualTo(written.pose().lostHeading());
                }
            }
        }
        assertThat(sums).isBetween(100, 300);
        assertThat(rotations).isBetween(50, 400);
    }

    @Test
    void writesTheSameTextForTheSameWorld() {
        World world = new World(
                4,
                2,
                4.5,
                List.of(
                        new WorldObject(
                                new SphereObject(new Point(1, 0, -1), 0.5).moveable("ball"),
                                "#FF0000",
                                List.of(new SonarRing(4, 0, 3, 10))),
                        new WorldObject(new ObjectGroup(List.of(new BoxObject(new Point(), 1, 1, 0.1))))));
        assertThat(WorldWriter.toXml(world)).isEqualTo("""
                        <?xml version="1.0" encoding="UTF-8"?>
                        <world xmlns="urn:robosim:world:1" width="4" height="2" length="4.5" dimension="SPATIAL" accuracy="EXACT">
                          <sphere name="ball" moveable="true" center="1 0 -1" radius="0.5" color="#ff0000">
                            <sonar count="4" first="0" step="90" min="0" max="3" width="10"/>
                          </sphere>
                          <group>
                            <box width="1" height="1" length="0.1"/>
                          </group>
                        </world>
                        """);
    }

    @Test
    void writesAWholeFileOrNone(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("world.xml");
        World good = new World(1, 2, 3, List.of());
        WorldWriter.write(good, file);
        World bad = new World(
                1, 2, 3, List.of(new WorldObject(new SphereObject(new Point(), 0).named("control \u0001 character"))));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> WorldWriter.write(bad, file))
                .withMessage("name must have only characters that XML allows (got: U+1)");
        assertThat(WorldReader.read(file)).isEqualTo(good);
        try (var files = Files.list(folder)) {
            assertThat(files).containsExactly(file);
        }
        Path nowhere = folder.resolve("missing/world.xml");
        assertThatThrownBy(() -> WorldWriter.write(good, nowhere))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining(nowhere.toString())
                .hasMessageContaining("could not be written");
    }

    @Test
    void writesNothingThatIsTooLargeToBeRead(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("world.xml");
        World world = new World(1, 2, 3, List.of());
        int size = WorldWriter.toXml(world).length();
        WorldWriter.write(world, file, size);
        World longer = new World(1, 2, 3.25, List.of());
        assertThatThrownBy(() -> WorldWriter.write(longer, file, size))
                .isInstanceOf(WorldException.class)
                .hasMessageStartingWith(file + ": a world file must have at most " + size + " bytes")
                .hasMessageContaining(".obj")
                .hasMessageEndingWith("(got: more)");
        // It does not write on to the end of what is far too large.
        assertThatThrownBy(() -> WorldWriter.write(longer, file, 10)).hasMessageContaining("at most 10 bytes");
        World many =
                new World(9, 9, 9, Collections.nCopies(100_000, new WorldObject(new BoxObject(new Point(), 1, 1, 1))));
        assertThatThrownBy(() -> WorldWriter.write(many, file, 1 << 20)).hasMessageContaining("at most 1048576 bytes");
        assertThat(WorldReader.read(file)).isEqualTo(world);
    }

    @Test
    void refusesWhatTheReaderWouldRefuse() throws WorldException {
        World named = named("x".repeat(1000));
        assertThat(reread(WorldWriter.toXml(named))).isEqualTo(named);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> WorldWriter.toXml(named("x".repeat(1001))))
                .withMessageContaining("at most 1000 characters; shorten it (got: 1001)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> WorldWriter.toXml(named("half a pair \ud83e")))
                .withMessageContaining("(got: U+d83e)");

        World deep = nested(50);
        assertThat(reread(WorldWriter.toXml(deep))).isEqualTo(deep);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> WorldWriter.toXml(nested(51)))
                .withMessageContaining("at most 50");
    }

    private static World named(String name) {
        return new World(9, 9, 9, List.of(new WorldObject(new SphereObject(new Point(), 1).named(name))));
    }

    private static World nested(int groups) {
        GeometryObject object = new SphereObject(new Point(), 1);
        for (int k = 0; k < groups; k++) {
            object = new ObjectGroup(List.of(object));
        }
        return new World(9, 9, 9, List.of(new WorldObject(object)));
    }
}
