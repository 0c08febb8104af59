package robosim.geometry.viewer.scene;

/** A growing rectangle of the XZ plane. */
public final class Bounds {
    private double minX = Double.POSITIVE_INFINITY;
    private double minZ = Double.POSITIVE_INFINITY;
    private double maxX = Double.NEGATIVE_INFINITY;
    private double maxZ = Double.NEGATIVE_INFINITY;

    public void add(Outline outline) {
        if (outline instanceof Outline.Disc disc) {
            add(disc.x() - disc.radius(), disc.z() - disc.radius());
            add(disc.x() + disc.radius(), disc.z() + disc.radius());
        } else if (outline instanceof Outline.Polygon polygon) {
            for (int k = 0; k < polygon.corners().length; k += 2) {
                add(polygon.corners()[k], polygon.corners()[k + 1]);
            }
        }
    }

    public void add(Scene.View view) {
        add(view.minX(), view.minZ());
        add(view.maxX(), view.maxZ());
    }

    private void add(double x, double z) {
        minX = Math.min(minX, x);
        minZ = Math.min(minZ, z);
        maxX = Math.max(maxX, x);
        maxZ = Math.max(maxZ, z);
    }

    boolean isWithin(Scene.View view) {
        return view.minX() <= minX && view.minZ() <= minZ && maxX <= view.maxX() && maxZ <= view.maxZ();
    }

    public boolean isApart(double fromX, double fromZ, double toX, double toZ) {
        return toX < minX || maxX < fromX || toZ < minZ || maxZ < fromZ;
    }

    public double width() {
        return Math.max(0, maxX - minX);
    }

    public double length() {
        return Math.max(0, maxZ - minZ);
    }

    double maxX() {
        return maxX;
    }

    public double middleX() {
        return (minX + maxX) / 2;
    }

    public double middleZ() {
        return (minZ + maxZ) / 2;
    }

    /** This rectangle and a margin of a twentieth around it; a unit square where there is nothing. */
    public Scene.View view() {
        if (minX > maxX) {
            return new Scene.View(-0.5, -0.5, 0.5, 0.5, false);
        }
        double size = Math.max(width(), length());
        double margin = size > 0 ? size / 20 : 0.5;
        return new Scene.View(minX - margin, minZ - margin, maxX + margin, maxZ + margin, false);
    }
}
