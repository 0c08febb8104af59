package robosim.geometry.material;

import java.io.Serial;
import java.io.Serializable;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;

/**
 * What a surface looks like, and what sensors feel of it: an immutable value.
 *
 * <p>Light that meets a surface is treated after Phong: {@code diffuse} of it is scattered in all directions in the
 * surface's colour, {@code specular} of it makes a highlight around the mirrored direction, the smaller the larger {@code
 * shininess} is. {@code mirror} is the share of what is seen that comes from the mirrored direction instead of the surface
 * itself. {@code emission} is light that the surface gives of its own.
 *
 * @param color       the colour of what is scattered; a texture takes its place
 * @param diffuse     the share of light that is scattered in all directions, from 0 to 1
 * @param specular    the share of light that makes a highlight, from 0 to 1
 * @param shininess   the exponent of the highlight, from 1 to {@link #MOST_SHININESS}; a greater one makes it smaller
 * @param mirror      the share of what is seen that comes from the mirrored direction, from 0 to 1
 * @param emission    the light that the surface gives of its own; black for none. It lights nothing else
 * @param texture     the pattern that takes the place of the colour; null for none
 * @param reflectance the share of a lidar's pulse that is scattered back at right angles, from 0 to 1
 * @param label       what a segmentation camera sees in its place, at least 0; 0 for none
 */
public record Material(
        Color color,
        double diffuse,
        double specular,
        double shininess,
        double mirror,
        Color emission,
        @Nullable Texture texture,
        double reflectance,
        int label)
        implements Serializable {
    /** The greatest shininess: a highlight that is narrower than a pixel. */
    public static final double MOST_SHININESS = 1e6;

    /** Of an object that was given no material: matt, light grey, reflectance 0.5, no label. */
    public static final Material DEFAULT =
            new Material(new Color(0.8, 0.8, 0.8), 1, 0.1, 16, 0, Color.BLACK, null, 0.5, 0);

    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses null, and numbers that are out of range. */
    public Material {
        Checks.present("color", color);
        diffuse = Checks.share("diffuse", diffuse);
        specular = Checks.share("specular", specular);
        if (!(shininess >= 1 && shininess <= MOST_SHININESS)) { // written so that NaN fails it
            throw new IllegalArgumentException("shininess must be a number from 1 to 1000000 (got: " + shininess + ")");
        }
        mirror = Checks.share("mirror", mirror);
        Checks.present("emission", emission);
        reflectance = Checks.share("reflectance", reflectance);
        if (label < 0) {
            throw new IllegalArgumentException("label must be at least 0, which is none (got: " + label + ")");
        }
    }

    /** {@link #DEFAULT} in another colour. */
    public static Material of(Color color) {
        return DEFAULT.withColor(color);
    }

    /** This material in another colour. */
    public Material withColor(Color newColor) {
        return new Material(newColor, diffuse, specular, shininess, mirror, emission, texture, reflectance, label);
    }

    /** This material with another share of scattered light, from 0 to 1. */
    public Material withDiffuse(double share) {
        return new Material(color, share, specular, shininess, mirror, emission, texture, reflectance, label);
    }

    /** This material with another share of light in its highlight, from 0 to 1. */
    public Material withSpecular(double share) {
        return new Material(color, diffuse, share, shininess, mirror, emission, texture, reflectance, label);
    }

    /** This material with another exponent of its highlight, from 1 to {@link #MOST_SHININESS}. */
    public Material withShininess(double exponent) {
        return new Material(color, diffuse, specular, exponent, mirror, emission, texture, reflectance, label);
    }

    /** This material with another share of mirrored light, from 0 to 1. */
    public Material withMirror(double share) {
        return new Material(color, diffuse, specular, shininess, share, emission, texture, reflectance, label);
    }

    /** This material with another light of its own. */
    public Material withEmission(Color light) {
        return new Material(color, diffuse, specular, shininess, mirror, light, texture, reflectance, label);
    }

    /** This material with a pattern in place of its colour, or without one if null. */
    public Material withTexture(@Nullable Texture pattern) {
        return new Material(color, diffuse, specular, shininess, mirror, emission, pattern, reflectance, label);
    }

    /** This material with another reflectance for lidars, from 0 to 1. */
    public Material withReflectance(double share) {
        return new Material(color, diffuse, specular, shininess, mirror, emission, texture, share, label);
    }

    /** This material with another label, at least 0. */
    public Material withLabel(int newLabel) {
        return new Material(color, diffuse, specular, shininess, mirror, emission, texture, reflectance, newLabel);
    }

    /** Whether this is what an object has that was given no material. */
    public boolean isDefault() {
        return equals(DEFAULT);
    }

    /**
     * What a member of a group is made of: the group's material where this is the default, and this one otherwise, with the
     * group's label where it has none.
     *
     * @param group the material of the group, itself after that of the group around it
     */
    public Material within(Material group) {
        if (isDefault()) {
            return Checks.present("group", group);
        }
        return label == 0 && group.label != 0 ? withLabel(group.label) : this;
    }

    /** The colour or the pattern, and all that differs from {@link #DEFAULT}. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder(texture == null ? color.toString() : texture.toString());
        tell(text, "diffuse", diffuse, DEFAULT.diffuse);
        tell(text, "specular", specular, DEFAULT.specular);
        tell(text, "shininess", shininess, DEFAULT.shininess);
        tell(text, "mirror", mirror, DEFAULT.mirror);
        if (!emission.equals(DEFAULT.emission)) {
            text.append(", emission ").append(emission);
        }
        tell(text, "reflectance", reflectance, DEFAULT.reflectance);
        if (label != 0) {
            text.append(", label ").append(label);
        }
        return text.toString();
    }

    private static void tell(StringBuilder text, String what, double value, double usual) {
        if (value != usual) {
            text.append(", ").append(what).append(' ').append(value);
        }
    }

    /** All classes of this package that a serialized object may contain, for an allow-list. */
    public static Set<Class<?>> serialClasses() {
        return Set.of(Color.class, Form.class, Texture.Checker.class, Texture.Stripes.class, ImageTexture.Form.class);
    }

    @Serial
    private Object writeReplace() {
        return new Form(color, diffuse, specular, shininess, mirror, emission, texture, reflectance, label);
    }

    /** The serialized form. */
    record Form(
            Color color,
            double diffuse,
            double specular,
            double shininess,
            double mirror,
            Color emission,
            @Nullable Texture texture,
            double reflectance,
            int label)
            implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        @Serial
        private Object readResolve() {
            return new Material(color, diffuse, specular, shininess, mirror, emission, texture, reflectance, label);
        }
    }
}
