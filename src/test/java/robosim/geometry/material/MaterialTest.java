package robosim.geometry.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.DoubleFunction;
import org.junit.jupiter.api.Test;

class MaterialTest {
    private static final Texture CHECKER = new Texture.Checker(Color.BLACK, Color.WHITE, 0.5);

    /** Each differs from the default in one thing. */
    private static List<Material> materials() {
        Material plain = Material.DEFAULT;
        return List.of(
                plain,
                plain.withColor(new Color(0.1, 0.2, 0.3)),
                plain.withDiffuse(0.5),
                plain.withSpecular(0.5),
                plain.withShininess(100),
                plain.withMirror(0.25),
                plain.withEmission(Color.WHITE),
                plain.withTexture(CHECKER),
                plain.withTexture(new Texture.Stripes(Color.BLACK, Color.WHITE, 0.5, 45)),
                plain.withTexture(ImageTextureTest.image()),
                plain.withReflectance(0.75),
                plain.withLabel(3));
    }

    @Test
    void materialsAreValuesThatSurviveSerialization() throws Exception {
        Set<String> texts = new HashSet<>();
        List<Material> others = materials(); // made afresh
        for (int k = 0; k < others.size(); k++) {
            Material one = materials().get(k);
            for (int j = 0; j < others.size(); j++) {
                assertThat(one.equals(others.get(j)))
                        .as(one + " and " + others.get(j))
                        .isEqualTo(k == j);
            }
            assertThat(one).hasSameHashCodeAs(others.get(k));
            assertThat(copied(one)).isEqualTo(one).hasSameHashCodeAs(one).hasToString(one.toString());
            assertThat(one.isDefault()).isEqualTo(k == 0);
            texts.add(one.toString());
        }
        assertThat(texts).hasSameSizeAs(others);
    }

    @Test
    void eachPropertyIsChangedAlone() {
        Material all = Material.of(new Color(0.1, 0.2, 0.3))
                .withDiffuse(0.4)
                .withSpecular(0.5)
                .withShininess(60)
                .withMirror(0.7)
                .withEmission(new Color(0.8, 0.9, 1))
                .withTexture(CHECKER)
                .withReflectance(0.25)
                .withLabel(9);
        assertThat(all.color()).isEqualTo(new Color(0.1, 0.2, 0.3));
        assertThat(all.diffuse()).isEqualTo(0.4);
        assertThat(all.specular()).isEqualTo(0.5);
        assertThat(all.shininess()).isEqualTo(60);
        assertThat(all.mirror()).isEqualTo(0.7);
        assertThat(all.emission()).isEqualTo(new Color(0.8, 0.9, 1));
        assertThat(all.texture()).isEqualTo(CHECKER);
        assertThat(all.reflectance()).isEqualTo(0.25);
        assertThat(all.label()).isEqualTo(9);
        assertThat(all.withTexture(null).texture()).isNull();
        assertThat(all)
                .hasToString(
                        "checker of #000000 and #ffffff, 0.5, diffuse 0.4, specular 0.5, shininess 60.0, mirror 0.7,"
                                + " emission #cce6ff, reflectance 0.25, label 9");
    }

    @Test
    void aShareOutsideItsRangeIsRefusedByName() {
        Material plain = Material.DEFAULT;
        for (double bad : new double[] {Double.NaN, -1e-9, Math.nextUp(1.0), Double.POSITIVE_INFINITY}) {
            refused("diffuse", plain::withDiffuse, bad);
            refused("specular", plain::withSpecular, bad);
            refused("mirror", plain::withMirror, bad);
            refused("reflectance", plain::withReflectance, bad);
            refused("red", x -> new Color(x, 0, 0), bad);
            refused("green", x -> new Color(0, x, 0), bad);
            refused("blue", x -> new Color(0, 0, x), bad);
        }
        for (double bad : new double[] {Double.NaN, 0, Math.nextDown(1.0), 1e7}) {
            refused("shininess", plain::withShininess, bad);
        }
        for (double bad : new double[] {Double.NaN, 0, -1, 0x1.1p100}) {
            refused("size", x -> new Texture.Checker(Color.BLACK, Color.WHITE, x), bad);
            refused("size", x -> new Texture.Stripes(Color.BLACK, Color.WHITE, x, 0), bad);
        }
        refused("degrees", x -> new Texture.Stripes(Color.BLACK, Color.WHITE, 1, x), Double.NaN);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> plain.withLabel(-1))
                .withMessageContaining("label")
                .withMessageContaining("(got: -1)");
    }

    private static void refused(String name, DoubleFunction<?> make, double bad) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> make.apply(bad))
                .withMessageStartingWith(name + " must be")
                .withMessageEndingWith("(got: " + bad + ")");
    }

    @Test
    void aMemberWithoutAMaterialIsMadeOfItsGroups() {
        Material group = Material.of(Color.BLACK).withLabel(4);
        Material red = Material.of(Color.parse("#ff0000"));
        assertThat(Material.DEFAULT.within(group)).isEqualTo(group);
        assertThat(red.within(Material.DEFAULT)).isSameAs(red);
        assertThat(red.within(group)).isEqualTo(red.withLabel(4));
        assertThat(red.withLabel(5).within(group)).isEqualTo(red.withLabel(5));
    }

    static Object copied(Object value) throws IOException, ClassNotFoundException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(value);
        }
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            return in.readObject();
        }
    }
}
