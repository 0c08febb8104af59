package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.io.Serializable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.RayPattern;

/**
 * The beams of a range sensor, described in as few numbers as they have: what a {@link RayPattern} is made of, with angles in
 * radians. Order and directions of the beams are those of the {@link RayPattern}.
 */
public sealed interface BeamPattern extends Serializable {
    /** The number of beams. */
    int size();

    /**
     * Beams in the sensor's own XZ plane, counter-clockwise from forward, seen from above: see {@link RayPattern#fan}.
     *
     * @param first radians from forward to the first beam
     * @param step  radians from each beam to the next
     * @param count number of beams, 1 to {@link RayPattern#MAX_SIZE}
     */
    record Fan(double first, double step, int count) implements BeamPattern {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses numbers that are NaN or out of range. */
        public Fan {
            Checks.radians("first", first);
            Checks.radians("step", step);
            checkCount("count", count, 1);
        }

        @Override
        public int size() {
            return count;
        }
    }

    /**
     * Layers of beams, one for each elevation: see {@link RayPattern#layers}.
     *
     * @param elevations radians, from -pi/2 (down) to pi/2 (up), one for each row
     * @param first      radians from forward to the first column, counter-clockwise
     * @param step       radians from each column to the next
     * @param count      number of columns; rows times columns are at most {@link RayPattern#MAX_SIZE}
     */
    record Layers(Numbers elevations, double first, double step, int count) implements BeamPattern {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null, and numbers that are NaN or out of range. */
        public Layers {
            int rows = Checks.present("elevations", elevations).size();
            checkCount("number of elevations", rows, 1);
            for (int k = 0; k < rows; k++) {
                if (!(Math.abs(elevations.get(k)) <= Math.PI / 2)) { // written so that NaN fails it
                    throw new IllegalArgumentException("elevations[" + k
                            + "] must be an angle in radians from -pi/2 to pi/2 (got: " + elevations.get(k) + ")");
                }
            }
            Checks.radians("first", first);
            Checks.radians("step", step);
            checkCount("count", count, rows);
        }

        @Override
        public int size() {
            return elevations.size() * count;
        }
    }

    /**
     * A beam through the middle of each pixel of a camera without distortion: see {@link RayPattern#pinhole}.
     *
     * @param width       pixels in a row
     * @param height      rows; all pixels are at most {@link RayPattern#MAX_SIZE}
     * @param fieldOfView radians from the left edge of the image to the right one, above 0 and below pi
     */
    record Pinhole(int width, int height, double fieldOfView) implements BeamPattern {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses numbers that are NaN or out of range. */
        public Pinhole {
            checkCount("width", width, 1);
            checkCount("height", height, width);
            if (!(fieldOfView > 0 && fieldOfView < Math.PI)) {
                throw new IllegalArgumentException(
                        "fieldOfView must be an angle in radians above 0 and below pi (got: " + fieldOfView + ")");
            }
        }

        @Override
        public int size() {
            return width * height;
        }
    }

    /**
     * Beams in any directions: see {@link RayPattern#of}.
     *
     * @param directions X, Y and Z of each direction in the sensor's own frame, of any length but zero
     */
    record Directions(Numbers directions) implements BeamPattern {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null, numbers that are NaN or beyond 2<sup>100</sup>, and a direction of zero. */
        public Directions {
            int size = Checks.present("directions", directions).size();
            if (size == 0 || size % 3 != 0) {
                throw new IllegalArgumentException(
                        "directions must have three numbers for each of at least one beam (got: " + size + " numbers)");
            }
            checkCount("number of directions", size / 3, 1);
            for (int k = 0; k < size; k += 3) {
                for (int axis = 0; axis < 3; axis++) {
                    if (!(Math.abs(directions.get(k + axis)) <= Checks.LIMIT)) {
                        Checks.coordinate("directions[" + (k + axis) + "]", directions.get(k + axis));
                    }
                }
                if (directions.get(k) == 0 && directions.get(k + 1) == 0 && directions.get(k + 2) == 0) {
                    throw new IllegalArgumentException(
                            "direction " + k / 3 + " must not be zero (got: (0.0, 0.0, 0.0))");
                }
            }
        }

        @Override
        public int size() {
            return directions.size() / 3;
        }
    }

    private static void checkCount(String argument, int count, int times) {
        if (count < 1 || count > RayPattern.MAX_SIZE / times) {
            throw new IllegalArgumentException(
                    argument + " must be from 1 to " + RayPattern.MAX_SIZE / times + " (got: " + count + ")");
        }
    }
}
