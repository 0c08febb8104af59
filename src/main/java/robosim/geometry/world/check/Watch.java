package robosim.geometry.world.check;

/** Told how far a check is; it may take a while. */
@FunctionalInterface
public interface Watch {
    /** So much of that work is done. */
    void at(String work, long done, long total);
}
