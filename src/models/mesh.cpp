#include "models/model.hpp"
#include "models/parameters.hpp"
#include "models/scene/parameter.hpp"

#include <fmt/format.h>

#include <cmath>

namespace steplab {

namespace {

constexpr std::string_view kick_places[] = {"centre", "corner"};

constexpr ParameterInfo parameters[] = {{.name = "dim",
                                         .kind = ParameterInfo::Kind::integer,
                                         .unit = "",
                                         .minimum = 3,
                                         .default_value = 10,
                                         .on_change = OnChange::restarts,
                                         .what = "number of particles along each side",
                                         .slider_low = 3,
                                         .slider_high = 100,
                                         .slider_logarithmic = true},
                                        rest_length(2),
                                        force_constant(1, "N/m", 100),
                                        particle_mass(1),
                                        kick_speed(1, "initial velocity of the kicked particle, along y"),
                                        {.name = "kick",
                                         .kind = ParameterInfo::Kind::choice,
                                         .unit = "",
                                         .default_value = 0,
                                         .on_change = OnChange::restarts,
                                         .what = "which particle is kicked",
                                         .choices = kick_places}};

/// Row and column of the kicked particle.
std::size_t kicked_row(const ParameterValues& values) { return values["kick"] == 0 ? values.count("dim") / 2 : 1; }

std::size_t kicked_particle(const ParameterValues& values) {
    return kicked_row(values) * values.count("dim") + kicked_row(values);
}

Lattice lattice(const ParameterValues& values) {
    const std::size_t dim = values.count("dim");
    return {.count = dim * dim, .columns = dim, .along_row = {values["L"], 0, 0}, .between_rows = {0, 0, -values["L"]}};
}

/// The four sides, rows by the indices of their ends.
std::vector<std::string> border(std::size_t dim) {
    std::vector<std::string> names{fmt::format("mesh[0-{}]", dim - 1),
                                   fmt::format("mesh[{}-{}]", dim * (dim - 1), dim * dim - 1)};
    for (std::size_t row = 1; row + 1 < dim; ++row) {
        names.push_back(fmt::format("mesh[0,{}]", row));
        names.push_back(fmt::format("mesh[{},{}]", dim - 1, row));
    }
    return names;
}

Scene scene(const ParameterValues& values) {
    const std::size_t dim = values.count("dim");
    const WrittenNumber length = parameter(values, "L");
    Scene scene;
    scene.particles = {{.group = "mesh",
                        .mass = parameter(values, "m"),
                        .arrangement = GridArrangement{dim, dim, {{{length, 0, 0}, {0, 0, -length}}}}}};
    scene.fixes = {{.particles = border(dim), .fixed = true},
                   {.particles = {fmt::format("mesh[{}]", kicked_particle(values))},
                    .velocity = WrittenVector{0, parameter(values, "v0"), 0},
                    .role = Role::kicked}};
    scene.springs = {{.between = "mesh", .along = SpringTerm::Along::both, .k = parameter(values, "k")}};
    return scene;
}

Plan plan(const ParameterValues& values) {
    const std::size_t dim = values.count("dim"), n = dim * dim;
    return {
        .mass = values["m"],
        .forces =
            GridForces{.rows = dim, .columns = dim, .mass = values["m"], .k = values["k"], .rest_length = values["L"]},
        .reference = lattice(values),
        .start = Start::kick(n, kicked_particle(values), {0, values["v0"], 0})};
}

/// Springs to the east, south, south-east and south-west: each spring once, in the order of its first particle.
void add_springs(Shape& shape, const ParameterValues& values) {
    const std::size_t dim = values.count("dim");
    const double length = values["L"], diagonal = std::sqrt(2.0) * length;
    shape.springs.reserve(4 * dim * dim);
    const auto add = [&](std::size_t first, std::size_t second, double rest) {
        shape.springs.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second), rest});
    };
    for (std::size_t i = 0; i < dim; ++i) {
        for (std::size_t j = 0; j < dim; ++j) {
            const std::size_t p = i * dim + j;
            if (j + 1 < dim) add(p, p + 1, length);
            if (i + 1 < dim) add(p, p + dim, length);
            if (i + 1 < dim && j + 1 < dim) add(p, p + dim + 1, diagonal);
            if (i + 1 < dim && j > 0) add(p, p + dim - 1, diagonal);
        }
    }
}

Shape shape(const ParameterValues& values) {
    const std::size_t dim = values.count("dim");
    Shape shape;
    for (std::size_t i = 0; i < dim * dim; ++i) {
        const std::size_t row = i / dim, column = i % dim;
        const bool border = row == 0 || column == 0 || row + 1 == dim || column + 1 == dim;
        shape.rest.push_back(lattice(values).at(i));
        shape.roles.push_back(border ? Role::fixed : Role::moving);
    }
    shape.roles[kicked_particle(values)] = Role::kicked;
    add_springs(shape, values);
    shape.spacing = values["L"] > 0 ? values["L"] : 1;
    const Vec3 kicked = shape.rest[kicked_particle(values)];
    const Vec3 amplitude{0, values["v0"] * std::sqrt(values["m"] / values["k"]), 0};
    shape.expected = {kicked + amplitude, kicked - amplitude};
    return shape;
}

/// That of the infinite grid, in its plane at wave vector (pi, 0): omega^2 = 8 k / m. The fixed border lowers it by a
/// few percent in small meshes, so that a dt below the limit computed from it is always below the true one.
std::optional<double> omega_max(const ParameterValues& values) {
    return std::sqrt(8.0) * std::sqrt(values["k"] / values["m"]);
}

SceneFacts facts(const ParameterValues& values) {
    const double ends = values.count("dim") == 3 ? 1 : 2;  // that move, of the spring that swings fastest
    return {.mass = values["m"], .bond = values["L"], .pair_frequency = std::sqrt(ends * values["k"] / values["m"])};
}

}  // namespace

const Model& mesh_model() {
    static const Model model{
        .info = {.id = "mesh",
                 .name = "Mesh",
                 .what = "dim × dim particles, each connected to its 8 neighbours by springs; the border is fixed, one "
                         "particle is kicked upwards.",
                 .parameters = parameters},
        .topic = "springs",
        .particles = [](const ParameterValues& values) { return values["dim"] * values["dim"]; },
        .facts = facts,
        .scene = scene,
        .plan = plan,
        .shape = shape,
        .omega_max = omega_max,
        .exact = [](const ParameterValues&) { return std::shared_ptr<const ExactSolution>(); },
    };
    return model;
}

}  // namespace steplab
