package robosim.geometry.collision;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;

/** Meshes to ask about. */
final class Meshes {
    private Meshes() {}

    /** Where the corners of the meshes come from, and how the meshes stand. */
    enum Family {
        /** Anywhere. */
        RANDOM(1000, 0.001, 0),
        /** Few places: faces in one plane, shared corners and edges, faces without area. */
        GRID(3, 1, 90),
        /** In a plane, all of them. */
        COPLANAR(6, 1, 0),
        /** Long and thin. */
        SLIVERS(4, 0x1p-30, 0),
        /** Few places, then turned: what met in them meets or not by roundings alone. */
        TURNED_GRID(3, 1, 31);

        private final int places;
        private final double unit;
        private final double turn;

        Family(int places, double unit, double turn) {
            this.places = places;
            this.unit = unit;
            this.turn = turn;
        }

        private Point corner(SplittableRandom random) {
            double x = random.nextInt(places) * unit;
            double y = this == COPLANAR ? 0 : random.nextInt(places) * unit;
            double z = random.nextInt(places) * (this == SLIVERS ? 1 : unit);
            return new Point(x, y, z);
        }

        MeshObject mesh(SplittableRandom random, int faces, double turns) {
            List<Point> corners = new ArrayList<>();
            for (int k = 0; k < faces + 3; k++) {
                corners.add(corner(random));
            }
            int[][] given = new int[faces][];
            for (int k = 0; k < faces; k++) {
                given[k] = k % 3 == 0 ? new int[] {k, k + 1, k + 2, k + 3} : new int[] {k, k + 1, k + 2};
            }
            return new MeshObject(corners, given).turned(turns * turn, turns * turn);
        }
    }

    /** A box's surface of 12 n n triangles, or of as many halves of quads. */
    static MeshObject finely(double width, double height, double length, int n, boolean quads) {
        List<Point> corners = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        double[] half = {width / 2, height / 2, length / 2};
        for (int side = 0; side < 6; side++) {
            int axis = side % 3;
            int first = corners.size();
            for (int k = 0; k < (n + 1) * (n + 1); k++) {
                double[] p = new double[3];
                p[axis] = side < 3 ? -half[axis] : half[axis];
                p[(axis + 1) % 3] = half[(axis + 1) % 3] * (2 * (k % (n + 1)) - n) / n;
                p[(axis + 2) % 3] = half[(axis + 2) % 3] * (2 * (k / (n + 1)) - n) / n;
                corners.add(new Point(p[0], p[1], p[2]));
            }
            for (int k = 0; k < n * n; k++) {
                int c = first + k / n * (n + 1) + k % n;
                if (quads) {
                    faces.add(new int[] {c, c + 1, c + n + 2, c + n + 1});
                } else {
                    faces.add(new int[] {c, c + 1, c + n + 2});
                    faces.add(new int[] {c, c + n + 2, c + n + 1});
                }
            }
        }
        return new MeshObject(corners, faces.toArray(new int[0][]));
    }
}
