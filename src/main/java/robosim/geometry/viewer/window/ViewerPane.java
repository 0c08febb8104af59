package robosim.geometry.viewer.window;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.GridLayout;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.Serial;
import java.nio.file.Path;
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
    private final transient KeyHelp help = new KeyHelp();
    private final transient Saving saving;
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
        this(viewing, theme, worker, Path.of(""));
    }

    ViewerPane(ViewerModel viewing, Theme theme, Executor worker, Path folder) {
        super(new BorderLayout());
        this.saving = new Saving(folder);
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

    /** Lets the plan and the camera go along with the selected robot, or no longer. */
    private void toggleFollowing() {
        boolean isFollowing = viewing.toggleFollowing();
        if (isFollowing && space.gallery.arrangement() == Gallery.Arrangement.OWN) {
            space.gallery.show(Gallery.Arrangement.ONE);
        }
        space.gallery.follow(isFollowing);
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
        typed('h', "these keys", help::toggle);
        key("F1", "these keys", help::toggle);
        if (viewing.hasSteps()) {
            key("SPACE", "play or pause", this::togglePlay);
            key("LEFT", "a step back; with Shift ten", () -> step(-1));
            key("RIGHT", "a step on; with Shift ten", () -> step(1));
            key("shift LEFT", "", () -> step(-FAR));
            key("shift RIGHT", "", () -> step(FAR));
            key("HOME", "the first step", () -> seek(Integer.MIN_VALUE));
            key("END", "the last step", () -> seek(Integer.MAX_VALUE));
            key("UP", "faster", () -> faster(1));
            key("DOWN", "slower", () -> faster(-1));
            typed('t', "longer trails, all, none", viewing.layers()::nextTrails);
        }
        typed('s', "sonars, or not", () -> viewing.layers().toggle(Layers.Layer.SONARS));
        typed('x', "refused moves, or not", () -> viewing.layers().toggle(Layers.Layer.REFUSALS));
        typed('g', "go with the selected robot", this::toggleFollowing);
        typed('q', "turn the selected robot left", () -> viewing.turnPicked(TURN));
        typed('e', "turn the selected robot right", () -> viewing.turnPicked(-TURN));
        typed('+', "zoom in", () -> zoom(1));
        typed('=', "", () -> zoom(1));
        typed('-', "zoom out", () -> zoom(-1));
        typed('f', "fit everything", this::fit);
        typed('v', "plan, both, three dimensions", this::nextParts);
        typed('c', "more cameras", this::nextCameras);
        typed('r', "a robot's own view", this::toggleOwn);
        typed('i', "fly forward, back", () -> space.gallery.fly(1, 0, 0));
        typed('k', "fly forward, back", () -> space.gallery.fly(-1, 0, 0));
        typed('j', "fly left, right", () -> space.gallery.fly(0, 0, -1));
        typed('l', "fly left, right", () -> space.gallery.fly(0, 0, 1));
        typed('o', "fly up, down", () -> space.gallery.fly(0, 1, 0));
        typed('u', "fly up, down", () -> space.gallery.fly(0, -1, 0));
        typed('d', "dark or light", () -> paintAs(theme == Theme.LIGHT ? Theme.DARK : Theme.LIGHT));
        typed('p', "save a picture of this window", this::picture);
        key("control S", "save the world as it stands", () -> viewing.save(saving));
        key("ESCAPE", "leave the copy, clear the selection", this::escape);
    }

    private void escape() {
        if (help.isShown()) {
            help.hide();
        } else {
            viewing.escape();
        }
    }

    /** Saves what the window shows, without the help. */
    private void picture() {
        help.hide();
        BufferedImage image = new BufferedImage(getWidth(), getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics page = image.createGraphics();
        paint(page);
        page.dispose();
        viewing.tell(() -> saving.picture(image, viewing.title()));
    }

    @Override
    protected void paintChildren(Graphics graphics) {
        super.paintChildren(graphics);
        if (help.isShown()) {
            help.paint(graphics, getWidth(), getHeight(), theme);
        }
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

    /** Binds a key that is pressed; what has no words is not in the help. */
    private void key(String stroke, String words, Runnable action) {
        bind(KeyStroke.getKeyStroke(stroke), action);
        help.add(stroke, words);
    }

    /** Binds a character, which different keyboards have on different keys. */
    private void typed(char character, String words, Runnable action) {
        bind(KeyStroke.getKeyStroke(character), action);
        bind(KeyStroke.getKeyStroke(Character.toUpperCase(character)), action);
        help.add(String.valueOf(character), words);
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
