package robosim.geometry.world.sdf;

import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.LimitProblem;
import robosim.geometry.world.shared.Placement;

/** The visuals of links. One that cannot be read is not seen, which costs nothing that is solid. */
final class SdfVisuals {
    private final SdfShapes shapes;
    private int failed;
    private String first = "";

    /** Those seen without their pictures. */
    private int plain;

    private String firstPlain = "";

    SdfVisuals(SdfShapes shapes) {
        this.shapes = shapes;
    }

    /** Where a visual is in its model. */
    @FunctionalInterface
    interface Local {
        Placement get() throws FileProblem;
    }

    /** What a visual shows, placed in an outer frame; null if nothing. */
    @Nullable
    GeometryObject read(SdfElement visual, SdfNode link, Placement outer, Local local) throws FileProblem {
        if (visual.child("geometry") == null) {
            return null;
        }
        try {
            Placement place = outer.then(local.get());
            GeometryObject shape = shapes.shape(visual, "visual", place, link.scale);
            if (shape == null || SdfShapes.isFloor(visual, place)) {
                return null;
            }
            Material material = SdfMaterials.ofVisual(visual);
            SdfElement map = SdfMaterials.picture(visual);
            ImageTexture image = material == null || map == null ? null : picture(map);
            if (material != null && image != null) {
                material = material.withTexture(covering(shape, image));
            }
            GeometryObject made = material == null || material.isDefault() ? shape : shape.withMaterial(material);
            return made.at(place.pose());
        } catch (LimitProblem e) {
            throw e;
        } catch (FileProblem | IllegalArgumentException e) {
            first = failed++ == 0 ? String.valueOf(e.getMessage()) : first;
            return null;
        }
    }

    /** The picture of an element; null if it cannot be read, and the plain colour is seen there. */
    private @Nullable ImageTexture picture(SdfElement map) throws FileProblem {
        SdfFiles files = shapes.files();
        try {
            Path file = files.find(map);
            if (file == null) {
                throw files.missing(map);
            }
            return files.textures().read(file.toAbsolutePath().resolveSibling(""), String.valueOf(file.getFileName()));
        } catch (LimitProblem e) {
            throw e;
        } catch (FileProblem | IllegalArgumentException e) {
            firstPlain = plain++ == 0 ? String.valueOf(e.getMessage()) : firstPlain;
            return null;
        }
    }

    /** A picture that covers a shape once: the largest sides of a box, or all around. */
    private static ImageTexture covering(GeometryObject shape, ImageTexture image) {
        if (shape instanceof BoxObject box) {
            double least = Math.min(box.width(), Math.min(box.height(), box.length()));
            double wide = box.width() == least ? box.length() : box.width();
            double high = box.height() == least ? box.length() : box.height();
            return wide > 0 && high > 0 ? image.tiled(wide, high) : image;
        }
        if (shape instanceof SphereObject sphere && sphere.radius() > 0) {
            return image.tiled(2 * Math.PI * sphere.radius(), Math.PI * sphere.radius());
        }
        return shape instanceof CylinderObject cylinder && cylinder.radius() > 0 && cylinder.height() > 0
                ? image.tiled(2 * Math.PI * cylinder.radius(), cylinder.height())
                : image;
    }

    /** Adds that some are missing. */
    void remark(List<String> remarks) {
        if (failed > 0) {
            remarks.add(failed + (failed == 1 ? " visual is" : " visuals are")
                    + " not seen, and a model without others as" + " its collisions; the first one: " + first);
        }
        if (plain > 0) {
            remarks.add(
                    plain + (plain == 1 ? " visual is" : " visuals are") + " seen in a plain colour, as the picture of"
                            + " an <albedo_map> cannot be read; the first one: " + firstPlain);
        }
    }

    /**
     * An object that is seen as some visuals.
     *
     * @param visuals in the frame around the object; none if it is seen as its shape
     */
    static GeometryObject seenAs(GeometryObject object, List<GeometryObject> visuals) {
        Placement back = Placement.of(object.pose()).inverse();
        return object.withVisuals(visuals.stream()
                .map(each -> each.at(back.then(Placement.of(each.pose())).pose()))
                .toList());
    }
}
