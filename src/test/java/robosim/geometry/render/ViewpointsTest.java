package robosim.geometry.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

class ViewpointsTest {
    /** Where a point is in the picture: from -1 to 1 to the right and up, if it is ahead. */
    private static double[] seen(Pose eye, Point point, double fieldOfView, double aspect) {
        double[] r = eye.rotation();
        double[] way = {
            point.x() - eye.center().x(),
            point.y() - eye.center().y(),
            point.z() - eye.center().z()
        };
        double ahead = r[0] * way[0] + r[3] * way[1] + r[6] * way[2];
        double up = r[1] * way[0] + r[4] * way[1] + r[7] * way[2];
        double right = r[2] * way[0] + r[5] * way[1] + r[8] * way[2];
        assertThat(ahead).isPositive();
        double tangent = StrictMath.tan(StrictMath.toRadians(fieldOfView / 2));
        return new double[] {right / ahead / tangent, up / ahead / tangent * aspect};
    }

    @Test
    void allPointsFillThePictureWithEvenBorders() {
        SplittableRandom random = new SplittableRandom(3);
        for (int round = 0; round < 300; round++) {
            List<Point> points = new ArrayList<>();
            for (int k = random.nextInt(1, 5); k > 0; k--) {
                Point corner =
                        new Point(random.nextDouble(90, 130), random.nextDouble(-9, 4), random.nextDouble(-40, 20));
                Bounds box = new Bounds(
                        corner.x(),
                        corner.y(),
                        corner.z(),
                        corner.x() + random.nextDouble(1, 20),
                        corner.y() + random.nextDouble(1, 20),
                        corner.z() + random.nextDouble(1, 20));
                points.addAll(box.corners());
            }
            double azimuth = random.nextDouble(-180, 180);
            double elevation = random.nextDouble(-90, 90);
            double fieldOfView = random.nextDouble(5, 40);
            double aspect = random.nextDouble(0.4, 2.5);
            Pose eye = Pose.around(points, azimuth, elevation, fieldOfView, aspect);
            double[] least = {2, 2};
            double[] most = {-2, -2};
            for (Point point : points) {
                double[] at = seen(eye, point, fieldOfView, aspect);
                for (int axis = 0; axis < 2; axis++) {
                    least[axis] = Math.min(least[axis], at[axis]);
                    most[axis] = Math.max(most[axis], at[axis]);
                }
            }
            String view = "%d points from %s, %s with %s, %s"
                    .formatted(points.size(), azimuth, elevation, fieldOfView, aspect);
            double filled = Math.max(most[0] - least[0], most[1] - least[1]) / 2;
            assertThat(filled).as(view).isBetween(0.9, 1.0);
            int tight = most[0] - least[0] > most[1] - least[1] ? 0 : 1;
            assertThat(most[tight]).as(view).isCloseTo(-least[tight], within(1e-9));
            for (int axis = 0; axis < 2; axis++) {
                assertThat(least[axis]).as(view).isGreaterThan(-1);
                assertThat(most[axis]).as(view).isLessThan(1);
            }
        }
    }
}
