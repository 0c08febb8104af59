package robosim.geometry.sensor;

import java.util.EnumSet;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.sensor.effects.Surfaces;

/** A turn of a {@link Lidar}: ranges, rings and times, and where they are wanted intensities and objects. */
public final class LidarFrame extends RayFrame {
    /** What a frame may take beside ranges, rings and times. */
    public enum Extra {
        /** How much light comes back: see {@link LidarFrame#intensity}. */
        INTENSITIES,
        /** What each ray met: see {@link LidarFrame#object}. */
        OBJECTS
    }

    private final EnumSet<Extra> extras = EnumSet.noneOf(Extra.class);
    private double[] intensities = new double[0];
    private @Nullable Lidar lidar;
    private final Surfaces surfaces = new Surfaces();

    /** A frame for ranges, rings and times, and more. */
    public LidarFrame(Extra... extras) {
        for (Extra extra : Checks.present("extras", extras)) {
            this.extras.add(Checks.present("extra", extra));
        }
    }

    boolean has(Extra extra) {
        return extras.contains(extra);
    }

    void finish(Lidar by) {
        lidar = by;
        if (!has(Extra.INTENSITIES)) {
            return;
        }
        int count = rays().size();
        if (intensities.length < count) {
            intensities = new double[count];
        }
        double[] cosines = incidence();
        for (int k = 0; k < count; k++) {
            boolean isLit = isMeasured(k) && cosines[k] > 0;
            GeometryObject met = buffer().object(k);
            intensities[k] = isLit && met != null ? cosines[k] * reflectance(met, buffer().part(k)) : 0;
        }
    }

    private double reflectance(GeometryObject object, int part) {
        return surfaces.of(object, part).reflectance();
    }

    /** The layer of a ray, from 0; in the presets the lowest one is 0. */
    public int ring(int ray) {
        return checked(ray) / columns();
    }

    /** Seconds from the start of the turn until a ray was sent. */
    public double time(int ray) {
        return Checks.present("lidar", lidar).time(checked(ray));
    }

    /**
     * How much light comes back: the {@linkplain robosim.geometry.material.Material#reflectance reflectance} of the surface
     * times the cosine of the angle between the ray and the surface normal; 0 where the ray has {@linkplain #hasPoint no point}. Like the calibrated
     * intensities of real lidars it does not fall off with the distance.
     */
    public double intensity(int ray) {
        checkHas(Extra.INTENSITIES);
        return intensities[checked(ray)];
    }

    /** All intensities: the frame's own array, as with {@link #ranges}. */
    public double[] intensities() {
        checkHas(Extra.INTENSITIES);
        return intensities;
    }

    /** The object that a ray met, noise aside; null for none. See {@link robosim.geometry.SenseBuffer#object}. */
    public @Nullable GeometryObject object(int ray) {
        checkHas(Extra.OBJECTS);
        return metBy(ray);
    }

    /** Which part of a group a ray met, noise aside. See {@link robosim.geometry.SenseBuffer#part}. */
    public int part(int ray) {
        checkHas(Extra.OBJECTS);
        return buffer().part(checked(ray));
    }

    /**
     * The {@linkplain robosim.geometry.material.Material#label label} of the surface that a ray met, noise aside; 0 for none.
     */
    public int label(int ray) {
        GeometryObject met = object(ray);
        return met == null ? 0 : surfaces.of(met, part(ray)).label();
    }

    private void checkHas(Extra extra) {
        if (!has(extra)) {
            throw new IllegalArgumentException("the frame must have been made for " + extra
                    + ", as by new LidarFrame(Extra." + extra + ") (got: none)");
        }
    }

    @Override
    double field(PointCloud.Field field, int ray) {
        if (field == PointCloud.Field.INTENSITY) {
            return intensity(ray);
        }
        if (field == PointCloud.Field.LABEL) {
            return label(ray);
        }
        return field == PointCloud.Field.TIME ? time(ray) : super.field(field, ray);
    }
}
