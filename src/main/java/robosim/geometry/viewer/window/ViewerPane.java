package robosim.geometry.viewer.window;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.GridLayout;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.io.Serial;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import robosim.geometry.viewer.draw.Palette;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.space.Gallery;
import robosim.geometry.viewer.space.SpaceCamera;

/**
 * The contents of a viewer's window: the map, the world in three dimensions, a status line below them, and for a
 * conversation its controls.
 */
final class ViewerPane extends JPanel {
    @Serial
    private static final long serialVersionUID = 1;

    private static final int TURN = 15;
    private static final int FAR = 10;

    private final transient ViewerModel viewing;
    private final MapPanel map;
    private final SpacePanel space;
    private final JPanel views = new JPanel(new GridLayout(1, 0, 2, 0));
    private final Timeline timeline;
    private final JPanel below = new JPanel();
    private final JPanel bar = new JPanel();
    private final JPanel foot = new JPanel();
    private final JLabel status = new JLabel(" ");
    private final JLabel speed = new JLabel(" ");
    private final transient List<JButton> buttons = new ArrayList<>();
    private final JButton play;
    private Theme theme;
    private Parts parts = Parts.PLAN;

    /** Whether keys that both parts know are meant for the one in three dimensions. */
    private boolean isInSpace;

    /** What is shown of the world. */
    private enum Parts {
        PLAN,
        BOTH,
        SPACE;

        Parts next() {
            return switch (this) {
                case PLAN -> BOTH;
                case BOTH -> SPACE;
                case SPACE -> PLAN;
            };
        }
    }

    ViewerPane(ViewerModel viewing, Theme theme) {
        this(viewing, theme, SpacePanel.worker());
    }

    /** A pane whose pictures in three dimensions are made elsewhere. */
    ViewerPane(ViewerModel viewing, Theme theme, Executor worker) {
        super(new BorderLayout());
        this.viewing = viewing;
        this.theme = theme;
        this.map = new MapPanel(viewing, theme, this::refresh);
        this.space = new SpacePanel(viewing, theme, this::refresh, worker);
        this.timeline = new Timeline(viewing, theme, this::refresh);
        this.play = button("play", ControlIcon.Shape.PLAY, "Play or pause (Space)", this::togglePlay);
        add(views, BorderLayout.CENTER);
        map.addMouseListener(new Entered(false));
        space.addMouseListener(new Entered(true));
        show(Parts.PLAN);
        lay();
        keys();
        paintAs(theme);
        refresh();
    }

    private void lay() {
        status.setName("status");
        for (JLabel label : List.of(status, speed)) {
            label.putClientProperty("html.disable", true); // names from peers are shown as plain text
        }
        speed.setName("speed");
        below.setLayout(new BoxLayout(below, BoxLayout.Y_AXIS));
        below.setBorder(BorderFactory.createEmptyBorder(0, 12, 8, 12));
        bar.setLayout(new BoxLayout(bar, BoxLayout.X_AXIS));
        bar.setAlignmentX(LEFT_ALIGNMENT);
        status.setAlignmentX(LEFT_ALIGNMENT);
        if (viewing.hasSteps()) {
            bar.add(button("first", ControlIcon.Shape.FIRST, "First step (Home)", () -> seek(Integer.MIN_VALUE)));
            bar.add(button("back", ControlIcon.Shape.BACK, "One step back (Left)", () -> step(-1)));
            bar.add(play);
            bar.add(button("forward", ControlIcon.Shape.FORWARD, "One step forward (Right)", () -> step(1)));
            bar.add(button("last", ControlIcon.Shape.LAST, "Last step (End)", () -> seek(Integer.MAX_VALUE)));
            bar.add(Box.createHorizontalStrut(8));
            bar.add(timeline);
            bar.add(Box.createHorizontalStrut(8));
            bar.add(button("slower", ControlIcon.Shape.SLOWER, "Slower (Down)", () -> faster(-1)));
            bar.add(speed);
            bar.add(button("faster", ControlIcon.Shape.FASTER, "Faster (Up)", () -> faster(1)));
            below.add(bar);
            below.add(Box.createVerticalStrut(4));
        }
        foot.setLayout(new BoxLayout(foot, BoxLayout.X_AXIS));
        foot.setAlignmentX(LEFT_ALIGNMENT);
        foot.add(status);
        foot.add(Box.createHorizontalGlue());
        foot.add(button("view", ControlIcon.Shape.CUBE, "Plan, both, or three dimensions (V)", this::nextParts));
        foot.add(button("cameras", ControlIcon.Shape.CAMERAS, "More cameras (C)", this::nextCameras));
        foot.add(button("own", ControlIcon.Shape.EYE, "What a robot sees (R)", this::toggleOwn));
        foot.add(button("follow", ControlIcon.Shape.FOLLOW, "Go along with a robot (G)", this::toggleFollowing));
        below.add(foot);
        add(below, BorderLayout.SOUTH);
    }

    private JButton button(String name, ControlIcon.Shape shape, String tip, Runnable action) {
        JButton button = new JButton(new ControlIcon(shape));
        button.setName(name);
        button.setToolTipText(tip);
        button.setFocusable(false);
        button.setContentAreaFilled(false);
        button.setBorder(BorderFactory.createEmptyBorder(4, 6, 4, 6));
        button.setPreferredSize(new Dimension(34, 28));
        button.getAccessibleContext().setAccessibleName(tip);
        button.addActionListener(event -> {
            action.run();
            refresh();
        });
        buttons.add(button);
        return button;
    }

    private final class Entered extends MouseAdapter {
        private final boolean isSpace;

        Entered(boolean isSpace) {
            this.isSpace = isSpace;
        }

        @Override
        public void mouseEntered(MouseEvent event) {
            isInSpace = isSpace;
        }
    }

    private void show(Parts other) {
        parts = other;
        isInSpace = parts == Parts.SPACE;
        views.removeAll();
        if (parts != Parts.SPACE) {
            views.add(map);
        }
        if (parts != Parts.PLAN) {
            views.add(space);
        }
        revalidate();
    }

    private void nextParts() {
        show(parts.next());
    }

    private void nextCameras() {
        if (parts == Parts.PLAN) {
            show(Parts.BOTH);
        }
        space.gallery.next();
    }

    private void toggleOwn() {
        boolean isOwn = parts != Parts.PLAN && space.gallery.arrangement() == Gallery.Arrangement.OWN;
        if (parts == Parts.PLAN) {
            show(Parts.BOTH);
        }
        space.gallery.show(isOwn ? Gallery.Arrangement.ONE : Gallery.Arrangement.OWN);
    }

    private void toggleFollowing() {
        boolean follow = parts == Parts.PLAN || !space.gallery.isFollowing();
        if (parts == Parts.PLAN) {
            show(Parts.BOTH);
        }
        if (space.gallery.arrangement() == Gallery.Arrangement.OWN) {
            space.gallery.show(Gallery.Arrangement.ONE);
        }
        space.gallery.follow(follow);
    }

    private void togglePlay() {
        viewing.leaveCopy();
        viewing.player.toggle();
    }

    private void step(int steps) {
        viewing.leaveCopy();
        viewing.player.step(steps);
    }

    private void seek(int number) {
        viewing.leaveCopy();
        viewing.player.seek(number);
    }

    private void faster(int steps) {
        viewing.player.faster(steps);
    }

    private void keys() {
        if (viewing.hasSteps()) {
            key("SPACE", this::togglePlay);
            key("LEFT", () -> step(-1));
            key("RIGHT", () -> step(1));
            key("shift LEFT", () -> step(-FAR));
            key("shift RIGHT", () -> step(FAR));
            key("HOME", () -> seek(Integer.MIN_VALUE));
            key("END", () -> seek(Integer.MAX_VALUE));
            key("UP", () -> faster(1));
            key("DOWN", () -> faster(-1));
            typed('t', viewing::nextTrails);
        }
        typed('+', () -> zoom(1));
        typed('=', () -> zoom(1));
        typed('-', () -> zoom(-1));
        typed('f', this::fit);
        typed('v', this::nextParts);
        typed('c', this::nextCameras);
        typed('r', this::toggleOwn);
        typed('g', this::toggleFollowing);
        typed('i', () -> space.gallery.fly(1, 0, 0));
        typed('k', () -> space.gallery.fly(-1, 0, 0));
        typed('l', () -> space.gallery.fly(0, 0, 1));
        typed('j', () -> space.gallery.fly(0, 0, -1));
        typed('o', () -> space.gallery.fly(0, 1, 0));
        typed('u', () -> space.gallery.fly(0, -1, 0));
        typed('d', () -> paintAs(theme == Theme.LIGHT ? Theme.DARK : Theme.LIGHT));
        typed('q', () -> viewing.turnPicked(TURN));
        typed('e', () -> viewing.turnPicked(-TURN));
        key("ESCAPE", viewing::escape);
    }

    private void fit() {
        if (isInSpace) {
            space.gallery.fit();
        } else {
            viewing.camera.fit();
        }
    }

    private void zoom(int steps) {
        if (isInSpace) {
            space.gallery.zoom(StrictMath.pow(SpaceCamera.STEP, steps));
            return;
        }
        viewing.wheel(map.getWidth() / 2.0, map.getHeight() / 2.0, -steps);
    }

    private void key(String stroke, Runnable action) {
        bind(KeyStroke.getKeyStroke(stroke), action);
    }

    private void typed(char letter, Runnable action) {
        bind(KeyStroke.getKeyStroke(letter), action);
        bind(KeyStroke.getKeyStroke(Character.toUpperCase(letter)), action);
    }

    private void bind(KeyStroke stroke, Runnable action) {
        getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(stroke, stroke);
        getActionMap().put(stroke, new Action(event -> {
            action.run();
            refresh();
        }));
    }

    private static final class Action extends AbstractAction {
        @Serial
        private static final long serialVersionUID = 1;

        private final transient Consumer<ActionEvent> action;

        Action(Consumer<ActionEvent> action) {
            this.action = action;
        }

        @Override
        public void actionPerformed(ActionEvent event) {
            action.accept(event);
        }
    }

    /** Advances the time and shows what has changed. */
    void tick(long nanos) {
        if (viewing.tick(nanos)) {
            refresh();
        }
    }

    /** Updates everything shown. */
    private void refresh() {
        String words = viewing.status();
        if (!words.equals(status.getText())) {
            status.setText(words);
        }
        speed.setText(viewing.pace());
        play.setIcon(new ControlIcon(viewing.player.isPlaying() ? ControlIcon.Shape.PAUSE : ControlIcon.Shape.PLAY));
        space.order();
        repaint();
    }

    private void paintAs(Theme other) {
        theme = other;
        Color paper = new Color(Palette.PAPER.in(theme));
        Color text = new Color(Palette.TEXT.in(theme));
        Color quiet = new Color(Palette.QUIET.in(theme));
        setBackground(paper);
        below.setBackground(paper);
        bar.setBackground(paper);
        foot.setBackground(paper);
        views.setBackground(paper);
        status.setForeground(text);
        speed.setForeground(quiet);
        Font plain = status.getFont().deriveFont(Font.PLAIN, 13f);
        status.setFont(plain);
        speed.setFont(plain);
        for (JButton button : buttons) {
            button.setForeground(text);
            button.setBackground(paper);
        }
        map.setTheme(theme);
        space.setTheme(theme);
        timeline.setTheme(theme);
        repaint();
    }
}
