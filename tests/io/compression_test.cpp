#include "io/compression.hpp"

#include "core/error.hpp"
#include "io/files.hpp"
#include "io/output_file.hpp"
#include "io/text_input.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <random>

namespace steplab {
namespace {

using testing::HasSubstr;

const Compression both[] = {Compression::gzip, Compression::zstd};

std::string file_ending(Compression compression) { return compression == Compression::gzip ? ".gz" : ".zst"; }

/// Lines of digits, as rows have them.
std::string rows(std::size_t count) {
    std::mt19937 random(1);
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += std::to_string(i) + ",0." + std::to_string(random()) + "\n";
    return text;
}

/// A text in a file compressed by its name.
std::string compressed(const std::string& text, Compression compression) {
    const TemporaryFolder folder;
    const std::string name = folder.file("a.csv") + file_ending(compression);
    OutputFile file(name, compression_of(name));
    for (std::size_t begin = 0; begin < text.size(); begin += 10007) {
        file.write(std::string_view(text).substr(begin, 10007));
        if (begin % 5 == 0) file.flush();
    }
    file.commit();
    return text_of(name);
}

/// What TextInput makes of a file of these bytes: its lines, or the refusal.
std::string read(const std::string& bytes) {
    const TemporaryFolder folder;
    put_text(folder.file("a"), bytes);
    std::string text;
    try {
        TextInput input((InputFile(folder.file("a"))));
        while (const auto line = input.line()) text.append(*line).append("\n");
    } catch (const FileError& error) {
        return error.what();
    }
    return text;
}

TEST(Compression, follows_the_name) {
    EXPECT_EQ(compression_of("a.csv.gz"), Compression::gzip);
    EXPECT_EQ(compression_of("a.ZST"), Compression::zstd);
    for (const char* name : {"a", "gz", ".gz", "a.gz/b", "a.csv", "-"})
        EXPECT_EQ(compression_of(name), Compression::none) << name;
    EXPECT_EQ(without_compression("b.gz/a.csv.gz"), "b.gz/a.csv");
    EXPECT_EQ(without_compression("a.csv"), "a.csv");
}

TEST(Compression, gives_back_the_text) {
    for (const Compression compression : both) {
        for (const std::size_t count : {0u, 1u, 1000u, 200000u}) {
            const std::string text = rows(count), small = compressed(text, compression);
            EXPECT_EQ(read(small), text);
            EXPECT_EQ(compression_in(small), compression);
            if (count > 100) {
                EXPECT_LT(small.size(), text.size() * 7 / 10);
            }
        }
    }
}

TEST(Compression, is_read_by_the_tools_of_the_system) {
    const TemporaryFolder folder;
    const std::string text = rows(5000);
    put_text(folder.file("a.gz"), compressed(text, Compression::gzip));
    ASSERT_EQ(std::system(("gzip -dc " + folder.file("a.gz") + " > " + folder.file("b")).c_str()), 0);
    EXPECT_EQ(text_of(folder.file("b")), text);
    ASSERT_EQ(std::system(("gzip " + folder.file("b")).c_str()), 0);
    EXPECT_EQ(read(text_of(folder.file("b.gz"))), text);
}

TEST(Compression, of_several_parts_is_read_whole) {
    const std::string text = rows(30000);
    for (const Compression compression : both) {
        const std::string part = compressed(text, compression);
        EXPECT_EQ(read(part + part + compressed("", compression) + part), text + text + text);
    }
}

TEST(Compression, truncated_anywhere_is_refused) {
    const std::string text = rows(400);
    for (const Compression compression : both) {
        const std::string whole = compressed(text, compression);
        for (std::size_t length = 4; length < whole.size(); ++length)
            ASSERT_THAT(read(whole.substr(0, length)), HasSubstr("its compressed data is truncated")) << length;
    }
}

TEST(Compression, changed_anywhere_is_refused_or_the_same_text) {
    const std::string text = rows(400);
    for (const Compression compression : both) {
        const std::string whole = compressed(text, compression);
        std::size_t refused = 0;
        for (std::size_t place = 4; place < whole.size(); ++place) {
            std::string changed = whole;
            changed[place] = static_cast<char>(changed[place] ^ (1 << place % 8));
            const std::string back = read(changed);
            if (back == text) continue;  // a time or a system in the head of gzip
            ++refused;
            ASSERT_THAT(back, HasSubstr("its compressed data is")) << place;
        }
        EXPECT_GT(refused, whole.size() - 20);
    }
}

TEST(Compression, rubbish_behind_it_is_refused) {
    for (const Compression compression : both)
        EXPECT_THAT(read(compressed("a\n", compression) + "rubbish"), HasSubstr("its compressed data is damaged"));
}

TEST(Compression, an_interrupted_file_is_whole_up_to_there) {
    const TemporaryFolder folder;
    for (const Compression compression : both) {
        OutputFile file(folder.file("a.csv") + file_ending(compression), compression);
        file.write("step\n1\n");
        const auto kept = file.keep_partial();
        ASSERT_TRUE(kept);
        EXPECT_EQ(read(text_of(*kept)), "step\n1\n");
    }
}

TEST(TextInput, gives_lines_whatever_ends_them) {
    EXPECT_EQ(read("a\r\nb\n\nc"), "a\nb\n\nc\n");
    EXPECT_EQ(read(""), "");
    EXPECT_EQ(read("\n"), "\n");
    const std::string text = rows(100000);  // longer than a piece that is read at once
    EXPECT_EQ(read(text), text);
}

TEST(TextInput, refuses_endless_lines) {
    EXPECT_THAT(read("a\n" + std::string(1000000, 'x')), HasSubstr("line 2: it is too long"));
    EXPECT_THAT(read(compressed(std::string(100000000, 'x'), Compression::zstd)), HasSubstr("line 1: it is too long"));
}

}  // namespace
}  // namespace steplab
