package robosim.geometry.cases;

/** What one variant of a question came to. */
public record Finding(HardCase hard, int question, Variant variant, String truth, String ours, boolean right) {
    @Override
    public String toString() {
        return hard.id() + ", question " + (question + 1) + ", " + variant.name() + ": truth " + truth + ", ours "
                + ours;
    }
}
