package robosim.geometry.world;

import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.world.body.ObjectBody;

/**
 * An object of a world file: the object itself, and data that only viewers and environments use.
 *
 * @param object the object with its name and place, and with its colour as its material unless it has another
 * @param color  for the viewer, {@code #rrggbb} in lower case; where null is given, that of the object's material, and where
 *     this is the default's, null, which leaves it to the viewer
 * @param sonars range sensors; only an object with a name can have any, and no grid
 * @param body   how it moves, of a static object how its surface is; null if nothing is known. Only an object with a name can
 *     have one, and no grid
 * @param attached the name of the moveable object to which this one is attached, where the file has both; null for none
 */
public record WorldObject(
        GeometryObject object,
        @Nullable String color,
        List<SonarRing> sonars,
        @Nullable ObjectBody body,
        @Nullable String attached) {
    /**
     * Refuses a colour of another form, sensors and bodies of a grid or of an object without a name, and a body of a static
     * object that is more than a surface.
     */
    public WorldObject {
        Checks.present("object", object);
        if (color != null) {
            if (!color.matches("#[0-9a-fA-F]{6}")) {
                throw new IllegalArgumentException("color must be # and six hexadecimal digits (got: " + color + ")");
            }
            color = color.toLowerCase(Locale.ROOT);
            if (object.material().isDefault()) {
                object = object.withMaterial(Material.of(Color.parse(color)));
            }
        } else if (!object.material().color().equals(Material.DEFAULT.color())) {
            color = object.material().color().toString();
        }
        sonars = Checks.list("sonars", sonars);
        if (!sonars.isEmpty() && object.kind() == GeometryObject.Kind.GRID) {
            throw new IllegalArgumentException("a grid has no sonars (got: " + object + ")");
        }
        if (!sonars.isEmpty() && object.name() == null) {
            throw new IllegalArgumentException("an object with sonars must have a name (got: " + object + ")");
        }
        if (body != null && (object.name() == null || object.kind() == GeometryObject.Kind.GRID)) {
            throw new IllegalArgumentException(
                    "an object with a body must have a name, and be no grid (got: " + object + ")");
        }
        if (body != null && !object.isMoveable() && !body.isSurface()) {
            throw new IllegalArgumentException("the body of a static object must be its surface alone: restitution,"
                    + " friction and slidingFriction (got: " + body + ")");
        }
        if (attached != null && (!object.isMoveable() || object.kind() == GeometryObject.Kind.GRID)) {
            throw new IllegalArgumentException(
                    "an object that is attached must be moveable, and no grid (got: " + object + ")");
        }
    }

    /** An object that is not attached to another one. */
    public WorldObject(
            GeometryObject object, @Nullable String color, List<SonarRing> sonars, @Nullable ObjectBody body) {
        this(object, color, sonars, body, null);
    }

    /** An object without a body. */
    public WorldObject(GeometryObject object, @Nullable String color, List<SonarRing> sonars) {
        this(object, color, sonars, null);
    }

    /** An object in the colour of its material, without sensors. */
    public WorldObject(GeometryObject object) {
        this(object, null, List.of());
    }
}
