package robosim.geometry.sweep.lines;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import robosim.geometry.Snapshot;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;

/** A digest of strings and of numbers by their bits: the same on every JVM. */
public final class Fingerprint {
    private final MessageDigest digest;

    public Fingerprint() {
        try {
            digest = MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
    }

    /** The digest of a world's settings and objects. */
    public static String of(Snapshot world) {
        Fingerprint print = new Fingerprint();
        print.add(world.width()).add(world.height()).add(world.length());
        print.add(world.dimension().name()).add(world.accuracy().name());
        world.objects().forEach(print::add);
        return print.hex().substring(0, 16);
    }

    public Fingerprint add(long number) {
        digest.update(ByteBuffer.allocate(Long.BYTES).putLong(number).array());
        return this;
    }

    public Fingerprint add(double number) {
        return add(Double.doubleToLongBits(number));
    }

    public Fingerprint add(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        add(bytes.length);
        digest.update(bytes);
        return this;
    }

    private void add(Point point) {
        add(point.x()).add(point.y()).add(point.z());
    }

    public void add(GeometryObject object) {
        add(object.kind().name());
        String name = object.name();
        add(name == null ? "" : name).add(object.isMoveable() ? 1 : 0);
        add(object.center());
        for (double number : object.rotation()) {
            add(number);
        }
        add(object.heading());
        Material material = object.material();
        if (!material.equals(Material.of(material.color()))) {
            add(material);
        }
        for (double size : object.sizes()) {
            add(size);
        }
        if (object instanceof MeshObject mesh) {
            add(mesh);
        } else if (object instanceof GridObject grid) {
            add(grid);
        } else if (object instanceof ObjectGroup group) {
            add(group.members().size());
            group.members().forEach(this::add);
        }
    }

    /** Not of one that is only a colour, which worlds had before there were materials. */
    private void add(Material material) {
        add(material.color());
        add(material.diffuse())
                .add(material.specular())
                .add(material.shininess())
                .add(material.mirror());
        add(material.emission());
        add(material.reflectance()).add(material.label());
        Texture texture = material.texture();
        add(texture == null ? "" : texture.getClass().getSimpleName());
        if (texture instanceof Texture.Checker checker) {
            add(checker.first());
            add(checker.second());
            add(checker.size());
        } else if (texture instanceof Texture.Stripes stripes) {
            add(stripes.first());
            add(stripes.second());
            add(stripes.size()).add(stripes.degrees());
        } else if (texture instanceof ImageTexture image) {
            add(image.width()).add(image.height()).add(image.tileWidth()).add(image.tileHeight());
            digest.update(image.bytes());
        }
    }

    private void add(Color color) {
        add(color.red()).add(color.green()).add(color.blue());
    }

    private void add(GridObject grid) {
        add(grid.cell()).add(grid.height()).add(grid.columns()).add(grid.rows());
        digest.update(grid.bytes());
    }

    private void add(MeshObject mesh) {
        add(mesh.isSolid() ? 1 : 0).add(mesh.vertices().size());
        mesh.vertices().forEach(this::add);
        for (int[] face : mesh.faces()) {
            add(face.length);
            for (int corner : face) {
                add(corner);
            }
        }
        TextureCoordinates texture = mesh.textureCoordinates();
        if (texture != null) {
            for (double number : texture.points()) {
                add(number);
            }
            for (int corner : texture.corners()) {
                add(corner);
            }
        }
    }

    /** The digest so far, in hexadecimal. */
    public String hex() {
        return HexFormat.of().formatHex(digest.digest());
    }
}
