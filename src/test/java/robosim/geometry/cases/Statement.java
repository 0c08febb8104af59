package robosim.geometry.cases;

import robosim.geometry.cases.HardCase.Question;

/** Whether what a file states is what was worked out. */
final class Statement {
    private Statement() {}

    static boolean agrees(Question question, String stated, String truth) {
        if (question instanceof HardCase.Overlap) {
            return stated.equals("apart") == truth.equals("apart");
        }
        if (question instanceof HardCase.Beam beam) {
            return isSame(stated, truth, beam.within());
        }
        if (question instanceof HardCase.Gap gap) {
            return isSame(stated, truth, gap.within());
        }
        if (question instanceof HardCase.Drive drive) {
            return isSame(stated.equals("refused") ? "0.0" : stated, truth, drive.within());
        }
        return stated.equals(truth);
    }

    private static boolean isSame(String stated, String truth, double within) {
        boolean turn = stated.startsWith("turn ");
        if (turn != truth.startsWith("turn ")) {
            return false;
        }
        String number = turn ? stated.substring(5) : stated;
        String exact = turn ? truth.substring(5) : truth;
        return number.equals(exact)
                || (isNumber(number)
                        && isNumber(exact)
                        && Math.abs(Double.parseDouble(number) - Double.parseDouble(exact)) <= within);
    }

    private static boolean isNumber(String text) {
        return !text.equals("miss") && !text.equals("free");
    }
}
