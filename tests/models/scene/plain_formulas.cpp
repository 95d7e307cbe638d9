// Potentials written out for plain_scene.hpp: none of steplab's own formulas is used.

#include "models/scene/plain_scene.hpp"

#include <stdexcept>

namespace steplab::test {

namespace {

using P = PlainParticle;
using V = PlainValues;

Real morse_b(const V& v) { return std::sqrt(Real(v.at("k")) / (2 * Real(v.at("D")))); }
Real morse_energy(Real r, const V& v, const P&, const P&) {
    const Real e = std::exp(-morse_b(v) * (r - Real(v.at("r0"))));
    return Real(v.at("D")) * e * (e - 2);
}
Real morse_slope(Real r, const V& v, const P&, const P&) {
    const Real b = morse_b(v), e = std::exp(-b * (r - Real(v.at("r0"))));
    return 2 * Real(v.at("D")) * b * e * (1 - e);
}

Real lennard_jones_energy(Real r, const V& v, const P&, const P&) {
    const Real s = Real(v.at("sigma")) / r;
    return 4 * Real(v.at("epsilon")) * (std::pow(s, Real(12)) - std::pow(s, Real(6)));
}
Real lennard_jones_slope(Real r, const V& v, const P&, const P&) {
    const Real s = Real(v.at("sigma")) / r;
    return 4 * Real(v.at("epsilon")) * (6 * std::pow(s, Real(6)) - 12 * std::pow(s, Real(12))) / r;
}

Real inverse(Real r, Real softening) { return 1 / std::hypot(r, softening); }
Real gravity_energy(Real r, const V& v, const P& a, const P& b) {
    return -Real(v.at("G")) * a.mass * b.mass * inverse(r, v.at("softening"));
}
Real gravity_slope(Real r, const V& v, const P& a, const P& b) {
    return Real(v.at("G")) * a.mass * b.mass * r * std::pow(inverse(r, v.at("softening")), Real(3));
}
Real coulomb_energy(Real r, const V& v, const P& a, const P& b) {
    return Real(v.at("K")) * a.charge * b.charge * inverse(r, v.at("softening"));
}
Real coulomb_slope(Real r, const V& v, const P& a, const P& b) {
    return -Real(v.at("K")) * a.charge * b.charge * r * std::pow(inverse(r, v.at("softening")), Real(3));
}

Real well_energy(Real r, const V& v, const P&, const P&) {
    const Real A = v.at("A"), w = v.at("w"), B = v.at("B");
    return -A * std::exp(-(r / w) * (r / w)) + B / (r * r * r);
}
Real well_slope(Real r, const V& v, const P&, const P&) {
    const Real A = v.at("A"), w = v.at("w"), B = v.at("B");
    return 2 * A * r / (w * w) * std::exp(-(r / w) * (r / w)) - 3 * B / (r * r * r * r);
}

Real sided_energy(Real r, const V&, const P& a, const P& b) {
    return a.mass * b.charge * b.charge * std::exp(-r / 2) * std::sqrt(r);
}
Real sided_slope(Real r, const V&, const P& a, const P& b) {
    return a.mass * b.charge * b.charge * std::exp(-r / 2) * (1 / (2 * std::sqrt(r)) - std::sqrt(r) / 2);
}

Real mixed_energy(Real r, const V&, const P& a, const P& b) {
    return Real(0.25) * a.mass * b.mass * std::exp(-r) - a.charge * b.charge * std::tanh(r) / (1 + r);
}
Real mixed_slope(Real r, const V&, const P& a, const P& b) {
    const Real t = std::tanh(r);
    return -Real(0.25) * a.mass * b.mass * std::exp(-r) -
           a.charge * b.charge * ((1 - t * t) / (1 + r) - t / ((1 + r) * (1 + r)));
}
/// 1 - tanh(r)^2, of which little is left.
Real mixed_terms(Real r, const V&, const P& a, const P& b) { return std::abs(a.charge * b.charge) / (1 + r); }

Real waves_energy(Real r, const V&, const P&, const P&) {
    return std::log(1 + r * r) * std::sin(r) + std::cos(2 * r) / (1 + r) + std::tan(1 / (2 + r));
}
Real waves_slope(Real r, const V&, const P&, const P&) {
    const Real c = std::cos(1 / (2 + r));
    return 2 * r / (1 + r * r) * std::sin(r) + std::log(1 + r * r) * std::cos(r) - 2 * std::sin(2 * r) / (1 + r) -
           std::cos(2 * r) / ((1 + r) * (1 + r)) - 1 / (c * c * (2 + r) * (2 + r));
}

Real powers_energy(Real r, const V& v, const P&, const P&) {
    return Real(v.at("a")) * std::pow(r, Real(1.5)) - std::pow(r, Real(0.25)) + std::pow(1 + r, -r) -
           std::pow(r, Real(v.at("n")));
}
Real powers_slope(Real r, const V& v, const P&, const P&) {
    const Real n = v.at("n");
    return Real(1.5) * Real(v.at("a")) * std::sqrt(r) - std::pow(r, Real(-0.75)) / 4 -
           (std::log1p(r) + r / (1 + r)) * std::pow(1 + r, -r) - n * std::pow(r, n - 1);
}

/// A contact that pushes below a distance of 1 (a choice between two formulas, smooth to the first derivative).
Real contact_energy(Real r, const V& v, const P&, const P&) {
    return r < 1 ? Real(v.at("stiff")) * std::pow(1 - r, Real(2.5)) : 0;
}
Real contact_slope(Real r, const V& v, const P&, const P&) {
    return r < 1 ? -Real(2.5) * Real(v.at("stiff")) * std::pow(1 - r, Real(1.5)) : 0;
}

Real waving_energy(Real3 at, Real m, Real q) {
    return m * std::sin(at.x) * at.y * at.y + q * at.z * at.z * at.z / (1 + at.x * at.x);
}
Real3 waving_slope(Real3 at, Real m, Real q) {
    const Real d = 1 + at.x * at.x;
    return {m * std::cos(at.x) * at.y * at.y - 2 * q * at.z * at.z * at.z * at.x / (d * d),
            2 * m * std::sin(at.x) * at.y, 3 * q * at.z * at.z / d};
}
Real double_well_energy(Real3 at, Real, Real) {
    return at.x * at.x * at.x * at.x / 4 - at.x * at.x / 2 + std::tanh(at.y);
}
Real3 double_well_slope(Real3 at, Real, Real) {
    const Real t = std::tanh(at.y);
    return {at.x * at.x * at.x - at.x, 1 - t * t, 0};
}
Real falling_energy(Real3 at, Real m, Real) { return m * std::exp(-at.z / 4) * std::hypot(Real(1), at.y); }
Real3 falling_slope(Real3 at, Real m, Real) {
    const Real e = m * std::exp(-at.z / 4), h = std::hypot(Real(1), at.y);
    return {0, e * at.y / h, -e * h / 4};
}

}  // namespace

const std::vector<PairFormula>& pair_formulas() {
    // numbers of which products are exact in double, as expressions multiply numbers in double
    static const std::vector<PairFormula> all{
        {"morse", morse_energy, morse_slope, {{"D", 1.2}, {"k", 5}, {"r0", 1.1}}},
        {"lennard-jones", lennard_jones_energy, lennard_jones_slope, {{"epsilon", 0.3}, {"sigma", 0.7}}},
        {"gravity", gravity_energy, gravity_slope, {{"G", 0.7}, {"softening", 0.3}}},
        {"gravity", gravity_energy, gravity_slope, {{"G", 0.6}, {"softening", 0}}},
        {"coulomb", coulomb_energy, coulomb_slope, {{"K", 1.3}, {"softening", 0}}},
        {"coulomb", coulomb_energy, coulomb_slope, {{"K", 0.9}, {"softening", 0.5}}},
        {"-A*exp(-(r/w)^2) + B/r^3", well_energy, well_slope, {{"A", 2}, {"w", 0.5}, {"B", 0.0625}}},
        {"m1*q2^2*exp(-r/2)*sqrt(r)", sided_energy, sided_slope, {}, true},
        {"m1*m2*exp(-r)/4 - q1*q2*tanh(r)/(1 + r)", mixed_energy, mixed_slope, {}, false, mixed_terms},
        {"log(1 + r^2)*sin(r) + cos(2*r)/(1 + r) + tan(1/(2 + r))", waves_energy, waves_slope, {}},
        {"a*r^1.5 - r^0.25 + (1 + r)^(-r) - r^n", powers_energy, powers_slope, {{"a", 0.375}, {"n", -1.703125}}},
        {"stiff*max(0, 1 - r)^2.5", contact_energy, contact_slope, {{"stiff", 9}}}};
    return all;
}

const PairFormula& pair_formula(std::string_view text) {
    for (const PairFormula& formula : pair_formulas()) {
        if (formula.text == text) return formula;
    }
    throw std::logic_error("no plain formula of this potential");
}

const std::vector<FieldFormula>& field_formulas() {
    static const std::vector<FieldFormula> all{{"m*sin(x)*y^2 + q*z^3/(1 + x^2)", waving_energy, waving_slope},
                                               {"x^4/4 - x^2/2 + tanh(y)", double_well_energy, double_well_slope},
                                               {"m*exp(-z/4)*sqrt(1 + y^2)", falling_energy, falling_slope}};
    return all;
}

}  // namespace steplab::test
