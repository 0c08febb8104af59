package robosim.geometry;

import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.motion.Carrier;
import robosim.geometry.engine.motion.Motion;
import robosim.geometry.engine.motion.Separation;
import robosim.geometry.engine.motion.Slide;
import robosim.geometry.engine.motion.TranslationFastPath;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.Scratch;

/** Carries out the moves of a world, for an object that has been looked up: the fast path first, then the sweep. */
final class GeometryMoves {
    private final Dimension dimension;
    private final ObjectRegistry registry;
    private final ObjectTable objects;
    private final AccuracyView view;
    private final Motion motion;
    private final TranslationFastPath fastPath;
    private @Nullable Slide slide;
    private final double[] vector = new double[6];
    private @Nullable Carrier carrier;

    GeometryMoves(Dimension dimension, ObjectRegistry registry, Motion motion, Scratch scratch) {
        this.dimension = dimension;
        this.registry = registry;
        this.motion = motion;
        objects = registry.objects;
        view = registry.view;
        fastPath = new TranslationFastPath(objects, registry.worldBounds, scratch);
    }

    /** What moves objects by their ids, made when it is first asked for. */
    Carrier carrier() {
        Carrier made = carrier == null ? new Carrier(registry, motion, fastPath) : carrier;
        carrier = made;
        return made;
    }

    /** See {@link Geometry#simpleMove}. */
    boolean straight(int id, double x, double y, double z) {
        objects.toWorld(id, Checks.coordinate("x", x), Checks.coordinate("y", y), Checks.coordinate("z", z), vector);
        int verdict = stride(id, vector[0], vector[1], vector[2]);
        return verdict == TranslationFastPath.UNKNOWN
                ? commitIf(id, motion.allows(view, id, vector[0], vector[1], vector[2]))
                : verdict == TranslationFastPath.FREE;
    }

    /** Makes a straight move if the fast path finds it free. */
    private int stride(int id, double dx, double dy, double dz) {
        int verdict = fastPath.ask(view, id, dx, dy, dz);
        if (verdict == TranslationFastPath.FREE) {
            registry.shift(id, fastPath.end());
        }
        return verdict;
    }

    /** See {@link Geometry#simpleTurn}. */
    boolean turn(int id, double degrees) {
        Checks.angle("degrees", degrees);
        return commitIf(id, motion.allowsTurn(view, id, degrees));
    }

    private boolean commitIf(int id, boolean free) {
        if (free) {
            registry.move(id, motion.end());
        }
        return free;
    }

    /** See {@link Geometry#move}. */
    MoveResult own(int id, Move asked) {
        objects.toWorld(id, asked.x(), asked.y(), asked.z(), vector);
        double rx = asked.rx();
        double ry = asked.ry();
        boolean isMade = rx == 0 && ry == 0 && stride(id, vector[0], vector[1], vector[2]) == TranslationFastPath.FREE;
        return result(isMade || commitIf(id, motion.attemptOwn(view, id, asked.x(), asked.y(), asked.z(), rx, ry, 0)));
    }

    /** See {@link Geometry#moveGlobal}. */
    MoveResult global(int id, Move asked) {
        double rx = dimension == Dimension.PLANAR ? 0 : asked.rx();
        double ry = asked.ry();
        boolean isMade = rx == 0 && ry == 0 && stride(id, asked.x(), asked.y(), asked.z()) == TranslationFastPath.FREE;
        return result(
                isMade || commitIf(id, motion.attempt(view, id, asked.x(), asked.y(), asked.z(), rx, ry, true, 0)));
    }

    /** See {@link Geometry#moveToContact}. */
    MoveResult toContact(int id, Move asked, double clearance) {
        Checks.clearance(clearance);
        boolean all = motion.attemptOwn(view, id, asked.x(), asked.y(), asked.z(), asked.rx(), asked.ry(), clearance);
        MoveResult result = result(all);
        registry.move(id, motion.end());
        return result;
    }

    /** Made when it is first asked for, as many worlds slide nothing. */
    private Slide slide() {
        Slide made = slide == null ? new Slide(registry, motion) : slide;
        slide = made;
        return made;
    }

    /** See {@link Geometry#moveAndSlide(String, Move, SlideOptions)}. */
    SlideResult sliding(int id, Move asked, SlideOptions options) {
        objects.toWorld(id, asked.x(), asked.y(), asked.z(), vector);
        Slide made = slide();
        made.set(options.clearance(), options.bends(), options.stepHeight(), options.maxSlope(), options.snap());
        made.make(view, id, vector, asked.rx(), asked.ry());
        return SlideResult.of(made, objects);
    }

    /** See {@link Geometry#separate}. */
    @Nullable
    Point separate(int id, double max) {
        return new Separation(registry, motion, slide()).find(view, id, max, vector)
                ? new Point(vector[0], vector[1], vector[2])
                : null;
    }

    private MoveResult result(boolean allowed) {
        if (allowed) {
            return new MoveResult(true, 1, 1, null, null, null);
        }
        motion.contact(vector);
        int obstacle = motion.obstacle();
        return new MoveResult(
                false,
                motion.fraction(),
                motion.turnFraction(),
                obstacle >= 0 ? objects.present(obstacle) : null,
                new Point(vector[0], vector[1], vector[2]),
                new Point(vector[3], vector[4], vector[5]));
    }
}
