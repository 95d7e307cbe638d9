#pragma once

#include "core/error.hpp"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <unistd.h>

namespace steplab {

/// Of the programs that ask for it, one at a time has a folder for itself: for as long as this object lives, and not
/// longer than its program. Nothing is written there. Where folders cannot be locked, every program has it.
class FolderLock {
public:
    /// Throws FileError if another one has it; `what` is what it does there: "another report is being written".
    FolderLock(const std::string& folder, const std::string& what)
        : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        if (descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
        close(descriptor_);
        throw FileError("cannot write into the folder '" + folder + "': " + what + " there");
    }
    ~FolderLock() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int descriptor_;
};

}  // namespace steplab
