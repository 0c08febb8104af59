package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.world.SdfSensorTest;

class ScanCommandTest {
    @TempDir
    Path folder;

    private final StringWriter out = new StringWriter();

    private int run(String... words) {
        PrintWriter printer = new PrintWriter(out, true);
        return Commands.run(printer, printer, words);
    }

    private static int points(Path ply) throws IOException {
        String text = Files.readString(ply, StandardCharsets.ISO_8859_1);
        int at = text.indexOf("element vertex ") + "element vertex ".length();
        return Integer.parseInt(text.substring(at, text.indexOf('\n', at)));
    }

    @Test
    void clouds() throws IOException {
        Path ply = folder.resolve("cloud.ply");
        assertThat(run("scan", "worlds/warehouse.xml", "-o", ply.toString())).isZero();
        assertThat(out.toString()).contains("Wrote " + ply + ": ").contains(" points of 28,928 rays");
        assertThat(points(ply)).isBetween(5000, 28_928);
        Path world = folder.resolve("world.ply");
        assertThat(run("scan", "worlds/warehouse.xml", "--in-world", "-o", world.toString()))
                .isZero();
        assertThat(points(world)).isEqualTo(points(ply));
        assertThat(Files.readAllBytes(world)).isNotEqualTo(Files.readAllBytes(ply));
        Path pcd = folder.resolve("cloud.pcd");
        assertThat(run(
                        "scan",
                        "worlds/warehouse.xml",
                        "--lidar",
                        "OS1-64",
                        "--at",
                        "0,2,0,45",
                        "--axes",
                        "module",
                        "-o",
                        pcd.toString()))
                .isZero();
        assertThat(Files.readString(pcd, StandardCharsets.ISO_8859_1)).startsWith("# .PCD v0.7");
    }

    /** A static model carries nothing, so its own box is in the way. */
    @Test
    void aSensorInsideAStaticModelIsWarnedOf() throws IOException {
        String sdf = "<sdf version='1.7'><world name='w'><model name='post'><static>%s</static><pose>0 0 1 0 0 0</pose>"
                + "<link name='l'><collision name='c'><geometry><box><size>.1 .1 .1</size></box></geometry></collision>"
                + "<sensor name='laser' type='gpu_lidar'><lidar><scan><horizontal><samples>90</samples>"
                + "<min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan><range><min>.2</min><max>9</max>"
                + "</range></lidar></sensor></link></model></world></sdf>";
        Path npy = folder.resolve("a.npy");
        for (boolean isStatic : new boolean[] {true, false}) {
            Path world = Files.writeString(folder.resolve("w.sdf"), sdf.formatted(isStatic));
            out.getBuffer().setLength(0);
            assertThat(run("scan", world.toString(), "--sensor", "laser", "-o", npy.toString()))
                    .isZero();
            if (isStatic) {
                assertThat(out.toString()).contains("warning: the sensor post::l::laser is inside box \"post\"");
            } else {
                assertThat(out.toString()).doesNotContain("warning");
            }
        }
    }

    /** A depth camera given on the command line, on a robot that was put there on the command line too. */
    @Test
    void aDepthCameraOnARobotThatWasAdded() throws IOException {
        Path world = folder.resolve("room.xml");
        Files.writeString(
                world,
                "<world xmlns='urn:robosim:world:1' width='20' height='4' length='20'>"
                        + "<box name='wall' center='4 0 0' width='1' height='4' length='20'/></world>");
        Path robots = folder.resolve("robots.xml");
        assertThat(run("add", world.toString(), robots.toString(), "eye=disc:0.2x0.5@0,0", "back=disc:0.2x0.5@-3,0"))
                .isZero();
        Path npy = folder.resolve("depth.npy");
        String[] scan = {"scan", robots.toString(), "--depth", "8x6,60", "--on", "eye", "--at", "0.2,0.3,0", "-o", ""};
        scan[scan.length - 1] = npy.toString();
        assertThat(run(scan)).isZero();
        assertThat(out.toString()).contains("6 x 8 depths");
        ByteBuffer numbers = ByteBuffer.wrap(Files.readAllBytes(npy)).order(ByteOrder.LITTLE_ENDIAN);
        double[] depths = new double[48];
        numbers.position(numbers.capacity() - 8 * depths.length)
                .asDoubleBuffer()
                .get(depths);
        for (int k = 0; k < 24; k++) { // upward: along the axis, as far everywhere on a wall across
            assertThat(depths[k]).isCloseTo(3.3, org.assertj.core.data.Offset.offset(1e-9));
        }
        Path ply = folder.resolve("seen.ply");
        assertThat(run("scan", robots.toString(), "--depth", "8x6", "--at", "0,0,0", "-o", ply.toString()))
                .isZero();
        assertThat(points(ply)).isBetween(8, 48);
        for (String wrong : new String[] {"8", "8x6,", "0x6", "8x6,180", "99999x99999", "8x6,1.2.3"}) {
            out.getBuffer().setLength(0);
            assertThat(run("scan", robots.toString(), "--depth", wrong, "-o", ply.toString()))
                    .as(wrong)
                    .isEqualTo(ExitCodes.UNUSABLE);
            assertThat(out.toString()).contains("--depth").contains("(got: ");
        }
        out.getBuffer().setLength(0);
        assertThat(run("scan", robots.toString(), "--depth", "8x6", "--sensor", "a", "-o", ply.toString()))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(out.toString()).contains("--depth must not be given with --sensor");
    }

    @Test
    void sensorsOfAWorldInSdf() throws IOException {
        Path world = Files.writeString(folder.resolve("w.sdf"), SdfSensorTest.ROBOT);
        Path one = folder.resolve("one.npy");
        assertThat(run("scan", world.toString(), "--sensor", "laser", "--seed", "1", "-o", one.toString()))
                .isZero();
        assertThat(out.toString()).contains("3 x 180 ranges");
        Path two = folder.resolve("two.npy");
        assertThat(run("scan", world.toString(), "--sensor", "rover::base::laser", "--seed", "2", "-o", two.toString()))
                .isZero();
        assertThat(Files.readAllBytes(two))
                .isNotEqualTo(Files.readAllBytes(one)); // it has noise, which follows the seed
        Path cloud = folder.resolve("eye.ply");
        assertThat(run("scan", world.toString(), "--sensor", "eye", "-o", cloud.toString()))
                .isZero();
        assertThat(points(cloud)).isBetween(10, 1200);
        assertThat(run(
                        "scan",
                        world.toString(),
                        "--sensor",
                        "eye",
                        "-o",
                        folder.resolve("e.npy").toString()))
                .isZero();
        assertThat(out.toString()).contains("30 x 40 depths");
        String[][] wrong = {
            {"nose", "--sensor must name a sensor of WORLD, one of [\"rover::base::laser\", \"rover::base::imu\""},
            {"photo", "one of [\"rover::head::photo\", \"post::l::photo\"] (got: photo)"},
            {"imu", "--sensor must be a lidar or a depth camera (got: rover::base::imu of type imu)"},
        };
        for (String[] each : wrong) {
            assertThat(run("scan", world.toString(), "--sensor", each[0], "-o", one.toString()))
                    .isEqualTo(ExitCodes.UNUSABLE);
            assertThat(out.toString()).contains(each[1]);
        }
        assertThat(run("scan", "worlds/rooms.xml", "--sensor", "x", "-o", one.toString()))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(out.toString()).contains("--sensor must be for a WORLD in SDFormat (got: worlds/rooms.xml)");
        assertThat(run("scan", world.toString(), "--sensor", "laser", "--at", "0,0,0", "-o", one.toString()))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(out.toString()).contains("--on and --at must not be given with --sensor");
    }

    /** Two equal lasers of one robot, and the same laser on two robots, have errors of their own for one seed. */
    @Test
    void sensorsOfOneSeedHaveErrorsOfTheirOwn() throws IOException {
        String laser = SdfSensorTest.ROBOT.replace("name=\"eye\"", "name=\"eye2\"");
        Path world = Files.writeString(folder.resolve("w.sdf"), SdfSensorTest.ROBOT);
        Path other = Files.writeString(folder.resolve("v.sdf"), laser);
        byte[][] files = new byte[3][];
        String[][] runs = {{world.toString(), "eye"}, {other.toString(), "eye2"}, {world.toString(), "eye"}};
        for (int k = 0; k < 3; k++) {
            Path out = folder.resolve(k + ".npy");
            assertThat(run("scan", runs[k][0], "--sensor", runs[k][1], "--seed", "3", "-o", out.toString()))
                    .isZero();
            files[k] = Files.readAllBytes(out);
        }
        assertThat(files[1]).isNotEqualTo(files[0]);
        assertThat(files[2]).isEqualTo(files[0]);
    }

    @Test
    void noiseFollowsTheSeed() throws IOException {
        byte[][] files = new byte[4][];
        String[] noises = {"0.01", "0.01", "0.01", "0"};
        String[] seeds = {"7", "7", "8", "7"};
        for (int k = 0; k < 4; k++) {
            Path npy = folder.resolve(k + ".npy");
            assertThat(run(
                            "scan",
                            "worlds/rooms.xml",
                            "--lidar",
                            "utm30lx",
                            "--noise",
                            noises[k],
                            "--seed",
                            seeds[k],
                            "-o",
                            npy.toString()))
                    .isZero();
            files[k] = Files.readAllBytes(npy);
        }
        assertThat(out.toString())
                .contains(
                        "1 x 1081 ranges; column 0 points -135 degrees from ahead, column 1 -134.75, the last 135, counter");
        assertThat(files[0]).isEqualTo(files[1]).isNotEqualTo(files[2]).isNotEqualTo(files[3]);
        assertThat(files[0].length).isEqualTo(128 + 8 * 1081);
        double noisy = ByteBuffer.wrap(files[0]).order(ByteOrder.LITTLE_ENDIAN).getDouble(128);
        double clean = ByteBuffer.wrap(files[3]).order(ByteOrder.LITTLE_ENDIAN).getDouble(128);
        assertThat(noisy).isNotEqualTo(clean);
    }

    /** Ranges of the lidars are in metres, whatever a world's unit is. */
    @Test
    void centimetres() throws IOException {
        String world = """
                <world xmlns="urn:robosim:world:1" width="400" height="10" length="400" unit="%s" dimension="SPATIAL">
                  <box center="%s 0 0" width="2" height="2" length="2"/>
                </world>
                """;
        Path file = folder.resolve("box.xml");
        Path npy = folder.resolve("box.npy");
        String[][] cases = {{"m", "21", "20"}, {"m", "41", "Infinity"}, {"cm", "101", "100"}, {"km", "2", "Infinity"}};
        for (String[] one : cases) {
            Files.writeString(file, world.formatted(one[0], one[1]));
            assertThat(run("scan", file.toString(), "--at", "0,0,0", "--lidar", "utm30lx", "-o", npy.toString()))
                    .as(out.toString())
                    .isZero();
            double ahead = ByteBuffer.wrap(Files.readAllBytes(npy))
                    .order(ByteOrder.LITTLE_ENDIAN)
                    .getDouble(128 + 8 * 540);
            assertThat(ahead).isEqualTo(Double.parseDouble(one[2]));
        }
        assertThat(run("scan", file.toString(), "-o", npy.toString())).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(out.toString()).contains("--at must be given for a world without moveable objects");
    }

    @Test
    void refused() {
        refused("FILE must end in .ply, .pcd or .npy (got: a.txt)", "worlds/rooms.xml", "-o", "a.txt");
        refused("--on must be the name of a moveable object", "worlds/rooms.xml", "--on", "no", "-o", "a.ply");
        refused("--at must be X,Y,Z or X,Y,Z,HEADING", "worlds/rooms.xml", "--at", "1,2", "-o", "a.ply");
        refused("--at must be X,Y,Z or X,Y,Z,HEADING", "worlds/rooms.xml", "--at", "1,2,x", "-o", "a.ply");
        refused("--noise must be from 0 to 1000", "worlds/rooms.xml", "--noise", "NaN", "-o", "a.ply");
        refused("must be one of vlp16, vlp32c,", "worlds/rooms.xml", "--lidar", "x", "-o", "a.ply");
        refused("WORLD must be a file that exists", "nowhere.xml", "-o", "a.ply");
        assertThat(Path.of("a.ply")).doesNotExist();
    }

    private void refused(String message, String... words) {
        String[] all = new String[words.length + 1];
        all[0] = "scan";
        System.arraycopy(words, 0, all, 1, words.length);
        out.getBuffer().setLength(0);
        assertThat(run(all)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(out.toString()).contains(message);
    }
}
