#pragma once

namespace steplab {

/// A vector of any number type.
template <class N>
struct Vector {
    N x, y, z;

    [[gnu::always_inline]] friend Vector operator+(const Vector& a, const Vector& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    [[gnu::always_inline]] friend Vector operator-(const Vector& a, const Vector& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    [[gnu::always_inline]] friend Vector operator*(const N& factor, const Vector& a) {
        return {factor * a.x, factor * a.y, factor * a.z};
    }
};

}  // namespace steplab
