/**
 * Support for testing robot programs, with JUnit Jupiter 5 or 6: a world from a file, robots by name, a clock that
 * advances in steps, a random source whose seed a failure reports, and on failure a scenario file that replays what
 * happened and a picture of its last moments.
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
