#include "app/commands/snapshot_options.hpp"

#include "app/cli/command_line.hpp"
#include "core/error.hpp"
#include "core/shown.hpp"
#include "io/output_file.hpp"

#include <fmt/format.h>

namespace steplab {
namespace {

void check_file(const std::string& name) {
    if (name.empty()) throw UsageError("--out FILE.png is required: the file of the picture");
    if (!written_directly(name) && !name.ends_with(".png")) {
        throw UsageError(fmt::format("--out must end in .png (got \"{}\")", shown(name)));
    }
}

}  // namespace

void SnapshotOptions::declare(CLI::App& app) {
    text_option(app, "--out", out_, "FILE.png", "File of the picture (required)", picture_group);
    picture_.declare(app);
}

PictureRequest SnapshotOptions::request(const RunDescription& description, std::size_t particles) const {
    check_file(out_);
    return picture_.request(description, particles);
}

}  // namespace steplab
