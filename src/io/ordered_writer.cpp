#include "io/ordered_writer.hpp"

#include "core/team.hpp"

#include <algorithm>
#include <utility>

namespace steplab {

OrderedWriter::OrderedWriter(OutputFile& file) : file_(file), most_threads_(std::min<std::size_t>(processors(), 16)) {}

OrderedWriter::~OrderedWriter() {
    for (std::jthread& thread : threads_) thread.request_stop();
    const std::lock_guard lock(mutex_);
    if (written_ < submitted_) file_.stop_waiting();  // a reader may never read again
}

void OrderedWriter::work(const std::stop_token& stop) try {
    std::string bytes, scratch;
    while (true) {
        std::unique_lock lock(mutex_);
        if (!ready_.wait(lock, stop, [this] { return !waiting_.empty(); })) return;
        if (!write_next(lock, stop, bytes, scratch)) return;
    }
} catch (...) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
    turn_.notify_all();
}

/// The first block that waits. False if it was to stop before, or others failed.
bool OrderedWriter::write_next(std::unique_lock<std::mutex>& lock, const std::stop_token& stop, std::string& bytes,
                               std::string& scratch) {
    Block block = std::move(waiting_.front());
    waiting_.pop_front();
    const std::uint64_t number = begun_++;
    lock.unlock();
    bytes.clear();
    block(bytes, scratch);
    block = nullptr;  // frees the rows that it holds
    lock.lock();
    if (!turn_.wait(lock, stop, [&] { return written_ == number || failure_; }) || failure_) return false;
    lock.unlock();
    file_.write(bytes);
    lock.lock();
    ++written_;
    turn_.notify_all();
    return true;
}

void OrderedWriter::submit(Block block) {
    wait_for_at_most(most_blocks() - 1);
    std::unique_lock lock(mutex_);
    waiting_.push_back(std::move(block));
    ++submitted_;
    ready_.notify_one();
    if (threads_.size() < std::min<std::uint64_t>(most_threads_, submitted_ - written_)) start_thread();
    if (!threads_.empty()) return;
    std::string bytes, scratch;
    try {
        write_next(lock, {}, bytes, scratch);
    } catch (...) {
        failure_ = std::current_exception();
        throw;
    }
}

/// If the system grants no more of them, those that there are do the work, or the submitting one.
void OrderedWriter::start_thread() {
    try {
        threads_.emplace_back([this](const std::stop_token& stop) { work(stop); });
    } catch (const std::exception&) {
        most_threads_ = threads_.size();
    }
}

void OrderedWriter::drain() { wait_for_at_most(0); }

void OrderedWriter::wait_for_at_most(std::size_t blocks) {
    std::unique_lock lock(mutex_);
    turn_.wait(lock, [&] { return failure_ || submitted_ - written_ <= blocks; });
    if (failure_) std::rethrow_exception(failure_);
}

}  // namespace steplab
