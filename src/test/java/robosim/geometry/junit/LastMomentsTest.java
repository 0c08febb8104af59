package robosim.geometry.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/** The picture that a failed test leaves. */
@Tag("slow")
class LastMomentsTest {
    private static Path run(Class<?> tests, String test, Path folder) {
        Launched.run(tests, Map.of("robosim.evidence", folder.toString()));
        return folder.resolve(tests.getName().replace('$', '.') + "." + test);
    }

    private static Document parse(Path file) throws Exception {
        return DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file.toFile());
    }

    /** The groups of a class, for objects of that name; empty is any. */
    private static List<Element> groups(Document picture, String role, String name) {
        List<Element> found = new ArrayList<>();
        NodeList all = picture.getElementsByTagName("g");
        for (int k = 0; k < all.getLength(); k++) {
            Element group = (Element) all.item(k);
            NodeList titles = group.getElementsByTagName("title");
            String title = titles.getLength() == 0 ? "" : titles.item(0).getTextContent();
            if (List.of(group.getAttribute("class").split(" ")).contains(role)
                    && (name.isEmpty() || title.equals(name))) {
                found.add(group);
            }
        }
        return found;
    }

    @Test
    void itShowsTheRobotItsWayAndWhatRefusedIt(@TempDir Path folder) throws Exception {
        Path file = run(Doomed.Failing.class, "blocked", folder).resolve("last-moments.svg");
        Document picture = parse(file);
        assertThat(picture.getDocumentElement().getTagName()).isEqualTo("svg");
        assertThat(groups(picture, "moveable", "r1")).hasSize(1);
        assertThat(groups(picture, "moveable", "r2")).hasSize(1);
        assertThat(groups(picture, "object", "wall")).hasSize(1);

        // It went by 0.5 to 1, along X.
        List<Element> trails = groups(picture, "trail", "r1");
        assertThat(trails).hasSize(1);
        String path = ((Element) trails.get(0).getElementsByTagName("path").item(0)).getAttribute("d");
        assertThat(path).matches("M([\\d.]+) ([\\d.]+)L(?!\\1 )[\\d.]+ \\2");

        // The wall's own outline, again, and the robot's cross.
        List<Element> blocks = groups(picture, "block", "r1");
        assertThat(blocks).hasSize(1);
        String flash = ((Element) blocks.get(0).getElementsByTagName("path").item(0)).getAttribute("d");
        Element wall = groups(picture, "object", "wall").get(0);
        assertThat(((Element) wall.getElementsByTagName("path").item(0)).getAttribute("d"))
                .isEqualTo(flash);
        // Where it would have been, the way there, and where it would have touched the wall.
        Element attempt = (Element) blocks.get(0).getElementsByTagName("g").item(0);
        assertThat(attempt.getAttribute("class")).isEqualTo("attempt");
        assertThat(attempt.getElementsByTagName("*").getLength())
                .as("shape and way")
                .isGreaterThanOrEqualTo(2);
        assertThat(groups(picture, "contact", "")).hasSize(1);
        assertThat(Files.readString(file)).contains("1 refused: r1 by wall", "Failing.blocked, seed 7");
    }

    /** A disc, within the picture wherever it is; an object; and none that was reached. */
    @Test
    void itShowsTheGoalThatWasMissed(@TempDir Path folder) throws Exception {
        Path file = run(Doomed.Failing.class, "lost", folder).resolve("last-moments.svg");
        Document picture = parse(file);
        List<Element> goals = groups(picture, "goal", "goal (-30, 2) to within 0.25");
        assertThat(goals).hasSize(1);
        assertThat(groups(picture, "goal", "")).hasSize(1);
        Element disc = (Element) goals.get(0).getElementsByTagName("circle").item(0);
        double x = Double.parseDouble(disc.getAttribute("cx"));
        double width = Double.parseDouble(
                picture.getDocumentElement().getAttribute("viewBox").split(" ")[2]);
        assertThat(x).isBetween(0.0, width / 4);
        assertThat(Double.parseDouble(disc.getAttribute("r"))).isPositive();
        assertThat(Files.readString(file)).contains(">goal</text>");

        picture = parse(run(Doomed.Failing.class, "undocked", folder).resolve("last-moments.svg"));
        assertThat(groups(picture, "goal", "r2")).hasSize(1);
        assertThat(groups(picture, "block", "r1"))
                .as("what its behaviour failed at")
                .hasSize(1);

        file = run(Doomed.Failing.class, "arrived", folder).resolve("last-moments.svg");
        assertThat(groups(parse(file), "goal", "")).isEmpty();
        assertThat(Files.readString(file)).doesNotContain(">goal</text>");
    }

    @Test
    void whatATestDidToTheWorldItselfIsSeen(@TempDir Path folder) throws Exception {
        Path file = run(Doomed.Failing.class, "broken", folder).resolve("last-moments.svg");
        assertThat(groups(parse(file), "moveable", "")).hasSize(2);
        assertThat(groups(parse(file), "block", "")).isEmpty();
    }

    @Test
    void aConversationWithAServerHasOneToo(@TempDir Path folder) throws Exception {
        Path file = run(Doomed.Talking.class, "talks", folder).resolve("connection-1.svg");
        assertThat(groups(parse(file), "moveable", "r1")).hasSize(1);
        assertThat(groups(parse(file), "ping", "")).hasSize(1);
    }

    /** For what shows no SVG: the same picture in pixels. */
    @Test
    void aPictureInPixelsIsBesideIt(@TempDir Path folder) throws Exception {
        for (Path file : List.of(
                run(Doomed.Failing.class, "blocked", folder).resolve("last-moments.svg"),
                run(Doomed.Talking.class, "talks", folder).resolve("connection-1.svg"))) {
            Element svg = parse(file).getDocumentElement();
            Path png = file.resolveSibling(file.getFileName().toString().replace(".svg", ".png"));
            BufferedImage image = ImageIO.read(png.toFile());
            assertThat(image.getWidth())
                    .isCloseTo(
                            (int) Double.parseDouble(svg.getAttribute("viewBox").split(" ")[2]), within(1));
            Set<Integer> colours = new HashSet<>();
            for (int y = 0; y < image.getHeight(); y++) {
                for (int x = 0; x < image.getWidth(); x++) {
                    colours.add(image.getRGB(x, y));
                }
            }
            assertThat(colours).as("it shows something").hasSizeGreaterThan(20);
        }
    }

    /** Its goals and its title are in the page's data, which PageDataTest reads. */
    @Test
    void aPageIsBesideIt(@TempDir Path folder) throws Exception {
        Path page = run(Doomed.Failing.class, "lost", folder).resolve("last-moments.html");
        assertThat(page).content().contains("<!DOCTYPE html>", "<title>").contains("Failing.lost, seed ");
        // It opens at the last of its steps, and is named after the step of the clock that the message has.
        assertThat(page).content().containsPattern("\\|\\|'step=[0-9]+'").doesNotContain("%START%");
        assertThat(page).content().containsPattern("<title>[^<]*Failing.lost, seed [-0-9]+, step [0-9]+ of the clock");
        assertThat(run(Doomed.Talking.class, "talks", folder).resolve("connection-1.html"))
                .content()
                .contains("<!DOCTYPE html>");
    }

    @Test
    void whatPassesLeavesNone(@TempDir Path folder) throws Exception {
        for (String name : List.of(
                "last-moments.svg",
                "last-moments.png",
                "last-moments.html",
                "connection-1.scenario.jsonl",
                "connection-1.png",
                "connection-1.html")) {
            Path stale =
                    folder.resolve(Doomed.class.getName() + ".Failing.passes").resolve(name);
            Files.createDirectories(stale.getParent());
            Files.writeString(stale, "of a run before");
        }
        Path passed = run(Doomed.Failing.class, "passes", folder);
        assertThat(passed).doesNotExist();
        // The others of the class have failed.
        assertThat(passed.resolveSibling(passed.getFileName().toString().replace("passes", "blocked")))
                .isNotEmptyDirectory();
    }

    @Test
    void whatSomebodyPutBesideTheEvidenceStays(@TempDir Path folder) throws Exception {
        Path passed = Files.createDirectories(folder.resolve(Doomed.class.getName() + ".Failing.passes"));
        Path own = passed.resolve("notes.txt");
        Files.writeString(own, "somebody's own");
        Files.writeString(passed.resolve("failure.txt"), "of a run before");
        run(Doomed.Failing.class, "passes", folder);
        assertThat(passed).isDirectoryContaining(file -> file.equals(own));
        assertThat(passed.resolve("failure.txt")).doesNotExist();
    }

    /** docs/scenario-tests.md tells what truly happens. */
    @Test
    void theGuideShowsARealFailure(@TempDir Path folder) throws Exception {
        Path left = run(Doomed.DoorTest.class, "itLeavesTheRoom", folder);
        String failure = Files.readAllLines(left.resolve("failure.txt")).get(1);
        assertThat(Path.of("docs", "scenario-tests.md")).content().contains(failure + "\n  seed:   7 (as");
        for (Path picture : List.of(left.resolve("last-moments.svg"), Path.of("docs", "images", "last-moments.svg"))) {
            assertThat(picture).content().contains("1 refused: robot by wall north");
        }
    }
}
