package robosim.geometry.cases;

/**
 * What one variant of a question came to.
 *
 * @param isStated whether the truth is what the file states, as it was not worked out
 */
public record Finding(
        HardCase hard, int question, Variant variant, String truth, boolean isStated, String ours, boolean right) {
    @Override
    public String toString() {
        return hard.id() + ", question " + (question + 1) + ", " + variant.name() + ": truth " + truth + ", ours "
                + ours;
    }
}
