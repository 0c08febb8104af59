/** Collision, motion and range queries for robot simulators. */
module robosim.geometry {
    requires static org.jspecify;

    exports robosim.geometry.model;
}
