#pragma once

#include "core/lane_vectors.hpp"
#include "core/lanes.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace steplab {

// Compression of selected lanes of a register into contiguous memory, and expansion back into their places: if only one
// lane in four needs a square root, a quarter of the roots is computed. T is float or double.

/// A set of lanes: bit l stands for lane l.
using LaneSet = std::uint32_t;

/// The first `count` lanes, or all.
inline constexpr LaneSet first_lanes(std::size_t count) { return count < 32 ? (LaneSet{1} << count) - 1 : ~LaneSet{0}; }

namespace detail {

#if defined(__SSE2__)
inline LaneSet set_below(__m128d a, __m128d b) { return static_cast<LaneSet>(_mm_movemask_pd(_mm_cmplt_pd(a, b))); }
inline LaneSet set_below(__m128 a, __m128 b) { return static_cast<LaneSet>(_mm_movemask_ps(_mm_cmplt_ps(a, b))); }
#else
template <class Register>
inline LaneSet set_below(Register a, Register b) {
    const auto mask = a < b;
    LaneSet set = 0;
    for (std::size_t lane = 0; lane < sizeof a / sizeof a[0]; ++lane)
        set |= static_cast<LaneSet>(mask[lane] & 1) << lane;
    return set;
}
#endif
#if defined(__AVX__)
inline LaneSet set_below(__m256d a, __m256d b) {
    return static_cast<LaneSet>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LT_OQ)));
}
inline LaneSet set_below(__m256 a, __m256 b) {
    return static_cast<LaneSet>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ)));
}
#endif
#if defined(__AVX512F__)
inline LaneSet set_below(__m512d a, __m512d b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
inline LaneSet set_below(__m512 a, __m512 b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
#endif

#if defined(__AVX512F__)

inline __m512d compressed(LaneSet set, __m512d lanes) {
    return _mm512_maskz_compress_pd(static_cast<__mmask8>(set), lanes);
}
inline __m512 compressed(LaneSet set, __m512 lanes) {
    return _mm512_maskz_compress_ps(static_cast<__mmask16>(set), lanes);
}
inline __m512d expanded(LaneSet set, __m512d lanes) {
    return _mm512_maskz_expand_pd(static_cast<__mmask8>(set), lanes);
}
inline __m512 expanded(LaneSet set, __m512 lanes) { return _mm512_maskz_expand_ps(static_cast<__mmask16>(set), lanes); }

/// Lanes compressed by one instruction; 0 where the instruction set has no such instruction.
template <class T>
inline constexpr std::size_t compressed_at_once = 64 / sizeof(T);

#elif defined(__AVX2__)

/// For every subset of four lanes, the index of each 32-bit word (a double has two), as permutation instructions take
/// it.
template <std::size_t Words>
using FourLanesTable = std::array<std::array<std::int32_t, 4 * Words>, 16>;
template <std::size_t Words, class F>
consteval FourLanesTable<Words> table_of_four_lanes(F number) {
    FourLanesTable<Words> table{};
    for (LaneSet set = 0; set < 16; ++set) {
        for (std::size_t place = 0; place < 4 * Words; ++place)
            table[set][place] = number(set, place / Words, place % Words);
    }
    return table;
}
/// Moves the lanes of a set to the front.
template <std::size_t Words>
alignas(32) inline constexpr FourLanesTable<Words> to_front =
    table_of_four_lanes<Words>([](LaneSet set, std::size_t place, std::size_t word) {
        std::size_t lane = 0;
        for (std::size_t before = 0; lane < 4; ++lane) {
            if ((set >> lane & 1) != 0 && before++ == place) break;
        }
        return static_cast<std::int32_t>(lane % 4 * Words + word);
    });
/// Moves them back.
template <std::size_t Words>
alignas(32) inline constexpr FourLanesTable<Words> from_front =
    table_of_four_lanes<Words>([](LaneSet set, std::size_t lane, std::size_t word) {
        const auto before = static_cast<std::size_t>(std::popcount(set & first_lanes(lane)));
        return static_cast<std::int32_t>(before % 4 * Words + word);
    });
/// Mask that keeps them and sets all others to 0.
template <std::size_t Words>
alignas(32) inline constexpr FourLanesTable<Words> itself = table_of_four_lanes<Words>([](LaneSet set, std::size_t lane,
                                                                                          std::size_t) {
    return (set >> lane & 1) != 0 ? -1 : 0;
});

inline __m256d permuted(__m256d lanes, const std::array<std::int32_t, 8>& places) {
    const __m256i by = _mm256_load_si256(reinterpret_cast<const __m256i*>(places.data()));
    return _mm256_castps_pd(_mm256_permutevar8x32_ps(_mm256_castpd_ps(lanes), by));
}
inline __m128 permuted(__m128 lanes, const std::array<std::int32_t, 4>& places) {
    return _mm_permutevar_ps(lanes, _mm_load_si128(reinterpret_cast<const __m128i*>(places.data())));
}
inline __m256d masked(__m256d lanes, const std::array<std::int32_t, 8>& mask) {
    return _mm256_and_pd(lanes, _mm256_load_pd(reinterpret_cast<const double*>(mask.data())));
}
inline __m128 masked(__m128 lanes, const std::array<std::int32_t, 4>& mask) {
    return _mm_and_ps(lanes, _mm_load_ps(reinterpret_cast<const float*>(mask.data())));
}
inline __m256d compressed(LaneSet set, __m256d four) { return permuted(four, to_front<2>[set]); }
inline __m128 compressed(LaneSet set, __m128 four) { return permuted(four, to_front<1>[set]); }
inline __m256d expanded(LaneSet set, __m256d four) {
    return masked(permuted(four, from_front<2>[set]), itself<2>[set]);
}
inline __m128 expanded(LaneSet set, __m128 four) { return masked(permuted(four, from_front<1>[set]), itself<1>[set]); }

template <class T>
inline constexpr std::size_t compressed_at_once = 4;

#else

template <class Register>
Register compressed(LaneSet set, Register lanes);  // not available
template <class Register>
Register expanded(LaneSet set, Register lanes);

template <class T>
inline constexpr std::size_t compressed_at_once = 0;

#endif

}  // namespace detail

/// The lanes in which a is less than b.
template <class T, std::size_t Count>
[[gnu::always_inline]] inline LaneSet lanes_below(const RegisterLanes<T, Count>& a, const RegisterLanes<T, Count>& b) {
    using N = RegisterLanes<T, Count>;
    LaneSet set = 0;
    for (std::size_t p = 0; p < N::parts; ++p)
        set |= detail::set_below(a.registers()[p], b.registers()[p]) << p * N::width;
    return set;
}

/// Stores the lanes of the set contiguously at `to` and returns the end of what was stored; up to Count numbers from
/// `to` may be overwritten. Without suitable instructions all lanes are stored, unless the set is empty.
template <class T, std::size_t Count>
[[gnu::always_inline]] inline T* store_compressed(LaneSet set, const RegisterLanes<T, Count>& lanes, T* to) {
    using N = RegisterLanes<T, Count>;
    constexpr std::size_t at_once = detail::compressed_at_once<T>;
    if constexpr (at_once == 0) {
        lanes.store_anywhere(to);
        return to + (set != 0 ? Count : 0);
    } else {
        const auto store = [&](std::size_t first, auto some) __attribute__((always_inline)) {
            const LaneSet here = set >> first & first_lanes(at_once);
            const auto front = detail::compressed(here, some);
            std::memcpy(to, &front, sizeof front);
            to += std::popcount(here);
        };
        for (std::size_t p = 0; p < N::parts; ++p) {
            if constexpr (at_once == N::width) {
                store(p * N::width, lanes.registers()[p]);
            } else {
                detail::each_four<T>(
                    lanes.registers()[p],
                    [&](std::size_t j, const auto& four)
                        __attribute__((always_inline)) { store(p * N::width + 4 * j, four.registers()[0]); },
                    std::make_index_sequence<N::width / at_once>{});
            }
        }
        return to;
    }
}

/// The inverse of store_compressed(): loads the lanes of the set from `from` and advances `from` past them. The other
/// lanes are 0, or hold their stored values where all lanes were stored.
template <class N, class T>
[[gnu::always_inline]] inline N load_expanded(LaneSet set, const T*& from) {
    constexpr std::size_t at_once = detail::compressed_at_once<T>;
    if constexpr (at_once == 0) {
        const T* const stored = from;
        from += set != 0 ? N::count : 0;
        return N::load_anywhere(stored);
    } else {
        const auto load = [&](std::size_t first) __attribute__((always_inline)) {
            const LaneSet here = set >> first & first_lanes(at_once);
            typename RegisterLanes<T, at_once>::Register front;
            std::memcpy(&front, from, sizeof front);
            from += std::popcount(here);
            return decltype(front)(detail::expanded(here, front));
        };
        std::array<typename N::Register, N::parts> registers;
        for (std::size_t p = 0; p < N::parts; ++p) {
            if constexpr (at_once == N::width) {
                registers[p] = load(p * N::width);
            } else {
                const auto first = load(p * N::width), second = load(p * N::width + at_once);
                constexpr auto same = [](std::size_t place) { return place; };
                registers[p] = detail::picked(first, second, same, std::make_index_sequence<N::width>{});
            }
        }
        return N(registers);
    }
}

}  // namespace steplab
