package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.SplittableRandom;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.rosmap.MapFiles;
import robosim.geometry.world.rosmap.OccupancyGrid;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;

class RosMapReaderTest {
    private static final Path MAPS = Path.of("src/test/resources/robosim/geometry/world/maps");
    private static final String YAML = """
            image: %s
            resolution: 0.5
            origin: [-1, -2, 0]
            negate: %d
            occupied_thresh: 0.65
            free_thresh: 0.196
            mode: %s
            """;

    @TempDir
    Path folder;

    private Path map(byte[] image, int negate, String mode) throws IOException {
        Files.write(folder.resolve("map.img"), image);
        return Files.writeString(folder.resolve("map.yaml"), YAML.formatted("map.img", negate, mode));
    }

    private Path map(String image) throws IOException {
        return map(image.getBytes(StandardCharsets.ISO_8859_1), 0, "trinary");
    }

    private static OccupancyGrid grid(Path yaml) throws FileProblem {
        return MapFiles.grid(yaml, MapFiles.settings(yaml), new ArrayList<>());
    }

    /** The rows of an image, walls as #. */
    private static String picture(OccupancyGrid grid) {
        StringBuilder rows = new StringBuilder();
        for (int row = 0; row < grid.height; row++) {
            for (int x = 0; x < grid.width; x++) {
                rows.append(grid.occupied.get(row * grid.width + x) ? '#' : '.');
            }
            rows.append(row < grid.height - 1 ? " " : "");
        }
        return rows.toString();
    }

    @Test
    void standsWhereRosHasIt() throws IOException {
        World world = RosMaps.read(map("P2 4 3 255  0 0 254 254  254 254 254 254  254 254 254 0"), 3);
        // The lower left corner is (-1, -2) of the map, which is X -1 and Z +2; up in the image is -Z.
        assertThat(world.objects())
                .containsExactly(
                        new WorldObject(
                                new GridObject(new Point(0, 0, 1.25), 0.5, 3, 4, 3, BitSet.valueOf(new byte[] {3, 8}))
                                        .named("map")),
                        // Around the image, from -1 to 1 and from 0.5 to 2, all is wall to half a cell from the border.
                        new WorldObject(
                                new BoxObject(new Point(-1.375, 0, 1.25), 0.75, 3, 1.5).named("left edge of the map")),
                        new WorldObject(
                                new BoxObject(new Point(1.375, 0, 1.25), 0.75, 3, 1.5).named("right edge of the map")),
                        new WorldObject(
                                new BoxObject(new Point(0, 0, -1.125), 3.5, 3, 3.25).named("upper edge of the map")),
                        new WorldObject(
                                new BoxObject(new Point(0, 0, 2.375), 3.5, 3, 0.75).named("lower edge of the map")));
        assertThat(world.dimension()).isEqualTo(Dimension.PLANAR);
        assertThat(world.unit()).isEqualTo(Unit.METRE);
        assertThat(new double[] {world.width(), world.height(), world.length()}).containsExactly(4, 3, 6);
        GridObject walls = (GridObject) world.objects().get(0).object();
        assertThat(walls.box(1, 0)).isEqualTo(new BoxObject(new Point(-0.25, 0, 0.75), 0.5, 3, 0.5));
        assertThat(walls.box(3, 2)).isEqualTo(new BoxObject(new Point(0.75, 0, 1.75), 0.5, 3, 0.5));
        assertThat(world.toGeometry().objects()).hasSize(5);
    }

    /** ROS 1 writes the path that the image had where the map was made. */
    @Test
    void anAbsoluteImageIsFoundByItsNameAndUnknownKeysAreTold() throws IOException {
        Path yaml = map("P2 2 1 1 0 1");
        World plain = RosMaps.read(yaml);
        Files.writeString(
                yaml, Files.readString(yaml).replace("map.img", "/home/me/maps/map.img") + "colour: [1, 2]\n");
        WorldImport read = WorldImport.read(yaml, ImportOptions.DEFAULT);
        assertThat(read.world()).isEqualTo(plain);
        assertThat(read.isWhole()).isTrue();
        assertThat(read.remarks()).hasSize(2);
        assertThat(read.remarks().get(0))
                .startsWith(yaml + ":8: a key should be image, ")
                .endsWith("(got: colour)");
        assertThat(read.remarks().get(1))
                .startsWith(yaml + ":1: image should be a path relative to this file")
                .endsWith("(got: /home/me/maps/map.img)");
    }

    @Test
    void unknownCellsAreWhatIsAskedFor() throws IOException {
        Path yaml = map("P2 4 1 255 0 205 254 205"); // a wall, unknown, free, unknown
        ImportOptions options = ImportOptions.DEFAULT;
        assertThat(cells(yaml, options)).isEqualTo("map:{0}");
        assertThat(cells(yaml, options.withUnknown(ImportOptions.Unknown.OCCUPIED)))
                .isEqualTo("map:{0, 1, 3}");
        assertThat(cells(yaml, options.withUnknown(ImportOptions.Unknown.EDGE)))
                .isEqualTo("map:{0} unknown part of the map:{1, 3}");
        assertThat(WorldImport.read(yaml, options).read()).containsEntry("unknown cell", 2);
    }

    private static String cells(Path yaml, ImportOptions options) throws WorldException {
        StringBuilder all = new StringBuilder();
        for (WorldObject each : WorldImport.read(yaml, options).world().objects()) {
            if (each.object() instanceof GridObject grid) {
                all.append(' ').append(grid.name()).append(':').append(grid.occupied());
            }
        }
        return all.substring(1);
    }

    /** The same map, moved so that the world is no larger than it. */
    @Test
    void aCentredMapIsTheMapMoved() throws IOException {
        Path yaml = map("P2 4 3 255  0 0 254 254  254 254 254 254  254 254 254 0");
        String text = Files.readString(yaml);
        for (String origin : new String[] {"-1, -2, 0", "3, -8, 0", "3, -8, 0.7", "30, 20, 1.5707963267948966"}) {
            Files.writeString(yaml, text.replace("-1, -2, 0", origin));
            World usual = RosMaps.read(yaml);
            WorldImport read = WorldImport.read(yaml, ImportOptions.DEFAULT.withMapCentred(true));
            World centred = read.world();
            Point map = usual.objects().get(0).object().center();
            assertThat(centred.objects().get(0).object().center()).isEqualTo(new Point());
            assertThat(read.remarks()).singleElement().asString().contains("the origin of the map's frame is at X ");
            String[] at = read.remarks().get(0).split("at X ")[1].split(", Z ");
            assertThat(Double.parseDouble(at[0])).isCloseTo(-map.x(), within(1e-12));
            assertThat(Double.parseDouble(at[1])).isCloseTo(-map.z(), within(1e-12));
            // The image with two cells on each side, however it is turned.
            assertThat(centred.width()).isBetween(1.5 + 2, 5.0);
            assertThat(centred.length()).isBetween(1.5 + 2, 5.0);
            assertThat(centred.toGeometry().objects()).hasSize(5);
        }
    }

    /** Nowhere outside the image is there room for a robot wider than half a cell. */
    @Test
    void outsideTheImageNothingIsFree() throws IOException {
        Path yaml = map("P2 9 7 1" + " 1".repeat(63));
        String text = Files.readString(yaml);
        SplittableRandom random = new SplittableRandom(3);
        int inside = 0;
        for (String yaw : new String[] {"0", "1.5707963267948966", "3.141592653589793", "-1.5707963267948966"}) {
            Files.writeString(yaml, text.replace("-1, -2, 0", "3, -8, " + yaw));
            World world = RosMaps.read(yaml);
            Geometry geometry = world.toGeometry();
            assertThat(geometry.objects()).hasSize(4);
            for (int k = 0; k < 1000; k++) {
                double x = random.nextDouble(-0.5, 0.5) * (world.width() - 0.6);
                double z = random.nextDouble(-0.5, 0.5) * (world.length() - 0.6);
                // Back into the image: a turn about its lower left corner, which is at (3, -8) of the map.
                double cos = StrictMath.cos(-Double.parseDouble(yaw));
                double sin = StrictMath.sin(-Double.parseDouble(yaw));
                double right = (x - 3) * cos - (-z + 8) * sin;
                double up = (x - 3) * sin + (-z + 8) * cos;
                boolean isFree = right > 0.3 && right < 4.2 && up > 0.3 && up < 3.2;
                inside += isFree ? 1 : 0;
                boolean isEdge = Math.abs(right - 0.3) < 1e-9 || Math.abs(up - 0.3) < 1e-9;
                if (!isEdge) {
                    assertThat(geometry.testObject(new SphereObject(new Point(x, 0, z), 0.3)))
                            .isEqualTo(!isFree);
                }
            }
        }
        assertThat(inside).isBetween(40, 1000);
    }

    /** A robot that maps replaces what it was given. */
    @Test
    void theGridCanBeReplacedByItsName() throws IOException {
        Geometry geometry = RosMaps.read(map("P2 2 1 1 0 1")).toGeometry();
        GridObject before = (GridObject) geometry.getObject("map");
        assertThat(geometry.removeObject("map")).isTrue();
        BitSet other = new BitSet();
        other.set(1);
        GridObject after = new GridObject(before.center(), before.cell(), before.height(), 2, 1, other).named("map");
        assertThat(geometry.addObjectUnchecked(after)).isTrue();
        assertThat(geometry.getObject("map")).isEqualTo(after);
    }

    /** The frame's origin may be far from the image: the world about it is four times the map, and none of that is map. */
    @Test
    void noRobotLeavesTheMap() throws IOException {
        Path yaml = map("P2 9 7 1" + " 1".repeat(63));
        String text = Files.readString(yaml);
        for (String yaw : new String[] {"0", "1.5707963267948966", "0.7", "-2.5"}) {
            Files.writeString(yaml, text.replace("-1, -2, 0", "3, -8, " + yaw));
            Geometry geometry = RosMaps.read(yaml).toGeometry();
            assertThat(geometry.objects()).hasSize(4);
            double cos = StrictMath.cos(Double.parseDouble(yaw));
            double sin = StrictMath.sin(Double.parseDouble(yaw));
            for (int k = 0; k < 64; k++) {
                double angle = 2 * Math.PI * k / 64;
                double right = 2.25;
                double up = 1.75;
                Point middle = new Point(3 + right * cos - up * sin, 0, 8 - (right * sin + up * cos));
                double towardsRight = StrictMath.cos(angle);
                double towardsUp = StrictMath.sin(angle);
                double free = Math.min(right / Math.abs(towardsRight), up / Math.abs(towardsUp));
                Ray ray = new Ray(
                        middle,
                        new Point(towardsRight * cos - towardsUp * sin, 0, -(towardsRight * sin + towardsUp * cos)));
                assertThat(geometry.getRayDistance(ray, 0, Double.POSITIVE_INFINITY, 0))
                        .isCloseTo(free, within(1e-9));
                assertThat(geometry.addObject(new SphereObject(middle, 0.125).moveable("robot")))
                        .isTrue();
                Move away = new Move(
                        100 * ray.direction().x(), 0, 100 * ray.direction().z(), 0, 0);
                assertThat(geometry.moveGlobal("robot", away).obstacle())
                        .isNotNull()
                        .satisfies(obstacle -> assertThat(obstacle.name()).endsWith(" edge of the map"));
                geometry.removeObject("robot");
            }
        }
    }

    @Test
    void givesWallsTheHeightThatIsAskedFor() throws IOException {
        Path yaml = map("P2 1 1 1 0");
        assertThat(((GridObject) RosMaps.read(yaml).objects().get(0).object()).height())
                .isEqualTo(ImportOptions.DEFAULT.wallHeight());
        for (double wrong : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> RosMaps.read(yaml, wrong))
                    .withMessage("the walls' height must be above 0 and at most 2^100 (got: " + wrong + ")");
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                // 89 is 0.651 occupied, 90 is 0.647; 204 is 0.2, 206 is 0.192
                "0 | trinary | ##..... | 3",
                "1 | trinary | ....### | 3",
                // 90 would be 99.4 of 100: not certain, but known
                "0 | scale   | ##..... | 0",
                // a value itself, from 0 to 100, above 65
                "0 | raw     | .##.... | 4",
            })
    void makesWallsByMode(int negate, String mode, String walls, int unknown) throws IOException {
        OccupancyGrid grid =
                grid(map("P2 7 1 255 0 89 90 150 204 206 255".getBytes(StandardCharsets.US_ASCII), negate, mode));
        assertThat(picture(grid)).isEqualTo(walls);
        assertThat(grid.unknown()).isEqualTo(unknown);
    }

    @Test
    void takesTheThresholdForFreeEnough() throws IOException {
        byte[] image = "P2 4 1 255 64 65 66 101".getBytes(StandardCharsets.US_ASCII);
        OccupancyGrid raw = grid(map(image, 0, "raw"));
        assertThat(picture(raw)).isEqualTo("..#.");
        assertThat(raw.unknown()).as("what is above 100").isEqualTo(1);
        Path yaml = map("P2 3 1 100 34 35 36"); // of which the second is 0.65 occupied, as the threshold is
        assertThat(picture(grid(yaml))).isEqualTo("#..");
    }

    @Test
    void readsEveryFormOfPgm() throws IOException {
        String walls = "#.# ..#";
        assertThat(picture(grid(map("P2\n# by hand\n3 2 # columns, rows\n9\n0 9 0\n9 # free\n9 0\n"))))
                .isEqualTo(walls);
        // A comment may stand in what looks like a word, and a carriage return ends it too.
        assertThat(picture(grid(map("P2#a\r3#b\n2 #c\r\n9#d\r 0 9#e\n0#f\r9 9 0"))))
                .isEqualTo(walls);
        assertThat(picture(grid(map("P5#a\r3#b\n2 255#d\n\0\u00ff\0\u00ff\u00fe\1"))))
                .isEqualTo(walls);
        assertThat(picture(grid(map("P5\r3 2\r255\r#\u00ff\0\u00ff\u00fe\1"))))
                .as("behind the one white space no comment begins")
                .isEqualTo("#.# ..#");
        assertThat(picture(grid(map("P5 3 2 255\n\0\u00ff\0\u00ff\u00fe\1")))).isEqualTo(walls);
        assertThat(picture(grid(map("P5 3 2 65535\n\0\0\u00ff\u00ff\0\1\u00ff\u00ff\u00ff\0\1\0"))))
                .isEqualTo(walls);
    }

    @ParameterizedTest
    @ValueSource(
            ints = {
                BufferedImage.TYPE_BYTE_GRAY,
                BufferedImage.TYPE_USHORT_GRAY,
                BufferedImage.TYPE_INT_RGB,
                BufferedImage.TYPE_INT_ARGB,
                BufferedImage.TYPE_BYTE_BINARY,
                BufferedImage.TYPE_BYTE_INDEXED
            })
    void readsEveryFormOfPng(int type) throws IOException {
        SplittableRandom random = new SplittableRandom(type);
        BufferedImage image = new BufferedImage(31, 17, type);
        StringBuilder pgm = new StringBuilder("P2 31 17 255");
        int black = 0;
        for (int row = 0; row < 17; row++) {
            for (int x = 0; x < 31; x++) {
                boolean isWall = random.nextInt(3) == 0;
                black += isWall ? 1 : 0;
                image.setRGB(x, row, isWall ? 0xff000000 : 0xffffffff);
                pgm.append(isWall ? " 0" : " 255");
            }
        }
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(image, "png", png);
        OccupancyGrid grid = grid(map(png.toByteArray(), 0, "trinary"));
        assertThat(grid.occupied.cardinality()).isEqualTo(black).isBetween(100, 300);
        assertThat(picture(grid)).isEqualTo(picture(grid(map(pgm.toString()))));
    }

    /** A grey's own value counts, not what a gamma curve makes of it. */
    @Test
    void takesGreysOfAPngAsTheyAre() throws IOException {
        BufferedImage image = new BufferedImage(256, 1, BufferedImage.TYPE_BYTE_GRAY);
        StringBuilder pgm = new StringBuilder("P2 256 1 255");
        for (int x = 0; x < 256; x++) {
            image.getRaster().setSample(x, 0, 0, x);
            pgm.append(' ').append(x);
        }
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(image, "png", png);
        OccupancyGrid grid = grid(map(png.toByteArray(), 0, "trinary"));
        assertThat(grid.occupied.cardinality()).isEqualTo(90); // 0 to 89
        assertThat(grid.unknown()).isEqualTo(116); // 90 to 205
        assertThat(picture(grid)).isEqualTo(picture(grid(map(pgm.toString()))));
    }

    /** What map servers read too: the same greys give the same cells, whatever the file is. */
    @ParameterizedTest
    @CsvSource({"bmp", "tiff", "jpeg", "png"})
    void readsWhatTheJdkReads(String format) throws IOException {
        String expected = picture(grid(map("P2 4 2 255 0 0 254 254 205 205 0 254")));
        int[] greys = {0, 0, 254, 254, 205, 205, 0, 254};
        int kinds = 0;
        for (int type :
                new int[] {BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_3BYTE_BGR, BufferedImage.TYPE_BYTE_INDEXED
                }) {
            int large = 16; // of which a JPEG keeps the colours
            BufferedImage image = new BufferedImage(4 * large, 2 * large, type);
            for (int x = 0; x < image.getWidth(); x++) {
                for (int y = 0; y < image.getHeight(); y++) {
                    int grey = greys[y / large * 4 + x / large];
                    if (type == BufferedImage.TYPE_BYTE_GRAY) {
                        image.getRaster().setSample(x, y, 0, grey);
                    } else {
                        image.setRGB(x, y, grey * 0x010101);
                    }
                }
            }
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            if (ImageIO.write(image, format, bytes)) {
                kinds++;
                OccupancyGrid grid = grid(map(bytes.toByteArray(), 0, "trinary"));
                assertThat(grid.occupied.cardinality()).isEqualTo(3 * large * large);
                StringBuilder rows = new StringBuilder();
                for (int cell = 0; cell < 8; cell++) {
                    int at = (cell / 4 * large + large / 2) * grid.width + cell % 4 * large + large / 2;
                    rows.append(cell == 4 ? " " : "").append(grid.occupied.get(at) ? '#' : '.');
                }
                assertThat(rows.toString()).isEqualTo(expected);
                if (type != BufferedImage.TYPE_BYTE_INDEXED) { // which rounds 205
                    assertThat(grid.unknown()).isEqualTo(2 * large * large);
                }
            }
        }
        assertThat(kinds).isPositive();
    }

    @Test
    void aBrokenImageOfTheJdkIsRefused() throws IOException {
        BufferedImage image = new BufferedImage(40, 20, BufferedImage.TYPE_3BYTE_BGR);
        SplittableRandom random = new SplittableRandom(1);
        int refused = 0;
        for (String format : new String[] {"bmp", "tiff", "jpeg"}) {
            ByteArrayOutputStream whole = new ByteArrayOutputStream();
            ImageIO.write(image, format, whole);
            for (int k = 0; k < 100; k++) {
                byte[] bytes = whole.toByteArray();
                for (int change = 0; change < 5; change++) {
                    bytes[4 + random.nextInt(Math.min(200, bytes.length - 4))] = (byte) random.nextInt();
                }
                byte[] part = Arrays.copyOf(bytes, 4 + random.nextInt(bytes.length - 3));
                Path yaml = map(part, 0, "trinary");
                try {
                    RosMaps.read(yaml);
                } catch (WorldException e) {
                    refused++;
                    assertThat(e.getMessage()).contains("image");
                }
            }
        }
        assertThat(refused).isBetween(100, 300);
    }

    @Test
    void countsOpacityAsRosDoes() throws IOException {
        int[] pixels = {0xff000000, 0x00000000, 0xffffffff, 0x00ffffff, 0xff505050};
        BufferedImage colours = new BufferedImage(5, 1, BufferedImage.TYPE_INT_ARGB);
        IndexColorModel palette = new IndexColorModel(3, 5, pixels, 0, true, -1, DataBuffer.TYPE_BYTE);
        BufferedImage indexed = new BufferedImage(5, 1, BufferedImage.TYPE_BYTE_INDEXED, palette);
        for (int x = 0; x < 5; x++) {
            colours.setRGB(x, 0, pixels[x]);
            indexed.getRaster().setSample(x, 0, 0, x);
        }
        for (BufferedImage image : new BufferedImage[] {colours, indexed}) {
            ByteArrayOutputStream png = new ByteArrayOutputStream();
            ImageIO.write(image, "png", png);
            // Trinary: the mean of four, so that white and transparent is 0.25 occupied, dark grey and opaque 0.51.
            OccupancyGrid trinary = grid(map(png.toByteArray(), 0, "trinary"));
            assertThat(picture(trinary)).isEqualTo("##...");
            assertThat(trinary.unknown()).isEqualTo(2);
            OccupancyGrid scale = grid(map(png.toByteArray(), 0, "scale"));
            assertThat(picture(scale)).isEqualTo("#...#");
            assertThat(scale.unknown()).isEqualTo(2);
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "P3 1 1 1 0|1|P2 or P5 must come next (got: P3)",
                "P2;# size;0 5 255|3|the width must be a whole number from 1 to 268435456 (got: 0)",
                "P5 100000 100000 255;|1|an image must have 1 to 268435456 pixels (got: 100000 x 100000)",
                "P5 9999999999 1 255;|1|(got: 9999999999)",
                "P2 2 1 70000 0 0|1|the value of white must be a whole number from 1 to 65535 (got: 70000)",
                "P2 2 1;9;0|3|a pixel must come next (got: the end of the file)",
                "P2 2 1;9;0 10|3|a pixel must be a whole number from 0 to 9 (got: 10)",
                "P2 2 1;9;0 9;0|4|an image must end after its last pixel",
                "P5 2 1 255;a|0|an image of 2 x 1 pixels must have 2 bytes after its header; it is truncated (got: 1)",
                "P5 2 1 255;abc|0|there is extra data after its last pixel, so save it again (got: 3)",
                "P5 2 1 255#a|0|it is truncated (got: 0)",
                "P5 2 1 9;aa|0|a pixel must be at most white, 9 (got: 97 in column 1 of row 1)",
                "P5 2 1 255|0|it is truncated (got: 0)",
            })
    void refusesImagesWithPlaceAndRemedy(String image, int line, String message) throws IOException {
        Path yaml = map(image.replace(';', '\n'));
        assertThatThrownBy(() -> RosMaps.read(yaml))
                .isInstanceOfSatisfying(
                        WorldException.class, e -> assertThat(e.line()).isEqualTo(line))
                .hasMessageContaining("map.img:")
                .hasMessageContaining(message);
    }

    @Test
    void refusesPngsThatAreBrokenOrFarTooLarge() throws IOException {
        BufferedImage image = new BufferedImage(40, 40, BufferedImage.TYPE_BYTE_GRAY);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        byte[] png = out.toByteArray();
        SplittableRandom random = new SplittableRandom(5);
        int refused = 0;
        for (int k = 0; k < 300; k++) {
            byte[] damaged = Arrays.copyOf(png, k < 100 ? 4 + random.nextInt(png.length - 4) : png.length);
            damaged[4 + random.nextInt(damaged.length - 4)] ^= (byte) (1 + random.nextInt(255));
            Path yaml = map(damaged, 0, "trinary");
            try {
                RosMaps.read(yaml);
            } catch (WorldException e) {
                refused++;
                assertThat(e).hasMessageContaining("map.img: ");
            }
        }
        assertThat(refused).isBetween(100, 300);
        png[17] = 0x7f; // the width: 8 million
        CRC32 sum = new CRC32();
        sum.update(png, 12, 17);
        ByteBuffer.wrap(png).putInt(29, (int) sum.getValue());
        Path yaml = map(png, 0, "trinary");
        assertThatThrownBy(() -> RosMaps.read(yaml))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("an image must have 1 to 268435456 pixels (got: 8323112 x 40)");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "image: map.img|image: gone.pgm|1|there is no such image file in ",
                "image: map.img|image: ../map.img|1|stay inside it (got: ../map.img)",
                "image: map.img|image: /maps/gone.pgm|1|there is no such image file in ",
                "image: map.img|image: /maps/|1|image must be the path of a file (got: /maps/)",
                "image: map.img|image: [a, b]|1|image must be a single value (got: a sequence)",
                "image: map.img|picture: map.img|0|a map must have image; add it (got: none)",
                "image: map.img|image: map.img;image: map.img|2|a key must occur only once; remove one of them (got twice: image)",
                "image: map.img|~~|0|a map must have image; add it (got: none)",
                "resolution: 0.5|resolution: 0|2|resolution must be above 0 metres per cell (got: 0.0)",
                "resolution: 0.5|resolution: .nan|2|resolution: a number must be decimal and finite",
                "resolution: 0.5|resolution: 1e-30|0|resolution must be far above the rounding of coordinates",
                "resolution: 0.5|resolution: 1e99|0|2^100",
                "origin: [-1, -2, 0]|origin: [-1, -2]|3|origin must be [x, y, yaw] (got: 2 numbers)",
                "origin: [-1, -2, 0]|origin: -1|3|origin must be [x, y, yaw] (got: 0 numbers)",
                "origin: [-1, -2, 0]|origin: [-1, -2, north]|3|origin: a number must be decimal",
                "negate: 0|negate: yes|4|negate must be 0, 1, false or true (got: yes)",
                "occupied_thresh: 0.65|occupied_thresh: 65|5|occupied_thresh must be from 0 to 1 (got: 65.0)",
                "mode: trinary|mode: ternary|7|mode must be trinary, scale or raw (got: ternary)",
                "negate: 0|negate: [0|5|this is not valid YAML: ",
            })
    void refusesSettingsWithPlaceAndRemedy(String was, String is, int line, String message) throws IOException {
        Path yaml = map("P2 1 1 1 0");
        String text = Files.readString(yaml);
        assertThat(text).contains(was);
        Files.writeString(yaml, text.replace(was, is.replace(';', '\n')));
        assertThatThrownBy(() -> RosMaps.read(yaml))
                .isInstanceOfSatisfying(
                        WorldException.class, e -> assertThat(e.line()).isEqualTo(line))
                .hasMessageStartingWith(yaml.toString())
                .hasMessageContaining(message);
    }

    @Test
    void refusesWhatIsNoMapAtAll() throws IOException {
        Path yaml = folder.resolve("map.yaml");
        assertThatThrownBy(() -> RosMaps.read(yaml)).hasMessage(yaml + ": there is no such file; check the path");
        for (String text : new String[] {"", "- a\n", "word"}) {
            Files.writeString(yaml, text);
            assertThatThrownBy(() -> RosMaps.read(yaml))
                    .isInstanceOf(WorldException.class)
                    .hasMessageContaining("a map must consist of keys with values");
        }
        Files.writeString(yaml, "#".repeat(Limits.MAX_SETTINGS + 1));
        assertThatThrownBy(() -> RosMaps.read(yaml))
                .hasMessageContaining(
                        "at most 65536 bytes; split it in several files, or simplify what is in it (got: more)");
        Path raw = map("P2 1 1 1 0".getBytes(StandardCharsets.US_ASCII), 1, "raw");
        assertThatThrownBy(() -> RosMaps.read(raw)).hasMessageContaining("negate must be 0 in mode raw");
    }

    @Test
    void readsSettingsAsPeopleWriteThem() throws IOException {
        World plain = RosMaps.read(map("P2 2 1 1 0 1"));
        Path yaml = Files.writeString(folder.resolve("other.yaml"), """
                %YAML 1.1
                ---
                # by hand
                mode: 'trinary'
                image: "./map.img"   # beside this file
                resolution: 5.0e-1
                origin:
                  - -1.0
                  - -2.
                  - 0.000000
                negate: false
                occupied_thresh: .65
                free_thresh: 0.196
                """);
        assertThat(RosMaps.read(yaml)).isEqualTo(plain);
        Files.writeString(yaml, Files.readString(yaml).replace("'trinary'", "Trinary"));
        assertThat(RosMaps.read(yaml)).isEqualTo(plain);
    }

    /** What is above both thresholds is a wall, as the reference asks that first; nothing is unknown. */
    @Test
    void aThresholdOfFreeAboveThatOfWallsIsReadAndTold() throws IOException {
        Path yaml = map("P2 4 1 100 0 34 36 100");
        Files.writeString(yaml, Files.readString(yaml).replace("free_thresh: 0.196", "free_thresh: 0.7"));
        OccupancyGrid grid = grid(yaml);
        assertThat(picture(grid)).isEqualTo("##..");
        assertThat(grid.unknown()).isZero();
        assertThat(WorldImport.read(yaml, ImportOptions.DEFAULT).remarks())
                .singleElement()
                .asString()
                .startsWith(yaml + ":6: free_thresh should be at most occupied_thresh, 0.65; ")
                .endsWith("(got: 0.7)");
    }

    // Maps that nobody here made.

    @Test
    void readsTenByTen() throws IOException {
        OccupancyGrid grid = grid(MAPS.resolve("TenByTen.yaml"));
        assertThat(picture(grid))
                .isEqualTo(
                        ".......... .......... .......### ....#..### ....#..### .......... .......... ...###.... .......###"
                                + " .......###");
        assertThat(grid.unknown()).isEqualTo(2);
        World world = RosMaps.read(MAPS.resolve("TenByTen.yaml"));
        assertThat(world.objects()).hasSize(1 + 4);
        assertThat(((GridObject) world.objects().get(0).object()).occupied()).isEqualTo(grid.occupied);
    }

    @Test
    void readsAnArenaAsARobotMappedIt() throws IOException {
        OccupancyGrid grid = grid(MAPS.resolve("tb3_sandbox.yaml"));
        assertThat(grid.width).isEqualTo(384);
        assertThat(grid.height).isEqualTo(384);
        assertThat(grid.occupied.cardinality()).isEqualTo(870);
        assertThat(grid.unknown()).isEqualTo(138_683);
        World world = RosMaps.read(MAPS.resolve("tb3_sandbox.yaml"));
        GridObject walls = (GridObject) world.objects().get(0).object();
        assertThat(walls.occupied()).isEqualTo(grid.occupied);
        assertThat(walls.cell()).isEqualTo(0.05);
        assertThat(walls.center().x()).isCloseTo(-10 + 192 * 0.05, within(1e-12));
        assertThat(walls.center().z()).isCloseTo(10 - 192 * 0.05, within(1e-12));
        assertThat(world.toGeometry().objects()).hasSameSizeAs(world.objects());
    }
}
