package robosim.geometry.contract;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Predicate;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.RayHit;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** Random questions and changes, the same for every world they are asked of, and each answer to the last bit as a line. */
final class Script {
    private final SplittableRandom random;
    private final RandomObjects objects;
    private final List<String> names = new ArrayList<>();
    private final List<String> movers = new ArrayList<>();
    private final List<String> answers = new ArrayList<>();
    private final Geometry world;
    private final List<Accuracy> levels;
    private final Predicate<GeometryObject> isNamed;

    private Script(
            Geometry world,
            long seed,
            double spread,
            double rise,
            List<Accuracy> levels,
            Predicate<GeometryObject> isNamed) {
        this.world = world;
        this.levels = levels;
        this.isNamed = isNamed;
        random = new SplittableRandom(seed);
        objects = new RandomObjects(random, spread, rise);
        for (GeometryObject object : world.objects()) {
            String name = object.name();
            if (name != null) {
                names.add(name);
                if (object.isMoveable()) {
                    movers.add(name);
                }
            }
        }
    }

    /** Carries out so many questions and changes; answers a line for each, and one for each object at the end. */
    static List<String> run(Geometry world, int count, long seed, double spread, double rise) {
        return run(world, count, seed, spread, rise, List.of(Accuracy.values()), object -> true);
    }

    /**
     * The same with some levels of accuracy, and without telling apart objects that stand for the same in different worlds.
     *
     * @param isNamed whether an object in an answer is told from others
     */
    static List<String> run(
            Geometry world,
            int count,
            long seed,
            double spread,
            double rise,
            List<Accuracy> levels,
            Predicate<GeometryObject> isNamed) {
        Script script = new Script(world, seed, spread, rise, levels, isNamed);
        for (int k = 0; k < count; k++) {
            script.answers.add(k + " " + script.next());
        }
        world.objects().stream().filter(isNamed).forEach(object -> script.answers.add(exactly(object)));
        return script.answers;
    }

    private String told(GeometryObject object) {
        return isNamed.test(object) ? exactly(object) : "cells";
    }

    /** An object with all the numbers of its place. */
    static String exactly(GeometryObject object) {
        double[] place = new double[17];
        object.pose().place(place, 0);
        return object + " " + Arrays.toString(place);
    }

    private String mover() {
        return movers.get(random.nextInt(movers.size()));
    }

    private String next() {
        return switch (random.nextInt(14)) {
            case 0, 1 -> "ray " + ray();
            case 2 -> "ignoring " + world.getRayDistance(line(), 0, 1 / 0.0, width(), any());
            case 3 -> {
                RayHit hit = world.castRay(line(), random.nextBoolean() ? 1 / 0.0 : random.nextDouble(8));
                yield "cast " + (hit == null ? "nothing" : text(hit));
            }
            case 4 -> "test " + world.testObject(objects.next(), level());
            case 5 -> "near " + world.getProximity(any(), random.nextBoolean() ? 1 / 0.0 : random.nextDouble(2));
            case 6, 7 -> "go " + world.simpleMove(mover(), random.nextDouble(-1, 1), 0, random.nextDouble(-0.3, 0.3));
            case 8 -> "turn " + world.simpleTurn(mover(), random.nextDouble(-60, 60));
            case 9 -> "move " + text(world.move(mover(), move()));
            case 10 -> "global " + text(world.moveGlobal(mover(), move()));
            case 11 -> "dock " + text(world.moveToContact(mover(), move(), random.nextInt(2) * 0.125));
            case 12 -> "place " + world.placeObject(mover(), objects.place(), objects.heading());
            default -> {
                double[] scan = world.scan(mover(), random.nextDouble(-180, 180), 17, 5, 0, 20);
                yield "scan " + Arrays.toString(scan);
            }
        };
    }

    private String any() {
        return names.get(random.nextInt(names.size()));
    }

    private Ray line() {
        return new Ray(objects.place(), objects.direction());
    }

    private double width() {
        return random.nextBoolean() ? 0 : random.nextDouble(random.nextBoolean() ? 10 : 179);
    }

    private double ray() {
        double min = random.nextBoolean() ? 0 : random.nextDouble(2);
        double max = random.nextBoolean() ? 1 / 0.0 : min + random.nextDouble(6);
        return world.getRayDistance(line(), min, max, width(), level());
    }

    private Move move() {
        double far = random.nextInt(4) == 0 ? 0 : random.nextDouble(2);
        double turn = random.nextInt(3) == 0 ? 0 : random.nextDouble(-60, 60);
        double tip = random.nextInt(6) == 0 ? random.nextDouble(-60, 60) : 0;
        Point way = new Point(far * random.nextDouble(-1, 1), 0, far * random.nextDouble(-1, 1));
        return new Move(way.x(), far * random.nextDouble(-0.2, 0.2), way.z(), tip, turn);
    }

    private Accuracy level() {
        return levels.get(random.nextInt(levels.size()));
    }

    private String text(RayHit hit) {
        return hit.distance() + " " + hit.point() + " " + hit.normal() + " " + told(hit.object());
    }

    private String text(MoveResult result) {
        GeometryObject obstacle = result.obstacle();
        return result.allowed() + " " + result.fraction() + " " + result.turnFraction() + " "
                + (obstacle == null ? "nothing" : told(obstacle)) + " " + result.contact() + " " + result.normal();
    }
}
