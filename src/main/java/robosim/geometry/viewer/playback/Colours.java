package robosim.geometry.viewer.playback;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/**
 * The colours that a world file gives its objects. An object with a name keeps its colour wherever it moves and
 * whatever else changes; one without is identified by all its properties but its material, which
 * a session may leave out.
 */
public final class Colours {
    public static final Colours NONE = new Colours();

    private final Map<String, Integer> named = new HashMap<>();
    private final Map<GeometryObject, Integer> nameless = new HashMap<>();

    private Colours() {}

    /** Those of a world's objects; none without a world. */
    public static Colours of(@Nullable World world) {
        Colours colours = new Colours();
        for (Scene.Thing thing : world == null ? List.<Scene.Thing>of() : things(world)) {
            String name = thing.object().name();
            Integer colour = thing.colour();
            if (colour != null && name != null) {
                colours.named.put(name, colour);
            } else if (colour != null) {
                colours.nameless.put(thing.object().withMaterial(Material.DEFAULT), colour);
            }
        }
        return colours;
    }

    /** The objects of a world, each with the colour that its file gives it. */
    static List<Scene.Thing> things(World world) {
        List<Scene.Thing> things = new ArrayList<>();
        for (WorldObject object : world.objects()) {
            String color = object.color();
            Integer colour = color == null ? null : Integer.valueOf(color.substring(1), 16);
            things.add(new Scene.Thing(object.object(), colour));
        }
        return things;
    }

    /** The colour 0xRRGGBB; null if the file has none for the object. */
    @Nullable
    public Integer of(GeometryObject object) {
        String name = object.name();
        return name != null ? named.get(name) : nameless.get(object.withMaterial(Material.DEFAULT));
    }
}
