#pragma once

#include "io/output_file.hpp"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace steplab {

/// Makes blocks of bytes on several threads and writes them in the order in which they were submitted, while the
/// submitting thread continues. Formatting a number takes about 30 ns, so one core makes some 400 MB/s of text: enough
/// for most disks, and each further core adds as much.
class OrderedWriter {
public:
    /// Puts the bytes of one block into an empty string; called once, on any thread. `scratch` is working memory that
    /// the thread keeps from block to block.
    using Block = std::function<void(std::string& bytes, std::string& scratch)>;

    explicit OrderedWriter(OutputFile& file);
    /// Drops blocks that are not yet written.
    ~OrderedWriter();
    OrderedWriter(const OrderedWriter&) = delete;
    OrderedWriter& operator=(const OrderedWriter&) = delete;

    /// Waits while there are most_blocks(). Throws what a block or OutputFile::write threw since the last call; nothing
    /// more is written from then on.
    void submit(Block block);
    /// Waits until all blocks are handed to the file. Throws as submit() does.
    void drain();
    /// The largest number of blocks that wait, are being made or are being written at once.
    std::size_t most_blocks() const { return 2 * most_threads_ + 1; }

private:
    void work(const std::stop_token& stop);
    bool write_next(std::unique_lock<std::mutex>& lock, const std::stop_token& stop, std::string& bytes,
                    std::string& scratch);
    void start_thread();
    void wait_for_at_most(std::size_t blocks);

    OutputFile& file_;
    std::size_t most_threads_;  ///< no more than the system grants
    std::mutex mutex_;          ///< of all members below; the file belongs to the thread whose turn it is
    std::condition_variable_any ready_;
    std::condition_variable_any turn_;
    std::deque<Block> waiting_;
    std::uint64_t submitted_ = 0;
    std::uint64_t begun_ = 0;
    std::uint64_t written_ = 0;
    std::exception_ptr failure_;
    std::vector<std::jthread> threads_;
};

}  // namespace steplab
