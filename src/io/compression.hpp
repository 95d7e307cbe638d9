#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace steplab {

/// How a file is compressed as a whole.
enum class Compression { none, gzip, zstd };

/// By the end of a file's name: ".gz", ".zst".
Compression compression_of(const std::string& file);
/// The name without that end.
std::string without_compression(const std::string& file);
/// What follows the last dot of a file's name, in small letters.
std::string extension_of(const std::string& file);

/// Compresses a stream of bytes.
class Compressor {
public:
    virtual ~Compressor() = default;
    /// Appends what these bytes become to `out`; some may be kept back. Throws FileError if the library fails.
    virtual void add(std::string_view bytes, std::string& out) = 0;
    /// All that was kept back, so that a reader gets what was added so far.
    virtual void flush(std::string& out) = 0;
    /// The same, and the end of the stream.
    virtual void finish(std::string& out) = 0;
};

/// Null for none.
std::unique_ptr<Compressor> compressor(Compression compression);

/// Restores a stream of bytes, of one or several compressed parts.
class Decompressor {
public:
    virtual ~Decompressor() = default;
    /// Takes bytes from the front of `bytes`, and appends what they were to `out`: some hundred kilobytes at most at a
    /// time. True if there is more of it without further bytes. Throws FileError that says what is damaged.
    virtual bool take(std::string_view& bytes, std::string& out) = 0;
    /// True if the bytes taken so far are whole.
    virtual bool complete() const = 0;
};

/// The compression of bytes that begin like this.
Compression compression_in(std::string_view begin);
/// Null for none.
std::unique_ptr<Decompressor> decompressor(Compression compression);

}  // namespace steplab
