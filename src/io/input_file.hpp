#pragma once

#include <cstdint>
#include <string>

namespace steplab {

/// A regular file, read at any offset.
class InputFile {
public:
    /// Throws FileError if it does not exist, or is a folder, a pipe or a device.
    explicit InputFile(std::string name);
    ~InputFile();
    InputFile(InputFile&& other) noexcept;
    InputFile& operator=(InputFile&&) = delete;

    const std::string& name() const { return name_; }
    std::uint64_t size() const { return size_; }
    /// Takes in what another program has written behind its end since; true if there is more.
    bool grow();
    /// The bytes from offset `place` on; fewer only at the end of the file. Throws FileError, also if they do not fit
    /// in memory.
    std::string read(std::uint64_t place, std::uint64_t bytes) const;

private:
    std::string name_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

}  // namespace steplab
