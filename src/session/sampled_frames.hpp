#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace steplab {

/// Which frames of a file plots show, and in which order they are read for them: first a few over all of the file, then
/// those between. They are the same ones however the file is played. Of a long file they are every second one, or every
/// fourth, and so on; of frames so large that few could be read, those alone that are shown.
class SampledFrames {
public:
    static constexpr std::uint64_t most_frames = 4096;
    /// In all frames that are read: some seconds of a text, in the background of a window.
    static constexpr std::uint64_t most_rows = 10'000'000;

    /// Of frames of so many particles.
    explicit SampledFrames(std::uint64_t rows);

    /// Of a file that has so many frames now. True if they are other ones than before, so that all are to be read
    /// again.
    bool adapt(std::uint64_t frames);
    /// True if this one is among them.
    bool has(std::uint64_t number) const { return number % spacing_ == 0; }
    /// The next of those before `end` that were not given yet; none: all were.
    std::optional<std::uint64_t> next(std::uint64_t end);
    /// Gives all of them again.
    void restart();

private:
    std::optional<std::uint64_t> next_of_pass();
    void begin_pass(std::uint64_t end);
    void begin_step(std::uint64_t step);

    std::uint64_t most_;  ///< 0: none is read
    std::uint64_t spacing_ = 1;
    std::uint64_t begin_ = 0, end_ = 0;   ///< those before `begin_` were given, and are being given before `end_`
    std::uint64_t coarse_ = 1;            ///< first the multiples of this
    std::uint64_t step_ = 1, place_ = 0;  ///< of those that are given now, and the next of them
};

}  // namespace steplab
