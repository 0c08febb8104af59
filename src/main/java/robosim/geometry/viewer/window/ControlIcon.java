package robosim.geometry.viewer.window;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import javax.swing.Icon;

/** The icons on the buttons, in the colour of the button's text. */
record ControlIcon(Shape shape) implements Icon {
    private static final int SIZE = 16;

    /** Each as closed polygons of x,y on a square of 16 by 16. */
    enum Shape {
        PLAY("3,1 14,8 3,15"),
        PAUSE("3,2 7,2 7,14 3,14 | 9,2 13,2 13,14 9,14"),
        BACK("10,2 2,8 10,14 | 11.5,2 14.0,2 14.0,14 11.5,14"),
        FORWARD("6,2 14,8 6,14 | 2,2 4.5,2 4.5,14 2,14"),
        FIRST("1,2 3.5,2 3.5,14 1,14 | 10,2 4,8 10,14 | 16,2 10,8 16,14"),
        LAST("12.5,2 15.0,2 15.0,14 12.5,14 | 6,2 12,8 6,14 | 0,2 6,8 0,14"),
        SLOWER("2,7 14,7 14,9 2,9"),
        FASTER("2,7 7,7 7,2 9,2 9,7 14,7 14,9 9,9 9,14 7,14 7,9 2,9"),
        CUBE("8,1 14,4.5 8,8 2,4.5 | 2,6 7.3,9 7.3,15 2,12 | 14,6 8.7,9 8.7,15 14,12"),
        CAMERAS("2,2 7,2 7,7 2,7 | 9,2 14,2 14,7 9,7 | 2,9 7,9 7,14 2,14 | 9,9 14,9 14,14 9,14"),
        EYE("1,8 4,4.5 8,3 12,4.5 15,8 12,11.5 8,13 4,11.5"),
        FOLLOW("9,3 15,8 9,13 | 1,4 3,4 3,12 1,12 | 4.5,4 6.5,4 6.5,12 4.5,12");

        private final String polygons;

        Shape(String polygons) {
            this.polygons = polygons;
        }
    }

    @Override
    public void paintIcon(Component on, Graphics graphics, int x, int y) {
        Graphics2D page = (Graphics2D) graphics.create();
        page.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        page.translate(x, y);
        page.setColor(on.getForeground());
        for (String polygon : shape.polygons.split(" \\| ", -1)) {
            Path2D path = new Path2D.Double();
            for (String corner : polygon.split(" ", -1)) {
                double px = Double.parseDouble(corner.substring(0, corner.indexOf(',')));
                double py = Double.parseDouble(corner.substring(corner.indexOf(',') + 1));
                if (path.getCurrentPoint() == null) {
                    path.moveTo(px, py);
                } else {
                    path.lineTo(px, py);
                }
            }
            path.closePath();
            page.fill(path);
        }
        page.dispose();
    }

    @Override
    public int getIconWidth() {
        return SIZE;
    }

    @Override
    public int getIconHeight() {
        return SIZE;
    }
}
