package robosim.geometry.model;

import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;

/** An object's name, and whether a world may move it; a moveable object always has a name. */
record Tag(@Nullable String name, boolean moveable) {
    static final Tag NONE = new Tag(null, false);

    Tag {
        if (name != null) {
            Checks.name(name);
        } else if (moveable) {
            throw new IllegalArgumentException("name must be given for a moveable object (got: null)");
        }
    }

    static Tag moveable(String name) {
        return new Tag(Checks.name(name), true);
    }

    /** The same under another name. */
    Tag named(String newName) {
        return new Tag(Checks.name(newName), moveable);
    }

    /** The name, if any, and the place, as text for people. */
    String text(Pose pose) {
        return (name == null ? "" : " \"" + name + "\"") + " at " + pose;
    }
}
