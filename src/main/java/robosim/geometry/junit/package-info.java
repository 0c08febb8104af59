/**
 * Support for testing robot programs, with JUnit Jupiter 5 or 6: a world from a file, robots by name, a clock that
 * advances in steps, a random source whose seed a failure reports, and on failure a scenario file that replays what
 * happened and a picture of its last moments.
 *
 * <ul>
 *   <li>{@link World}: the world of a test, from a file or a method
 *   <li>{@link RobotWorld}: that world as a parameter of the test; it returns robots and places
 *   <li>{@link Robot}: drives, turns, senses, is pushed, and checks what it touches
 *   <li>{@link Arrival}: a robot on its way to a goal
 *   <li>{@link Goal}: where robots must arrive
 *   <li>{@link Sonar}: what a sensor of a robot reads
 *   <li>{@link Range}: the distance between a robot and an object, for assertions
 *   <li>{@link VirtualClock}: the time of a test, which advances in steps
 *   <li>{@link Seed}: the seed of its random numbers
 *   <li>{@link ScenarioTest} and {@link Scenarios}: tests made of scenario files
 * </ul>
 *
 * <pre>{@code
 * @World("worlds/rooms.xml")
 * class CorridorTest {
 *     @Test
 *     void drumOneLeavesTheCorridor(RobotWorld world) {
 *         world.robot("drum 1").drives(2.0).turns(90).senses(0, 3.0).neverTouches("bench 1");
 *     }
 * }
 * }</pre>
 *
 * <p>{@code docs/scenario-tests.md} is the guide. Requires JUnit Jupiter's API, and Jackson's core if scenarios are
 * read or written. Nothing here sleeps or reads the time of day.
 */
@NullMarked
package robosim.geometry.junit;

import org.jspecify.annotations.NullMarked;
