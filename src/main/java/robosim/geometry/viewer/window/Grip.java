package robosim.geometry.viewer.window;

import org.jspecify.annotations.Nullable;

/** A pressed button: where it was pressed, where the mouse was last, and what is being dragged. */
final class Grip {
    final double beginX;
    final double beginY;
    double x;
    double y;
    boolean moved;
    final @Nullable String robot;
    double offsetX;
    double offsetZ;

    Grip(double x, double y, @Nullable String robot) {
        this.beginX = x;
        this.beginY = y;
        this.x = x;
        this.y = y;
        this.robot = robot;
    }
}
