package robosim.geometry.sensor;

/** An image of a {@link NormalCamera}. */
public final class NormalFrame extends RayFrame {
    private final double[] vector = new double[3];

    /** An empty frame. */
    public NormalFrame() {}

    /**
     * The X component, along the world's axis, of the unit normal of the surface that a ray met; 0 for none. It is, to the
     * bit, what {@link robosim.geometry.Geometry#castRay} returns.
     */
    public double normalX(int ray) {
        return buffer().normalX(checked(ray));
    }

    /** Its Y component. */
    public double normalY(int ray) {
        return buffer().normalY(checked(ray));
    }

    /** Its Z component. */
    public double normalZ(int ray) {
        return buffer().normalZ(checked(ray));
    }

    /**
     * All normals, X, Y and Z of each ray, along the world's axes: the frame's own array, no copy. Elements from three times
     * {@link #size} on mean nothing.
     */
    public double[] normals() {
        return buffer().normals();
    }

    /**
     * Writes the normal of a ray along the camera's own axes.
     *
     * @param out takes X, Y and Z
     * @param at  where in the array they begin
     */
    public void ownNormal(int ray, double[] out, int at) {
        turnBack(normalX(ray), normalY(ray), normalZ(ray), out, at);
    }

    @Override
    double field(PointCloud.Field field, int ray) {
        if (field.axis() >= 0) {
            ownNormal(ray, vector, 0);
            return vector[field.axis()];
        }
        return super.field(field, ray);
    }
}
