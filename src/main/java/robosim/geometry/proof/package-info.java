/**
 * Proofs of answers: a claim, and a witness with which a short program can verify it in exact arithmetic. That program is {@link
 * robosim.geometry.proof.ProofChecker}; it contains nothing of what found the answer. A second one in Python, {@code
 * examples/check_proof.py}, reads the form that {@link robosim.geometry.proof.Proof#json} writes.
 *
 * <ul>
 *   <li>{@link Claim}: what is proved
 *   <li>{@link Scene}: the objects that it is about
 *   <li>{@link Proof}, {@link Attempt}: a claim with its witness (directions of planes, common or near points); or a reason why
 *       none was found
 *   <li>{@link ProofChecker}: decides whether a proof holds
 *   <li>{@link Prover}: looks for proofs; {@link robosim.geometry.Geometry#prove} does it for the answers of a world
 * </ul>
 *
 * <pre>{@code
 * BoxObject crate = new BoxObject(new Point(0, 0, 0), 2, 2, 2);
 * SphereObject ball = new SphereObject(new Point(2.5, 0, 0), 1);
 * Attempt attempt = Prover.of(crate).apart(ball);
 * attempt.isProved();                                                     // true
 * new ProofChecker(Scene.of(crate)).check(attempt.proof()).isValid();     // true
 * }</pre>
 */
@NullMarked
package robosim.geometry.proof;

import org.jspecify.annotations.NullMarked;
