package robosim.geometry.viewer.space;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.viewer.draw.Palette;
import robosim.geometry.viewer.scene.Scene;

/**
 * The world that is rendered: that of a viewer, standing on a floor, with a colour for everything that was given no
 * material. It is always SPATIAL. Used by one thread at a time.
 */
final class Stage {
    /** How much larger than its contents the world is along each axis, as room for robots that are put outside. */
    private static final double ROOM = 3;

    /** The thickness of the floor as a share of its size. */
    private static final double FLOOR = 0.01;

    /** Squares of the floor's pattern along its longer side, at least. */
    private static final double SQUARES = 16;

    private @Nullable Snapshot ground;
    private int world;
    private @Nullable Moment last;
    private @Nullable Snapshot shown;

    /** The world at a moment. */
    Snapshot at(Moment moment) {
        Snapshot present = shown;
        if (present != null && last != null && last.looksLike(moment)) {
            return present;
        }
        Snapshot below = ground;
        if (below == null || world != moment.world()) {
            below = ground(moment);
            ground = below;
            world = moment.world();
        }
        Geometry stage = below.toGeometry();
        int number = 0;
        for (Scene.Thing thing : moment.life().things()) {
            Integer colour = thing.colour();
            int own = colour != null ? colour : Palette.robot(number).light();
            stage.addObjectUnchecked(dressed(thing.object(), own));
            number++;
        }
        Snapshot made = stage.snapshot();
        last = moment;
        shown = made;
        return made;
    }

    private static Snapshot ground(Moment moment) {
        GeometryObject floor = floor(moment);
        Bounds all = bounds(moment).and(floor.bounds());
        Geometry stage = new Geometry(
                extent(all.minX(), all.maxX()), extent(all.minY(), all.maxY()), extent(all.minZ(), all.maxZ()));
        for (Scene.Thing thing : moment.statics()) {
            Integer colour = thing.colour();
            int own =
                    colour != null ? colour : Palette.of(thing.object().kind()).light();
            stage.addObjectUnchecked(dressed(thing.object(), own));
        }
        stage.addObjectUnchecked(floor);
        return stage.snapshot();
    }

    /** A world is centred at the origin. */
    private static double extent(double least, double most) {
        return 2 * ROOM * Math.max(Math.abs(least), Math.abs(most));
    }

    private static GeometryObject dressed(GeometryObject object, int colour) {
        return object.material().isDefault()
                ? object.withMaterial(object.material().withColor(Color.ofPacked(colour)))
                : object;
    }

    /** What the world takes up; its border counts only as the outline of its floor. */
    static Bounds bounds(Moment moment) {
        Bounds bounds = null;
        List<Scene.Thing> things = new ArrayList<>(moment.statics());
        things.addAll(moment.life().things());
        for (Scene.Thing thing : things) {
            Bounds own = thing.object().bounds();
            bounds = bounds == null ? own : bounds.and(own);
        }
        Scene.View view = moment.border();
        if (bounds == null) {
            return new Bounds(view.minX(), 0, view.minZ(), view.maxX(), 0, view.maxZ());
        }
        Bounds flat = new Bounds(view.minX(), bounds.minY(), view.minZ(), view.maxX(), bounds.minY(), view.maxZ());
        return bounds.and(flat);
    }

    /** A floor below everything. */
    private static GeometryObject floor(Moment moment) {
        Bounds all = bounds(moment);
        double side = Math.max(all.width(), all.length());
        double thickness = FLOOR * side;
        Point middle = new Point(all.middleX(), all.minY() - thickness / 2, all.middleZ());
        double square = StrictMath.pow(10, Math.floor(StrictMath.log10(side / SQUARES)));
        while (side / square > 4 * SQUARES) {
            square *= 2;
        }
        Material tiles = Material.DEFAULT
                .withSpecular(0)
                .withTexture(new Texture.Checker(Color.parse("#dcd9d2"), Color.parse("#cfcbc2"), square));
        return new BoxObject(middle, all.width(), thickness, all.length()).withMaterial(tiles);
    }

    /** Whether an object that was met is the floor, which is no object of the world. */
    static boolean isFloor(GeometryObject object, Moment moment) {
        return !object.isMoveable() && object.name() == null && object.equals(floor(moment));
    }
}
