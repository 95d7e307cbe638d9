#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace steplab {

/// A 3 x 3 matrix: the derivative of the acceleration of one particle with respect to the position of another.
template <class T>
struct Block {
    std::array<std::array<T, 3>, 3> at{};  ///< at[row][column]

    static Block diagonal(T number) {
        Block block;
        for (std::size_t i = 0; i < 3; ++i) block.at[i][i] = number;
        return block;
    }

    Block& operator+=(const Block& b) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) at[i][j] += b.at[i][j];
        }
        return *this;
    }
    friend Block operator*(T factor, Block block) {
        for (auto& row : block.at) {
            for (T& number : row) number *= factor;
        }
        return block;
    }
    friend Block operator*(const Block& a, const Block& b) {
        Block product;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j)
                product.at[i][j] = a.at[i][0] * b.at[0][j] + a.at[i][1] * b.at[1][j] + a.at[i][2] * b.at[2][j];
        }
        return product;
    }
    friend std::array<T, 3> operator*(const Block& a, const std::array<T, 3>& b) {
        std::array<T, 3> product;
        for (std::size_t i = 0; i < 3; ++i) product[i] = a.at[i][0] * b[0] + a.at[i][1] * b[1] + a.at[i][2] * b[2];
        return product;
    }
    friend Block transposed(const Block& a) {
        Block swapped;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) swapped.at[i][j] = a.at[j][i];
        }
        return swapped;
    }
};

/// By Gauss-Jordan elimination with the largest pivot of each column. Not finite if the block is singular.
template <class T>
Block<T> inverse(Block<T> a) {
    Block<T> inverse = Block<T>::diagonal(T(1));
    for (std::size_t c = 0; c < 3; ++c) {
        std::size_t pivot = c;
        for (std::size_t i = c + 1; i < 3; ++i) {
            if (std::abs(a.at[i][c]) > std::abs(a.at[pivot][c])) pivot = i;
        }
        std::swap(a.at[c], a.at[pivot]);
        std::swap(inverse.at[c], inverse.at[pivot]);
        const T scale = T(1) / a.at[c][c];
        for (std::size_t j = 0; j < 3; ++j) a.at[c][j] *= scale, inverse.at[c][j] *= scale;
        for (std::size_t i = 0; i < 3; ++i) {
            if (i == c) continue;
            const T factor = a.at[i][c];
            for (std::size_t j = 0; j < 3; ++j) {
                a.at[i][j] -= factor * a.at[c][j];
                inverse.at[i][j] -= factor * inverse.at[c][j];
            }
        }
    }
    return inverse;
}

}  // namespace steplab
