#include "io/input_file.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "sim/run/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <new>
#include <stdexcept>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace steplab {

namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
    throw FileError(fmt::format("cannot read '{}': {}", shown(name), reason));
}

std::string reason_of(int error) { return std::generic_category().message(error); }

/// Of a file that may claim anything of itself: memory that would be granted but is not there is not taken.
std::string space(const std::string& name, std::uint64_t bytes) {
    constexpr std::uint64_t surely_there = std::uint64_t{1} << 26;
    try {
        if (bytes <= surely_there || static_cast<double>(bytes) < available_memory()) return std::string(bytes, '\0');
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    refuse(name, fmt::format("{} of its bytes, which belong together, do not fit in memory", bytes));
}

}  // namespace

InputFile::InputFile(std::string name)
    : name_(std::move(name)), descriptor_(open(name_.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {
    if (descriptor_ < 0) refuse(name_, reason_of(errno));
    struct stat status {};
    const bool regular = fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
    size_ = static_cast<std::uint64_t>(status.st_size);
    if (regular) return;
    close(descriptor_);
    refuse(name_, S_ISDIR(status.st_mode) ? "it is a folder" : "it is not a regular file");
}

InputFile::InputFile(InputFile&& other) noexcept
    : name_(std::move(other.name_)), descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_) {}

InputFile::~InputFile() {
    if (descriptor_ >= 0) close(descriptor_);
}

bool InputFile::grow() {
    struct stat status {};
    if (fstat(descriptor_, &status) != 0) return false;
    const auto now = static_cast<std::uint64_t>(status.st_size);
    const bool more = now > size_;
    size_ = std::max(size_, now);
    return more;
}

std::string InputFile::read(std::uint64_t place, std::uint64_t bytes) const {
    if (place >= size_) return {};
    std::string text = space(name_, std::min(bytes, size_ - place));
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t got =
            pread(descriptor_, text.data() + done, text.size() - done, static_cast<off_t>(place + done));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) refuse(name_, reason_of(errno));
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    text.resize(done);
    return text;
}

}  // namespace steplab
