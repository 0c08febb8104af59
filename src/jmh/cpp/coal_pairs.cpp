// Coal's answers to the pairs of robosim.geometry.bench.Pairs: coal_pairs FILE, then a line "turn" on the standard input for
// each round. For each set a line: name, CPU ns of a collision test, CPU ns of a distance, pairs judged other than in the file.
#include <coal/BVH/BVH_model.h>
#include <coal/collision.h>
#include <coal/distance.h>
#include <coal/shape/geometric_shapes.h>
#include <ctime>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
using namespace coal;
typedef std::shared_ptr<CollisionGeometry> Shape;
struct Placed { Shape shape; Transform3s at; };
struct Pair { Placed a, b; bool touch; };
struct Set { std::string name; std::vector<Pair> pairs; };

static double now() {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return t.tv_sec * 1e9 + t.tv_nsec;
}

static Shape mesh(const std::string &file) {
    std::ifstream in(file);
    int vertices, triangles;
    in >> vertices >> triangles;
    std::vector<Vec3s> v(vertices);
    std::vector<Triangle> t(triangles);
    for (Vec3s &p : v) in >> p[0] >> p[1] >> p[2];
    for (Triangle &p : t) { size_t i, j, k; in >> i >> j >> k; p = Triangle(i, j, k); }
    auto model = std::make_shared<BVHModel<OBBRSS>>();
    model->beginModel(triangles, vertices);
    model->addSubModel(v, t);
    model->endModel();
    return model;
}

static Placed placed(std::istream &in, const Shape &model) {
    std::string kind;
    double s[3], c[3];
    Matrix3s r;
    in >> kind >> s[0] >> s[1] >> s[2] >> c[0] >> c[1] >> c[2];
    for (int k = 0; k < 9; k++) in >> r(k / 3, k % 3);
    Matrix3s z_up; // Coal's axes of cylinders and capsules are z, the file's are y
    z_up << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    Shape shape;
    if (kind == "box") shape = std::make_shared<Box>(s[0], s[1], s[2]);
    else if (kind == "sphere") shape = std::make_shared<Sphere>(s[0]);
    else if (kind == "mesh") shape = model;
    else {
        if (kind == "capsule") shape = std::make_shared<Capsule>(s[0], s[1]);
        else shape = std::make_shared<Cylinder>(s[0], s[1]);
        r = r * z_up;
    }
    return {shape, Transform3s(r, Vec3s(c[0], c[1], c[2]))};
}

int main(int, char **arguments) {
    std::ifstream in(arguments[1]);
    std::vector<Set> sets;
    Shape model;
    std::string line;
    while (std::getline(in, line)) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "model") { words >> word; model = mesh(word); }
        else if (word == "set") { words >> word; sets.push_back({word, {}}); }
        else {
            Pair pair;
            pair.touch = word == "touch";
            pair.a = placed(words, model);
            pair.b = placed(words, model);
            sets.back().pairs.push_back(pair);
        }
    }
    double sum = 0;
    while (std::getline(std::cin, line)) {
        for (const Set &set : sets) {
            size_t n = set.pairs.size();
            CollisionRequest collides;
            collides.enable_contact = false;
            CollisionResult hit;
            DistanceRequest measures;
            measures.enable_signed_distance = false;
            DistanceResult result;
            double start = now();
            int wrong = 0;
            for (const Pair &p : set.pairs) {
                hit.clear();
                wrong += (collide(p.a.shape.get(), p.a.at, p.b.shape.get(), p.b.at, collides, hit) > 0) != p.touch;
            }
            double between = now();
            for (const Pair &p : set.pairs) {
                result.clear();
                sum += distance(p.a.shape.get(), p.a.at, p.b.shape.get(), p.b.at, measures, result);
            }
            double end = now();
            std::cout << set.name << ' ' << (between - start) / n << ' ' << (end - between) / n << ' ' << wrong << '\n';
        }
        std::cout << "done " << (sum == 42) << std::endl;
    }
}
