package robosim.geometry.export;

import java.util.HashMap;
import java.util.Map;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;

/** What the objects of a page look like, each look once. A picture on a surface is told as its mean colour. */
final class PageLooks {
    private static final int PLAIN = 0;
    private static final int CHECKER = 1;
    private static final int STRIPES = 2;

    /** Most pixels of a picture whose mean is taken; of a larger one as many, evenly spread. */
    private static final int LOOKED_AT = 1 << 16;

    private final PageQuantization quanta;
    private final PackedStream out;
    private final Map<Material, Integer> known = new HashMap<>();

    PageLooks(PageQuantization quanta, PackedStream out) {
        this.quanta = quanta;
        this.out = out;
    }

    /** The number of a material, which is written at its first use. What only sensors feel makes no difference. */
    int number(Material material) {
        Material seen = material.withReflectance(Material.DEFAULT.reflectance()).withLabel(0);
        Integer number = known.get(seen);
        if (number == null) {
            number = known.size();
            known.put(seen, number);
            write(seen);
        }
        return number;
    }

    private void write(Material material) {
        Texture texture = material.texture();
        Color color = material.color();
        if (texture instanceof ImageTexture image) {
            color = mean(image);
        } else if (texture instanceof Texture.Checker checker) {
            color = checker.first();
        } else if (texture instanceof Texture.Stripes stripes) {
            color = stripes.first();
        }
        double diffuse = material.diffuse();
        color(
                diffuse == 1
                        ? color
                        : Color.ofLinear(
                                diffuse * color.linearRed(),
                                diffuse * color.linearGreen(),
                                diffuse * color.linearBlue()));
        color(material.emission());
        out.octet((int) Math.rint(255 * material.specular()));
        out.octet((int) Math.rint(255 * material.mirror()));
        if (texture instanceof Texture.Checker checker) {
            out.octet(CHECKER);
            color(checker.second());
            out.real(quanta.length(checker.size()));
        } else if (texture instanceof Texture.Stripes stripes) {
            out.octet(STRIPES);
            color(stripes.second());
            out.real(quanta.length(stripes.size()));
            out.real(StrictMath.toRadians(stripes.degrees()));
        } else {
            out.octet(PLAIN);
        }
    }

    private void color(Color color) {
        for (int shift = 16; shift >= 0; shift -= 8) {
            out.octet(color.packed() >> shift);
        }
    }

    /** The mean of a picture's light. */
    private static Color mean(ImageTexture image) {
        double[] sum = new double[3];
        long pixels = (long) image.width() * image.height();
        int taken = (int) Math.min(pixels, LOOKED_AT);
        for (long k = 0; k < taken; k++) {
            long at = k * pixels / taken;
            int pixel = image.pixel((int) (at % image.width()), (int) (at / image.width()));
            for (int channel = 0; channel < 3; channel++) {
                sum[channel] += Color.linear(pixel >> (16 - 8 * channel) & 255);
            }
        }
        return Color.ofLinear(sum[0] / taken, sum[1] / taken, sum[2] / taken);
    }
}
