package robosim.geometry.world.shared;

/** A file beyond a limit, which is refused as a whole: leaving out a part of it would not bound what the rest costs. */
public final class LimitProblem extends FileProblem {
    private static final long serialVersionUID = 1;

    public LimitProblem(String source, int line, int column, String problem) {
        super(source, line, column, problem, null);
    }
}
