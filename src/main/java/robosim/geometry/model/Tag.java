package robosim.geometry.model;

import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;
import robosim.geometry.material.Material;

/** An object's name, whether a world may move it, and its material; a moveable object always has a name. */
record Tag(@Nullable String name, boolean moveable, Material material) {
    static final Tag NONE = new Tag(null, false, Material.DEFAULT);

    Tag {
        if (name != null) {
            Checks.name(name);
        } else if (moveable) {
            throw new IllegalArgumentException("name must be given for a moveable object (got: null)");
        }
        Checks.present("material", material);
    }

    Tag(@Nullable String name, boolean moveable) {
        this(name, moveable, Material.DEFAULT);
    }

    /** The same as one that a world may move. */
    Tag moveable(String newName) {
        return new Tag(Checks.name(newName), true, material);
    }

    /** The same under another name. */
    Tag named(String newName) {
        return new Tag(Checks.name(newName), moveable, material);
    }

    /** The same of another material. */
    Tag of(Material newMaterial) {
        return new Tag(name, moveable, newMaterial);
    }

    /** The name, if any, and the place, as text for people. */
    String text(Pose pose) {
        return (name == null ? "" : " \"" + name + "\"") + " at " + pose;
    }
}
