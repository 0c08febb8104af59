package robosim.geometry.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** A torus of radii 1 and 0.4 with bumps, of any number of triangles, rays at it, and places beside it. */
final class MeshScene {
    private final SplittableRandom random = new SplittableRandom(5);

    /** Five times as many steps round the ring as round the tube; two triangles to a step of both. */
    MeshObject torus(int triangles) {
        int round = (int) Math.sqrt(triangles / 10.0);
        int along = 5 * round;
        List<Point> vertices = new ArrayList<>(along * round);
        List<int[]> faces = new ArrayList<>(2 * along * round);
        for (int i = 0; i < along; i++) {
            for (int j = 0; j < round; j++) {
                vertices.add(point(2 * Math.PI * i / along, 2 * Math.PI * j / round));
                int right = (i + 1) % along * round;
                int up = (j + 1) % round;
                faces.add(new int[] {i * round + j, i * round + up, right + up});
                faces.add(new int[] {i * round + j, right + up, right + j});
            }
        }
        return new MeshObject(vertices, faces.toArray(new int[0][]));
    }

    private static Point point(double u, double v) {
        double tube = 0.4 * (1 + 0.1 * StrictMath.sin(11 * u) * StrictMath.cos(3 * v));
        double out = 1 + tube * StrictMath.cos(v);
        return new Point(out * StrictMath.cos(u), tube * StrictMath.sin(v), out * StrictMath.sin(u));
    }

    /** From about four away to a point within the box about it. */
    Ray[] rays(int count) {
        Ray[] rays = new Ray[count];
        for (int k = 0; k < count; k++) {
            Point start = direction(4);
            Point at =
                    new Point(random.nextDouble(-1.2, 1.2), random.nextDouble(-0.4, 0.4), random.nextDouble(-1.2, 1.2));
            rays[k] = new Ray(start, new Point(at.x() - start.x(), at.y() - start.y(), at.z() - start.z()));
        }
        return rays;
    }

    /** The mesh turned any way, from 0 to 2.6 away: four in five of the places collide. */
    MeshObject[] beside(MeshObject mesh, int count) {
        MeshObject[] placed = new MeshObject[count];
        for (int k = 0; k < count; k++) {
            placed[k] = mesh.turned(random.nextDouble(-180, 180), random.nextDouble(-180, 180))
                    .movedTo(direction(random.nextDouble(2.6)));
        }
        return placed;
    }

    private Point direction(double length) {
        double y = random.nextDouble(-1, 1);
        double angle = random.nextDouble(2 * Math.PI);
        double flat = length * Math.sqrt(1 - y * y);
        return new Point(flat * StrictMath.cos(angle), length * y, flat * StrictMath.sin(angle));
    }
}
