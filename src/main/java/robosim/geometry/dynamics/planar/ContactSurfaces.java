package robosim.geometry.dynamics.planar;

/** How the objects of a world bounce and rub, by their ids; -1 is the border. */
public interface ContactSurfaces {
    /** The share of the speed of approach that is left. */
    double restitution(int object);

    /** The coefficient of friction while nothing slides. */
    double staticFriction(int object);

    /** The coefficient of friction while it slides. */
    double slidingFriction(int object);

    /** The restitution of a contact, of those of two objects. */
    double mixRestitution(double a, double b);

    /** The friction of a contact, static or sliding, of those of two objects. */
    double mixFriction(double a, double b);
}
