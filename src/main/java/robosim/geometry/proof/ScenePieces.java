package robosim.geometry.proof;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.proof.Proof.Flaw;

/** The pieces of all objects of a scene, counted through. */
final class ScenePieces {
    final Dimension dimension;
    private final List<Piece> pieces = new ArrayList<>();
    private final int[] first;
    private final List<List<int[]>> solids = new ArrayList<>();

    ScenePieces(Scene scene) {
        dimension = scene.dimension();
        first = new int[scene.objects().size() + 1];
        for (int k = 0; k < scene.objects().size(); k++) {
            GeometryObject object = scene.objects().get(k);
            solids.add(solids(object, first[k]));
            pieces.addAll(Piece.of(object));
            first[k + 1] = pieces.size();
        }
    }

    int objects() {
        return first.length - 1;
    }

    List<Piece> pieces() {
        return pieces;
    }

    Piece piece(int j) {
        Flaw.unless(j >= 0 && j < pieces.size(), "there is no piece " + j);
        return pieces.get(j);
    }

    /** The first piece of an object, or of the one after the last their number. */
    int begin(int object) {
        return first[object];
    }

    int objectOf(int piece) {
        int object = 0;
        while (object < objects() && piece >= first[object + 1]) {
            object++;
        }
        Flaw.unless(piece >= 0 && object < objects(), "there is no piece " + piece);
        return object;
    }

    /** Where the solid meshes of an object begin and end. */
    List<int[]> solids(int object) {
        return solids.get(object);
    }

    /** The triangles of the solid mesh that a piece belongs to. */
    List<Piece> solidOf(int piece) {
        return solidOf(piece, solids.get(objectOf(piece)), pieces);
    }

    /** The same of other pieces, if the solid meshes among them are given. */
    static List<Piece> solidOf(int piece, List<int[]> solids, List<Piece> pieces) {
        for (int[] solid : solids) {
            if (piece >= solid[0] && piece < solid[1]) {
                return pieces.subList(solid[0], solid[1]);
            }
        }
        throw new Flaw("piece " + piece + " is not of a solid mesh");
    }

    /** Where the solid meshes of an object begin and end, if its first piece has a number. */
    static List<int[]> solids(GeometryObject object, int from) {
        List<int[]> solids = new ArrayList<>(0);
        int at = from;
        for (GeometryObject part : object instanceof ObjectGroup group ? group.parts() : List.of(object)) {
            int size = part instanceof MeshObject mesh ? mesh.triangles().size() : 1;
            if (part instanceof MeshObject mesh && mesh.isSolid()) {
                solids.add(new int[] {at, at + size});
            }
            at += size;
        }
        return solids;
    }

    /** How many triangles a ray crosses, none of them at an edge. */
    static int crossings(Vec start, Vec ray, List<Piece> triangles) {
        int count = 0;
        Flaw.unless(!ray.isZero(), "a ray must have a direction");
        for (Piece t : triangles) {
            int least = 1;
            int most = -1;
            for (int k = 0; k < 3; k++) {
                int side = ray.dot(t.r[k].minus(start).cross(t.r[(k + 1) % 3].minus(start)))
                        .sign();
                least = Math.min(least, side);
                most = Math.max(most, side);
            }
            Vec n = t.r[1].minus(t.r[0]).cross(t.r[2].minus(t.r[0]));
            if ((least < 0 && most > 0) || n.isZero()) {
                continue; // what has no area changes nothing
            }
            Flaw.unless(least == most && least != 0, "a ray passes an edge of a solid mesh");
            int ahead = n.dot(t.r[0].minus(start)).sign() * n.dot(ray).sign();
            Flaw.unless(ahead != 0, "a ray begins on a solid mesh");
            count += ahead > 0 ? 1 : 0;
        }
        return count;
    }

    /** Half the extent of a world along an axis. */
    static Num half(Point size, Vec axis) {
        return Num.of((axis.x().sign() != 0 ? size.x() : axis.y().sign() != 0 ? size.y() : size.z()) / 2);
    }
}
