package robosim.geometry.report;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.report.Reply.Kind;

/** The figures over all cases. */
record Summary(int cases, int questions, int variants, long wrong, List<String> peers) {
    static Summary of(List<Row> rows, List<Peer> peers) {
        int questions =
                rows.stream().mapToInt(row -> row.hard().questions().size()).sum();
        int variants = rows.stream().mapToInt(row -> row.findings().size()).sum();
        List<String> lines = new ArrayList<>();
        for (Peer peer : peers) {
            lines.add(peer.name() + " " + peer.version() + ": of "
                    + (questions - count(rows, peer, Kind.CANNOT))
                    + " questions that it has words for, "
                    + count(rows, peer, Kind.RIGHT) + " right, "
                    + count(rows, peer, Kind.WRONG) + " wrong, "
                    + count(rows, peer, Kind.DIFFERS) + " of another meaning");
        }
        long wrong = rows.stream().mapToLong(Row::wrong).sum();
        return new Summary(rows.size(), questions, variants, wrong, lines);
    }

    private static long count(List<Row> rows, Peer peer, Kind kind) {
        return rows.stream().mapToLong(row -> row.count(peer.name(), kind)).sum();
    }

    String line() {
        return cases + " cases, " + questions + " questions, " + variants + " variants: " + wrong + " wrong here. "
                + String.join(". ", peers) + ".";
    }

    /** What a reader must know to read the table fairly. */
    static List<String> notes() {
        return List.of(
                "Truth is worked out from the stored numbers by exact rational arithmetic that shares no code with the"
                        + " module; the few that are stated by hand say so in their file.",
                "This module's sets are closed: what touches collides. A world, CollisionDetection and ContactQuery must agree."
                        + " Each question is asked as given, in the other order,"
                        + " times 2^-40 to 2^40 and far from the origin, in space and in projection; the column counts them"
                        + " all. A distance is right within the bound that the module states for its shape, and a start"
                        + " of a move in contact by its direction.",
                "JTS and dyn4j know the plane only and are asked the projected question, as given and once; corners of"
                        + " turned boxes are rounded to doubles for them. A distance of theirs is called wrong where it is"
                        + " off by more than 1e-9 of the largest number in the question.",
                "Meaning differs: dyn4j's sets are open, so that what touches does not collide there, its rays do not see"
                        + " what they start in, its distances and times keep a declared tolerance (6e-6), and it does not look at the"
                        + " direction of what starts in contact. JTS's sets are closed; a disc is a point and a distance"
                        + " there, and it has no moves.",
                "Reported elsewhere is what the source says, of the version that it says; it was not run here.");
    }
}
