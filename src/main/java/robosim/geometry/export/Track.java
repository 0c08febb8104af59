package robosim.geometry.export;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Quaternion;

/**
 * The places of one moveable object, from frame to frame.
 *
 * <p>What drives and turns on the floor repeats the same short moves, so a place is told by its move from the place
 * before, in the object's own direction there: one byte if it drives as far as it did the last time it drove, and by how many
 * steps the rounded place differs from where that leads (never more than one along X and Z each). Rounding errors do
 * not add up, as each move is reckoned from the rounded place before. What tips over is told by the differences of its coordinates and of its quaternion.
 */
final class Track {
    /** In the byte of a move: it does not drive; as far as before; as far as told. The last two have nine values each. */
    private static final int STAYS = 0;

    private static final int AGAIN = 1;
    private static final int ANEW = 10;

    /** Its place is told, as no move leads there exactly enough. */
    private static final int LEAPS = 19;

    /** Bits of that byte: the object turns; it rises or sinks. */
    private static final int TURNS = 32;

    private static final int RISES = 64;

    private final List<Integer> frames = new ArrayList<>();
    private final List<Pose> poses = new ArrayList<>();
    private boolean upright = true;

    void add(int frame, Pose pose) {
        frames.add(frame);
        poses.add(pose);
        upright &= pose.isUpright();
    }

    /** Writes all places, the first with its frame; {@code frame} is where the chapter begins. */
    void write(int begin, PageQuantization quanta, PageStreams out) {
        out.tracks.count(2L * poses.size() + (upright ? 1 : 0));
        int before = begin;
        for (int frame : frames) {
            out.times.count(frame - before);
            before = frame;
        }
        if (upright) {
            writeUpright(quanta, out);
        } else {
            writeFree(quanta, out);
        }
    }

    private void writeUpright(PageQuantization quanta, PageStreams out) {
        long x = 0;
        long y = 0;
        long z = 0;
        int turn = 0;
        long ahead = 0;
        long aside = 0;
        for (Pose pose : poses) {
            long toX = PageQuantization.steps(quanta.x(pose.center()));
            long toY = PageQuantization.steps(quanta.y(pose.center()));
            long toZ = PageQuantization.steps(quanta.z(pose.center()));
            int toTurn = PageQuantization.turn(pose.heading());
            int move = STAYS;
            if (toX != x || toZ != z) {
                double cos = PageQuantization.cos(turn);
                double sin = PageQuantization.sin(turn);
                int off = off(toX - x - led(cos, ahead, sin, aside), toZ - z - led(cos, aside, -sin, ahead));
                move = AGAIN + off;
                if (off < 0) {
                    ahead = PageQuantization.round(cos * (toX - x) - sin * (toZ - z));
                    aside = PageQuantization.round(sin * (toX - x) + cos * (toZ - z));
                    out.moves.signed(ahead);
                    out.moves.signed(aside);
                    off = off(toX - x - led(cos, ahead, sin, aside), toZ - z - led(cos, aside, -sin, ahead));
                    move = off < 0 ? LEAPS : ANEW + off;
                }
                if (move == LEAPS) {
                    out.moves.signed(toX);
                    out.moves.signed(toZ);
                }
            }
            out.tracks.octet(move | (toTurn != turn ? TURNS : 0) | (toY != y ? RISES : 0));
            if (toTurn != turn) {
                int by = Math.floorMod(toTurn - turn, PageQuantization.TURN);
                out.turns.signed(by < PageQuantization.TURN / 2 ? by : by - PageQuantization.TURN);
            }
            if (toY != y) {
                out.free.signed(toY - y);
            }
            x = toX;
            y = toY;
            z = toZ;
            turn = toTurn;
        }
    }

    /** How far a move leads along one axis. */
    private static long led(double along, long far, double across, long wide) {
        return PageQuantization.round(along * far + across * wide);
    }

    /** A difference of at most one step along X and Z each, as a number from 0 to 8; negative for a larger one. */
    private static int off(long x, long z) {
        return Math.abs(x) > 1 || Math.abs(z) > 1 ? -1 : (int) (3 * (x + 1) + z + 1);
    }

    private void writeFree(PageQuantization quanta, PageStreams out) {
        long[] before = new long[7];
        Quaternion turned = Quaternion.NONE;
        for (Pose pose : poses) {
            turned = Quaternion.of(pose).towards(turned);
            long[] now = {
                PageQuantization.steps(quanta.x(pose.center())),
                PageQuantization.steps(quanta.y(pose.center())),
                PageQuantization.steps(quanta.z(pose.center())),
                PageQuantization.round(turned.x() * PageQuantization.SPIN),
                PageQuantization.round(turned.y() * PageQuantization.SPIN),
                PageQuantization.round(turned.z() * PageQuantization.SPIN),
                PageQuantization.round(turned.w() * PageQuantization.SPIN)
            };
            for (int k = 0; k < now.length; k++) {
                out.free.signed(now[k] - before[k]);
            }
            before = now;
        }
    }
}
