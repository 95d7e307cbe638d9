#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>

namespace steplab {

/// A file in memory that readers open by its name.
class MemoryFile {
public:
    MemoryFile() : descriptor_(memfd_create("input", 0)) {
        if (descriptor_ < 0) throw std::runtime_error("no file in memory");
    }
    ~MemoryFile() { close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::string name() const { return "/proc/self/fd/" + std::to_string(descriptor_); }
    void put(std::string_view bytes) const {
        const bool written = ftruncate(descriptor_, 0) == 0 &&
                             pwrite(descriptor_, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size());
        if (!written) throw std::runtime_error("the file in memory cannot be written");
    }

private:
    int descriptor_;
};

}  // namespace steplab
