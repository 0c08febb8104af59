/** The command line: the only room that parses arguments or exits. It needs picocli and the JDK's java.desktop. */
@NullMarked
package robosim.geometry.cli;

import org.jspecify.annotations.NullMarked;
