package robosim.geometry.junit;

import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;

/** A small world whose distances can be worked out by hand. */
final class Worlds {
    private Worlds() {}

    /** Robot r1 at the origin; a wall whose face is 3.5 ahead of its centre; robot r2 that stands 4 to its left. */
    static Geometry wallAhead() {
        Geometry geometry = new Geometry(40, 4, 40, Dimension.PLANAR, Accuracy.EXACT);
        geometry.addObject(new CylinderObject(new Point(), 0.5, 1).moveable("r1"));
        geometry.addObject(new BoxObject(new Point(4, 0, 0), 1, 1, 4).named("wall"));
        geometry.addObject(new CylinderObject(new Point(0, 0, -4), 0.5, 1).moveable("r2"));
        return geometry;
    }
}
