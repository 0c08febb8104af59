package robosim.geometry.sensor.effects;

import robosim.geometry.exact.Degrees;

/**
 * One effect of a noise.
 *
 * <p>Each draws its numbers from a key of its own, by the number of the ray.
 */
public sealed interface NoiseEffect {
    /** Changes the distances of a frame. */
    void apply(long key, long step, NoisyFrame measured);

    /** Whether the same numbers are drawn for every frame. */
    default boolean isConstant() {
        return false;
    }

    default boolean needsIncidence() {
        return false;
    }

    /** Degrees; 0 if no cone is needed. */
    default double coneWidth() {
        return 0;
    }

    /** An error of the same size at any distance. */
    record Gaussian(double mean, double deviation) implements NoiseEffect {
        @Override
        public void apply(long key, long step, NoisyFrame measured) {
            double[] distances = measured.distances;
            for (int k = 0; k < measured.count; k++) {
                distances[k] += mean + deviation * Draws.normal(Draws.bits(key, step, k));
            }
        }
    }

    /** An error that grows with the distance. */
    record Proportional(double share) implements NoiseEffect {
        @Override
        public void apply(long key, long step, NoisyFrame measured) {
            double[] distances = measured.distances;
            for (int k = 0; k < measured.count; k++) {
                double distance = distances[k];
                if (distance < Double.POSITIVE_INFINITY) {
                    distances[k] = distance + share * distance * Draws.normal(Draws.bits(key, step, k));
                }
            }
        }
    }

    /** One error for all. */
    record Bias(double mean, double deviation) implements NoiseEffect {
        @Override
        public boolean isConstant() {
            return true;
        }

        @Override
        public void apply(long key, long step, NoisyFrame measured) {
            double bias = mean + deviation * Draws.normal(Draws.bits(key, step, 0));
            for (int k = 0; k < measured.count; k++) {
                measured.distances[k] += bias;
            }
        }
    }

    /** Whole steps. */
    record Quantized(double size) implements NoiseEffect {
        @Override
        public void apply(long key, long step, NoisyFrame measured) {
            for (int k = 0; k < measured.count; k++) {
                measured.distances[k] = Math.rint(measured.distances[k] / size) * size;
            }
        }
    }

    /** Echoes that get lost. */
    record Dropout(double probability) implements NoiseEffect {
        @Override
        public void apply(long key, long step, NoisyFrame measured) {
            for (int k = 0; k < measured.count; k++) {
                if (Draws.uniform(Draws.bits(key, step, k)) < probability) {
                    measured.distances[k] = measured.lost;
                }
            }
        }
    }

    /** Worse the more a surface is seen from the side. */
    record Grazing(double deviation, double limitDegrees) implements NoiseEffect {
        @Override
        public boolean needsIncidence() {
            return true;
        }

        @Override
        public void apply(long key, long step, NoisyFrame measured) {
            double least = Degrees.cos(limitDegrees);
            double[] distances = measured.distances;
            for (int k = 0; k < measured.count; k++) {
                double cosine = measured.incidence[k];
                if (cosine < 0) {
                    continue; // no surface
                }
                if (cosine < least || cosine == 0) {
                    distances[k] = Double.POSITIVE_INFINITY;
                } else if (distances[k] < Double.POSITIVE_INFINITY) {
                    double tangent = Math.sqrt(1 - cosine * cosine) / cosine;
                    distances[k] += deviation * tangent * Draws.normal(Draws.bits(key, step, k));
                }
            }
        }
    }

    /** A mixture of what is in front and what is behind. */
    record MixedPixels(double widthDegrees, double gap) implements NoiseEffect {
        @Override
        public boolean needsIncidence() {
            return true;
        }

        @Override
        public double coneWidth() {
            return widthDegrees;
        }

        @Override
        public void apply(long key, long step, NoisyFrame measured) {
            double cos = Degrees.cos(widthDegrees / 2);
            double sin = Degrees.sin(widthDegrees / 2);
            for (int k = 0; k < measured.count; k++) {
                double behind = measured.distances[k];
                double front = measured.cones[k];
                if (!(front < nearestOfPlane(behind, measured.incidence[k], cos, sin) - gap)) {
                    continue;
                }
                double drawn = Draws.uniform(Draws.bits(key, step, k));
                if (behind < Double.POSITIVE_INFINITY) {
                    measured.distances[k] = front + drawn * (behind - front);
                } else if (drawn < 0.5) {
                    measured.distances[k] = front;
                }
            }
        }

        /**
         * The distance of the nearest point, within the cone, of the plane that a ray meets. The plane is
         * {@code distance * cosine} away; if the foot of its perpendicular is outside the cone, then the nearest point is on
         * the side of the cone, whose angle to the perpendicular is less by half the opening angle.
         */
        private static double nearestOfPlane(double distance, double cosine, double cos, double sin) {
            if (cosine < 0) {
                return distance; // no surface, and so no plane
            }
            double sine = Math.sqrt(1 - cosine * cosine);
            double away = distance * cosine;
            return sine <= sin ? away : away / (cosine * cos + sine * sin);
        }
    }

    /** Echoes of nothing that is in the world. */
    record FalseEchoes(double probability) implements NoiseEffect {
        @Override
        public void apply(long key, long step, NoisyFrame measured) {
            for (int k = 0; k < measured.count; k++) {
                long bits = Draws.bits(key, step, k);
                if (Draws.uniform(bits) >= probability) {
                    continue;
                }
                double far = Math.min(measured.distances[k], measured.max);
                if (far < Double.POSITIVE_INFINITY) {
                    double near = Math.min(measured.min, far);
                    measured.distances[k] = near + Draws.uniform(Draws.more(bits)) * (far - near);
                }
            }
        }
    }
}
