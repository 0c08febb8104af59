package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Right and wrong verdicts by the size of the true gap: how wide a gap can be and still not be told apart. */
final class Wrongs {
    /** Neighbours in size that are judged together. */
    private static final int WINDOW = 40;

    private record Verdict(double gap, boolean isWrong) {}

    private final List<Verdict> verdicts = new ArrayList<>();

    /** Exact touch is left out. */
    void add(double gap, boolean isWrong) {
        if (gap != 0) {
            verdicts.add(new Verdict(gap, isWrong));
        }
    }

    /**
     * The widest gap or depth that is told wrong among 40 neighbours in size of which more than a share are; 0 where none
     * is.
     */
    double widest(double mostWrong) {
        return Math.max(widest(mostWrong, 1), widest(mostWrong, -1));
    }

    private double widest(double mostWrong, int sign) {
        List<Verdict> side = verdicts.stream()
                .filter(verdict -> Math.signum(verdict.gap) == sign)
                .sorted(Comparator.comparingDouble(verdict -> -Math.abs(verdict.gap)))
                .toList();
        int window = Math.min(WINDOW, side.size());
        int wrong = 0;
        for (int k = 0; k < side.size(); k++) {
            wrong += side.get(k).isWrong ? 1 : 0;
            if (k >= window && side.get(k - window).isWrong) {
                wrong--;
            }
            if (k >= window - 1 && wrong > mostWrong * window) {
                return firstWrong(side.subList(k - window + 1, k + 1));
            }
        }
        return 0;
    }

    private static double firstWrong(List<Verdict> window) {
        return window.stream()
                .filter(Verdict::isWrong)
                .mapToDouble(verdict -> Math.abs(verdict.gap))
                .findFirst()
                .orElseThrow();
    }
}
