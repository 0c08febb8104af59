package robosim.geometry.world.check;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.world.World;

/** One setting, with its answers. */
final class SettingTally {
    final Dimension dimension;
    final Accuracy accuracy;
    final Geometry geometry;
    int places;
    int placesOtherwise;
    int moves;
    int movesOtherwise;
    int distances;
    int distancesOtherwise;
    double shortest;

    SettingTally(World world, Dimension dimension, Accuracy accuracy) {
        this.dimension = dimension;
        this.accuracy = accuracy;
        geometry = new Geometry(world.width(), world.height(), world.length(), dimension, accuracy);
        world.objects().forEach(object -> geometry.addObjectUnchecked(object.object()));
    }

    boolean hasFailed() {
        return placesOtherwise + movesOtherwise + distancesOtherwise > 0;
    }

    SettingComparison setting() {
        return new SettingComparison(
                dimension,
                accuracy,
                places,
                placesOtherwise,
                moves,
                movesOtherwise,
                distances,
                distancesOtherwise,
                shortest);
    }

    /** All settings, with a world for each and no answers yet. */
    static List<SettingTally> all(World world) {
        List<SettingTally> tallies = new ArrayList<>();
        for (Dimension dimension : Dimension.values()) {
            for (Accuracy accuracy : Accuracy.values()) {
                tallies.add(new SettingTally(world, dimension, accuracy));
            }
        }
        return tallies;
    }
}
