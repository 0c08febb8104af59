package robosim.geometry.render;

import robosim.geometry.exact.Degrees;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Texture;

/** Looks up the linear colour of a texture at a place (s, t) in its plane. */
abstract class Pattern {
    /** Looks up a place in world units. */
    abstract void color(double s, double t, double[] out);

    /** Whether the texture is a picture, so that texture coordinates place it. */
    boolean isImage() {
        return false;
    }

    /** Looks up a place in shares of a picture. */
    void colorOfShare(double u, double v, double[] out) {
        color(u, v, out);
    }

    static Pattern of(Texture texture) {
        if (texture instanceof Texture.Checker checker) {
            return new Checker(checker);
        }
        if (texture instanceof Texture.Stripes stripes) {
            return new Stripes(stripes);
        }
        return new Image((ImageTexture) texture);
    }

    /** Two colours in turn. */
    private abstract static class Two extends Pattern {
        private final double[] first;
        private final double[] second;

        Two(Color first, Color second) {
            this.first = linear(first);
            this.second = linear(second);
        }

        private static double[] linear(Color color) {
            return new double[] {color.linearRed(), color.linearGreen(), color.linearBlue()};
        }

        final void take(boolean isFirst, double[] out) {
            double[] taken = isFirst ? first : second;
            out[0] = taken[0];
            out[1] = taken[1];
            out[2] = taken[2];
        }
    }

    private static boolean isEven(double whole) {
        double half = whole / 2;
        return half == Math.floor(half);
    }

    private static final class Checker extends Two {
        private final double size;

        Checker(Texture.Checker texture) {
            super(texture.first(), texture.second());
            size = texture.size();
        }

        @Override
        void color(double s, double t, double[] out) {
            take(isEven(Math.floor(s / size)) == isEven(Math.floor(t / size)), out);
        }
    }

    private static final class Stripes extends Two {
        private final double size;
        private final double alongS;
        private final double alongT;

        Stripes(Texture.Stripes texture) {
            super(texture.first(), texture.second());
            size = texture.size();
            alongS = -Degrees.sin(texture.degrees());
            alongT = Degrees.cos(texture.degrees());
        }

        @Override
        void color(double s, double t, double[] out) {
            take(isEven(Math.floor((s * alongS + t * alongT) / size)), out);
        }
    }

    /** A picture: between the middles of its pixels, their colours are mixed. */
    private static final class Image extends Pattern {
        private final ImageTexture image;
        private final double tileWidth;
        private final double tileHeight;

        Image(ImageTexture texture) {
            image = texture;
            tileWidth = texture.tileWidth();
            tileHeight = texture.tileHeight();
        }

        @Override
        boolean isImage() {
            return true;
        }

        @Override
        void color(double s, double t, double[] out) {
            colorOfShare(s / tileWidth, t / tileHeight, out);
        }

        @Override
        void colorOfShare(double u, double v, double[] out) {
            int width = image.width();
            int height = image.height();
            double x = (u - Math.floor(u)) * width - 0.5;
            double y = (1 - (v - Math.floor(v))) * height - 0.5;
            int left = (int) Math.floor(x);
            int top = (int) Math.floor(y);
            double right = x - left;
            double low = y - top;
            int left0 = wrap(left, width);
            int left1 = wrap(left + 1, width);
            int a = image.pixel(left0, wrap(top, height));
            int b = image.pixel(left1, wrap(top, height));
            int c = image.pixel(left0, wrap(top + 1, height));
            int d = image.pixel(left1, wrap(top + 1, height));
            for (int k = 0; k < 3; k++) {
                int shift = 16 - 8 * k;
                double above = mix(a >> shift & 0xff, b >> shift & 0xff, right);
                double below = mix(c >> shift & 0xff, d >> shift & 0xff, right);
                out[k] = above + (below - above) * low;
            }
        }

        private static int wrap(int k, int count) {
            return k < 0 ? k + count : k >= count ? k - count : k;
        }

        private static double mix(int a, int b, double share) {
            double first = Color.linear(a);
            return first + (Color.linear(b) - first) * share;
        }
    }
}
