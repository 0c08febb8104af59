package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.Test;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.image.PngWriter;

/** Pictures of recordings, and what a picture must not replace. */
class RenderRecordingTest extends CommandRun {
    /** A picture of each step, of the size of any other, and a robot that moved is elsewhere in it. */
    @Test
    void aRecordingIsASeriesOfPictures() throws IOException {
        String recording = "worlds/scenarios/wandering.scenario.jsonl";
        Path frames = folder.resolve("frame.png");
        assertThat(run(
                        "render",
                        recording,
                        "--steps",
                        "2-8",
                        "--every",
                        3,
                        "--size",
                        "90x60",
                        "--samples",
                        1,
                        "-o",
                        frames))
                .as("%s", err)
                .isZero();
        assertThat(out.toString()).contains("frame-0.png to ").contains("frame-2.png: steps 2 to 8, every 3");
        assertThat(folder.resolve("frame-3.png")).doesNotExist();
        assertThat(Files.readAllBytes(folder.resolve("frame-0.png")))
                .isNotEqualTo(Files.readAllBytes(folder.resolve("frame-2.png")));
        Path plan = folder.resolve("plan.svg");
        assertThat(run("render", recording, "--steps", "9-9", "--world", "worlds/rooms.xml", "-o", plan))
                .isZero();
        assertThat(plan).content().contains("step 9 of 9", " m<");
    }

    /** A recording may have any name that ends in .jsonl; its plan is a film of one picture for each step. */
    @Test
    void aPlanOfARecordingIsAFilm() throws IOException {
        Path recording = Files.copy(Path.of("worlds/scenarios/wandering.scenario.jsonl"), folder.resolve("run.jsonl"));
        Path film = folder.resolve("film.gif");
        assertThat(run("render", recording, "--plan", "--steps", "2-9", "--every", 2, "-o", film))
                .as("%s", err)
                .isZero();
        assertThat(out.toString()).contains("film.gif: steps 2 to 8, every 2");
        Path plan = folder.resolve("plan.png");
        assertThat(run("render", recording, "--plan", "--steps", "2-2", "-o", plan))
                .isZero();
        BufferedImage expected = ImageIO.read(plan.toFile());
        ImageReader frames = ImageIO.getImageReadersByFormatName("gif").next();
        try (ImageInputStream in = ImageIO.createImageInputStream(film.toFile())) {
            frames.setInput(in);
            assertThat(frames.getNumImages(true)).isEqualTo(4);
            BufferedImage first = frames.read(0);
            assertThat(first.getWidth()).isEqualTo(expected.getWidth());
            assertThat(first.getHeight()).isEqualTo(expected.getHeight());
            assertThat(first.getRGB(3, 3) & 0xf8f8f8).isEqualTo(expected.getRGB(3, 3) & 0xf8f8f8);
        }
        assertThat(run("render", "worlds/maze.xml", "--plan", "-o", film)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("FILE must end in .svg or .png for the plan of a world");
    }

    /** Measuring, a command and the time after it are one step; so are commands and time without a sensor. */
    @Test
    void aCommandBelongsToTheTimeAfterIt() throws IOException {
        Path recording = folder.resolve("run.jsonl");
        Files.writeString(recording, """
                {"type":"scenario","version":1,"title":"t","madeBy":"a test","options":{"dimension":"PLANAR","accuracy":"EXACT","beam":{"min":0,"max":null,"width":0}}}
                {"type":"init","objects":[{"kind":"cylinder","name":"robot","moveable":true,"center":[0,0,0],"radius":1,"height":1}]}
                """ + """
                {"type":"batch","requests":[{"kind":"sense","objectName":"robot","pattern":{"kind":"fan","first":0,"step":1,"count":4},"min":0,"max":8,"width":0}]}
                {"type":"step","seconds":0,"commands":[{"objectName":"robot","forward":0.5,"turn":0}]}
                {"type":"step","seconds":1}
                """.repeat(3) + """
                {"type":"step","seconds":1}
                """);
        Path page = folder.resolve("run.html");
        assertThat(run("export", recording, page)).as("%s", err).isZero();
        assertThat(out.toString()).contains("run.html: 5 steps");
    }

    @Test
    void stepsThatARecordingLacks() {
        String recording = "worlds/scenarios/wandering.scenario.jsonl";
        Path frames = folder.resolve("frame.png");
        for (String steps : new String[] {"0-4", "9-3", "1-999", "x"}) {
            assertThat(run("render", recording, "--steps", steps, "-o", frames)).isEqualTo(ExitCodes.UNUSABLE);
            assertThat(err.toString()).contains("--steps must be").contains("(got: " + steps + ")");
        }
        assertThat(run("render", "worlds/maze.xml", "--steps", "1-2", "-o", frames))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("--steps is for a recording");
        assertThat(folder).isEmptyDirectory();
    }

    /** A plan at a height has what is there, and no more. */
    @Test
    void aPlanAtAHeight() throws IOException {
        Path world = Files.writeString(
                folder.resolve("w.xml"),
                "<world xmlns='urn:robosim:world:1' width='20' height='4' length='20'>"
                        + "<box name='low' center='4 -1.5 0' width='1' height='1' length='2'/>"
                        + "<sphere name='ball' center='0 0 0' radius='1'/></world>");
        Path low = folder.resolve("low.svg");
        assertThat(run("render", world, "--slice", "-1.25", "-o", low))
                .as("%s", err)
                .isZero();
        assertThat(low).content().contains("1 object", "w, at Y -1.25", "low").doesNotContain("ball");
        Path middle = folder.resolve("middle.svg");
        assertThat(run("render", world, "--slice", "0.6", "-o", middle)).isZero();
        assertThat(middle).content().contains("ball", "r=\"").doesNotContain("low");
        Path png = folder.resolve("middle.png");
        assertThat(run("render", world, "--slice", "0.6", "-o", png)).isZero();
        assertThat(png).exists();
        for (String height : new String[] {"2.5", "NaN"}) {
            assertThat(run("render", world, "--slice", height, "-o", png)).isEqualTo(ExitCodes.UNUSABLE);
            assertThat(err.toString()).contains("--slice must be a height within the world, from -2.0 to 2.0");
        }
    }

    /** A step of a recording is cut as its world is. */
    @Test
    void aRecordingAtAHeight() throws IOException {
        Path world = Files.writeString(
                folder.resolve("w.xml"),
                "<world xmlns='urn:robosim:world:1' width='20' height='4' length='20' dimension='PLANAR'>"
                        + "<box name='low' center='4 -1.5 0' width='1' height='1' length='2'/>"
                        + "<sphere name='lamp' center='0 1 4' radius='0.5'/>"
                        + "<box name='cart' moveable='true' center='-4 0 0' width='1' height='4' length='1'/></world>");
        Path recorded = folder.resolve("drive.scenario.jsonl");
        assertThat(run("drive", world, "--seconds", "1", "--speed", "2", "--record", recorded))
                .as("%s", err)
                .isZero();
        Path low = folder.resolve("low.svg");
        assertThat(run("render", recorded, "--slice", "-1.25", "--steps", "20-20", "-o", low))
                .as("%s", err)
                .isZero();
        assertThat(low).content().contains(", at Y -1.25", ">low<", ">cart<").doesNotContain(">lamp<");
        Path high = folder.resolve("high.svg");
        assertThat(run("render", recorded, "--slice", "1", "--steps", "20-20", "-o", high))
                .isZero();
        assertThat(high).content().contains(", at Y 1", ">lamp<", ">cart<").doesNotContain(">low<");
        assertThat(run("render", recorded, "--slice", "2.5", "-o", high)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("--slice must be a height within the world, from -2.0 to 2.0");
    }

    /** The image of a map is input too. */
    @Test
    void theImageOfAMapIsNotOverwritten() throws IOException {
        Path image = folder.resolve("map.png");
        PngWriter.writeColour(Files.newOutputStream(image), 4, 4, new int[16]);
        Path map = Files.writeString(
                folder.resolve("map.yaml"),
                "image: map.png\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n");
        byte[] before = Files.readAllBytes(image);
        assertThat(run("render", map, "--plan", "-o", image)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("FILE must not be a file that is read");
        assertThat(image).hasBinaryContent(before);
    }
}
