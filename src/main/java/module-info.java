/** Collision, motion and range queries for robot simulators: what may be where, how far it may move, what is next. */
module robosim.geometry {
    requires static org.jspecify;

    exports robosim.geometry;
    exports robosim.geometry.model;
}
