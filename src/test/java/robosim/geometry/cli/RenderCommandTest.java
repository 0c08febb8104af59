package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.image.PngReader;
import robosim.geometry.world.SdfSensorTest;

/** The cameras of {@code render}. */
class RenderCommandTest {
    private final StringWriter err = new StringWriter();

    @TempDir
    Path folder;

    private int run(String... options) {
        List<String> all = new ArrayList<>(List.of("render", "worlds/rooms.xml", "--samples", "1", "--sky-rays", "0"));
        all.addAll(List.of(options));
        return Commands.run(new PrintWriter(new StringWriter()), new PrintWriter(err), all.toArray(String[]::new));
    }

    private PngReader.Pixels picture(String... options) throws IOException {
        Path file = folder.resolve("a.png");
        List<String> all = new ArrayList<>(List.of("--size", "60x41", "-o", file.toString()));
        all.addAll(List.of(options));
        assertThat(run(all.toArray(String[]::new))).as("%s", err).isZero();
        PngReader.Pixels read;
        try (var in = Files.newInputStream(file)) {
            read = PngReader.read(in);
        }
        assertThat(read.width()).isEqualTo(60);
        assertThat(read.height()).isEqualTo(41);
        assertThat(Arrays.stream(read.pixels()).distinct().count()).isGreaterThan(8);
        return read;
    }

    @Test
    void eachCameraHasItsPicture() throws IOException {
        List<int[]> seen = new ArrayList<>();
        seen.add(picture().pixels());
        assertThat(picture("--camera", "overview").pixels()).isEqualTo(seen.get(0));
        for (String camera : List.of("top", "front", "side", "four", "robot:drum 1", "30,20,30")) {
            int[] pixels = picture("--camera", camera).pixels();
            assertThat(seen).noneMatch(other -> Arrays.equals(other, pixels));
            seen.add(pixels);
        }
        assertThat(picture("--camera", "30,20,30", "--look-at", "5,0,0").pixels())
                .isNotEqualTo(seen.get(6));
        assertThat(picture("--no-floor").pixels()).isNotEqualTo(seen.get(0));
    }

    /** A camera that the file describes, with its own size unless another one is given. */
    @Test
    void aSensorOfAWorldInSdf() throws IOException {
        Path world = Files.writeString(folder.resolve("w.sdf"), SdfSensorTest.ROBOT);
        Path file = folder.resolve("seen.png");
        String[] words = {
            "render",
            world.toString(),
            "--samples",
            "1",
            "--sky-rays",
            "0",
            "--camera",
            "sensor:eye",
            "-o",
            file.toString()
        };
        PrintWriter nothing = new PrintWriter(new StringWriter());
        assertThat(Commands.run(nothing, new PrintWriter(err), words))
                .as("%s", err)
                .isZero();
        try (var in = Files.newInputStream(file)) {
            PngReader.Pixels read = PngReader.read(in);
            assertThat(read.width()).isEqualTo(40);
            assertThat(read.height()).isEqualTo(30);
            assertThat(Arrays.stream(read.pixels()).distinct().count()).isGreaterThan(20);
        }
        words[7] = "sensor:laser";
        assertThat(Commands.run(nothing, new PrintWriter(err), words)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("--camera sensor:NAME must name a camera (got: rover::base::laser");
        refused("--camera sensor:NAME must be for a WORLD in SDFormat", "--camera", "sensor:eye");
    }

    @Test
    void anOrbitIsASeriesOfFiles() throws IOException {
        Path file = folder.resolve("o.png");
        assertThat(run("--size", "30x20", "--camera", "orbit", "--frames", "11", "-o", file.toString()))
                .isZero();
        assertThat(file).doesNotExist();
        try (var files = Files.list(folder)) {
            assertThat(files.map(f -> String.valueOf(f.getFileName())))
                    .hasSize(11)
                    .contains("o-00.png", "o-10.png");
        }
    }

    @Test
    void anOrbitIsAFilm() throws IOException {
        Path file = folder.resolve("film.gif");
        assertThat(run("--size", "30x20", "--orbit", "--frames", "3", "-o", file.toString()))
                .isEqualTo(ExitCodes.FINE);
        byte[] film = Files.readAllBytes(file);
        assertThat(new String(film, 0, 6, StandardCharsets.US_ASCII)).isEqualTo("GIF89a");
        assertThat(film[6] + 256 * film[7]).isEqualTo(30);
        int pictures = 0;
        for (int k = 0; k + 3 < film.length; k++) {
            pictures +=
                    film[k] == 0x21 && film[k + 1] == (byte) 0xf9 && film[k + 2] == 4 && (film[k + 3] | 1) == 5 ? 1 : 0;
        }
        assertThat(pictures).isEqualTo(3);
        refused("--camera must be left out with --orbit", "--orbit", "--camera", "top");
    }

    @Test
    void refusesWhatItCannotTake() {
        refused("--camera must be overview, top", "--camera", "nowhere");
        refused("--camera robot:NAME must name a moveable object", "--camera", "robot:nobody");
        refused("--size must be WxH", "--size", "60");
        refused("--size must be WxH, two numbers of pixels above 0 (got: 0x0)", "--size", "0x0");
        refused("--size must be WxH", "--size", "60x-1");
        refused(
                "--world is for a recording, and WORLD is a world (got: worlds/maze.xml)",
                "--world",
                "worlds/maze.xml");
        refused("67108864 pixels", "--size", "100000x100000");
        refused("--look-at must be X,Y,Z", "--camera", "1,2,3", "--look-at", "1,2");
        refused("samples must be from 1 to 16", "--samples", "17");
        refused("--frames must be from 1", "--camera", "orbit", "--frames", "0");
        refused("below 180", "--fov", "180");
        assertThat(folder).isEmptyDirectory();
    }

    private void refused(String because, String... options) {
        err.getBuffer().setLength(0);
        List<String> all = new ArrayList<>(List.of("render", "worlds/rooms.xml", "-o", folder + "/a.png"));
        all.addAll(List.of(options));
        assertThat(Commands.run(new PrintWriter(new StringWriter()), new PrintWriter(err), all.toArray(String[]::new)))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains(because);
    }
}
