package robosim.geometry.viewer.draw;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import robosim.geometry.check.Text;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.viewer.scene.Scene;

class PainterTest {
    private static final int RED = 0xff0000;

    private static final int FIRST_ROBOT = 0x0067a8;
    private static final int GROUP = 0xa3ab88;
    private static final int FLOOR = 0xffffff;
    private static final int DARK_FLOOR = 0x1b1f26;
    private static final int PAPER = 0xfbfaf7;

    /** Where the page's picture has the middle of {@link #VIEW}, in pixels: 10 and 5 units beside a margin. */
    private static final int MIDDLE_X = 806;

    private static final int MIDDLE_Y = 449;
    private static final int SCALE = 75;

    /** 20 by 10 units: 75 pixels a unit. */
    private static final Scene.View VIEW = Scene.View.world(20, 10);

    private static Scene scene() {
        List<Scene.Thing> things = List.of(
                new Scene.Thing(new BoxObject(new Point(-5, 0, 0), 4, 1, 2).named("wall & <door>"), RED),
                new Scene.Thing(
                        new BoxObject(new Point(-5, 0, 3), 2, 1, 1)
                                .turned(30, 20)
                                .turned(25, 40),
                        null),
                new Scene.Thing(new CylinderObject(new Point(0, 0, 0), 1, 1), 0x00ff00),
                new Scene.Thing(new CylinderObject(new Point(0, 0, 3), 0.5, 2).turned(90, 0), null),
                new Scene.Thing(new SphereObject(new Point(5, 0, 0), 1.5), 0x0000ff),
                new Scene.Thing(mesh().movedTo(new Point(5, 0, 3)), null),
                new Scene.Thing(
                        new ObjectGroup(List.of(
                                new BoxObject(new Point(), 1, 1, 1), new SphereObject(new Point(1, 0, 0), 0.5))),
                        null),
                new Scene.Thing(new CylinderObject(new Point(0, 0, -3), 0.4, 1).moveable("drum"), null));
        return Scene.of("Everything", VIEW, things)
                .described("a line below", "m")
                .with(
                        List.of(new Scene.Trail("drum", List.of(new Point(-3, 0, -3), new Point(0, 0, -3)))),
                        List.of(
                                new Scene.Ping(new Point(0, 0, -3), 30, 20, 5, 2),
                                new Scene.Ping(new Point(0, 0, -3), 0, 0, 5, 4),
                                new Scene.Ping(new Point(0, 0, -3), 200, 20, 5, Double.POSITIVE_INFINITY)),
                        List.of(new Scene.Refusal(new Point(-2, 0, -3), 90)));
    }

    private static MeshObject mesh() {
        return new MeshObject(
                List.of(new Point(0, 0, 0), new Point(1, 0, 0), new Point(1, 0, 1), new Point(0, 1, 1)),
                new int[][] {{0, 1, 2, 3}});
    }

    private static Document parse(String svg) throws Exception {
        DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
        factory.setNamespaceAware(true);
        return factory.newDocumentBuilder().parse(new ByteArrayInputStream(svg.getBytes(StandardCharsets.UTF_8)));
    }

    private static List<Element> withClass(Document document, String role) {
        List<Element> found = new ArrayList<>();
        NodeList groups = document.getElementsByTagNameNS("http://www.w3.org/2000/svg", "g");
        for (int k = 0; k < groups.getLength(); k++) {
            Element group = (Element) groups.item(k);
            if (List.of(group.getAttribute("class").split(" ")).contains(role)) {
                found.add(group);
            }
        }
        return found;
    }

    private static int count(Element group, String tag) {
        return group.getElementsByTagName(tag).getLength();
    }

    @Test
    void everyThingStandsInTheDocument() throws Exception {
        Document document = parse(Painter.svg(scene()));
        assertThat(withClass(document, "box")).hasSize(2);
        assertThat(withClass(document, "cylinder")).hasSize(3); // the robot is one
        assertThat(withClass(document, "sphere")).hasSize(1);
        // Its higher triangle is above the group, its lower one below it.
        assertThat(withClass(document, "mesh")).hasSize(2);
        assertThat(withClass(document, "group")).hasSize(1);
        assertThat(withClass(document, "moveable")).hasSize(1);
        assertThat(withClass(document, "trail")).hasSize(1);
        assertThat(withClass(document, "ping")).hasSize(2);
        assertThat(withClass(document, "silence")).hasSize(1);
        // One in the map, one in the legend.
        assertThat(withClass(document, "refusal")).hasSize(2);
        assertThat(withClass(document, "scale-bar")).hasSize(1);
        assertThat(withClass(document, "ramp")).hasSize(1);
        assertThat(document.getDocumentElement().getTextContent())
                .contains("Everything", "a line below", "wall & <door>", "drum", "2 m", "refused move, 1 shown");
    }

    /** The crosses of a drive are where it bumped: nobody asked for a move. */
    @Test
    void theLegendTellsBumpsFromRefusedMoves() {
        Scene.Refusal move = new Scene.Refusal(new Point(-2, 0, -3), 90);
        Scene.Refusal bump = new Scene.Refusal(new Point(-2, 0, -3), 90, Scene.Refusal.Kind.BUMP);
        assertThat(legend(move)).contains(">refused move, 1 shown<");
        assertThat(legend(bump, bump)).contains(">bump, 2 shown<");
        assertThat(legend(move, bump)).contains(">refused move or bump, 2 shown<");
    }

    private static String legend(Scene.Refusal... crosses) {
        return Painter.svg(scene().with(List.of(), List.of(), List.of(crosses)));
    }

    /** Cells side by side are one area without edges, and what a robot met on a map is not the whole of it. */
    @Test
    void aGridIsDrawnAsItsCells() throws Exception {
        BitSet cells = new BitSet();
        cells.set(0, 40); // the first of ten rows, and the last cell
        cells.set(399);
        GridObject map = new GridObject(new Point(0, 0, 0), 0.25, 1, 40, 10, cells).named("map");
        GeometryObject robot = new CylinderObject(new Point(-4.5, 0, -0.5), 0.2, 1).moveable("robot");
        Scene scene = Scene.of("Map", VIEW, List.of(new Scene.Thing(map, null), new Scene.Thing(robot, null)))
                .blocked(List.of(new Scene.Blocked(robot, map, 1)))
                .marked(List.of(new Scene.Mark(map, Scene.Mark.Why.PICKED)), 0);
        Document document = parse(Painter.svg(scene));
        Element drawn = withClass(document, "object").get(0);
        assertThat(count(drawn, "path")).isEqualTo(1);
        Element path = (Element) drawn.getElementsByTagName("path").item(0);
        assertThat(path.getAttribute("d")).containsPattern("^M[^Z]*Z *M[^Z]*Z$");
        assertThat(path.getAttribute("class")).matches("f[0-9]+");
        assertThat(path.getAttribute("stroke-width")).isEmpty();
        // Near the robot are some cells of the first row, 25 pixels high, and not the one in the far corner.
        Element block = withClass(document, "block").get(0);
        assertThat(((Element) block.getElementsByTagName("path").item(0)).getAttribute("d"))
                .containsPattern("^M[^Z]*Z$");
        Element picked = withClass(document, "picked").get(0);
        assertThat(count(picked, "path")).as("an outline of the whole grid").isEqualTo(1);
        BufferedImage image = Painter.image(scene, Theme.LIGHT);
        assertThat(image.getRGB(MIDDLE_X, MIDDLE_Y - (int) (1.125 * SCALE)) & 0xffffff)
                .isEqualTo(Palette.of(GeometryObject.Kind.GRID).light());
        assertThat(image.getRGB(MIDDLE_X + 10, MIDDLE_Y + 20) & 0xffffff).isEqualTo(FLOOR);
        // Its name would stand on free floor.
        assertThat(withClass(document, "names").get(0).getTextContent()).doesNotContain("map");
    }

    @Test
    void shapesAreDrawnAsWhatTheyCover() throws Exception {
        Document document = parse(Painter.svg(scene()));
        Element sphere = (Element) withClass(document, "sphere")
                .get(0)
                .getElementsByTagName("circle")
                .item(0);
        assertThat(sphere.getAttribute("r")).isEqualTo("112.5");
        assertThat(sphere.getAttribute("cx")).isEqualTo("1181");
        assertThat(sphere.getAttribute("cy")).isEqualTo("449");
        Element box = (Element)
                withClass(document, "box").get(0).getElementsByTagName("path").item(0);
        assertThat(box.getAttribute("d").replaceAll("[^MLZ]", "")).isEqualTo("MLLLZ");
        Element tipped = (Element)
                withClass(document, "box").get(1).getElementsByTagName("path").item(0);
        assertThat(tipped.getAttribute("d").replaceAll("[^MLZ]", "")).isEqualTo("MLLLLLZ");
        // Two triangles that are not in one plane, the edge between them and the four around them.
        StringBuilder paths = new StringBuilder();
        for (Element mesh : withClass(document, "mesh")) {
            NodeList drawn = mesh.getElementsByTagName("path");
            for (int k = 0; k < drawn.getLength(); k++) {
                paths.append(((Element) drawn.item(k)).getAttribute("d").replaceAll("[^MLZ]", ""));
            }
        }
        assertThat(paths).hasToString("MLLZ" + "MLZ".repeat(2) + "MLLZ" + "MLZ".repeat(3));
        Element group = withClass(document, "group").get(0);
        assertThat(count(group, "path")).isEqualTo(1);
        assertThat(count(group, "circle")).isEqualTo(1);
    }

    private static Scene above(GeometryObject... objects) {
        List<Scene.Thing> things = new ArrayList<>();
        for (GeometryObject object : objects) {
            things.add(new Scene.Thing(object, null));
        }
        return Scene.of("Above", VIEW, things);
    }

    private static List<String> titles(Document document, String role) {
        return withClass(document, role).stream()
                .map(group -> group.getElementsByTagName("title").item(0).getTextContent())
                .toList();
    }

    /** Seen from above, what reaches higher is drawn over what lies below it, wherever it stands in the file. */
    @Test
    void whatCoversIsDrawnOverWhatLiesBelow() throws Exception {
        Scene scene = above(
                new BoxObject(new Point(0, 3, 0), 4, 0.2, 3).named("roof"),
                new CylinderObject(new Point(0, 0, 0), 1, 1).turned(90, 0).named("log"),
                new MeshObject(
                                List.of(
                                        new Point(-2, 5, -1),
                                        new Point(2, 0, -1),
                                        new Point(2, 0, 1),
                                        new Point(9, 9, 9)),
                                new int[][] {{0, 1, 2}})
                        .movedTo(new Point(0, -1, 0))
                        .named("sheet"),
                new SphereObject(new Point(0, 1, 0), 1.25).named("ball"),
                new ObjectGroup(List.of(new BoxObject(new Point(0, -1, 0), 1, 1, 1).turned(45, 0)))
                        .turned(45, 0)
                        .named("group"),
                new BoxObject(new Point(0, -2, 0), 20, 0.1, 10).named("floor"),
                new BoxObject(new Point(0, -2, 0), 2, 0.1, 1).named("mat"));
        // Tops: 3.1, 1, 4, 2.25, about -0.2, -1.95, -1.95.
        Document document = parse(Painter.svg(scene));
        assertThat(titles(document, "object")).containsExactly("floor", "mat", "group", "log", "ball", "roof", "sheet");
        // In the middle of the page only what nothing covers has a name; the mat's place is the floor's middle too.
        Element names = withClass(document, "names").get(0);
        assertThat(names.getTextContent()).contains("sheet").doesNotContain("mat", "floor", "roof");
    }

    private static boolean isShade(int rgb, int other) {
        int most = 0;
        for (int shift = 16; shift >= 0; shift -= 8) {
            most = Math.max(most, Math.abs((rgb >> shift & 0xff) - (other >> shift & 0xff)));
        }
        return most < 40;
    }

    private static int pixels(BufferedImage image, double x, double z, int around, int rgb) {
        int found = 0;
        for (int dx = -around; dx <= around; dx++) {
            for (int dy = -around; dy <= around; dy++) {
                int px = (int) (MIDDLE_X + x * SCALE) + dx;
                int py = (int) (MIDDLE_Y + z * SCALE) + dy;
                found += isShade(image.getRGB(px, py) & 0xffffff, rgb) ? 1 : 0;
            }
        }
        return found;
    }

    /** An arrow is seen where nothing is below it, and is no larger than the part that it stands on. */
    @Test
    void anArrowIsSeenAndNoLargerThanItsPart() {
        GeometryObject off = new ObjectGroup(List.of(
                        new BoxObject(new Point(3, 0, 0), 1, 1, 1), new BoxObject(new Point(-3, 0, 1), 1, 1, 1)))
                .moveable("off");
        BufferedImage image = Painter.image(above(off), Theme.LIGHT);
        assertThat(pixels(image, 0, 0, 10, FIRST_ROBOT))
                .as("an arrow on the floor")
                .isBetween(30, 150);
        assertThat(pixels(image, 3, 0, 30, 0xffffff)).as("none on a part").isZero();
        // A plus of two bars: the arrow keeps to the bar's width of 0.4, 30 pixels.
        GeometryObject plus = new ObjectGroup(
                        List.of(new BoxObject(new Point(), 8, 1, 0.4), new BoxObject(new Point(), 0.4, 1, 8)))
                .moveable("plus");
        image = Painter.image(above(plus), Theme.LIGHT);
        assertThat(pixels(image, 0, 0, 16, 0xffffff)).isGreaterThan(60);
        assertThat(pixels(image, 0.5, 0, 14, FIRST_ROBOT))
                .as("the bar ahead of it")
                .isGreaterThan(28 * 28 * 9 / 10);
    }

    /** A robot of a pixel or two is a dot of its colour and not of its edge. */
    @Test
    void smallRobotsAreSeen() {
        for (GeometryObject small : List.of(
                new CylinderObject(new Point(1, 0, 1), 0.01, 1).moveable("a"),
                new CylinderObject(new Point(1, 0, 1), 0.04, 1).moveable("a"),
                new BoxObject(new Point(1, 0, 1), 0.02, 1, 0.02).moveable("a"),
                new BoxObject(new Point(1, 0, 1), 0.1, 1, 0.1).moveable("a"),
                new BoxObject(new Point(1, 0, 1), 0, 1, 0).moveable("a"),
                new ObjectGroup(List.of(new BoxObject(new Point(0, 0, 0), 0.02, 1, 0.02)))
                        .movedTo(new Point(1, 0, 1))
                        .moveable("a"))) {
            BufferedImage image = Painter.image(above(small), Theme.LIGHT);
            assertThat(pixels(image, 1, 1, 4, FIRST_ROBOT)).as("%s", small).isGreaterThanOrEqualTo(8);
        }
        // Forward is told beside it.
        BufferedImage image = Painter.image(
                above(new SphereObject(new Point(), 0.02).turned(0, 90).moveable("a")), Theme.LIGHT);
        assertThat(pixels(image, 0, -0.13, 4, FIRST_ROBOT))
                .isGreaterThan(2 * pixels(image, 0, 0.13, 4, FIRST_ROBOT))
                .isPositive();
    }

    @Test
    void whatMovesIsNotCalledARobot() {
        String svg = Painter.svg(above(new BoxObject(new Point(), 1, 1, 1).moveable("crate")));
        assertThat(svg).contains("moves; the arrow is its heading").doesNotContain("robot");
    }

    @Test
    void theSameSceneGivesTheSameBytes() {
        assertThat(Painter.svg(scene())).isEqualTo(Painter.svg(scene()));
        BufferedImage first = Painter.image(scene(), Theme.DARK);
        BufferedImage second = Painter.image(scene(), Theme.DARK);
        int width = first.getWidth();
        int height = first.getHeight();
        assertThat(first.getRGB(0, 0, width, height, null, 0, width))
                .isEqualTo(second.getRGB(0, 0, width, height, null, 0, width));
    }

    @Test
    void pixelsHaveTheColourOfWhatIsThere() {
        BufferedImage image = Painter.image(scene(), Theme.LIGHT);
        // 20 by 10 units, and the margins.
        assertThat(image.getWidth()).isEqualTo(1612);
        assertThat(image.getHeight()).isEqualTo(940);
        assertThat(at(image, -6.7, 0.7)).isEqualTo(RED);
        assertThat(at(image, 0.7, 0)).isEqualTo(GROUP); // drawn after the cylinder
        assertThat(at(image, 5.6, 0.9)).isEqualTo(0x0000ff);
        assertThat(at(image, 9.4, 4.6)).isEqualTo(FLOOR);
        assertThat(image.getRGB(3, 3) & 0xffffff).isEqualTo(PAPER);
        // Within the cone that was heard after 2 units, and just beyond it.
        double x = 1.5 * StrictMath.cos(StrictMath.toRadians(30));
        double z = -3 - 1.5 * StrictMath.sin(StrictMath.toRadians(30));
        assertThat(at(image, x, z)).isNotEqualTo(FLOOR);
        assertThat(at(image, 1.6 * x, -3 + 1.6 * (z + 3))).isEqualTo(FLOOR);
        BufferedImage dark = Painter.image(scene(), Theme.DARK);
        assertThat(at(dark, 9.4, 4.6)).isEqualTo(DARK_FLOOR);
    }

    private static int at(BufferedImage image, double x, double z) {
        return image.getRGB((int) (MIDDLE_X + x * SCALE), (int) (MIDDLE_Y + z * SCALE)) & 0xffffff;
    }

    @Test
    void positiveTurnsAreCounterClockwiseOnThePage() throws Exception {
        // A long box turned by +30: its far end is up the page, towards -Z.
        Scene scene = Scene.of(
                "turned", VIEW, List.of(new Scene.Thing(new BoxObject(new Point(), 8, 1, 0.5).turned(0, 30), RED)));
        BufferedImage image = Painter.image(scene, Theme.LIGHT);
        double c = 3.5 * StrictMath.cos(StrictMath.toRadians(30));
        double s = 3.5 * StrictMath.sin(StrictMath.toRadians(30));
        assertThat(at(image, c, -s)).isEqualTo(RED);
        assertThat(at(image, c, s)).isEqualTo(FLOOR);
    }

    @Test
    void nearerIsStrongerAgainstThePaper() {
        for (Theme theme : Theme.values()) {
            double before = contrast(0, theme);
            for (int k = 1; k < Palette.RAMP; k++) {
                double now = contrast(k, theme);
                assertThat(now).as("step %d on %s", k, theme).isLessThan(before + 0.02);
                before = now;
            }
            assertThat(contrast(Palette.RAMP - 1, theme)).isLessThan(contrast(0, theme) - 0.25);
        }
    }

    /** The difference of lightness (the cube root of luminance) from the floor. */
    private static double contrast(int step, Theme theme) {
        int ink = Palette.distance(step / (Palette.RAMP - 1.0)).in(theme);
        return Math.abs(Math.cbrt(luminance(ink)) - Math.cbrt(luminance(theme == Theme.LIGHT ? FLOOR : DARK_FLOOR)));
    }

    private static double luminance(int rgb) {
        return 0.2126 * linear(rgb >> 16 & 0xff) + 0.7152 * linear(rgb >> 8 & 0xff) + 0.0722 * linear(rgb & 0xff);
    }

    private static double linear(int channel) {
        double v = channel / 255.0;
        return v <= 0.04045 ? v / 12.92 : Math.pow((v + 0.055) / 1.055, 2.4);
    }

    @Test
    void flatAndPointedThingsAreStillDrawn() throws Exception {
        List<Scene.Thing> things = List.of(
                new Scene.Thing(new BoxObject(new Point(), 0, 0, 0), null),
                new Scene.Thing(new BoxObject(new Point(), 0, 1, 3), null),
                new Scene.Thing(new SphereObject(new Point(), 0), null),
                new Scene.Thing(new CylinderObject(new Point(), 0, 2).turned(90, 0), null));
        Document document = parse(Painter.svg(Scene.of("flat", VIEW, things)));
        assertThat(withClass(document, "object")).hasSize(4);
        assertThat(Painter.svg(Scene.of("flat", VIEW, things)))
                .doesNotContain("NaN")
                .doesNotContain("Infinity");
    }

    @Test
    void theNameOfTheFileDecidesTheFormat(@TempDir Path folder) throws Exception {
        Painter.write(scene(), Theme.LIGHT, folder.resolve("a.svg"));
        Painter.write(scene(), Theme.LIGHT, folder.resolve("a.PNG"));
        assertThat(Files.readString(folder.resolve("a.svg"))).isEqualTo(Painter.svg(scene()));
        BufferedImage read = ImageIO.read(folder.resolve("a.PNG").toFile());
        assertThat(read.getWidth())
                .isEqualTo(Painter.image(scene(), Theme.LIGHT).getWidth());
        // All or nothing: what stands beside it is not touched, and nothing else is left there.
        Path none = folder.resolve("none/a.png");
        assertThatThrownBy(() -> Painter.write(scene(), Theme.LIGHT, none))
                .isInstanceOf(NoSuchFileException.class)
                .hasMessageStartingWith(none + ":");
        try (var files = Files.list(folder)) {
            assertThat(files).hasSize(2);
        }
        assertThatThrownBy(() -> Painter.write(scene(), Theme.LIGHT, folder.resolve("a.gif")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("a.gif");
    }

    @Test
    void aViewMustHaveAnArea() {
        assertThatThrownBy(() -> new Scene.View(0, 0, 0, 1, true)).hasMessageContaining("got: x 0.0 to 0.0");
        assertThatThrownBy(() -> new Scene.View(0, 0, Double.NaN, 1, true)).hasMessageContaining("NaN");
        Scene.View around = Scene.View.around(List.of(new SphereObject(new Point(3, 0, 4), 2)));
        assertThat(around.minX()).isEqualTo(0.8);
        assertThat(around.maxZ()).isEqualTo(6.2);
        assertThat(Scene.View.around(List.of()).maxX()).isEqualTo(0.5);
    }

    @Test
    void numbersAreShortAndNeverSurprising() {
        assertThat(SvgCanvas.number(1)).isEqualTo("1");
        assertThat(SvgCanvas.number(-0.001)).isEqualTo("0");
        assertThat(SvgCanvas.number(-0.05)).isEqualTo("-0.05");
        assertThat(SvgCanvas.number(12.5)).isEqualTo("12.5");
        assertThat(SvgCanvas.number(12.346)).isEqualTo("12.35");
        assertThat(Text.xml("a\u0000<&>\"")).isEqualTo("a\ufffd&lt;&amp;&gt;&quot;");
        assertThat(MapFrame.roundLength(7)).isEqualTo(5);
        assertThat(MapFrame.roundLength(0.02)).isEqualTo(0.02);
    }
}
