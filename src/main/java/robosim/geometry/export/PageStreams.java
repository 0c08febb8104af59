package robosim.geometry.export;

import java.util.List;

/** The parts of a page's data, each of numbers that resemble one another, so that they compress well side by side. */
final class PageStreams {
    /** What the page is about: texts, units, sizes. */
    final PackedStream about = new PackedStream();

    /** Objects: names, colours, parts. */
    final PackedStream objects = new PackedStream();

    /** What surfaces look like. */
    final PackedStream looks = new PackedStream();

    /** The vertices and triangles of meshes. */
    final PackedStream meshes = new PackedStream();

    /** Worlds, and what happened in them. */
    final PackedStream chapters = new PackedStream();

    /** The lengths of tracks and the bytes of their moves. */
    final PackedStream tracks = new PackedStream();

    /** The frames of places. */
    final PackedStream times = new PackedStream();

    /** Moves ahead and aside. */
    final PackedStream moves = new PackedStream();

    final PackedStream turns = new PackedStream();

    /** Heights, and places of objects that tip over. */
    final PackedStream free = new PackedStream();

    /** How sensors are arranged on an object. */
    final PackedStream sensors = new PackedStream();

    /** When distances were measured, and by which sensors. */
    final PackedStream scans = new PackedStream();

    final PackedStream distances = new PackedStream();

    /** All of them, in the order in which the page reads them. */
    byte[] toBytes() {
        List<PackedStream> all = List.of(
                about, looks, objects, meshes, chapters, tracks, times, moves, turns, free, sensors, scans, distances);
        PackedStream whole = new PackedStream();
        whole.count(all.size());
        for (PackedStream each : all) {
            whole.count(each.size());
        }
        for (PackedStream each : all) {
            whole.append(each.toBytes());
        }
        return whole.toBytes();
    }
}
