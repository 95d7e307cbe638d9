#include "io/compression.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>
#include <zlib.h>
#include <zstd.h>

namespace steplab {

namespace {

constexpr std::size_t piece = std::size_t{1} << 18;
constexpr int gzip_format = 15 + 16;  // window of 32 KiB; a head and a checksum as gzip writes them
constexpr std::string_view gzip_magic = "\x1f\x8b", zstd_magic = "\x28\xb5\x2f\xfd";
constexpr std::array endings{std::pair{std::string_view("gz"), Compression::gzip},
                             std::pair{std::string_view("zst"), Compression::zstd}};

[[noreturn]] void fail(std::string_view library, const char* reason) {
    throw FileError(fmt::format("{}: {}", library, reason ? reason : "unknown error"));
}

/// zlib counts in 32 bits.
uInt part_of(std::size_t bytes) {
    return static_cast<uInt>(std::min<std::size_t>(bytes, std::numeric_limits<uInt>::max()));
}

/// zlib reads through a pointer that is not const.
Bytef* input(std::string_view bytes) { return reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data())); }

class GzipCompressor final : public Compressor {
public:
    GzipCompressor() {
        constexpr int level = 6, memory = 8;
        if (deflateInit2(&stream_, level, Z_DEFLATED, gzip_format, memory, Z_DEFAULT_STRATEGY) != Z_OK)
            fail("zlib", stream_.msg);
    }
    ~GzipCompressor() override { deflateEnd(&stream_); }
    GzipCompressor(const GzipCompressor&) = delete;
    GzipCompressor& operator=(const GzipCompressor&) = delete;

    void add(std::string_view bytes, std::string& out) override { run(bytes, Z_NO_FLUSH, out); }
    void flush(std::string& out) override { run({}, Z_SYNC_FLUSH, out); }
    void finish(std::string& out) override { run({}, Z_FINISH, out); }

private:
    void run(std::string_view bytes, int mode, std::string& out) {
        do {
            stream_.next_in = input(bytes);
            stream_.avail_in = part_of(bytes.size());
            bytes.remove_prefix(stream_.avail_in);
            do {
                stream_.next_out = memory_.data();
                stream_.avail_out = part_of(memory_.size());
                const int result = deflate(&stream_, mode);
                out.append(memory_.data(), memory_.data() + (memory_.size() - stream_.avail_out));
                if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR) fail("zlib", stream_.msg);
            } while (stream_.avail_out == 0);
        } while (!bytes.empty());
    }

    z_stream stream_{};
    std::vector<Bytef> memory_ = std::vector<Bytef>(piece);
};

class ZstdCompressor final : public Compressor {
public:
    ZstdCompressor() : context_(ZSTD_createCCtx(), ZSTD_freeCCtx) {
        if (!context_) fail("zstd", "not enough memory");
        checked(ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_checksumFlag, 1));
    }
    void add(std::string_view bytes, std::string& out) override { run(bytes, ZSTD_e_continue, out); }
    void flush(std::string& out) override { run({}, ZSTD_e_flush, out); }
    void finish(std::string& out) override { run({}, ZSTD_e_end, out); }

private:
    static std::size_t checked(std::size_t result) {
        if (ZSTD_isError(result)) fail("zstd", ZSTD_getErrorName(result));
        return result;
    }
    void run(std::string_view bytes, ZSTD_EndDirective mode, std::string& out) {
        ZSTD_inBuffer from{bytes.data(), bytes.size(), 0};
        for (std::size_t left = 1; left > 0;) {
            const std::size_t before = out.size();
            out.resize(before + piece);
            ZSTD_outBuffer to{out.data() + before, piece, 0};
            left = checked(ZSTD_compressStream2(context_.get(), &to, &from, mode));
            out.resize(before + to.pos);
            if (mode == ZSTD_e_continue) left = from.size - from.pos;
        }
    }

    std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context_;
};

class GzipDecompressor final : public Decompressor {
public:
    GzipDecompressor() {
        if (inflateInit2(&stream_, gzip_format) != Z_OK) fail("zlib", stream_.msg);
    }
    ~GzipDecompressor() override { inflateEnd(&stream_); }
    GzipDecompressor(const GzipDecompressor&) = delete;
    GzipDecompressor& operator=(const GzipDecompressor&) = delete;

    bool take(std::string_view& bytes, std::string& out) override {
        if (complete_ && !bytes.empty()) inflateReset(&stream_), complete_ = false;  // the next part
        stream_.next_in = input(bytes);
        stream_.avail_in = part_of(bytes.size());
        stream_.next_out = memory_.data();
        stream_.avail_out = part_of(memory_.size());
        const std::size_t given = stream_.avail_in;
        const int result = inflate(&stream_, Z_NO_FLUSH);
        out.append(memory_.data(), memory_.data() + (memory_.size() - stream_.avail_out));
        bytes.remove_prefix(given - stream_.avail_in);
        if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR) fail("zlib", stream_.msg);
        complete_ = result == Z_STREAM_END;
        return stream_.avail_out == 0 && !complete_;
    }
    bool complete() const override { return complete_; }

private:
    z_stream stream_{};
    std::vector<Bytef> memory_ = std::vector<Bytef>(piece);
    bool complete_ = false;
};

class ZstdDecompressor final : public Decompressor {
public:
    ZstdDecompressor() : context_(ZSTD_createDCtx(), ZSTD_freeDCtx) {
        if (!context_) fail("zstd", "not enough memory");
    }
    bool take(std::string_view& bytes, std::string& out) override {
        const std::size_t before = out.size();
        out.resize(before + piece);
        ZSTD_inBuffer from{bytes.data(), bytes.size(), 0};
        ZSTD_outBuffer to{out.data() + before, piece, 0};
        const std::size_t left = ZSTD_decompressStream(context_.get(), &to, &from);
        out.resize(before + to.pos);
        bytes.remove_prefix(from.pos);
        if (ZSTD_isError(left)) fail("zstd", ZSTD_getErrorName(left));
        complete_ = left == 0;
        return to.pos == to.size && !complete_;
    }
    bool complete() const override { return complete_; }

private:
    std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context_;
    bool complete_ = false;
};

}  // namespace

std::string extension_of(const std::string& file) {
    std::string ending = std::filesystem::path(file).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return ending.empty() ? ending : ending.substr(1);
}

Compression compression_of(const std::string& file) {
    for (const auto& [ending, compression] : endings) {
        if (extension_of(file) == ending) return compression;
    }
    return Compression::none;
}

std::string without_compression(const std::string& file) {
    if (compression_of(file) == Compression::none) return file;
    return file.substr(0, file.rfind('.'));
}

Compression compression_in(std::string_view begin) {
    if (begin.starts_with(gzip_magic)) return Compression::gzip;
    return begin.starts_with(zstd_magic) ? Compression::zstd : Compression::none;
}

std::unique_ptr<Compressor> compressor(Compression compression) {
    if (compression == Compression::gzip) return std::make_unique<GzipCompressor>();
    if (compression == Compression::zstd) return std::make_unique<ZstdCompressor>();
    return nullptr;
}

std::unique_ptr<Decompressor> decompressor(Compression compression) {
    if (compression == Compression::gzip) return std::make_unique<GzipDecompressor>();
    if (compression == Compression::zstd) return std::make_unique<ZstdDecompressor>();
    return nullptr;
}

}  // namespace steplab
