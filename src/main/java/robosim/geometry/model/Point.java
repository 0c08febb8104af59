package robosim.geometry.model;
/** P. */
public record Point(double x, double y, double z) {}
