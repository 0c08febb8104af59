package robosim.geometry.world.sdf;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.LimitProblem;
import robosim.geometry.world.shared.Placement;

/** The visuals of links. One that cannot be read is not seen, which costs nothing that is solid. */
final class SdfVisuals {
    private final SdfShapes shapes;
    private int failed;
    private String first = "";

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
            GeometryObject made = material == null || material.isDefault() ? shape : shape.withMaterial(material);
            return made.at(place.pose());
        } catch (LimitProblem e) {
            throw e;
        } catch (FileProblem | IllegalArgumentException e) {
            first = failed++ == 0 ? String.valueOf(e.getMessage()) : first;
            return null;
        }
    }

    /** Adds that some are missing. */
    void remark(List<String> remarks) {
        if (failed > 0) {
            remarks.add(failed + (failed == 1 ? " visual is" : " visuals are")
                    + " not seen, and a model without others as" + " its collisions; the first one: " + first);
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
