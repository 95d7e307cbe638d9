#pragma once

#include "io/input_file.hpp"
#include "io/text_input.hpp"

#include <cstdint>
#include <fstream>
#include <memory>
#include <string>

namespace steplab {

/// The text that is compressed in a file, restored piece by piece, so that any place in it can be read: into a file
/// without a name in the folder for temporary files.
class RestoredText {
public:
    /// Throws FileError if there is no such folder.
    explicit RestoredText(InputFile compressed);

    /// What is restored so far; it grows.
    const std::shared_ptr<InputFile>& file() const { return file_; }
    bool is_whole() const { return whole_; }
    /// The part of the compressed file that was read.
    double part() const;
    /// Restores about so many bytes more. Throws FileError if the rest is damaged, or does not fit on the disk.
    void restore(std::uint64_t bytes);

private:
    double size_;  ///< of the compressed file
    TextInput text_;
    std::ofstream out_;
    std::shared_ptr<InputFile> file_;
    bool whole_ = false;
};

}  // namespace steplab
