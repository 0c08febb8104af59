package robosim.geometry.export;

import java.util.List;

/** The parts of a page's data, each of numbers that resemble one another, so that they compress well side by side. */
final class PageStreams {
    /** What the page is about: texts, units, sizes. */
    final Packed about = new Packed();

    /** Objects: names, colours, parts. */
    final Packed objects = new Packed();

    /** What surfaces look like. */
    final Packed looks = new Packed();

    /** The vertices and triangles of meshes. */
    final Packed meshes = new Packed();

    /** Worlds, and what happened in them. */
    final Packed chapters = new Packed();

    /** The lengths of tracks and the bytes of their moves. */
    final Packed tracks = new Packed();

    /** The frames of places. */
    final Packed times = new Packed();

    /** Moves ahead and aside. */
    final Packed moves = new Packed();

    final Packed turns = new Packed();

    /** Heights, and places of objects that tip over. */
    final Packed free = new Packed();

    /** How sensors are arranged on an object. */
    final Packed sensors = new Packed();

    /** When distances were measured, and by which sensors. */
    final Packed scans = new Packed();

    final Packed distances = new Packed();

    /** All of them, in the order in which the page reads them. */
    byte[] toBytes() {
        List<Packed> all = List.of(
                about, looks, objects, meshes, chapters, tracks, times, moves, turns, free, sensors, scans, distances);
        Packed whole = new Packed();
        whole.count(all.size());
        for (Packed each : all) {
            whole.count(each.size());
        }
        for (Packed each : all) {
            whole.append(each.toBytes());
        }
        return whole.toBytes();
    }
}
