package robosim.geometry.narrow.cone;

/** Working memory for queries about cones. */
final class ConeWorkspace {
    final Cone cone = new Cone();
    final PlainConeBox box = new PlainConeBox();
    final PlainSectorBox sectorBox = new PlainSectorBox();
    final ConePolytope polytope = new ConePolytope();
    final ConeCylinder cylinder = new ConeCylinder();
    final SectorOval oval = new SectorOval();
    final ConeCapsule capsule = new ConeCapsule();
}
