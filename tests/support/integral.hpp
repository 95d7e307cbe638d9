#pragma once

#include <boost/math/quadrature/tanh_sinh.hpp>

namespace steplab::test {

/// The integral of f from 0 to a length, to a relative tolerance. f may be steep at both ends.
template <class Real, class Function>
Real integral(const Function& f, Real length, Real tolerance) {
    boost::math::quadrature::tanh_sinh<Real> rule;
    // Over [-1, 1], the rule's own range: at a limit of 0 its smallest step underflows, which it asserts it does not.
    const Real half = length / 2;
    return half * rule.integrate([&](const Real& w) -> Real { return f(half * (1 + w)); }, tolerance);
}

}  // namespace steplab::test
