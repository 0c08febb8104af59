package robosim.geometry.report;

/** What the families are called. */
final class Titles {
    private Titles() {}

    static String of(String family) {
        return switch (family) {
            case "parallel" -> "Parallel and nearly parallel edges";
            case "touching" -> "Touching and tangent";
            case "containment" -> "Deep containment";
            case "degenerate" -> "Degenerate faces";
            case "triangles" -> "Triangle and triangle";
            case "scale" -> "Huge, small, far from the origin";
            case "moves" -> "Thin walls, moves";
            case "starts" -> "Moves of no length, starts in contact";
            case "grazing" -> "Grazing rays, corners, edges";
            case "inside" -> "Rays that start on or inside";
            case "axes" -> "Rays along axes";
            case "bad" -> "Bad numbers, order, drift, wrap";
            case "sensors" -> "Range sensors";
            default -> throw new IllegalArgumentException("a family must have a title (got: " + family + ")");
        };
    }
}
