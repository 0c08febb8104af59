/**
 * What surfaces look like, and what sensors feel of them: colours, materials and textures.
 *
 * <ul>
 *   <li>{@link Material}: colour, reflection, texture, and what sensors measure: reflectance and label
 *   <li>{@link Color}: red, green and blue
 *   <li>{@link Texture}: a pattern on a surface: {@link Texture.Checker}, {@link Texture.Stripes} or {@link
 *       ImageTexture}
 *   <li>{@link ImageTexture}: a picture as a texture
 *   <li>{@link TextureCoordinates}: where on a mesh a picture goes
 * </ul>
 *
 * <p>Every object of a world has a {@link robosim.geometry.material.Material}; one that was given none has {@link
 * robosim.geometry.material.Material#DEFAULT}. No query about collisions, moves or distances looks at it.
 *
 * <pre>{@code
 * Material steel = Material.of(Color.parse("#c0c4cc")).withSpecular(0.6).withShininess(80).withMirror(0.2);
 * Material hazard = Material.DEFAULT
 *         .withTexture(new Texture.Stripes(Color.parse("#ffd000"), Color.BLACK, 0.2, 45))
 *         .withReflectance(0.8)
 *         .withLabel(7);
 * steel.color();                              // #c0c4cc
 * hazard.label();                             // 7
 * hazard.equals(hazard.withMirror(0));        // true
 * }</pre>
 *
 * <p>All types are immutable, compare by value and may be shared between threads.
 */
@NullMarked
package robosim.geometry.material;

import org.jspecify.annotations.NullMarked;
