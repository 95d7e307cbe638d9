#include "io/output_file.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/shown.hpp"

#include <climits>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace steplab {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t block_size = std::size_t{1} << 18;

std::optional<struct stat> status_of(const std::string& name) {
    struct stat status {};
    const int result = name == "-" ? fstat(STDOUT_FILENO, &status) : stat(name.c_str(), &status);
    if (result != 0) return std::nullopt;
    return status;
}

/// The path at the end of a chain of links, whether or not it exists.
fs::path link_target(fs::path path) {
    constexpr int most_links = 40;  // as the system itself allows
    std::error_code ignored;
    for (int i = 0; i < most_links && fs::is_symlink(path, ignored); ++i) {
        const fs::path next = fs::read_symlink(path, ignored);
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    return path;
}

/// The file that a name leads to, with links in its folder resolved if the folder exists.
fs::path resolved(const std::string& name) {
    std::error_code error;
    const fs::path target = link_target(name);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const fs::path real_folder = fs::canonical(folder, error);
    return (error ? folder : real_folder) / target.filename();
}

/// Gives the permissions and the owner of the old file to the new one.
void inherit(int descriptor, const struct stat& old) {
    const int not_ours_to_give = fchown(descriptor, old.st_uid, old.st_gid);
    static_cast<void>(not_ours_to_give);
    fchmod(descriptor, old.st_mode & 07777);
}

/// True if the path leads to the open file.
bool is_at(const fs::path& path, int descriptor) {
    struct stat named {};
    struct stat held {};
    return lstat(path.c_str(), &named) == 0 && fstat(descriptor, &held) == 0 && named.st_dev == held.st_dev &&
           named.st_ino == held.st_ino;
}

bool lock(int descriptor) { return flock(descriptor, LOCK_EX | LOCK_NB) == 0; }

/// Where folders are shared, locks may be known to one computer alone: each has files of its own.
fs::path hidden_file(const fs::path& folder, int number) {
    std::array<char, 65> host{};
    gethostname(host.data(), host.size() - 1);
    return folder / fmt::format(".steplab-{}-{}", host.data(), number);
}

/// Removes the hidden files that programs have left which were killed: whoever writes one has it locked.
void remove_abandoned(const fs::path& folder) {
    constexpr int most = 16;  // a program writes a few at a time
    for (int number = 0; number < most; ++number) {
        const fs::path hidden = hidden_file(folder, number);
        const int descriptor = open(hidden.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (descriptor < 0) continue;
        if (lock(descriptor) && is_at(hidden, descriptor)) unlink(hidden.c_str());
        close(descriptor);
    }
}

}  // namespace

bool written_directly(const std::string& name) {
    const auto status = status_of(name);
    return name == "-" || (status && !S_ISREG(status->st_mode) && !S_ISDIR(status->st_mode));
}

bool same_output(const std::string& a, const std::string& b) {
    if (a == b && a == "-") return true;
    const auto first = status_of(a);
    const auto second = status_of(b);
    if (first && second) {
        return first->st_dev == second->st_dev && first->st_ino == second->st_ino && !S_ISCHR(first->st_mode);
    }
    return !first && !second && resolved(a) == resolved(b);
}

OutputFile::OutputFile(std::string name, Compression compression)
    : name_(std::move(name)), compressor_(compressor(compression)) {
    if (name_.empty()) throw FileError("cannot write a file with an empty name");
    buffer_.reserve(block_size);
    if (name_ == "-") {
        name_ = "standard output";
        descriptor_ = STDOUT_FILENO;
    } else if (written_directly(name_)) {
        open_directly(name_);
    } else {
        target_ = resolved(name_);
        open_beside();
    }
    struct stat status {};
    const bool has_reader = fstat(descriptor_, &status) == 0 &&
                            (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode) || isatty(descriptor_) != 0);
    piece_ = has_reader ? PIPE_BUF : block_size;
}

OutputFile::~OutputFile() {
    if (!temporary_.empty()) unlink(temporary_.c_str());
    unfinished_.reset();
    if (owns_descriptor_ && descriptor_ >= 0) close(descriptor_);
}

void OutputFile::open_directly(const std::string& path) {
    while ((descriptor_ = open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC)) < 0) {
        if (errno != EINTR) fail("write", errno);
        check_interruption();  // a named pipe without a reader waits here
    }
    owns_descriptor_ = true;
}

void OutputFile::open_beside() {
    std::error_code ignored;
    if (fs::is_symlink(target_, ignored)) fail("write", ELOOP);
    const auto old = status_of(target_);
    if (old && S_ISDIR(old->st_mode)) fail("write", EISDIR);
    if (old && access(target_.c_str(), W_OK) != 0) fail("write", errno);
    const fs::path folder = target_.parent_path();
    if (!fs::is_directory(folder, ignored)) {
        throw FileError(
            fmt::format("cannot write '{}': there is no folder '{}'", shown(name_), shown(folder.string())));
    }
    remove_abandoned(folder);
    for (int number = 0; temporary_.empty(); ++number) {
        if (create_hidden(hidden_file(folder, number))) temporary_ = hidden_file(folder, number);
    }
    owns_descriptor_ = true;
    at_program_end(UnfinishedFile::AtEnd::removed);
    if (old) inherit(descriptor_, *old);
}

/// False if another program writes there.
bool OutputFile::create_hidden(const fs::path& candidate) {
    descriptor_ = open(candidate.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) fail("write", errno);
    if (descriptor_ < 0) return false;
    // Where files cannot be locked, nobody takes them for abandoned either.
    if ((lock(descriptor_) || errno != EWOULDBLOCK) && is_at(candidate, descriptor_)) return true;
    close(std::exchange(descriptor_, -1));
    return false;
}

void OutputFile::at_program_end(UnfinishedFile::AtEnd what) {
    if (temporary_.empty()) return;
    // a line that ends in compressed bytes is none
    const bool lines = compressor_ && what == UnfinishedFile::AtEnd::kept_in_lines;
    unfinished_.reset();
    unfinished_.emplace(descriptor_, temporary_, lines ? UnfinishedFile::AtEnd::kept : what, partial_name());
}

void OutputFile::write(std::string_view bytes) {
    if (!compressor_) return put(bytes);
    compressed_.clear();
    compressor_->add(bytes, compressed_);
    put(compressed_);
}

void OutputFile::end_compression() {
    if (!compressor_) return;
    compressed_.clear();
    compressor_->finish(compressed_);
    compressor_.reset();
    put(compressed_);
}

void OutputFile::put(std::string_view bytes) {
    if (buffer_.size() + bytes.size() > block_size) send_buffer();
    if (bytes.size() >= block_size) {
        send(bytes);
    } else {
        buffer_.append(bytes);
    }
}

void OutputFile::flush() {
    if (compressor_) {
        compressed_.clear();
        compressor_->flush(compressed_);
        put(compressed_);
    }
    send_buffer();
}

void OutputFile::send_buffer() {
    send(buffer_);
    buffer_.clear();
}

void OutputFile::send(std::string_view bytes) {
    while (!bytes.empty()) {
        if (temporary_.empty()) wait_for_reader();
        const ssize_t sent = ::write(descriptor_, bytes.data(), std::min(bytes.size(), piece_));
        if (sent >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(sent));
        } else if (errno == EPIPE) {
            throw ReaderGone();
        } else if (errno != EINTR) {
            fail("write", errno);
        }
    }
}

/// Waits until a pipe or terminal accepts a piece, and polls for interruptions meanwhile: the reader may never read
/// again, and the signal may be delivered to another thread.
void OutputFile::wait_for_reader() const {
    constexpr int milliseconds = 50;
    pollfd place{descriptor_, POLLOUT, 0};
    do {
        check_interruption();
        if (!waits_) throw ReaderGone();
    } while (poll(&place, 1, milliseconds) <= 0);
}

void OutputFile::commit() {
    end_compression();
    flush();
    if (temporary_.empty()) return;
    check_interruption();
    if (fsync(descriptor_) != 0 && errno != EINVAL) fail("write", errno);
    check_interruption();
    put_in_place(target_);
    // Makes the new name survive a loss of power, where folders can be synced.
    const int folder = open(target_.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder >= 0) {
        fsync(folder);
        close(folder);
    }
}

/// The file is locked until it has its name: under the hidden one it would be taken for abandoned.
void OutputFile::put_in_place(const fs::path& place) {
    unfinished_.reset();
    if (rename(temporary_.c_str(), place.c_str()) != 0) fail("write", errno);
    temporary_.clear();
    owns_descriptor_ = false;
    close(std::exchange(descriptor_, -1));
}

std::optional<std::string> OutputFile::keep_partial() {
    if (temporary_.empty()) return std::nullopt;
    end_compression();
    flush();
    struct stat status {};
    if (fstat(descriptor_, &status) != 0 || status.st_size == 0) return std::nullopt;
    put_in_place(partial_name());
    std::error_code ignored;
    return fs::is_symlink(name_, ignored) ? partial_name() : name_ + ".partial";
}

void OutputFile::fail(std::string_view action, int error) const {
    const std::string reason = error == EISDIR ? "it is a folder" : std::generic_category().message(error);
    throw FileError(fmt::format("cannot {} {}: {}", action,
                                descriptor_ == STDOUT_FILENO ? name_ : "'" + shown(name_) + "'", reason));
}

}  // namespace steplab
