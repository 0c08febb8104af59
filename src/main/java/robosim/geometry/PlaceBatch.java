package robosim.geometry;

import robosim.geometry.check.Checks;
import robosim.geometry.engine.World;
import robosim.geometry.engine.motion.ClearanceQuery;
import robosim.geometry.engine.motion.FreePlaces;
import robosim.geometry.engine.motion.PlaceBatches;

/**
 * Many questions about places of one moveable object, checked and ready to be answered by any copy of its world, in parts.
 *
 * @param count how many there are
 */
record PlaceBatch(String call, String name, Avoidance avoid, int count, Part part) {
    /** Answers a part of the questions. */
    interface Part {
        int answer(World world, int id, int from, int to);
    }

    /** Poses of an object that may stand on what it stands on now. */
    static PlaceBatch standing(String name, double[] poses, long[] free) {
        int count = FreePlaces.check("poses", poses, FreePlaces.POSE, free);
        Part part = (world, id, from, to) -> world.places().poses(world.view, id, poses, from, to, free);
        return new PlaceBatch("freePoses", name, Avoidance.ALL, count, part);
    }

    /** Edges of such an object. */
    static PlaceBatch driving(String name, double[] edges, long[] free) {
        int count = FreePlaces.check("edges", edges, FreePlaces.EDGE, free);
        Part part = (world, id, from, to) -> world.places().edges(world.view, id, edges, from, to, free);
        return new PlaceBatch("freeEdges", name, Avoidance.ALL, count, part);
    }

    static PlaceBatch poses(String name, double[] poses, Avoidance avoid, long[] free) {
        double margin = margin(name, avoid);
        int count = FreePlaces.check("poses", poses, FreePlaces.POSE, free);
        Part part = (world, id, from, to) -> world.batches().poses(world.view, id, poses, from, to, margin, free);
        return new PlaceBatch("freePoses", name, avoid, count, part);
    }

    static PlaceBatch edges(String name, double[] edges, Avoidance avoid, long[] free) {
        double margin = margin(name, avoid);
        int count = FreePlaces.check("edges", edges, FreePlaces.EDGE, free);
        Part part = (world, id, from, to) -> world.batches().edges(world.view, id, edges, from, to, margin, free);
        return new PlaceBatch("freeEdges", name, avoid, count, part);
    }

    static PlaceBatch clearances(String name, double[] poses, double max, Avoidance avoid, double[] out) {
        margin(name, avoid);
        int count = FreePlaces.check("poses", poses, FreePlaces.POSE);
        Checks.range(0, max);
        room("out", out, count, 1);
        if (count > 0 && out.length > count && out.length != ClearanceQuery.NUMBERS * count) {
            throw new IllegalArgumentException("out must have 1 or " + ClearanceQuery.NUMBERS + " numbers for each of "
                    + count + " poses (got: " + out.length + " numbers)");
        }
        Part part = (world, id, from, to) -> world.batches().clearances(world.view, id, poses, from, to, max, out);
        return new PlaceBatch("clearances", name, avoid, count, part);
    }

    static PlaceBatch fractions(String name, double[] edges, Avoidance avoid, double[] out) {
        double margin = margin(name, avoid);
        int count = FreePlaces.check("edges", edges, FreePlaces.EDGE);
        room("fractions", out, count, PlaceBatches.FRACTIONS);
        Part part = (world, id, from, to) -> world.batches().fractions(world.view, id, edges, from, to, margin, out);
        return new PlaceBatch("edgeFractions", name, avoid, count, part);
    }

    static PlaceBatch drives(String name, double[] drives, Avoidance avoid, double[] out) {
        double margin = margin(name, avoid);
        int count = PlaceBatches.checkDrives(drives);
        room("fractions", out, count, 1);
        Part part = (world, id, from, to) -> world.batches().drives(world.view, id, drives, from, to, margin, out);
        return new PlaceBatch("driveFractions", name, avoid, count, part);
    }

    private static double margin(String name, Avoidance avoid) {
        Checks.present("name", name);
        return Checks.present("avoid", avoid).margin();
    }

    private static void room(String argument, double[] out, int count, int each) {
        if (Checks.present(argument, out).length < each * count) {
            throw new IllegalArgumentException(argument + " must have " + each + " numbers for each of " + count
                    + " answers (got: " + out.length + " numbers)");
        }
    }

    /** Answers all questions in a world; returns how many of them are free or clear. */
    int answer(World engine) {
        return answer(engine, 0, count);
    }

    /** Answers some of the questions in a world; returns how many of them are free or clear. */
    int answer(World engine, int from, int to) {
        engine.registry.begin(call);
        int id = engine.registry.mover(name);
        avoid.begin(engine);
        try {
            return part.answer(engine, id, from, to);
        } finally {
            engine.objects.ignored.clear();
        }
    }
}
