#pragma once

#include <cstdint>
#include <string>

namespace steplab {

/// The names of files that are numbered, as printf and ffmpeg write them: frames/%05d.png.
class SeriesName {
public:
    /// The file's name has one %d or %0Nd, and %% for a percent sign; its folder is taken as it is. Throws UsageError.
    explicit SeriesName(const std::string& pattern);

    std::string of(std::uint64_t number) const;

private:
    std::string before_, after_;
    int digits_ = 1;  ///< filled up with zeros
};

}  // namespace steplab
