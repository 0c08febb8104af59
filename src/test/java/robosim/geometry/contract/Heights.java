package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import robosim.geometry.Geometry;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;

/** In which world a sensor's single rays are asked: sensors that look up or down see a PLANAR world with its heights. */
public final class Heights {
    private Heights() {}

    /** A SPATIAL world with the same objects. */
    public static Geometry of(Geometry world) {
        Geometry twin =
                new Geometry(world.width(), world.height(), world.length(), Dimension.SPATIAL, world.accuracy());
        world.objects()
                .forEach(object -> assertThat(twin.addObjectUnchecked(object)).isTrue());
        return twin;
    }

    /** The world itself for a sonar or a level laser, and where heights count anyhow. */
    public static Geometry seen(Geometry world, String carrier, Pose pose, RayPattern pattern, double width) {
        boolean isFlat = width > 0 || isLevel(world, carrier, pose, pattern);
        return isFlat || world.dimension() == Dimension.SPATIAL ? world : of(world);
    }

    private static boolean isLevel(Geometry world, String carrier, Pose pose, RayPattern pattern) {
        boolean isFan = true;
        for (int beam = 0; beam < pattern.size(); beam++) {
            isFan &= pattern.y(beam) == 0;
        }
        return isFan
                && pose.isUpright()
                && (carrier == null || world.getObject(carrier).pose().isUpright());
    }
}
