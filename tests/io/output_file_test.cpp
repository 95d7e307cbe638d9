#include "io/output_file.hpp"

#include "core/error.hpp"
#include "io/files.hpp"

#include <gmock/gmock.h>

#include <sys/stat.h>

namespace steplab {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::ptrdiff_t files_in(const TemporaryFolder& folder) {
    return std::distance(std::filesystem::directory_iterator(folder.path()), {});
}

TEST(OutputFile, appears_whole_when_committed) {
    const TemporaryFolder folder;
    const std::string name = folder.file("a");
    const std::string large(1000000, 'x');  // more than the buffer
    OutputFile file(name);
    file.write("begin ");
    file.write(large);
    file.flush();
    EXPECT_FALSE(std::filesystem::exists(name));
    file.write(" end");
    file.commit();
    EXPECT_EQ(text_of(name), "begin " + large + " end");
    EXPECT_EQ(files_in(folder), 1);
}

TEST(OutputFile, leaves_nothing_when_abandoned) {
    const TemporaryFolder folder;
    put_text(folder.file("a"), "before");
    {
        OutputFile file(folder.file("a"));
        file.write("after");
        file.flush();
        EXPECT_EQ(files_in(folder), 2);
    }
    EXPECT_EQ(text_of(folder.file("a")), "before");
    EXPECT_EQ(files_in(folder), 1);
}

// A killed program's file is locked by nobody.
TEST(OutputFile, removes_what_killed_programs_have_left) {
    const TemporaryFolder folder;
    std::string left;
    {
        OutputFile file(folder.file("a"));
        for (const auto& entry : std::filesystem::directory_iterator(folder.path())) left = entry.path().string();
    }
    ASSERT_FALSE(left.empty());
    put_text(left, "half a file");
    OutputFile(folder.file("b")).commit();
    EXPECT_EQ(files_in(folder), 1) << "b alone";
    EXPECT_FALSE(std::filesystem::exists(left));
}

TEST(OutputFile, interrupted_is_kept_under_another_name) {
    const TemporaryFolder folder;
    put_text(folder.file("a"), "before");
    OutputFile file(folder.file("a"));
    EXPECT_EQ(file.keep_partial(), std::nullopt);  // nothing was written
    file.write("some lines\n");
    EXPECT_EQ(file.keep_partial(), folder.file("a.partial"));
    EXPECT_EQ(text_of(folder.file("a")), "before");
    EXPECT_EQ(text_of(folder.file("a.partial")), "some lines\n");
}

TEST(OutputFile, two_writers_of_one_name_do_not_meet) {
    const TemporaryFolder folder;
    OutputFile first(folder.file("a"));
    OutputFile second(folder.file("a"));
    first.write("first");
    second.write("second");
    first.commit();
    EXPECT_EQ(text_of(folder.file("a")), "first");
    second.commit();
    EXPECT_EQ(text_of(folder.file("a")), "second");
}

TEST(OutputFile, names_the_reason_why_a_file_cannot_be_written) {
    const TemporaryFolder folder;
    EXPECT_THAT([&] { OutputFile(folder.file("no/a")); }, ThrowsMessage<FileError>(HasSubstr("there is no folder")));
    EXPECT_THAT([&] { OutputFile(folder.path()); }, ThrowsMessage<FileError>(HasSubstr("it is a folder")));
    EXPECT_THAT([&] { OutputFile(folder.path() + '/'); }, ThrowsMessage<FileError>(HasSubstr("it is a folder")));
    EXPECT_THAT([&] { OutputFile(""); }, ThrowsMessage<FileError>(HasSubstr("with an empty name")));
    put_text(folder.file("file"), "");
    EXPECT_THROW(OutputFile(folder.file("file/a")), FileError);
    EXPECT_THROW(OutputFile(folder.file(std::string(1000, 'a'))).commit(), FileError);
}

TEST(OutputFile, circular_link_is_refused) {
    const TemporaryFolder folder;
    std::filesystem::create_symlink("b", folder.file("a"));
    std::filesystem::create_symlink("a", folder.file("b"));
    EXPECT_THROW(OutputFile(folder.file("a")), FileError);
}

TEST(OutputFile, full_device_is_an_error) {
    OutputFile file("/dev/full");
    file.write("text");
    EXPECT_THAT([&] { file.commit(); }, ThrowsMessage<FileError>(HasSubstr("'/dev/full': No space left on device")));
}

TEST(OutputFile, new_files_have_the_usual_permissions) {
    const TemporaryFolder folder;
    const mode_t before = umask(027);
    OutputFile(folder.file("a")).commit();
    umask(before);
    struct stat status {};
    stat(folder.file("a").c_str(), &status);
    EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(SameOutput, sees_through_names_and_links) {
    const TemporaryFolder folder;
    const std::string a = folder.file("a"), b = folder.file("b"), link = folder.file("link");
    std::filesystem::create_symlink("a", link);
    for (int time = 0; time < 2; ++time) {  // before and after the files exist
        EXPECT_TRUE(same_output(a, a));
        EXPECT_TRUE(same_output(a, folder.path() + "/./a"));
        EXPECT_TRUE(same_output(a, link));
        EXPECT_FALSE(same_output(a, b));
        EXPECT_FALSE(same_output("-", a));
        put_text(a, "");
        put_text(b, "");
    }
    EXPECT_TRUE(same_output("-", "-"));
    EXPECT_FALSE(same_output("/dev/null", "/dev/null"));
}

TEST(WrittenDirectly, are_devices_and_pipes_but_not_files) {
    const TemporaryFolder folder;
    ASSERT_EQ(mkfifo(folder.file("pipe").c_str(), 0600), 0);
    put_text(folder.file("file"), "");
    EXPECT_TRUE(written_directly("-"));
    EXPECT_TRUE(written_directly("/dev/null"));
    EXPECT_TRUE(written_directly(folder.file("pipe")));
    EXPECT_FALSE(written_directly(folder.file("file")));
    EXPECT_FALSE(written_directly(folder.file("missing")));
    EXPECT_FALSE(written_directly(folder.path()));
}

}  // namespace
}  // namespace steplab
