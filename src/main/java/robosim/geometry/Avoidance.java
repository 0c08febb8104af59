package robosim.geometry;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.Set;
import robosim.geometry.check.Checks;
import robosim.geometry.engine.World;
import robosim.geometry.engine.objects.IgnoredObjects;

/**
 * What a moving object keeps clear of, and by how much: a margin, and names of objects that do not count, such as the floor
 * it stands on or a tool that it carries, or of layers. A planner keeps one for each robot; together they are its matrix of allowed
 * collisions.
 *
 * <pre>{@code
 * Avoidance careful = Avoidance.margin(0.1);
 * Avoidance standing = Avoidance.ignoring("floor", "ramp").withMargin(0.05);
 * Avoidance.ALL.margin();                // 0.0: everything counts, touching is colliding
 * }</pre>
 *
 * <p>A margin is what the object grows by on all sides, rounded at edges and corners, whatever its shape. It has the
 * guarantees of a clearance ({@link Geometry#moveToContact}): a place keeps it if the distance that {@link
 * Geometry#getProximity} returns there, and that from the world's bounds, are at least the margin.
 *
 * @param margin  world units; at least 0. With 0, touching is colliding
 * @param ignored names of objects that do not count, or of {@linkplain robosim.geometry.model.GeometryObject#layers layers} of
 *                which none does. Each must be in the world of the query; an object comes before a layer of the same name
 */
public record Avoidance(double margin, Set<String> ignored) {
    /** Everything counts, without a margin. */
    public static final Avoidance ALL = new Avoidance(0, Set.of());

    public Avoidance {
        margin = Checks.clearance(margin) + 0.0;
        ignored = Checks.names("ignored", ignored);
    }

    /** Everything counts, with a margin. */
    public static Avoidance margin(double margin) {
        return new Avoidance(margin, Set.of());
    }

    /** Some objects do not count. */
    public static Avoidance ignoring(String... names) {
        return ALL.andIgnoring(Set.of(names));
    }

    /** The same with another margin. */
    public Avoidance withMargin(double other) {
        return new Avoidance(other, ignored);
    }

    /** The same with more objects or layers that do not count. */
    public Avoidance andIgnoring(Collection<String> names) {
        Set<String> all = new LinkedHashSet<>(ignored);
        all.addAll(Checks.present("names", names));
        return new Avoidance(margin, all);
    }

    /** Leaves the ignored objects out of a world's queries, until its {@link IgnoredObjects#clear}. */
    void begin(World world) {
        world.registry.ignore(ignored);
    }
}
