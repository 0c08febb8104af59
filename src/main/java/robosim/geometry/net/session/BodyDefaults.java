package robosim.geometry.net.session;

import robosim.geometry.dynamics.Body;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;

/** What an object weighs if nobody says so. */
final class BodyDefaults {
    /** kg/m^3: a Pioneer P3-DX is 9 kg in a box of 0.455 x 0.381 x 0.237 m, a TurtleBot3 Burger 1 kg in 0.138 x 0.178 x 0.192 m. */
    private static final double DENSITY = 200;

    private BodyDefaults() {}

    /**
     * A body of a shape; of shapes that {@link Body#ofMass} does not know, that of the box around it.
     *
     * @param mass    kg; 0 for what it weighs at the default density
     * @param inertia kg m^2; 0 for that of the shape
     * @throws IllegalArgumentException if it has no volume, or no width, to work these out from
     */
    static Body of(GeometryObject shape, double mass, double inertia) {
        Body solid = solid(shape, mass);
        return inertia == 0 ? solid : Body.of(solid.mass(), inertia);
    }

    private static Body solid(GeometryObject shape, double mass) {
        if (shape.kind().isSized()) {
            return mass == 0 ? Body.ofDensity(shape, DENSITY) : Body.ofMass(shape, mass);
        }
        Bounds box = shape.bounds();
        double kg = mass == 0 ? DENSITY * box.width() * box.height() * box.length() : mass;
        return Body.of(kg, kg * (box.width() * box.width() + box.length() * box.length()) / 12);
    }
}
