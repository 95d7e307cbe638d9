#pragma once

#include "io/compression.hpp"
#include "io/input_file.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace steplab {

/// Bytes; longer ones are no text of ours.
inline constexpr std::size_t longest_text_line = std::size_t{1} << 16;

/// The lines of a text, decompressed if it is compressed, whatever its name. Holds a line and a piece of a file at a
/// time.
class TextInput {
public:
    explicit TextInput(InputFile file);
    /// Of a text in memory, with this name in messages.
    TextInput(std::string name, std::shared_ptr<const std::string> text);

    /// A part of a plain text: the bytes of a file from `begin` to `end`, the first of which follows so many lines.
    TextInput(std::string name, const std::shared_ptr<const InputFile>& file, std::uint64_t begin, std::uint64_t end,
              std::uint64_t lines);

    /// The next line without its end; none at the end of the file. Valid until the next call. Throws FileError for
    /// damaged or truncated compressed data, and for lines that are no text of ours.
    std::optional<std::string_view> line();
    /// The next bytes, up to `bytes` of them, which are not taken.
    std::string_view peek(std::size_t bytes);
    /// Takes so many of those that peek() gave.
    void drop(std::size_t bytes) { taken_ += bytes; }
    /// All that is left. Throws FileError as line() does, and for more than `most` bytes.
    std::string rest(std::size_t most);

    /// Throws FileError: the file, the number of the last line, the reason.
    [[noreturn]] void fail(const std::string& reason) const;
    const std::string& name() const { return name_; }
    /// Bytes of the file, compressed or not, that were read so far.
    std::uint64_t bytes_read() const { return place_; }

private:
    /// The bytes from a place on, fewer at the end.
    using Source = std::function<std::string(std::uint64_t place, std::uint64_t bytes)>;

    TextInput(std::string name, Source source);
    explicit TextInput(const std::shared_ptr<const InputFile>& file);
    bool fill();
    bool decompress();

    std::string name_;
    Source source_;
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
