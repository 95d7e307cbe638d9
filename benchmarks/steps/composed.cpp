#include "composed.hpp"

#include "io/scene_file.hpp"
#include "sim/run/simulation.hpp"
#include "sim/run/starting.hpp"
#include "sim/steppers/reordered.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>

namespace steplab::benchmark {

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// Of `count` points at random in a cube, one in each volume of 1.
std::vector<Vec3> points_in_a_cube(std::size_t count) {
    std::mt19937_64 random(2008);
    std::uniform_real_distribution<double> anywhere(0, std::cbrt(static_cast<double>(count)));
    std::vector<Vec3> points(count);
    for (Vec3& point : points) point = {anywhere(random), anywhere(random), anywhere(random)};
    return points;
}

/// Each with its 6 nearest, searched for among cells of side 2 around it.
std::set<Pair> nearest_six(const std::vector<Vec3>& points) {
    constexpr std::size_t nearest = 6, row = 64;
    const auto cell = [](double at) { return static_cast<std::size_t>(at / 2) + 1; };
    std::vector<std::vector<std::uint32_t>> cells(row * row * row);
    const auto place = [](std::size_t x, std::size_t y, std::size_t z) { return (x * row + y) * row + z; };
    for (std::uint32_t i = 0; i < points.size(); ++i)
        cells[place(cell(points[i].x), cell(points[i].y), cell(points[i].z))].push_back(i);
    std::set<Pair> pairs;
    std::vector<std::pair<double, std::uint32_t>> near;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        near.clear();
        for (std::size_t d = 0; d < 27; ++d) {
            const Vec3 at = points[i];
            for (const std::uint32_t j :
                 cells[place(cell(at.x) + d % 3 - 1, cell(at.y) + d / 3 % 3 - 1, cell(at.z) + d / 9 - 1)])
                near.emplace_back(dot(points[j] - at, points[j] - at), j);
        }
        const std::size_t found = std::min(near.size(), nearest + 1);
        std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(found), near.end());
        for (std::size_t k = 1; k < found; ++k) pairs.insert(std::minmax(i, near[k].second));
    }
    return pairs;
}

std::string xyz(const std::vector<Vec3>& points, double speed) {
    std::mt19937_64 random(2009);
    std::normal_distribution<double> v(0, speed);
    std::string text = fmt::format("{}\nProperties=species:S:1:pos:R:3:velo:R:3\n", points.size());
    for (const Vec3 at : points)
        fmt::format_to(std::back_inserter(text), "X {:.9f} {:.9f} {:.9f} {:.6f} {:.6f} {:.6f}\n", at.x, at.y, at.z,
                       v(random), v(random), v(random));
    return text;
}

SceneOrigin with_particles(const std::string& text, std::string particles) {
    return scene_from(
        {{"", "steplab = 1\n[[particles]]\nfile = \"start.xyz\"\n" + text}, {"start.xyz", std::move(particles)}},
        "scene.toml");
}

SceneOrigin network() {
    const std::vector<Vec3> points = points_in_a_cube(100000);
    std::string text = "[[springs]]\nk = 1\npairs = [\n";
    for (const auto& [i, j] : nearest_six(points)) fmt::format_to(std::back_inserter(text), "[{}, {}],\n", i, j);
    return with_particles(text + "]\n", xyz(points, 0.1));
}

constexpr double liquid_box = 20 * 1.679595;  // density 0.8442

SceneOrigin liquid(std::string_view pairs) {
    const std::string text = fmt::format(
        "steplab = 1\n[[particles]]\nlattice = {{ kind = \"fcc\", cells = [20, 20, 20], constant = {0} }}\n"
        "temperature = {{ kT = 1.44, seed = 2008 }}\n[box]\nsize = [{1}, {1}, {1}]\n[[pairs]]\n{2}epsilon = 1\nsigma = "
        "1\ncutoff = 2.5\n",
        liquid_box / 20, liquid_box, pairs);
    return scene_from({{"", text}}, "scene.toml");
}

SceneOrigin gravity() {
    std::vector<Vec3> points = points_in_a_cube(1000);
    for (Vec3& point : points) point = 0.2 * point;
    return with_particles("[[pairs]]\npotential = \"gravity\"\nG = 0.001\nsoftening = 0.1\n", xyz(points, 0.3));
}

/// The scene as peers are given it: in the order in which steplab steps it.
Problem problem_of(const RunDescription& run, std::string_view model) {
    const Frame start = Simulation(run).frame();
    const Plan plan = plan_of(run);
    std::vector<std::uint32_t> order = order_by_place(plan);
    if (order.empty()) {
        order.resize(start.positions.size());
        std::iota(order.begin(), order.end(), 0U);
    }
    Problem problem{.model = model, .method = run.method, .dt = run.dt, .positions = {}, .velocities = {}};
    std::vector<std::uint32_t> places(order.size());
    for (std::uint32_t place = 0; place < order.size(); ++place) {
        problem.positions.push_back(start.positions[order[place]]);
        problem.velocities.push_back(start.velocities[order[place]]);
        places[order[place]] = place;
    }
    std::vector<Join> springs;
    for (const ComposedSpring& spring : std::get<ComposedForces>(plan.forces).terms->springs) {
        const auto [first, second] = std::minmax(places[spring.first], places[spring.second]);
        springs.push_back({first, second, spring.length});
    }
    std::sort(springs.begin(), springs.end(),
              [](const Join& a, const Join& b) { return std::pair(a.first, a.second) < std::pair(b.first, b.second); });
    problem.springs = std::make_shared<const std::vector<Join>>(std::move(springs));
    problem.box = liquid_box;
    return problem;
}

struct Row {
    std::string_view id, peers;
    std::function<SceneOrigin()> scene;
    double dt;
    std::size_t steps;
    std::vector<std::size_t> threads;
};

const std::vector<Row>& rows() {
    static const std::vector<Row> all{
        {"network-100000", "network", network, 0.05, 40, {1, 2}},
        {"liquid-32000", "liquid", [] { return liquid("potential = \"lennard-jones\"\n"); }, 0.004, 20, {1, 2}},
        {"liquid-32000-expression",
         "",
         [] { return liquid("potential = \"4*epsilon*((sigma/r)^12 - (sigma/r)^6)\"\n"); },
         0.004,
         20,
         {1}},
        {"gravity-1000", "gravity", gravity, 0.004, 100, {1}}};
    return all;
}

}  // namespace

std::vector<Comparison> composed_comparisons(
    const std::function<Contestant(const RunDescription&, std::size_t threads)>& ourselves,
    const std::function<bool(const std::string& name)>& wanted) {
    std::vector<Comparison> all;
    for (const Row& row : rows()) {
        std::optional<RunDescription> scene;
        for (const std::string_view method : {"velocity-verlet", "rk4"}) {
            for (const Precision precision : {Precision::double_, Precision::float_}) {
                const std::string name = fmt::format("{}/{}/{}", row.id, method, id(precision));
                if (!wanted(name)) continue;
                if (!scene) scene = describe(row.scene());
                RunDescription run = with_method(*scene, method);
                run.precision = precision;
                run.dt = row.dt;
                const Problem problem = problem_of(run, row.peers);
                Comparison comparison{name, problem.positions.size(), {}};
                for (const std::size_t threads : row.threads)
                    comparison.entries.push_back({ourselves(run, threads), row.steps, row.steps});
                for (const Contestant& peer :
                     precision == Precision::float_ ? peers_in_float(problem) : peers_in_double(problem))
                    comparison.entries.push_back({peer, row.steps, row.steps});
                all.push_back(std::move(comparison));
            }
        }
    }
    return all;
}

}  // namespace steplab::benchmark
