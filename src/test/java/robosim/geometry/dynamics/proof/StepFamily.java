package robosim.geometry.dynamics.proof;

import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Small worlds in which a step may go wrong, each with a wall, an order or a cage that tells who has passed through what. */
enum StepFamily {
    /** A wall as thin as a nanometre from border to border, upright or oblique, and speeds of up to 10^4 m/s. */
    THIN_WALLS {
        @Override
        StepScene make(SplittableRandom random) {
            StepScene scene = scene(random, 8, 8);
            double thick = Math.pow(10, random.nextDouble(-9, -3));
            double heading = random.nextBoolean() ? 0 : random.nextDouble(360);
            double along = StrictMath.abs(StrictMath.cos(StrictMath.toRadians(heading)));
            double aside = StrictMath.abs(StrictMath.sin(StrictMath.toRadians(heading)));
            double length = 2 * (4 - SLIT - thick) / Math.max(along, aside);
            BoxObject wall = new BoxObject(new Point(0, 0, 0), thick, 1, heading == 0 ? 8 : length).turned(0, heading);
            scene.wall(wall);
            for (int k = 0; k < 4; k++) {
                any(scene, random, 3.5, 0.2, 0.9);
            }
            scene.keepsSides(0, 0, wall.rotation()[2], wall.rotation()[8]);
            return scene;
        }

        @Override
        double speed(SplittableRandom random) {
            return random.nextInt(3) > 0 ? 1e4 : 5;
        }
    },
    /** Two walls that meet at less than 40 degrees, and bodies that are driven into where they meet. */
    WEDGES {
        @Override
        StepScene make(SplittableRandom random) {
            StepScene scene = scene(random, 20, 20);
            double half = StrictMath.toRadians(random.nextDouble(0.5, 20));
            double thick = Math.pow(10, random.nextDouble(-6, -2));
            double[][] ways = new double[2][];
            for (int side = 0; side < 2; side++) {
                double angle = side == 0 ? half : -half;
                double dx = StrictMath.cos(angle);
                double dz = StrictMath.sin(angle);
                double reach = (19 - SLIT - thick) / dx / 2;
                // A turn takes the own X to (cos, -sin).
                scene.wall(new BoxObject(new Point(-9 + reach * dx, 0, reach * dz), 2 * reach, 1, thick)
                        .turned(0, -StrictMath.toDegrees(angle)));
                ways[side] = new double[] {dx, dz};
            }
            for (int k = 0; k < 12 && scene.names.size() < 3; k++) {
                double x = random.nextDouble(-4, 9);
                double room = (x + 9) * StrictMath.tan(half);
                double size = Math.min(0.8, room) * random.nextDouble(0.2, 0.9);
                add(scene, random, new Point(x, 0, random.nextDouble(-room, room)), size, size);
            }
            for (double[] way : ways) {
                scene.keepsSides(-9, 0, way[0], way[1]);
            }
            return scene;
        }

        @Override
        void stir(StepScene scene, SplittableRandom random) {
            double speed = random.nextInt(3) == 0 ? 1e4 : 5;
            for (String name : scene.names) {
                scene.velocity(
                        name,
                        -random.nextDouble() * speed,
                        random.nextDouble(-0.2, 0.2) * speed,
                        random.nextDouble(-200, 200));
            }
        }
    },
    /** A row in a corridor too narrow for two to pass: nearly touching, hit at one end. */
    CHAINS {
        @Override
        StepScene make(SplittableRandom random) {
            StepScene scene = scene(random, 24, 1);
            double gap = Math.pow(10, random.nextDouble(-9, -1));
            double x = random.nextDouble(-11, -4);
            int count = random.nextInt(2, 6);
            for (int k = 0; k < count; k++) {
                double size = random.nextDouble(0.6, 0.85);
                boolean isRound = random.nextBoolean();
                Point at = new Point(x + size / 2, 0, random.nextDouble(-0.5, 0.5) * (0.999 - size));
                GeometryObject shape = isRound ? new CylinderObject(at, size / 2, 1) : new BoxObject(at, size, 1, size);
                if (scene.body(shape, body(shape, random)) != null) {
                    x += size + gap;
                }
            }
            scene.law(() -> {
                for (int k = 1; k < scene.names.size(); k++) {
                    if (scene.center(scene.names.get(k - 1)).x()
                            >= scene.center(scene.names.get(k)).x()) {
                        return scene.names.get(k) + " has been passed by the one behind it";
                    }
                }
                return null;
            });
            return scene;
        }

        @Override
        void stir(StepScene scene, SplittableRandom random) {
            double speed = random.nextInt(3) == 0 ? 1e4 : 5;
            int count = scene.names.size();
            for (int k = 0; k < count; k++) {
                boolean isHit = random.nextInt(4) == 0;
                double along = k == 0 ? speed : k == count - 1 ? -speed : isHit ? random.nextDouble(-speed, speed) : 0;
                scene.velocity(scene.names.get(k), along, isHit ? speed / 10 : 0, isHit ? 90 : 0);
            }
        }
    },
    /** Two half walls that meet in the middle: their corner is hit by two at once, and between the two by a third. */
    CORNERS {
        @Override
        StepScene make(SplittableRandom random) {
            StepScene scene = scene(random, 8, 8);
            double thick = Math.pow(10, random.nextDouble(-6, -1));
            scene.wall(new BoxObject(new Point(0, 0, 2), thick, 1, 4));
            scene.wall(new BoxObject(new Point(2, 0, 0), 4, 1, thick));
            double far = random.nextDouble(1, 3);
            double radius = random.nextDouble(0.1, 0.5);
            for (int k = 0; k < 2; k++) {
                Point c = k == 0 ? new Point(far, 0, -far) : new Point(-far, 0, far);
                GeometryObject shape = new CylinderObject(c, radius, 1);
                scene.body(shape, Body.ofMass(shape, 2).withSurface(surface(random)));
            }
            any(scene, random, 3.5, 0.2, 0.6);
            GeometryObject inner = new BoxObject(new Point(far, 0, far), radius, 1, radius)
                    .turned(0, random.nextBoolean() ? 45 : random.nextDouble(90));
            scene.body(inner, body(inner, random));
            boolean[] isWithin = new boolean[scene.names.size()];
            for (int k = 0; k < isWithin.length; k++) {
                isWithin[k] = isWithin(scene, k);
            }
            scene.law(() -> {
                for (int k = 0; k < isWithin.length; k++) {
                    if (isWithin(scene, k) != isWithin[k]) {
                        return scene.names.get(k) + " has passed the corner's walls";
                    }
                }
                return null;
            });
            return scene;
        }

        private boolean isWithin(StepScene scene, int k) {
            Point c = scene.center(scene.names.get(k));
            return c.x() > 0 && c.z() > 0;
        }

        @Override
        void stir(StepScene scene, SplittableRandom random) {
            // All towards the corner, so that they are there at one time.
            double seconds = random.nextInt(3) == 0 ? 1e-3 : random.nextDouble(0.05, 1);
            for (String name : scene.names) {
                Point c = scene.center(name);
                scene.velocity(name, -c.x() / seconds, -c.z() / seconds, random.nextInt(3) == 0 ? 100 : 0);
            }
        }
    },
    /** Frames that move and turn, with somebody in each who never gets out, and others who never get in. */
    CAGES {
        @Override
        StepScene make(SplittableRandom random) {
            StepScene scene = scene(random, 10, 10);
            double half = random.nextDouble(0.6, 1.2);
            double thick = Math.pow(10, random.nextDouble(-4, -1));
            Point at = new Point(random.nextDouble(-2, 2), 0, random.nextDouble(-2, 2));
            GeometryObject frame =
                    frame(half, thick).turned(0, random.nextDouble(360)).movedTo(at);
            scene.body(frame, Body.of(random.nextDouble(0.5, 5), half * half));
            GeometryObject inner = random.nextBoolean()
                    ? new CylinderObject(at, half * random.nextDouble(0.2, 0.8), 1)
                    : new BoxObject(at, half * random.nextDouble(0.2, 1), 1, half * random.nextDouble(0.2, 0.8));
            scene.body(inner, body(inner, random));
            any(scene, random, 4.5, 0.2, 0.8);
            // The third may have found a place inside as well.
            boolean[] wasIn = new boolean[scene.names.size()];
            for (int k = 1; k < wasIn.length; k++) {
                wasIn[k] = isIn(scene, k, half);
            }
            scene.law(() -> {
                for (int k = 1; k < wasIn.length; k++) {
                    if (isIn(scene, k, half) != wasIn[k]) {
                        return "b" + k + " has passed the frame";
                    }
                }
                return null;
            });
            return scene;
        }

        private boolean isIn(StepScene scene, int k, double half) {
            GeometryObject cage = scene.world.getObject("b0");
            double[] r = cage.rotation();
            double dx = scene.center("b" + k).x() - cage.center().x();
            double dz = scene.center("b" + k).z() - cage.center().z();
            return Math.abs(r[0] * dx + r[6] * dz) < half && Math.abs(r[2] * dx + r[8] * dz) < half;
        }

        @Override
        double speed(SplittableRandom random) {
            return random.nextInt(3) == 0 ? 1e4 : 5;
        }
    },
    /** Groups like an L and like a U, which catch each other. */
    HOOKS {
        @Override
        StepScene make(SplittableRandom random) {
            StepScene scene = parted(random);
            for (int k = 0; k < 3; k++) {
                double thick = random.nextDouble(0.05, 0.3);
                GeometryObject foot = new BoxObject(new Point(0, 0, 0.5), 1, 1, thick);
                GeometryObject leg = new BoxObject(new Point(0.5, 0, 0), thick, 1, 1);
                GeometryObject other = new BoxObject(new Point(-0.5, 0, 0), thick, 1, 1);
                GeometryObject hook = new ObjectGroup(k == 0 ? List.of(foot, leg) : List.of(foot, leg, other))
                        .turned(0, random.nextDouble(360))
                        .movedTo(anywhere(random, 3.3));
                scene.body(hook, Body.of(random.nextDouble(0.5, 5), 0.4).withSurface(surface(random)));
            }
            any(scene, random, 3.5, 0.1, 0.4);
            scene.keepsSides(0, 0, 0, 1);
            return scene;
        }
    },
    /** Long bars that turn by up to a revolution in a tenth of a second. */
    BARS {
        @Override
        StepScene make(SplittableRandom random) {
            StepScene scene = parted(random);
            for (int k = 0; k < 4; k++) {
                GeometryObject bar = new BoxObject(
                                anywhere(random, 3.5),
                                random.nextDouble(0.5, 3),
                                1,
                                Math.pow(10, random.nextDouble(-3, -0.7)))
                        .turned(0, random.nextDouble(360));
                scene.body(bar, body(bar, random));
            }
            scene.keepsSides(0, 0, 0, 1);
            return scene;
        }

        @Override
        double turn(SplittableRandom random) {
            return random.nextInt(4) == 0 ? 3600 : 360;
        }
    },
    /** Rows and columns of equal bodies with equal gaps, so that many meet at one time. */
    LATTICES {
        @Override
        StepScene make(SplittableRandom random) {
            StepScene scene = scene(random, 8, 8);
            double gap = random.nextInt(3) == 0 ? Math.pow(10, random.nextDouble(-9, -2)) : 0.125;
            boolean areRound = random.nextBoolean();
            Surface surface = surface(random);
            int columns = random.nextInt(2, 4);
            for (int k = 0; k < 2 * columns; k++) {
                Point c = new Point((k % columns) * (0.75 + gap) - 1, 0, (k / columns) * (0.75 + gap) - 1);
                GeometryObject shape = areRound ? new CylinderObject(c, 0.375, 1) : new BoxObject(c, 0.75, 1, 0.75);
                scene.body(shape, Body.ofMass(shape, 1).withSurface(surface));
            }
            return scene;
        }

        @Override
        void stir(StepScene scene, SplittableRandom random) {
            double speed = random.nextInt(4) == 0 ? 1e4 : 4;
            int way = random.nextInt(4);
            for (String name : scene.names) {
                Point c = scene.center(name);
                double inwards = way == 0 ? speed : 0;
                // All in one direction, all to the middle, or one alone.
                double vx = way == 1 ? -Math.signum(c.x()) * speed : way == 2 && name.equals("b0") ? speed : inwards;
                double vz = way == 1 ? -Math.signum(c.z()) * speed : way == 3 ? -speed : inwards;
                scene.velocity(name, vx, vz, 0);
            }
        }
    },
    /** Walls on a map of cells, one column of which has no gap. */
    MAPS {
        @Override
        StepScene make(SplittableRandom random) {
            StepScene scene = scene(random, 8, 8);
            BitSet cells = new BitSet();
            for (int row = 0; row < 20; row++) {
                cells.set(row * 20 + 10);
                cells.set(row * 20 + random.nextInt(20));
            }
            GridObject wall =
                    new GridObject(new Point(0, 0, 0), 0.4, 1, 20, 20, cells).turned(0, 90 * random.nextInt(4));
            scene.wall(wall);
            for (int k = 0; k < 12 && scene.names.size() < 3; k++) {
                any(scene, random, 3.5, 0.1, 0.5);
            }
            double[] r = wall.rotation();
            scene.keepsSides(0.2 * r[0], 0.2 * r[6], r[2], r[8]);
            return scene;
        }

        @Override
        double speed(SplittableRandom random) {
            return random.nextInt(3) == 0 ? 1e4 : 5;
        }
    },
    /** Steps of up to an hour. */
    LONG_STEPS {
        @Override
        StepScene make(SplittableRandom random) {
            StepScene scene = parted(random);
            for (int k = 0; k < 3; k++) {
                any(scene, random, 3.5, 0.2, 0.9);
            }
            scene.keepsSides(0, 0, 0, 1);
            return scene;
        }

        @Override
        double seconds(StepScene scene, SplittableRandom random) {
            return Math.pow(10, random.nextDouble(-1, random.nextInt(64) == 0 ? 3.5 : 0));
        }

        @Override
        double speed(SplittableRandom random) {
            return random.nextInt(32) == 0 ? 1e4 : 3;
        }

        @Override
        double turn(SplittableRandom random) {
            return random.nextInt(3) == 0 ? 20 : 0;
        }
    },
    /** Robots that drive against walls and each other, and push what the floor slows. */
    DRIVEN {
        @Override
        StepScene make(SplittableRandom random) {
            StepScene scene = parted(random);
            for (int k = 0; k < 8 && scene.names.size() < 4; k++) {
                Point c = anywhere(random, 3.5);
                GeometryObject shape = k % 2 == 0
                        ? new CylinderObject(c, random.nextDouble(0.2, 0.5), 1)
                        : new BoxObject(c, 0.5, 1, 0.4).turned(0, random.nextDouble(360));
                Body body = body(shape, random);
                scene.body(shape, scene.names.size() < 2 ? body : body.withFloorFriction(0.4));
            }
            scene.keepsSides(0, 0, 0, 1);
            return scene;
        }

        @Override
        void stir(StepScene scene, SplittableRandom random) {
            for (int k = 0; k < Math.min(2, scene.names.size()); k++) {
                scene.dynamics.drive(
                        scene.names.get(k),
                        new DifferentialDrive(0.4, 3, 6)
                                .driving(random.nextDouble(-1, 3), random.nextDouble(-120, 120)));
            }
        }

        @Override
        boolean isDriven() {
            return true;
        }
    },
    /** Balls, capsules, meshes and cylinders that lie. */
    SHAPES {
        @Override
        StepScene make(SplittableRandom random) {
            StepScene scene = parted(random);
            // Cylinders that lie cost most.
            int kinds = random.nextInt(4) == 0 ? 4 : 3;
            for (int k = 0; k < kinds; k++) {
                Point c = anywhere(random, 3.2);
                double size = random.nextDouble(0.3, 0.8);
                GeometryObject shape = switch (k) {
                    case 0 -> new SphereObject(c, size / 2);
                    case 1 -> new CapsuleObject(c, size / 3, size).turned(random.nextDouble(10, 90), 0);
                    case 2 -> wedge(size).movedTo(c);
                    default -> new CylinderObject(c, size / 3, size).turned(90, random.nextDouble(360));
                };
                scene.body(
                        shape,
                        Body.of(random.nextDouble(0.5, 5), 0.2 * size * size).withSurface(surface(random)));
            }
            scene.keepsSides(0, 0, 0, 1);
            return scene;
        }
    };

    /** What is left beside the end of an oblique wall, which no body fits through. */
    private static final double SLIT = 1e-5;

    abstract StepScene make(SplittableRandom random);

    /** Gives the bodies new velocities. */
    void stir(StepScene scene, SplittableRandom random) {
        scene.stir(random, speed(random), turn(random));
    }

    double speed(SplittableRandom random) {
        return random.nextInt(5) == 0 ? 1e4 : 5;
    }

    double turn(SplittableRandom random) {
        return random.nextInt(3) == 0 ? 0 : 400;
    }

    /** How long a step is: mostly such that the fastest goes some metres, one in 512 up to a hundred times as long. */
    double seconds(StepScene scene, SplittableRandom random) {
        double way = random.nextInt(512) == 0 ? random.nextDouble(200) : random.nextDouble(2);
        return Math.min(random.nextInt(3) == 0 ? 1e-3 : 0.1, way / Math.max(1, scene.fastest()));
    }

    /** Whether its steps take long. */
    boolean isSlow() {
        return this == CAGES || this == CHAINS || this == SHAPES;
    }

    /** Whether drives bring in energy. */
    boolean isDriven() {
        return false;
    }

    private static StepScene scene(SplittableRandom random, double width, double length) {
        return new StepScene(width, length, surface(random));
    }

    /** A room that a thin wall parts. */
    private static StepScene parted(SplittableRandom random) {
        StepScene scene = scene(random, 8, 8);
        scene.wall(new BoxObject(new Point(0, 0, 0), 1e-6, 1, 8));
        return scene;
    }

    private static Surface surface(SplittableRandom random) {
        double friction = random.nextInt(3) == 0 ? 0 : random.nextDouble();
        double bounce = random.nextInt(3) == 0 ? random.nextInt(2) : random.nextDouble();
        return new Surface(bounce, friction, friction * random.nextDouble());
    }

    private static Body body(GeometryObject shape, SplittableRandom random) {
        return Body.ofMass(shape, random.nextDouble(0.1, 10)).withSurface(surface(random));
    }

    private static Point anywhere(SplittableRandom random, double half) {
        return new Point(random.nextDouble(-half, half), 0, random.nextDouble(-half, half));
    }

    private static void any(StepScene scene, SplittableRandom random, double half, double least, double most) {
        add(scene, random, anywhere(random, half), random.nextDouble(least, most), random.nextDouble(least, most));
    }

    private static @Nullable String add(
            StepScene scene, SplittableRandom random, Point c, double width, double length) {
        GeometryObject shape = random.nextInt(3) == 0
                ? new CylinderObject(c, width / 2, 1)
                : new BoxObject(c, width, 1, length).turned(0, random.nextDouble(360));
        return scene.body(shape, body(shape, random));
    }

    private static ObjectGroup frame(double half, double thick) {
        double out = half + thick / 2;
        return new ObjectGroup(List.of(
                new BoxObject(new Point(-out, 0, 0), thick, 1, 2 * half + 2 * thick),
                new BoxObject(new Point(out, 0, 0), thick, 1, 2 * half + 2 * thick),
                new BoxObject(new Point(0, 0, -out), 2 * half, 1, thick),
                new BoxObject(new Point(0, 0, out), 2 * half, 1, thick)));
    }

    /** A prism over a triangle. */
    private static MeshObject wedge(double size) {
        List<Point> corners = List.of(
                new Point(-size, -0.5, -size / 2),
                new Point(size / 2, -0.5, -size / 2),
                new Point(-size / 2, -0.5, size / 2),
                new Point(-size, 0.5, -size / 2),
                new Point(size / 2, 0.5, -size / 2),
                new Point(-size / 2, 0.5, size / 2));
        return new MeshObject(
                corners,
                new int[][] {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}});
    }
}
