package robosim.geometry.world.check;

/** Receives the progress of a check, which may take a while. */
@FunctionalInterface
public interface CheckProgress {
    /** Reports that a share of some work is done. */
    void at(String work, long done, long total);
}
