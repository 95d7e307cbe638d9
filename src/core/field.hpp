#pragma once

#include "core/number.hpp"
#include "core/vec3.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <vector>

namespace steplab {

/// Memory that starts on a cache line, so that vector loads of a field never straddle two lines.
template <class T>
struct CacheLineAllocator {
    using value_type = T;
    static constexpr std::align_val_t alignment{64};

    CacheLineAllocator() = default;
    template <class U>
    CacheLineAllocator(const CacheLineAllocator<U>&) {}
    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
    void deallocate(T* p, std::size_t) { ::operator delete(p, alignment); }
    friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }
};

/// A vector quantity of n particles as a structure of arrays: n x, padding, n y, padding, n z, padding. The padding is
/// zero and stays zero under elementwise operations over flat(). One more granule behind it may be read, so that a
/// register may begin at any number of flat().
template <class T>
class Field {
public:
    Field() = default;
    // not inlined: a call is nothing beside what they do, and steppers make fields in many places
    [[gnu::noinline]] explicit Field(std::size_t count)
        : count_(count), stride_(padded(count)), values_(3 * stride_ + granule, T(0)) {}
    [[gnu::noinline]] Field(const Field& other) = default;
    [[gnu::noinline]] Field& operator=(const Field& other) = default;
    Field(Field&& other) noexcept = default;
    Field& operator=(Field&& other) noexcept = default;
    ~Field() = default;

    std::size_t count() const { return count_; }
    T* x() { return values_.data(); }
    T* y() { return values_.data() + stride_; }
    T* z() { return values_.data() + 2 * stride_; }
    const T* x() const { return values_.data(); }
    const T* y() const { return values_.data() + stride_; }
    const T* z() const { return values_.data() + 2 * stride_; }
    /// All numbers, padding included; the length is a multiple of `granule`.
    std::span<T> flat() { return {values_.data(), 3 * stride_}; }
    std::span<const T> flat() const { return {values_.data(), 3 * stride_}; }

    Vec3 at(std::size_t i) const {
        return {static_cast<double>(value_of(x()[i])), static_cast<double>(value_of(y()[i])),
                static_cast<double>(value_of(z()[i]))};
    }
    void set(std::size_t i, Vec3 value) {
        x()[i] = static_cast<T>(value.x);
        y()[i] = static_cast<T>(value.y);
        z()[i] = static_cast<T>(value.z);
    }

    /// Numbers in one cache line of float: loops over flat() have no remainder.
    static constexpr std::size_t granule = 16;

private:
    /// The same for every number type. The components of float and double are kept apart modulo 4096 bytes: otherwise
    /// loads would wait for recent stores to addresses that differ only in their high bits (4K aliasing).
    static std::size_t padded(std::size_t count) {
        const auto meet = [](std::size_t bytes) {
            constexpr std::size_t near = 384;
            return bytes >= 4096 && (bytes + near) % 2048 < 2 * near;
        };
        std::size_t stride = (count + granule - 1) / granule * granule;
        while (meet(stride * sizeof(float)) || meet(stride * sizeof(double))) stride += granule;
        return stride;
    }

    std::size_t count_ = 0;
    std::size_t stride_ = 0;
    std::vector<T, CacheLineAllocator<T>> values_;
};

/// Copies `count` vectors from index `first` to index `place`; within the same field only to a lower index.
template <class T>
void copy(const Field<T>& from, std::size_t first, std::size_t count, Field<T>& to, std::size_t place) {
    std::copy_n(from.x() + first, count, to.x() + place);
    std::copy_n(from.y() + first, count, to.y() + place);
    std::copy_n(from.z() + first, count, to.z() + place);
}

/// Makes `to` the same field in another number type, each number rounded once; its memory is reused.
template <class From, class To>
void convert(const Field<From>& from, Field<To>& to) {
    if (to.count() != from.count()) to = Field<To>(from.count());
    std::transform(from.flat().begin(), from.flat().end(), to.flat().begin(),
                   [](From v) { return static_cast<To>(v); });
}

template <class To, class From>
Field<To> converted(const Field<From>& from) {
    Field<To> to;
    convert(from, to);
    return to;
}

/// Displacements from the reference positions, and velocities, of one time.
template <class T>
struct State {
    Field<T> displacement;
    Field<T> velocity;
};

}  // namespace steplab
