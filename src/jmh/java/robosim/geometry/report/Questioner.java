package robosim.geometry.report;

import java.util.List;
import robosim.geometry.cases.Finding;
import robosim.geometry.cases.HardCase;
import robosim.geometry.cases.HardCase.Question;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.reference.Gaps;
import robosim.geometry.reference.Reference;
import robosim.geometry.report.Peer.CannotException;
import robosim.geometry.report.Reply.Kind;

/** Asks another engine the questions of a case in projection, and weighs its answers. */
final class Questioner {
    /** A distance that is off by more than this share of the largest number in the question is called wrong. */
    static final double ALLOWED = 1e-9;

    private static final double NEVER = Double.POSITIVE_INFINITY;

    private final HardCase hard;
    private final Peer peer;

    Questioner(HardCase hard, Peer peer) {
        this.hard = hard;
        this.peer = peer;
    }

    Reply ask(int index, List<Finding> findings) {
        Question question = hard.questions().get(index);
        String truth = findings.stream()
                .filter(finding -> finding.question() == index)
                .filter(finding -> finding.variant().name().equals("planar, as given"))
                .map(Finding::truth)
                .findFirst()
                .orElse(null);
        if (truth == null) {
            return Reply.cannot("a question in space, or about the module alone");
        }
        try {
            return answer(question, truth);
        } catch (CannotException e) {
            return Reply.cannot(String.valueOf(e.getMessage()));
        } catch (RuntimeException e) {
            return new Reply(Kind.WRONG, "throws " + e + " for " + truth);
        }
    }

    private Reply answer(Question question, String truth) throws CannotException {
        if (question instanceof HardCase.Overlap overlap) {
            boolean collides = peer.overlap(outline(overlap.a()), outline(overlap.b()));
            String said = collides ? "collide" : "apart";
            if (said.equals(truth)) {
                return new Reply(Kind.RIGHT, said);
            }
            if (!collides && question.truth().equals("touch") && peer.hasOpenSets()) {
                return new Reply(Kind.DIFFERS, "open sets: " + said + " for " + truth);
            }
            return isCloseCall(overlap, collides)
                    ? new Reply(Kind.DIFFERS, "corners are rounded: " + said + " for " + truth)
                    : new Reply(Kind.WRONG, said + " for " + truth);
        }
        if (question instanceof HardCase.Gap gap) {
            double said = peer.gap(outline(gap.a()), outline(gap.b()));
            return number(said, truth, size(List.of(gap.a(), gap.b())), false);
        }
        if (question instanceof HardCase.Beam beam) {
            return beam(beam, truth);
        }
        if (question instanceof HardCase.Drive drive) {
            return drive(drive, truth);
        }
        throw new CannotException("no words for it");
    }

    private Outline outline(String name) throws CannotException {
        return Outline.of(hard.object(name));
    }

    private Reply beam(HardCase.Beam beam, String truth) throws CannotException {
        if (beam.width() > 0) {
            throw new CannotException("no cones");
        }
        double[] from = {beam.from()[0], beam.from()[2]};
        double[] direction = {beam.direction()[0], beam.direction()[2]};
        double size = Math.max(size(beam.of()), Math.max(Math.abs(from[0]), Math.abs(from[1])));
        double length = Math.min(beam.max(), 8 * size);
        if (length == 0) {
            throw new CannotException("no rays without a length");
        }
        double nearest = NEVER;
        for (String name : beam.of()) {
            nearest = Math.min(nearest, peer.ray(from, direction, length, outline(name)));
        }
        return number(nearest < beam.min() ? beam.min() : nearest, truth, size, isCloseCall(beam, truth));
    }

    private Reply drive(HardCase.Drive drive, String truth) throws CannotException {
        double first = NEVER;
        for (String name : drive.of()) {
            first = Math.min(first, peer.move(outline(drive.mover()), drive, outline(name)));
        }
        String said = first == NEVER ? "free" : Double.toString(first);
        if (touches(drive)) {
            return reply(said.equals(truth), "a start in contact", said, truth);
        }
        String number = truth.startsWith("turn ") ? truth.substring(5) : truth;
        if (number.equals("free") || first == NEVER) {
            return reply(said.equals(number), "", said, truth);
        }
        double off = Math.abs(first - Double.parseDouble(number));
        // The share of a turn is worked out to 2^-20.
        double allowed = truth.startsWith("turn ") ? 0x1p-19 : ALLOWED;
        return reply(off <= allowed, isContact(drive, first) ? "within its tolerance" : "", said, truth);
    }

    /** Whether at a share of the way the mover is no farther from being in touch than the engine declares. */
    private boolean isContact(HardCase.Drive drive, double share) {
        GeometryObject mover = hard.object(drive.mover());
        double[] way = drive.way();
        Point c = mover.center();
        GeometryObject there = mover.movedTo(new Point(c.x() + share * way[0], c.y(), c.z() + share * way[2]))
                .turned(0, share * drive.turn());
        boolean touches = false;
        boolean isApart = false;
        for (GeometryObject other : hard.objects(drive.of())) {
            for (Point place : around(other.center(), 2 * peer.tolerance())) {
                boolean overlaps = Gaps.overlap(there, other.movedTo(place), Dimension.PLANAR);
                touches |= overlaps;
                isApart |= !overlaps;
            }
        }
        return touches && isApart;
    }

    /** Whether corners are rounded and the truth is another one a few roundings aside. */
    private boolean isCloseCall(HardCase.Overlap overlap, boolean said) throws CannotException {
        GeometryObject a = hard.object(overlap.a());
        GeometryObject b = hard.object(overlap.b());
        if (!Outline.of(a).isRounded() && !Outline.of(b).isRounded()) {
            return false;
        }
        double rounding = 4 * Math.ulp(size(List.of(overlap.a(), overlap.b())));
        return around(b.center(), rounding).stream()
                .anyMatch(place -> Gaps.overlap(a, b.movedTo(place), Dimension.PLANAR) == said);
    }

    /** Whether the ray hits or misses otherwise when it starts aside by what the engine declares. */
    private boolean isCloseCall(HardCase.Beam beam, String truth) {
        if (peer.tolerance() == 0) {
            return false;
        }
        double[] d = beam.direction();
        double[] f = beam.from();
        return around(new Point(f[0], f[1], f[2]), peer.tolerance()).stream().anyMatch(place -> {
            Ray ray = new Ray(place, new Point(d[0], d[1], d[2]));
            boolean misses = hard.objects(beam.of()).stream()
                    .allMatch(object -> Reference.distance(ray, object, Dimension.PLANAR) == null);
            return misses != truth.equals("miss");
        });
    }

    private static List<Point> around(Point p, double by) {
        return List.of(
                new Point(p.x() + by, p.y(), p.z()),
                new Point(p.x() - by, p.y(), p.z()),
                new Point(p.x(), p.y(), p.z() + by),
                new Point(p.x(), p.y(), p.z() - by));
    }

    /** A start in contact, whose direction other engines do not look at. */
    private boolean touches(HardCase.Drive drive) throws CannotException {
        for (String name : drive.of()) {
            if (new JtsPeer().gap(outline(drive.mover()), outline(name)) < 1e-12) {
                return true;
            }
        }
        return false;
    }

    private Reply number(double said, String truth, double size, boolean isCloseCall) {
        String text = said == NEVER ? "miss" : Double.toString(said);
        if (truth.equals("0.0") && peer.hasOpenSets() && said != 0) {
            return reply(false, "what a ray starts in or on is not seen", text, truth);
        }
        if (truth.equals("miss") || said == NEVER) {
            return reply(text.equals(truth), isCloseCall ? "within its tolerance" : "", text, truth);
        }
        double off = Math.abs(said - Double.parseDouble(truth));
        return reply(off <= ALLOWED * size, off <= peer.tolerance() ? "within its tolerance" : "", text, truth);
    }

    private static Reply reply(boolean right, String explained, String said, String truth) {
        if (right) {
            return new Reply(Kind.RIGHT, said);
        }
        return explained.isEmpty()
                ? new Reply(Kind.WRONG, said + " for " + truth)
                : new Reply(Kind.DIFFERS, explained + ": " + said + " for " + truth);
    }

    private double size(List<String> names) throws CannotException {
        double most = 0;
        for (String name : names) {
            GeometryObject object = hard.object(name);
            Point c = object.center();
            most = Math.max(most, Math.max(Math.abs(c.x()), Math.abs(c.z())));
            for (Outline.Piece piece : Outline.of(object).pieces()) {
                for (double[] corner : piece.corners()) {
                    most = Math.max(
                            most, Math.max(Math.abs(corner[0]), Math.abs(corner[1])) + Math.max(0, piece.radius()));
                }
            }
        }
        return most;
    }
}
