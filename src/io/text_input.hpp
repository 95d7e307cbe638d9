#pragma once

#include "io/compression.hpp"
#include "io/input_file.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace steplab {

/// The lines of a text file, decompressed if it is compressed, whatever its name. Holds a line and a piece of the file
/// at a time.
class TextInput {
public:
    explicit TextInput(InputFile file);

    /// The next line without its end; none at the end of the file. Valid until the next call. Throws FileError for
    /// damaged or truncated compressed data, and for lines that are no text of ours.
    std::optional<std::string_view> line();
    /// The next bytes, up to `bytes` of them, which are not taken.
    std::string_view peek(std::size_t bytes);

    /// Throws FileError: the file, the number of the last line, the reason.
    [[noreturn]] void fail(const std::string& reason) const;
    const std::string& name() const { return file_.name(); }

private:
    bool fill();
    bool decompress();

    InputFile file_;
    std::unique_ptr<Decompressor> decompressor_;
    std::uint64_t place_ = 0;  ///< in the file, of what is read next
    std::string raw_;          ///< compressed bytes
    std::size_t used_ = 0;     ///< of them
    bool more_ = false;        ///< the decompressor has more of the bytes it took
    std::string text_;
    std::size_t taken_ = 0;  ///< bytes of text_ that were given out
    std::uint64_t lines_ = 0;
};

}  // namespace steplab
