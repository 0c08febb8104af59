package robosim.geometry.dynamics.step;

/** What drives do when a collision has taken speed from the bodies that they drive. */
@FunctionalInterface
public interface Pushes {
    /**
     * Lets the drive of a body use what it has left of its acceleration; answers whether the velocity has changed.
     *
     * @param body  the index of the body
     * @param angle by how much it has turned since the run began, radians
     */
    boolean push(int body, double angle);
}
