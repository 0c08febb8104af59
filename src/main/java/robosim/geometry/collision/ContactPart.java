package robosim.geometry.collision;

/**
 * The piece of an object that takes part in a contact.
 *
 * @param part index of the object's simple part: 0 unless the object is a group or a grid. The boxes, cylinders, spheres,
 *     capsules and meshes of a group are counted from 0 in the order of its members; those of a nested group are counted
 *     at that group's place. Of a grid it is the cell, row * columns + column
 * @param face the index of the mesh's face, as its faces were given; -1 if the part is not a mesh, or is a solid mesh
 *     that contains the other piece and none of whose faces is touched
 * @param half which triangle of the face: 0 for the face's corners 0, 1, 2, which is all of a triangle, and 1 for
 *     corners 0, 2, 3 of a quad; -1 if there is no face
 */
public record ContactPart(int part, int face, int half) implements Comparable<ContactPart> {
    /** Whether this is a face of a mesh; otherwise it is the part as a whole. */
    public boolean isFace() {
        return face >= 0;
    }

    /** By part, then by face, then by half. */
    @Override
    public int compareTo(ContactPart other) {
        if (part != other.part) {
            return Integer.compare(part, other.part);
        }
        return face != other.face ? Integer.compare(face, other.face) : Integer.compare(half, other.half);
    }
}
