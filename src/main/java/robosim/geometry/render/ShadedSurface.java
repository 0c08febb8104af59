package robosim.geometry.render;

import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Pose;

/** The surface of an object that is no group, as shading needs it: linear colours, and where a texture lies. */
final class ShadedSurface {
    final double red;
    final double green;
    final double blue;
    final double diffuse;
    final double specular;
    final double shininess;
    final double mirror;
    final double emittedRed;
    final double emittedGreen;
    final double emittedBlue;

    /** No point of the object is farther from any other. */
    final double size;

    private final GeometryObject object;
    private final @Nullable Pattern pattern;
    private final double[] rotation = new double[9];
    private double x;
    private double y;
    private double z;

    /**
     * A surface.
     *
     * @param object with the material that is seen
     * @param size   at least the largest distance of any two points of the object, or of the group that it is a part of
     */
    ShadedSurface(GeometryObject object, double size) {
        this.object = object;
        this.size = size;
        Material material = object.material();
        Color color = material.color();
        red = color.linearRed();
        green = color.linearGreen();
        blue = color.linearBlue();
        diffuse = material.diffuse();
        specular = material.specular();
        shininess = material.shininess();
        mirror = material.mirror();
        Color emission = material.emission();
        emittedRed = emission.linearRed();
        emittedGreen = emission.linearGreen();
        emittedBlue = emission.linearBlue();
        Texture texture = material.texture();
        pattern = texture == null ? null : Pattern.of(texture);
        place(object.pose());
    }

    /** Puts the surface where the object is now. */
    void place(Pose pose) {
        x = pose.center().x();
        y = pose.center().y();
        z = pose.center().z();
        pose.rotation(rotation, 0);
    }

    /** Whether the colour depends on the place. */
    boolean hasPattern() {
        return pattern != null;
    }

    /**
     * The linear colour at a point in the world.
     *
     * @param face the triangle, of a mesh
     * @param n    the unit normal there, three numbers from an index on
     * @param work has room for the point and the normal in the own frame
     * @param out  takes red, green and blue
     */
    void color(double px, double py, double pz, double[] n, int at, int face, TexturePoint work, double[] out) {
        Pattern drawn = pattern;
        if (drawn == null) {
            out[0] = red;
            out[1] = green;
            out[2] = blue;
            return;
        }
        double[] r = rotation;
        double dx = px - x;
        double dy = py - y;
        double dz = pz - z;
        work.qx = r[0] * dx + r[3] * dy + r[6] * dz;
        work.qy = r[1] * dx + r[4] * dy + r[7] * dz;
        work.qz = r[2] * dx + r[5] * dy + r[8] * dz;
        work.nx = r[0] * n[at] + r[3] * n[at + 1] + r[6] * n[at + 2];
        work.ny = r[1] * n[at] + r[4] * n[at + 1] + r[7] * n[at + 2];
        work.nz = r[2] * n[at] + r[5] * n[at + 1] + r[8] * n[at + 2];
        if (drawn.isImage() && object instanceof MeshObject mesh && work.placeByCorners(mesh, face)) {
            drawn.colorOfShare(work.s, work.t, out);
            return;
        }
        work.place(object);
        drawn.color(work.s, work.t, out);
    }
}
