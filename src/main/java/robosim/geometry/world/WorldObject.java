package robosim.geometry.world;

import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject;

/**
 * An object of a world file: the object itself, and data that only viewers and environments use.
 *
 * @param object the object with its name and place, and with its colour as its material unless it has another
 * @param color  for the viewer, {@code #rrggbb} in lower case; where null is given, that of the object's material, and where
 *     this is the default's, null, which leaves it to the viewer
 * @param sonars range sensors; only an object with a name can have any, and no grid
 */
public record WorldObject(GeometryObject object, @Nullable String color, List<SonarRing> sonars) {
    /** Refuses a colour of another form, and sensors of a grid or of an object without a name. */
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
    }

    /** An object in the colour of its material, without sensors. */
    public WorldObject(GeometryObject object) {
        this(object, null, List.of());
    }
}
