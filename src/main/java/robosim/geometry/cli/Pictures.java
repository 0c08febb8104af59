package robosim.geometry.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import robosim.geometry.viewer.Scene;
import robosim.geometry.world.Unit;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** From world files to what the painter draws. */
final class Pictures {
    private Pictures() {}

    /** A world as its file has it. */
    static Scene of(World world, String title) {
        List<Scene.Thing> things = new ArrayList<>();
        for (WorldObject object : world.objects()) {
            things.add(new Scene.Thing(object.object(), colour(object)));
        }
        String subtitle = things.size()
                + (things.size() == 1 ? " object, " : " objects, ")
                + world.dimension().name().toLowerCase(Locale.ROOT);
        return Scene.of(title, view(world, things), things).described(subtitle, unit(world));
    }

    /** The whole world; where its objects fill less than a quarter of it, only what holds them. */
    private static Scene.View view(World world, List<Scene.Thing> things) {
        Scene.View around =
                Scene.View.around(things.stream().map(Scene.Thing::object).toList());
        double across = around.maxX() - around.minX();
        double down = around.maxZ() - around.minZ();
        boolean whole = world.width() > 0 && world.length() > 0 && across * down * 4 >= world.width() * world.length();
        return whole || things.isEmpty() ? Scene.View.world(world.width(), world.length()) : around;
    }

    static String unit(World world) {
        Unit unit = world.unit();
        return unit == null ? "" : unit.symbol();
    }

    static @Nullable Integer colour(WorldObject object) {
        String color = object.color();
        return color == null ? null : Integer.valueOf(color.substring(1), 16);
    }

    /** The name of a file without its folder and ending. */
    static String title(Path file) {
        Path name = file.getFileName();
        return name == null ? file.toString() : name.toString().replaceFirst("\\.[^.]*$", "");
    }
}
