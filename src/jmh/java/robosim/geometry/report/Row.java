package robosim.geometry.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import robosim.geometry.cases.Finding;
import robosim.geometry.cases.HardCase;
import robosim.geometry.cases.HardCase.Question;
import robosim.geometry.cases.Trial;

/** What the table says of one case. */
record Row(HardCase hard, String family, List<Finding> findings, Map<String, List<Reply>> replies) {

    /** Runs a case here and there. */
    static Row of(HardCase hard, String family, List<Peer> peers) {
        List<Finding> findings = Trial.run(hard);
        Map<String, List<Reply>> replies = new LinkedHashMap<>();
        for (Peer peer : peers) {
            Questioner questioner = new Questioner(hard, peer);
            List<Reply> said = new ArrayList<>();
            for (int k = 0; k < hard.questions().size(); k++) {
                said.add(questioner.ask(k, findings));
            }
            replies.put(peer.name(), said);
        }
        return new Row(hard, family, findings, replies);
    }

    /** One line a question: what is asked, and what is true. */
    List<String> questions() {
        List<String> lines = new ArrayList<>();
        for (int k = 0; k < hard.questions().size(); k++) {
            String inSpace = truth(k, "as given");
            String inPlane = truth(k, "planar, as given");
            boolean differs = inSpace != null && inPlane != null && !isSame(inSpace, inPlane);
            String how = hard.questions().get(k).how();
            lines.add(text(hard.questions().get(k))
                    + (differs ? "; in projection " + inPlane : "")
                    + (how.equals(HardCase.RECOMPUTED) || how.equals("by contract") ? "" : " (" + how + ")"));
        }
        return lines;
    }

    private static boolean isSame(String a, String b) {
        boolean numbers = Character.isDigit(a.charAt(0)) && Character.isDigit(b.charAt(0));
        return a.equals(b) || (numbers && Math.abs(Double.parseDouble(a) / Double.parseDouble(b) - 1) < 1e-12);
    }

    private @Nullable String truth(int question, String variant) {
        return findings.stream()
                .filter(finding -> finding.question() == question)
                .filter(finding -> finding.variant().name().equals(variant))
                .map(Finding::truth)
                .findFirst()
                .orElse(null);
    }

    private static String text(Question question) {
        String truth = question.truth();
        if (question instanceof HardCase.Overlap overlap) {
            return overlap.a() + ", " + overlap.b() + ": " + truth;
        }
        if (question instanceof HardCase.Gap gap) {
            return gap.a() + ", " + gap.b() + " apart by " + truth;
        }
        if (question instanceof HardCase.Beam beam) {
            return (beam.width() > 0 ? "cone of " + number(beam.width()) + " degrees: " : "ray: ") + truth;
        }
        if (question instanceof HardCase.Drive drive) {
            return "move of " + drive.mover() + ": " + truth;
        }
        if (question instanceof HardCase.Spin spin) {
            return spin.times() + " turns of " + number(spin.degrees()) + " degrees: " + truth;
        }
        if (question instanceof HardCase.Scan scan) {
            return "scan of " + scan.count() + " rays: " + truth;
        }
        return "refused, naming " + truth;
    }

    private static String number(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }

    long wrong() {
        return findings.stream().filter(finding -> !finding.right()).count();
    }

    /** How many variants of all questions are right. */
    String ours() {
        return (findings.size() - wrong()) + " of " + findings.size() + " right";
    }

    /** What another engine's replies come to. */
    List<String> theirs(String peer) {
        List<Reply> said = replies.get(peer);
        List<String> lines = new ArrayList<>();
        long right =
                said.stream().filter(reply -> reply.kind() == Reply.Kind.RIGHT).count();
        if (right > 0) {
            lines.add(right + " of " + said.size() + " right");
        }
        lines.addAll(grouped(said, Reply.Kind.WRONG, "wrong"));
        lines.addAll(grouped(said, Reply.Kind.DIFFERS, "meaning differs"));
        lines.addAll(grouped(said, Reply.Kind.CANNOT, "cannot express"));
        return lines;
    }

    private static List<String> grouped(List<Reply> said, Reply.Kind kind, String word) {
        Map<String, List<Integer>> numbers = new LinkedHashMap<>();
        for (int k = 0; k < said.size(); k++) {
            if (said.get(k).kind() == kind) {
                numbers.computeIfAbsent(said.get(k).text(), text -> new ArrayList<>())
                        .add(k + 1);
            }
        }
        List<String> lines = new ArrayList<>();
        numbers.forEach((text, of) -> lines.add(word
                + (of.size() == said.size()
                        ? ": "
                        : " (" + of.stream().map(String::valueOf).collect(Collectors.joining(", ")) + "): ")
                + text));
        return lines;
    }

    long count(String peer, Reply.Kind kind) {
        return replies.get(peer).stream().filter(reply -> reply.kind() == kind).count();
    }
}
