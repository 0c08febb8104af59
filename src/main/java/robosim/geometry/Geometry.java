package robosim.geometry;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** A world of objects and the questions about it (its signatures; being written). */
@SuppressWarnings("DoNotCallSuggester")
public final class Geometry {
    public Geometry() {
        this(1000, 1000, 1000);
    }

    public Geometry(double width, double height, double length) {
        this(width, height, length, Dimension.SPATIAL, Accuracy.EXACT);
    }

    public Geometry(double width, double height, double length, Dimension dimension, Accuracy accuracy) {}

    private static UnsupportedOperationException later() {
        return new UnsupportedOperationException();
    }

    public double width() {
        throw later();
    }

    public double height() {
        throw later();
    }

    public double length() {
        throw later();
    }

    public Dimension dimension() {
        throw later();
    }

    public Accuracy accuracy() {
        throw later();
    }

    public boolean addObject(GeometryObject object) {
        throw later();
    }

    public boolean addObjectUnchecked(GeometryObject object) {
        throw later();
    }

    public boolean testObject(GeometryObject object) {
        throw later();
    }

    public boolean testObject(GeometryObject object, Accuracy accuracy) {
        throw later();
    }

    public boolean removeObject(String name) {
        throw later();
    }

    public boolean placeObject(String name, Point center, double heading) {
        throw later();
    }

    public GeometryObject getObject(String name) {
        throw later();
    }

    public List<GeometryObject> objects() {
        throw later();
    }

    /** Whether there is an object of that name. */
    public boolean hasObject(String name) {
        throw later();
    }

    public boolean simpleMove(String name, double x, double y, double z) {
        throw later();
    }

    public boolean simpleTurn(String name, double degrees) {
        throw later();
    }

    public MoveResult move(String name, Move move) {
        throw later();
    }

    public MoveResult moveGlobal(String name, Move move) {
        throw later();
    }

    public MoveResult moveToContact(String name, Move move, double clearance) {
        throw later();
    }

    public double getRayDistance(Ray ray, double min, double max, double width) {
        throw later();
    }

    public double getRayDistance(Ray ray, double min, double max, double width, Accuracy accuracy) {
        throw later();
    }

    public double getRayDistance(Ray ray, double min, double max, double width, String ignored) {
        throw later();
    }

    public double getSonarDistance(String name, double x, double z, double min, double max, double width) {
        throw later();
    }

    public double getSonarDistance(String name, Ray mount, double min, double max, double width) {
        throw later();
    }

    public double getProximity(String name, double max) {
        throw later();
    }

    public @Nullable RayHit castRay(Ray ray, double max) {
        throw later();
    }

    public double[] scan(String name, double firstDegrees, double stepDegrees, int count, double min, double max) {
        throw later();
    }
}
