package robosim.geometry.stress;

import static robosim.geometry.reference.Truth.Form.BOX;
import static robosim.geometry.reference.Truth.Form.CAPSULE;
import static robosim.geometry.reference.Truth.Form.CYLINDER;
import static robosim.geometry.reference.Truth.Form.SPHERE;
import static robosim.geometry.reference.Truth.Form.TRIANGLE;
import static robosim.geometry.reference.Truth.Form.UPRIGHT_BOX;
import static robosim.geometry.reference.Truth.Form.UPRIGHT_CAPSULE;
import static robosim.geometry.reference.Truth.Form.UPRIGHT_CYLINDER;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.reference.Truth.Form;

/** All families of questions. */
final class Families {
    private static final Form[] DISCS = {UPRIGHT_CYLINDER, SPHERE, UPRIGHT_CAPSULE};
    private static final Form[] RECTANGLE = {UPRIGHT_BOX};
    private static final Form[] POLYGONS = {BOX, UPRIGHT_BOX};
    private static final Form[] TRIANGLES = {TRIANGLE};
    private static final Form[] BALL = {SPHERE};
    private static final Form[] UPRIGHT_TUBE = {UPRIGHT_CYLINDER};
    private static final Form[] TURNED_TUBE = {CYLINDER};
    private static final Form[] CAPSULES = {UPRIGHT_CAPSULE, CAPSULE};
    private static final Form[] TURNED_CAPSULE = {CAPSULE};

    private Families() {}

    static List<Family> all() {
        List<Family> all = new ArrayList<>();
        all.add(new OrientationFamily("orientation in the plane", 2));
        all.add(new OrientationFamily("orientation in space", 3));
        planar(all);
        spatial(all);
        rays(all);
        meshes(all);
        sweeps(all);
        return all;
    }

    private static void planar(List<Family> all) {
        all.add(new OverlapFamily("planar disc-disc", true, DISCS, DISCS, 2));
        all.add(new OverlapFamily("planar disc-rectangle", true, DISCS, RECTANGLE, 1.5));
        all.add(new OverlapFamily("planar disc-zonogon", true, DISCS, new Form[] {BOX}, 1.5));
        all.add(new OverlapFamily("planar disc-triangle", true, DISCS, TRIANGLES, 1.2));
        all.add(new OverlapFamily("planar rectangle-rectangle", true, RECTANGLE, RECTANGLE, 1.2));
        all.add(new OverlapFamily("planar polygon-zonogon", true, POLYGONS, new Form[] {BOX}, 1.4));
        all.add(new OverlapFamily("planar triangle-polygon", true, TRIANGLES, POLYGONS, 1.2));
        all.add(new OverlapFamily("planar triangle-triangle", true, TRIANGLES, TRIANGLES, 0.8));
    }

    private static void spatial(List<Family> all) {
        all.add(new OverlapFamily("upright box-upright box", false, RECTANGLE, RECTANGLE, 1.2));
        all.add(new OverlapFamily("upright box-upright cylinder", false, RECTANGLE, UPRIGHT_TUBE, 1.3));
        all.add(new OverlapFamily("upright cylinder-upright cylinder", false, UPRIGHT_TUBE, UPRIGHT_TUBE, 1.4));
        all.add(new OverlapFamily("box-box", false, POLYGONS, new Form[] {BOX}, 1.3));
        all.add(new OverlapFamily("box-triangle", false, POLYGONS, TRIANGLES, 1));
        all.add(new OverlapFamily("triangle-triangle", false, TRIANGLES, TRIANGLES, 0.5));
        all.add(new OverlapFamily("sphere-sphere", false, BALL, BALL, 2));
        all.add(new OverlapFamily("sphere-box", false, BALL, POLYGONS, 1.5));
        all.add(new OverlapFamily("sphere-triangle", false, BALL, TRIANGLES, 1));
        all.add(new OverlapFamily("sphere-upright cylinder", false, BALL, UPRIGHT_TUBE, 1.6));
        all.add(new OverlapFamily("sphere-turned cylinder", false, BALL, TURNED_TUBE, 1.6));
        all.add(new OverlapFamily("turned cylinder-box", false, TURNED_TUBE, POLYGONS, 1.3));
        all.add(new OverlapFamily("upright cylinder-turned box", false, UPRIGHT_TUBE, new Form[] {BOX}, 1.3));
        all.add(new OverlapFamily("parallel cylinders", false, TURNED_TUBE, TURNED_TUBE, 1.4, true));
        all.add(new OverlapFamily("cylinder-triangle", false, new Form[] {UPRIGHT_CYLINDER, CYLINDER}, TRIANGLES, 1));
        all.add(new OverlapFamily("capsule-sphere", false, CAPSULES, BALL, 1.4));
        all.add(new OverlapFamily("capsule-box", false, CAPSULES, POLYGONS, 1.2));
        all.add(new OverlapFamily("capsule-triangle", false, CAPSULES, TRIANGLES, 0.9));
        all.add(new OverlapFamily("capsule-capsule", false, CAPSULES, CAPSULES, 1.1));
        all.add(new OverlapFamily("parallel capsules", false, TURNED_CAPSULE, TURNED_CAPSULE, 1.2, true));
    }

    private static void rays(List<Family> all) {
        all.add(new RayFamily("planar ray-disc", true, DISCS, 1.6));
        all.add(new RayFamily("planar ray-rectangle", true, RECTANGLE, 1.5));
        all.add(new RayFamily("planar ray-zonogon", true, new Form[] {BOX}, 1.4));
        all.add(new RayFamily("planar ray-triangle", true, TRIANGLES, 1));
        all.add(new RayFamily("ray-box", false, POLYGONS, 1));
        all.add(new RayFamily("ray-triangle", false, TRIANGLES, 0.35));
        all.add(new RayFamily("ray-sphere", false, BALL, 1.3));
        all.add(new RayFamily("ray-upright cylinder", false, UPRIGHT_TUBE, 1.2));
        all.add(new RayFamily("ray-turned cylinder", false, TURNED_TUBE, 1.2));
        all.add(new RayFamily("planar ray-capsule", true, TURNED_CAPSULE, 1.5));
        all.add(new RayFamily("ray-capsule", false, CAPSULES, 1));
    }

    private static void meshes(List<Family> all) {
        all.add(new MeshFamily("mesh-mesh", false));
        all.add(new MeshFamily("solid mesh-mesh", true));
        all.add(new SolidFamily("solid mesh-box"));
        all.add(new MeshRayFamily("ray-quad", MeshRayFamily.Target.QUAD));
        all.add(new MeshRayFamily("ray-closed mesh", MeshRayFamily.Target.CLOSED));
        all.add(new MeshRayFamily("ray-solid mesh", MeshRayFamily.Target.SOLID));
    }

    private static void sweeps(List<Family> all) {
        Form[] flat = {UPRIGHT_BOX, BOX, TRIANGLE};
        all.add(new SweepFamily("planar sweep of disc and disc", true, DISCS, DISCS));
        all.add(new SweepFamily("planar sweep of disc and polygon", true, DISCS, flat));
        all.add(new SweepFamily("planar sweep of polygon and disc", true, flat, DISCS));
        all.add(new SweepFamily("planar sweep of polygon and polygon", true, flat, flat));
        all.add(new SweepFamily("sweep of upright box and upright box", false, RECTANGLE, RECTANGLE));
        all.add(new SweepFamily("sweep of upright cylinder and upright thing", false, UPRIGHT_TUBE, new Form[] {
            UPRIGHT_CYLINDER, UPRIGHT_BOX
        }));
        all.add(new SweepFamily("sweep of sphere and sphere", false, BALL, BALL));
        all.add(new SweepFamily("sweep of sphere and box", false, BALL, POLYGONS));
        all.add(new SweepFamily("sweep of sphere and triangle", false, BALL, TRIANGLES));
        all.add(new SweepFamily("sweep of box and box", false, POLYGONS, new Form[] {BOX}));
        all.add(new SweepFamily("sweep of box and triangle", false, POLYGONS, TRIANGLES));
        all.add(new SweepFamily("sweep of triangle and triangle", false, TRIANGLES, TRIANGLES));
    }
}
