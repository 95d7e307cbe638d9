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

/// Makes blocks of bytes on several threads, which write them in the order in which they were submitted, while whoever
/// submits goes on. A number takes about 30 ns to format, so one core makes some 400 MB/s of text: enough for most
/// disks, and each further core adds as much.
class OrderedWriter {
public:
    /// Puts the bytes of one block into an empty string; called on some thread, once. `scratch` is memory to work in
    /// that the thread keeps from block to block.
    using Block = std::function<void(std::string& bytes, std::string& scratch)>;

    explicit OrderedWriter(OutputFile& file);
    /// Drops what is not yet written.
    ~OrderedWriter();
    OrderedWriter(const OrderedWriter&) = delete;
    OrderedWriter& operator=(const OrderedWriter&) = delete;

    /// Never holds more than most_blocks(): waits until there is room. Throws what a block or OutputFile::write threw
    /// since the last call; nothing more is written from then on.
    void submit(Block block);
    /// Waits until all blocks are with the file. Throws as submit() does.
    void drain();
    /// The largest number of blocks that wait, are being made or are being written.
    std::size_t most_blocks() const { return 2 * most_threads_ + 1; }

private:
    void work(const std::stop_token& stop);
    void wait_for_at_most(std::size_t blocks);

    OutputFile& file_;
    std::size_t most_threads_;
    std::mutex mutex_;  ///< of all that follows; the file belongs to the thread whose turn it is
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
