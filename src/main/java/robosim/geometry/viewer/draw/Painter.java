package robosim.geometry.viewer.draw;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.imageio.ImageIO;
import robosim.geometry.check.Checks;
import robosim.geometry.viewer.scene.Layers;
import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.shared.AtomicFileWriter;

/** Draws a {@link Scene}. The same scene gives the same picture, to the byte in SVG. */
public final class Painter {
    private final Scene scene;
    private final MapFrame frame;
    private final Canvas canvas;
    private final double farthest;

    /** A colour for each moveable object, in the order of the scene. */
    private final Map<String, Ink> robots = new LinkedHashMap<>();

    private Painter(Scene scene, MapFrame frame, Canvas canvas) {
        this.scene = scene;
        this.frame = frame;
        this.canvas = canvas;
        this.farthest = Math.max(
                scene.farthest(),
                scene.pings().stream()
                        .mapToDouble(Scene.Ping::distance)
                        .filter(Double::isFinite)
                        .max()
                        .orElse(0));
        for (Scene.Thing thing : scene.things()) {
            String name = thing.object().name();
            if (thing.object().isMoveable() && name != null) {
                robots.put(name, Palette.robot(robots.size()));
            }
        }
    }

    /** The scene as an SVG document that follows the viewer's light or dark theme. */
    public static String svg(Scene scene) {
        Checks.present("scene", scene);
        MapFrame frame = new MapFrame(scene.view());
        SvgCanvas canvas = new SvgCanvas(frame.width, frame.height, scene.title());
        new Painter(scene, frame, canvas).paint();
        return canvas.document();
    }

    /** The scene as an image; requires the JDK's {@code java.desktop}, but no display. */
    public static BufferedImage image(Scene scene, Theme theme) {
        Checks.present("scene", scene);
        Checks.present("theme", theme);
        MapFrame frame = new MapFrame(scene.view());
        return ImageCanvas.image(frame.width, frame.height, theme, canvas -> new Painter(scene, frame, canvas).paint());
    }

    /** The pixels of a drawing, row by row from the top, {@code 0xRRGGBB}. */
    public static final class Pixels {
        public final int width;
        public final int height;
        public final int[] rgb;

        public Pixels(int width, int height, int[] rgb) {
            this.width = width;
            this.height = height;
            this.rgb = rgb;
        }
    }

    /** The scene as pixels, for a film. */
    public static Pixels pixels(Scene scene, Theme theme) {
        BufferedImage image = image(scene, theme);
        int width = image.getWidth();
        int height = image.getHeight();
        return new Pixels(width, height, image.getRGB(0, 0, width, height, null, 0, width));
    }

    /**
     * Writes the scene to a file, {@code .svg} or {@code .png} by its ending; atomically.
     *
     * @throws IllegalArgumentException if it ends otherwise
     * @throws IOException if the file cannot be written
     */
    public static void write(Scene scene, Theme theme, Path file) throws IOException {
        Checks.present("scene", scene);
        Checks.present("theme", theme);
        Checks.present("file", file);
        String name = file.toString().toLowerCase(Locale.ROOT);
        if (name.endsWith(".svg")) {
            byte[] document = svg(scene).getBytes(StandardCharsets.UTF_8);
            AtomicFileWriter.write(file, out -> out.write(document));
        } else if (name.endsWith(".png")) {
            BufferedImage image = image(scene, theme);
            // Not by PngWriter, whose choice of filters takes three times as long and gains little on flat drawings.
            AtomicFileWriter.write(file, out -> ImageIO.write(image, "png", out));
        } else {
            throw new IllegalArgumentException("a picture's name must end in .svg or .png (got: " + file + ")");
        }
    }

    private void paint() {
        paintFloor();
        new GridPainter(scene, frame, canvas).title();
        clip();
        List<Layers.Layer> layers = statics();
        paintStatics(layers);
        paintLife();
        canvas.unclip();
        new LabelPainter(frame, canvas).paint(movers(), layers);
        new LegendPainter(scene, frame, canvas, farthest).paint();
    }

    private void clip() {
        canvas.clip(frame.left(), frame.top(), frame.right() - frame.left(), frame.bottom() - frame.top());
    }

    private void paintFloor() {
        canvas.open("page", "");
        canvas.rectangle(0, 0, frame.width, frame.height, Style.filled(Palette.PAPER, 1));
        canvas.close();
        new GridPainter(scene, frame, canvas).paint();
    }

    private List<Scene.Thing> movers() {
        return scene.things().stream()
                .filter(thing -> thing.object().isMoveable())
                .toList();
    }

    private List<Layers.Layer> statics() {
        return Layers.fromBelow(scene.things().stream()
                .filter(thing -> !thing.object().isMoveable())
                .toList());
    }

    private void paintStatics(List<Layers.Layer> layers) {
        canvas.open("objects", "");
        for (int k = 0; k < layers.size(); k++) {
            Layers.Layer layer = layers.get(k);
            if (k == 0 || layers.get(k - 1).index() != layer.index()) {
                ThingPainter.open("object", layer.thing().object(), canvas);
            }
            ThingPainter.paint(layer, frame, canvas);
            if (k == layers.size() - 1 || layers.get(k + 1).index() != layer.index()) {
                canvas.close();
            }
        }
        canvas.close();
    }

    private void paintLife() {
        TracePainter traces = new TracePainter(scene, frame, canvas, farthest);
        traces.trails(robots);
        traces.pings();
        canvas.open("moveables", "");
        for (Scene.Thing thing : movers()) {
            Ink ink = robots.getOrDefault(thing.object().name(), Palette.robot(0));
            ThingPainter.paintMoveable(thing, ink, frame, canvas);
        }
        canvas.close();
        if (!scene.blocked().isEmpty()) {
            traces.blocked();
        }
        traces.refusals();
        if (!scene.marks().isEmpty()) {
            traces.marks();
        }
    }
}
