package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.model.Dimension;
import robosim.geometry.reference.Truth.Form;

/** All kernels that are counted, in the order of the published table. */
final class Kernels {
    private static final Form[] DISC = {Form.SPHERE};
    private static final Form[] RECTANGLE = {Form.UPRIGHT_BOX};
    private static final Form[] POLYGONS = {Form.BOX, Form.TRIANGLE, Form.UPRIGHT_BOX};
    private static final Form[] TIPPED = {Form.BOX, Form.TRIANGLE};
    private static final Form[] OVAL = {Form.CYLINDER};
    private static final Form[] ANY = {Form.SPHERE, Form.UPRIGHT_BOX, Form.BOX, Form.TRIANGLE, Form.CYLINDER};
    private static final Form[] CAPSULE = {Form.CAPSULE};
    private static final Form[] ANY_OR_CAPSULE = {
        Form.SPHERE, Form.UPRIGHT_CAPSULE, Form.UPRIGHT_BOX, Form.BOX, Form.TRIANGLE, Form.CYLINDER, Form.CAPSULE
    };

    private Kernels() {}

    static List<Kernel> all() {
        List<Kernel> all = new ArrayList<>();
        planar(all);
        spatial(all);
        all.add(new StandingMoves(Dimension.PLANAR));
        all.add(new StandingMoves(Dimension.SPATIAL));
        for (Dimension dimension : Dimension.values()) {
            all.add(new NearStart(dimension, true));
            all.add(new NearStart(dimension, false));
        }
        return all;
    }

    private static void spatial(List<Kernel> all) {
        all.addAll(OverlapKernel.all());
        all.add(new RayKernel());
        all.add(new CylinderCone());
        all.add(new SphereCone());
        all.add(new CapsuleCone());
        for (PolytopeCone.Shape shape : PolytopeCone.Shape.values()) {
            all.add(new PolytopeCone(shape));
        }
        all.addAll(DistanceKernel.all());
        all.add(new SpatialTurn());
        all.add(new SpatialWay());
    }

    private static void planar(List<Kernel> all) {
        all.add(new PlanarPair("discs", DISC, DISC));
        all.add(new PlanarPair("a disc and an upright box", DISC, RECTANGLE));
        all.add(new PlanarPair("a disc and a tipped box or a triangle", DISC, TIPPED));
        all.add(new PlanarPair("boxes and triangles", POLYGONS, POLYGONS));
        all.add(new PlanarPair("a tipped cylinder and any other", OVAL, ANY));
        all.add(new PlanarPair("a tipped capsule and any other", CAPSULE, ANY_OR_CAPSULE));
        all.add(new PlanarSight("a disc", Form.SPHERE));
        all.add(new PlanarSight("an upright box", Form.UPRIGHT_BOX));
        all.add(new PlanarSight("a tipped box or a triangle", Form.BOX, Form.TRIANGLE));
        all.add(new PlanarSight("a tipped cylinder", Form.CYLINDER));
        all.add(new PlanarSight("a tipped capsule", Form.CAPSULE));
        all.add(new PlanarBeam("a disc", Form.SPHERE));
        all.add(new PlanarBeam("a box or a triangle", Form.UPRIGHT_BOX, Form.BOX, Form.TRIANGLE));
        all.add(new PlanarBeam("a tipped cylinder", Form.CYLINDER));
        all.add(new PlanarBeam("a tipped capsule", Form.CAPSULE));
        all.add(new PlanarWay("discs", DISC, DISC));
        all.add(new PlanarWay("a disc and a box or a triangle", DISC, POLYGONS));
        all.add(new PlanarWay("boxes and triangles", POLYGONS, POLYGONS));
        all.add(new PlanarOvalWay("a tipped cylinder and any other", OVAL, ANY));
        all.add(new PlanarOvalWay("a tipped capsule and any other", CAPSULE, ANY_OR_CAPSULE));
        all.add(new PlanarSpin("discs", DISC, DISC));
        all.add(new PlanarSpin("a disc and a box or a triangle", DISC, POLYGONS));
        all.add(new PlanarSpin("boxes and triangles", POLYGONS, POLYGONS));
    }
}
