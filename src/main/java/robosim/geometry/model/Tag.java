package robosim.geometry.model;

import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;

/** What an object is called, and whether a world may move it; what is moveable has a name. */
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

    /** For people: the name, if any, and the place. */
    String text(Pose pose) {
        return (name == null ? "" : " \"" + name + "\"") + " at " + pose;
    }
}
