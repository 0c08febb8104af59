package robosim.geometry.junit;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.opentest4j.AssertionFailedError;
import robosim.geometry.Geometry;
import robosim.geometry.check.NumberText;
import robosim.geometry.check.Text;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.Contact;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.collision.Verdict;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.session.FallDetector;
import robosim.geometry.scenario.drive.Nameless;
import robosim.geometry.world.shared.ObjectNames;

/** What robots must never touch, the moves that were refused so far, and what bodies met. */
final class Watches {
    /** The least upward part of the normal of a contact with what carries a robot: it is not steeper than 45 degrees. */
    private static final double CARRIES = Math.sqrt(0.5);

    /** Of the size of a robot: what it stands on is not in it, so that it is free when it is raised by so much. */
    private static final double RAISED = 0x1p-20;

    /** Of a length in a message. */
    private static final int DIGITS = 4;

    private final Geometry geometry;
    private final VirtualClock clock;
    private final List<Refusal> refusals = new ArrayList<>();
    private final List<Watch> watches = new ArrayList<>();

    /**
     * A move that was blocked.
     *
     * @param obstacle the name of what blocked it; null for what has none and for the border of the world
     * @param asked    what was to be done
     * @param blocked  what came of it
     */
    private record Refusal(String mover, @Nullable String obstacle, long step, String asked, String blocked) {
        boolean isOf(String robot) {
            return mover.equals(robot) || robot.equals(obstacle);
        }

        @Nullable
        String other(String robot) {
            return mover.equals(robot) ? obstacle : mover;
        }

        String words(String moment) {
            return asked + moment + " and was " + blocked;
        }
    }

    Watches(Geometry geometry, VirtualClock clock) {
        this.geometry = geometry;
        this.clock = clock;
    }

    /**
     * A robot and what it must not touch: one object, or everything but some objects and what carries the robot, the
     * ground or a floor. Moves and meetings are looked at once.
     */
    private final class Watch {
        private final String robot;
        private final @Nullable String only;
        private final Set<String> except;
        private int refusalsSeen;
        private int meetingsSeen;

        Watch(String robot, @Nullable String only, Set<String> except) {
            this.robot = robot;
            this.only = only;
            this.except = except;
        }

        /** Whether it is about an object; null for one without a name and for the border of the world. */
        private boolean isAbout(@Nullable String other) {
            return only == null ? other == null || !except.contains(other) : only.equals(other);
        }

        private boolean isAbout(Bodies.Meeting meeting) {
            return meeting.isOf(robot) && isAbout(meeting.other(robot)) && (only != null || !isGround(meeting));
        }

        private String moment(long step) {
            return only == null ? time(step) : step(step);
        }

        void check(List<Bodies.Meeting> meetings) {
            for (; refusalsSeen < refusals.size(); refusalsSeen++) {
                Refusal refusal = refusals.get(refusalsSeen);
                if (refusal.isOf(robot) && isAbout(refusal.other(robot))) {
                    throw failure(refusal.words(moment(refusal.step)));
                }
            }
            for (; meetingsSeen < meetings.size(); meetingsSeen++) {
                Bodies.Meeting meeting = meetings.get(meetingsSeen);
                if (isAbout(meeting)) {
                    throw failure((only == null
                                    ? "it met " + other(meeting, robot) + time(meeting.step())
                                    : "they met in step " + meeting.step())
                            + " at " + FailureFormat.point(meeting.contact().point(), 0));
                }
            }
            if (!geometry.hasObject(robot)) {
                return;
            }
            if (only == null) {
                checkAll(geometry.getObject(robot));
            } else if (geometry.hasObject(only)) {
                checkOne(geometry.getObject(robot), geometry.getObject(only));
            }
        }

        private void checkOne(GeometryObject present, GeometryObject other) {
            if (touch(present, other)) {
                throw failure("they touch" + step(clock.steps()) + ": " + FailureFormat.object(present) + " and "
                        + FailureFormat.object(other));
            }
        }

        private void checkAll(GeometryObject present) {
            for (GeometryObject other : geometry.search().touching(present)) {
                if (!robot.equals(other.name()) && isAbout(other.name()) && touch(present, other)) {
                    Contact contact = ContactQuery.contacts(present, other, geometry.dimension(), 1).stream()
                            .findFirst()
                            .orElse(null);
                    if (carries(present, other, contact)) {
                        continue;
                    }
                    throw failure("it touches " + FailureFormat.object(other) + time(clock.steps())
                            + (contact == null
                                    ? ""
                                    : ", at "
                                            + FailureFormat.point(
                                                    contact.point(),
                                                    present.bounds().size()))
                            + "; it stands " + FailureFormat.place(present));
                }
            }
        }

        private AssertionFailedError failure(String words) {
            String what = only != null
                    ? Text.quoted(only)
                    : except.isEmpty()
                            ? "anything"
                            : except.stream().map(Text::quoted).collect(Collectors.joining(", ", "anything but ", ""));
            return new AssertionFailedError(
                    "robot " + Text.quoted(robot) + " must never touch " + what + ", but " + words);
        }
    }

    /** What a body met, for a message. */
    String other(Bodies.Meeting meeting, String name) {
        String other = meeting.other(name);
        if (other == null) {
            FallDetector.Fall fall = meeting.fall();
            return fall != null && fall.isBorder() && Nameless.isGround(geometry, meeting.contact())
                    ? "the lower border of the world after a fall of " + NumberText.digits(fall.drop(), DIGITS)
                            + " (if it should stand on a floor, add one to the world)"
                    : FailureFormat.object(
                            Nameless.at(geometry, meeting.contact().point()));
        }
        return geometry.hasObject(other) ? ObjectNames.kindAndName(geometry.getObject(other)) : Text.quoted(other);
    }

    /** Whether a robot stood on the lower border of the world or on something static, onto which it has not fallen. */
    boolean isGround(Bodies.Meeting meeting) {
        String other = meeting.contact().other();
        return meeting.fall() == null
                && meeting.contact().normal().y() >= CARRIES
                && (other == null || isStatic(other));
    }

    private boolean isStatic(String name) {
        return !geometry.hasObject(name) || !geometry.getObject(name).isMoveable();
    }

    private boolean carries(GeometryObject robot, GeometryObject other, @Nullable Contact contact) {
        Point center = robot.center();
        double up = RAISED * robot.bounds().size();
        GeometryObject raised = robot.movedTo(new Point(center.x(), center.y() + up, center.z()));
        return geometry.dimension() == Dimension.SPATIAL
                && !other.isMoveable()
                && contact != null
                && contact.normal().y() >= CARRIES
                && !touch(raised, other);
    }

    private boolean touch(GeometryObject robot, GeometryObject other) {
        return ContactQuery.decide(robot, other, geometry.dimension(), Budget.UNLIMITED)
                        .answer()
                != Verdict.Answer.NO;
    }

    /** A step of the clock, for a message; empty before the first. */
    private static String step(long step) {
        return step == 0 ? "" : " in step " + step;
    }

    private String time(long step) {
        double seconds = clock.step().multipliedBy(step).toNanos() / 1e9;
        return step == 0 ? "" : step(step) + " (after " + NumberText.digits(seconds, 9) + " s)";
    }

    void refused(String mover, @Nullable String obstacle, String asked, String blocked) {
        refusals.add(new Refusal(mover, obstacle, clock.steps(), asked, blocked));
    }

    /** The robot's last refusal, for a message; empty where there is none. */
    String lastRefusal(String name) {
        for (int k = refusals.size() - 1; k >= 0; k--) {
            if (refusals.get(k).mover.equals(name)) {
                return "; the last that stopped it: " + refusals.get(k).words(step(refusals.get(k).step));
            }
        }
        return "";
    }

    /** Watches two objects, from now on and in what happened so far. */
    void add(String robot, String other, List<Bodies.Meeting> meetings) {
        add(new Watch(robot, other, Set.of()), meetings);
    }

    /** Watches a robot and everything but some objects, from now on and in what happened so far. */
    void add(String robot, Set<String> except, List<Bodies.Meeting> meetings) {
        add(new Watch(robot, null, except), meetings);
    }

    private void add(Watch watch, List<Bodies.Meeting> meetings) {
        watch.check(meetings);
        watches.add(watch);
    }

    void check(List<Bodies.Meeting> meetings) {
        watches.forEach(watch -> watch.check(meetings));
    }
}
