package robosim.geometry.report;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.report.Peer.CannotException;

/**
 * The projection of an object on the plane of X and Z as engines of the plane take it: discs, and hulls of corners that
 * are rounded to doubles.
 *
 * @param pivot     what it turns about
 * @param isRounded whether corners may be rounded: those of what is turned
 */
public record Outline(List<Piece> pieces, double[] pivot, boolean isRounded) {
    /**
     * A disc about one corner, or the hull of corners where its radius is negative.
     *
     * @param ordered whether the corners are those of a convex polygon in order
     */
    public record Piece(List<double[]> corners, double radius, boolean ordered) {
        public boolean isDisc() {
            return radius >= 0;
        }
    }

    public static Outline of(GeometryObject object) throws CannotException {
        List<Piece> pieces = new ArrayList<>();
        add(object, pieces);
        return new Outline(pieces, flat(object.center()), isTurned(object));
    }

    private static boolean isTurned(GeometryObject object) {
        for (double entry : object.rotation()) {
            if (entry != 0 && Math.abs(entry) != 1) {
                return true;
            }
        }
        return false;
    }

    private static double[] flat(Point p) {
        return new double[] {p.x(), p.z()};
    }

    private static void add(GeometryObject object, List<Piece> pieces) throws CannotException {
        switch (object.kind()) {
            case BOX -> pieces.add(box((BoxObject) object));
            case SPHERE -> pieces.add(disc(object, ((SphereObject) object).radius()));
            case CYLINDER -> {
                if (Math.abs(object.rotation()[4]) != 1) {
                    throw new CannotException("a cylinder that lies is no disc");
                }
                pieces.add(disc(object, ((CylinderObject) object).radius()));
            }
            case MESH -> mesh((MeshObject) object, pieces);
            case CAPSULE, GRID -> throw new CannotException("no other engine has this shape");
            case GROUP -> {
                for (GeometryObject member : ((ObjectGroup) object).members()) {
                    add(member, pieces);
                }
            }
        }
    }

    private static Piece disc(GeometryObject object, double radius) {
        return new Piece(List.of(flat(object.center())), radius, true);
    }

    private static Piece box(BoxObject box) {
        double[] r = box.rotation();
        boolean upright = Math.abs(r[4]) == 1;
        List<double[]> corners = new ArrayList<>();
        int[][] signs = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        for (int y = upright ? 1 : -1; y <= 1; y += 2) {
            double up = upright ? 0 : y * box.height() / 2;
            for (int[] sign : signs) {
                double along = sign[0] * box.width() / 2;
                double aside = sign[1] * box.length() / 2;
                corners.add(new double[] {
                    box.center().x() + (along * r[0] + up * r[1] + aside * r[2]),
                    box.center().z() + (along * r[6] + up * r[7] + aside * r[8])
                });
            }
        }
        return new Piece(corners, -1, upright && box.width() > 0 && box.length() > 0);
    }

    private static void mesh(MeshObject mesh, List<Piece> pieces) {
        double[] r = mesh.rotation();
        List<double[]> placed = mesh.vertices().stream()
                .map(v -> new double[] {
                    r[0] * v.x() + r[1] * v.y() + r[2] * v.z() + mesh.center().x(),
                    r[6] * v.x() + r[7] * v.y() + r[8] * v.z() + mesh.center().z()
                })
                .toList();
        if (mesh.isSolid()) {
            pieces.add(new Piece(placed, -1, false)); // the solid meshes of the cases are convex
            return;
        }
        for (int[] face : mesh.faces()) {
            for (int k = 2; k < face.length; k++) {
                List<double[]> corners = List.of(placed.get(face[0]), placed.get(face[k - 1]), placed.get(face[k]));
                pieces.add(new Piece(corners, -1, false));
            }
        }
    }
}
