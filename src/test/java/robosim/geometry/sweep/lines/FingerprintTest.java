package robosim.geometry.sweep.lines;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.Samples;

class FingerprintTest {
    private static String print(GeometryObject object) {
        Fingerprint print = new Fingerprint();
        print.add(object);
        return print.hex();
    }

    /** What is sent is what counts: objects that are equal have one digest, and others another one. */
    @Test
    void objectsThatDifferHaveDifferentDigests() {
        Set<String> prints = new HashSet<>();
        Set<GeometryObject> objects = new HashSet<>();
        for (Bundle bundle : Samples.everyBundle()) {
            if (bundle instanceof InitBundle init) {
                for (GeometryObject object : init.objects()) {
                    for (GeometryObject each : List.of(
                            object.material()
                                            .equals(Material.of(
                                                    object.material().color()))
                                    ? object.withMaterial(Material.DEFAULT)
                                    : object,
                            object.withMaterial(Material.DEFAULT),
                            object.withMaterial(Material.of(Color.BLACK).withLabel(1)),
                            object.withMaterial(Material.of(Color.BLACK).withEmission(Color.WHITE)))) {
                        assertThat(print(each)).isEqualTo(print(each));
                        prints.add(print(each));
                        objects.add(each);
                    }
                }
            }
        }
        assertThat(objects).hasSizeGreaterThan(50);
        assertThat(prints).hasSameSizeAs(objects);
    }

    /** Worlds had colours before, which were of the viewer alone: their digests stay. */
    @Test
    void aColorAloneDoesNotCount() {
        GeometryObject object = Samples.everyShape().get(0);
        assertThat(print(object.withMaterial(Material.of(Color.BLACK)))).isEqualTo(print(object));
        assertThat(print(object.withMaterial(Material.of(Color.BLACK).withLabel(1))))
                .isNotEqualTo(print(object.withMaterial(Material.of(Color.WHITE).withLabel(1))));
    }

    @Test
    void textureCoordinatesCount() {
        MeshObject mesh =
                new MeshObject(List.of(new Point(), new Point(1, 0, 0), new Point(0, 1, 0)), new int[][] {{0, 1, 2}});
        Set<String> prints = new HashSet<>();
        prints.add(print(mesh));
        prints.add(
                print(mesh.withTextureCoordinates(new TextureCoordinates(new double[] {0, 0}, new int[] {0, 0, 0}))));
        prints.add(
                print(mesh.withTextureCoordinates(new TextureCoordinates(new double[] {0, 1}, new int[] {0, 0, 0}))));
        prints.add(
                print(mesh.withTextureCoordinates(new TextureCoordinates(new double[] {0, 0}, new int[] {0, 0, -1}))));
        assertThat(prints).hasSize(4);
    }
}
