package robosim.geometry.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.Geometry;
import robosim.geometry.material.Material;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Images as the JDK reads them. */
class FramePicturesTest {
    private static final Intrinsics LENS = Intrinsics.fieldOfView(31, 21, 80);

    @TempDir
    Path folder;

    private static Geometry world(int label) {
        Geometry world = new Geometry(100, 100, 100);
        world.addObject(new SphereObject(new Point(6, 0, 0), 1).withMaterial(Material.DEFAULT.withLabel(label)));
        world.addObject(new BoxObject(new Point(8, -6, 0), 9, 1, 30).withMaterial(Material.DEFAULT.withLabel(7)));
        return world;
    }

    private static int grey(BufferedImage image, int pixel) {
        return image.getRaster().getSample(pixel % image.getWidth(), pixel / image.getWidth(), 0);
    }

    @Test
    void depthsInMillimetres() throws IOException {
        DepthFrame frame = new DepthFrame();
        DepthCamera.of(LENS).read(world(3), frame);
        Path file = folder.resolve("depth.png");
        frame.writePng(1, file);
        BufferedImage image = ImageIO.read(file.toFile());
        assertThat(image.getWidth()).isEqualTo(31);
        assertThat(image.getHeight()).isEqualTo(21);
        assertThat(image.getColorModel().getPixelSize()).isEqualTo(16);
        int nothing = 0;
        for (int k = 0; k < frame.size(); k++) {
            double depth = frame.depth(k);
            nothing += depth == Double.POSITIVE_INFINITY ? 1 : 0;
            assertThat(grey(image, k)).isEqualTo(depth < 65.5355 ? (int) Math.rint(1000 * depth) : 0);
        }
        assertThat(grey(image, 31 * 10 + 15)).isEqualTo(5000);
        assertThat(nothing).isBetween(100, 600);
    }

    @Test
    void labelsInstancesAndNormals() throws IOException {
        SegmentationFrame frame = new SegmentationFrame();
        SegmentationCamera.of(LENS).read(world(40_000), frame);
        Path file = folder.resolve("a.png");
        frame.writeLabels(file);
        BufferedImage labels = ImageIO.read(file.toFile());
        frame.writeInstances(file);
        BufferedImage instances = ImageIO.read(file.toFile());
        NormalFrame normals = new NormalFrame();
        NormalCamera.of(LENS).read(world(1), normals);
        normals.writePng(file);
        BufferedImage colours = ImageIO.read(file.toFile());
        for (int k = 0; k < frame.size(); k++) {
            assertThat(grey(labels, k)).isEqualTo(frame.label(k));
            assertThat(grey(instances, k)).isEqualTo(frame.instance(k));
            int rgb = colours.getRGB(k % 31, k / 31) & 0xffffff;
            assertThat(rgb == 0).isEqualTo(frame.instance(k) == 0);
            if (frame.label(k) == 7 && normals.normalY(k) == 1) {
                assertThat(rgb).isEqualTo(0x800080); // the top of the floor: up is less than nothing down
            }
        }
        assertThat(frame.label(31 * 10 + 15)).isEqualTo(40_000);
        assertThat(frame.label(31 * 20 + 15)).isEqualTo(7);
    }

    @Test
    void refused() {
        Path file = folder.resolve("no.png");
        assertThatThrownBy(() -> new DepthFrame().writePng(1, file))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("the frame must have been read");
        SegmentationFrame frame = new SegmentationFrame();
        SegmentationCamera.of(LENS).read(world(65_536), frame);
        assertThatThrownBy(() -> frame.writeLabels(file))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("labels must be from 0 to 65535 for 16 bits (got: 65536)");
        assertThat(file).doesNotExist();
    }
}
