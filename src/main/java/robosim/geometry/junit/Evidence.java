package robosim.geometry.junit;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.export.PageWriter;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.world.World;
import robosim.geometry.world.shared.AtomicFileWriter;

/** The files that a failed test leaves in its folder. */
final class Evidence {
    private static final String REPLAY = "replay" + ScenarioReader.ENDING;
    private static final String PICTURE = "last-moments.svg";
    private static final String BITMAP = "last-moments.png";
    private static final String PAGE = "last-moments.html";
    private static final String WORDS = "failure.txt";

    private final Path folder;

    Evidence(Path folder) {
        this.folder = folder;
    }

    /** Deletes the files of an earlier run, and the folder unless it contains other files. */
    void clear() throws IOException {
        for (String name : List.of(REPLAY, PICTURE, BITMAP, PAGE, WORDS)) {
            Files.deleteIfExists(folder.resolve(name));
        }
        for (int connection = 1; Files.deleteIfExists(file(connection, ScenarioReader.ENDING)); connection++) {
            for (String ending : List.of(".svg", ".png", ".html")) {
                Files.deleteIfExists(file(connection, ending));
            }
        }
        if (Files.isDirectory(folder)) {
            try {
                Files.deleteIfExists(folder);
            } catch (DirectoryNotEmptyException e) {
                // It contains other files too.
            }
        }
    }

    private Path file(int connection, String ending) {
        return folder.resolve("connection-" + connection + ending);
    }

    /**
     * Writes all evidence and returns the lines of the failure message that name it. Throws nothing, so that the
     * failure itself is reported.
     */
    String leave(String failure, long seed, @Nullable RobotWorld world, RecordedServer talks, String title) {
        String lines = "\n  seed:   " + seed + " (as @Seed(" + seed + "L) or -Drobosim.seed=" + seed + ")";
        if (world != null) {
            lines += "\n  replay: " + unlessItFails("written", () -> replay(world.scenario(title)));
            lines += images(
                    () -> Pictures.lastMoments(world.scenario(title), world.goals(), world.file()),
                    folder.resolve(PICTURE),
                    folder.resolve(BITMAP));
            lines += "\n  page:   "
                    + unlessItFails(
                            "written",
                            () -> page(world.scenario(title), world.goals(), world.file(), folder.resolve(PAGE)));
        }
        int connection = 0;
        for (byte[] recording : talks.recorded()) {
            lines += "\n  talk:   " + talk(++connection, recording);
        }
        try {
            Files.createDirectories(folder);
            String all = title + "\n" + failure + lines + "\n";
            Files.writeString(folder.resolve(WORDS), all, StandardCharsets.UTF_8);
        } catch (IOException | RuntimeException e) {
            lines += "\n  and " + folder.resolve(WORDS) + " could not be written: " + e;
        }
        return lines;
    }

    private String talk(int connection, byte[] recording) {
        if (recording.length == 0) {
            return "none of connection " + connection + ", which said nothing or could not be recorded";
        }
        Path file = file(connection, ScenarioReader.ENDING);
        String written = unlessItFails("written", () -> {
            Files.createDirectories(folder);
            Files.write(file, recording);
            return file.toString();
        });
        String images = images(
                () -> Pictures.lastMoments(Scenario.read(file), List.of(), null),
                file(connection, ".svg"),
                file(connection, ".png"));
        String page =
                unlessItFails("written", () -> page(Scenario.read(file), List.of(), null, file(connection, ".html")));
        return written + images + "\n  page:   " + page;
    }

    private String replay(Scenario scenario) throws IOException {
        Path file = folder.resolve(REPLAY);
        Files.createDirectories(folder);
        AtomicFileWriter.write(file, scenario::write); // if it cannot be written, no file remains
        return file.toString();
    }

    /** What is drawn, made when it is first needed: it takes to play the whole conversation. */
    @FunctionalInterface
    private interface Drawing {
        Pictures.Moments moments() throws IOException;
    }

    /**
     * Draws the robots at the end, with their last paths, what they sensed, what blocked them and their goals: for browsers, and
     * in pixels for what shows no SVG. Returns the lines that name both.
     */
    private String images(Drawing drawing, Path picture, Path bitmap) {
        Pictures.Moments[] made = new Pictures.Moments[1];
        String image = unlessItFails("drawn", () -> {
            made[0] = drawing.moments();
            return written(made[0], picture);
        });
        return "\n  image:  " + image
                + (made[0] == null ? "" : "\n  png:    " + unlessItFails("drawn", () -> written(made[0], bitmap)));
    }

    private String written(Pictures.Moments moments, Path file) throws IOException {
        Files.createDirectories(folder);
        moments.write(file);
        return file.toString();
    }

    /** Writes the whole conversation as a page that plays it in three dimensions. */
    private String page(Scenario scenario, List<GeometryObject> goals, @Nullable World world, Path file)
            throws IOException {
        Files.createDirectories(folder);
        PageWriter.write(scenario, goals, world, file);
        return file.toString();
    }

    /** Writes one piece of evidence. */
    @FunctionalInterface
    private interface Leaving {
        String leave() throws IOException;
    }

    /**
     * Writes a piece of evidence, or returns why it could not be written. A missing optional module, a world too deep to be
     * written, or a system without fonts or with a display that does not answer throws an {@code Error}, which must not replace
     * the failure to be reported.
     */
    private static String unlessItFails(String done, Leaving leaving) {
        try {
            return leaving.leave();
        } catch (IOException | RuntimeException | Error e) {
            return "none, for " + why(done, e);
        }
    }

    private static String why(String done, Throwable thrown) {
        String missing = thrown instanceof NoClassDefFoundError ? String.valueOf(thrown.getMessage()) : "";
        if (missing.contains("jackson")) {
            return "jackson-core is not on the class path, is older than 2.15, or is not added to the modules ("
                    + missing + ")";
        }
        return missing.contains("java/awt") || missing.contains("javax/imageio")
                ? "the module java.desktop is not there (" + missing + ")"
                : "it could not be " + done + ": " + thrown;
    }
}
