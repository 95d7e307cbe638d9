#pragma once

#include <cstddef>
#include <string>

namespace steplab {

/// A file under a hidden name while it is being written: what the end of the program makes of it if that comes before
/// this object is destroyed. Some files at a time are remembered, and none with a very long path.
class UnfinishedFile {
public:
    enum class AtEnd {
        removed,
        kept,           ///< under another name, if anything was written
        kept_in_lines,  ///< the same, cut behind its last whole line
    };

    /// `descriptor` is open for reading and writing; `kept_as` is not used if the file is to be removed.
    UnfinishedFile(int descriptor, const std::string& hidden, AtEnd at_end, const std::string& kept_as);
    ~UnfinishedFile();
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;

private:
    std::size_t place_;
};

/// Removes or keeps all unfinished files and ends the program with this exit code: from any thread, and from a signal
/// handler.
[[noreturn]] void end_program(int exit_code) noexcept;

/// The same in a moment, unless the program has ended by itself until then.
void end_program_soon(int exit_code);

}  // namespace steplab
