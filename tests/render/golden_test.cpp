#include "app/png.hpp"
#include "render/studio.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>
#include <png.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace steplab::render {
namespace {

using test::Image;

const PictureSize golden_size{320, 180};

Image read_png(const std::filesystem::path& file) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&png, file.c_str())) throw std::runtime_error("cannot read " + file.string());
    png.format = PNG_FORMAT_RGBA;
    Image image{{static_cast<int>(png.width), static_cast<int>(png.height)},
                std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png))};
    if (!png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr)) throw std::runtime_error(png.message);
    return image;
}

/// Other versions of Mesa and other processors round differently: outlines may gain or lose a sample, which changes a
/// pixel by a quarter of its contrast. The text's pixels depend on the fonts that are installed, so it is left out.
bool similar(const Image& a, const Image& b) {
    return a.size == b.size && test::differing_pixels(a, b, 24) < golden_size.width * golden_size.height / 1000;
}

std::filesystem::path golden_file(const std::string& model) {
    return std::filesystem::path(STEPLAB_SOURCE_DIR) / "assets/golden" / (model + ".png");
}

class Golden : public test::Studio, public testing::WithParamInterface<std::string> {
protected:
    /// Each model some time after its start; without the axes' numbers and the legend.
    static Image draw_model(std::uint64_t steps, const Style& style) {
        Simulation simulation(describe(GetParam()));
        const Camera camera = default_camera(simulation.frame(), golden_size);
        simulation.advance(steps);
        return draw(simulation.frame(), camera, style, golden_size);
    }
    static Style style() {
        Style style;
        style.grid = style.legend = false;
        style.colouring = Colouring::displacement;
        return style;
    }
};

TEST_P(Golden, picture_is_as_it_was) {
    const Image image = draw_model(15, style());
    // STEPLAB_UPDATE_GOLDEN=1 writes the pictures instead, after an intended change; inspect them.
    if (std::getenv("STEPLAB_UPDATE_GOLDEN")) {
        std::ofstream(golden_file(GetParam()), std::ios::binary)
            << encode_png(image.size.width, image.size.height, image.rgba);
    }
    EXPECT_TRUE(similar(image, read_png(golden_file(GetParam()))));
}

TEST_P(Golden, a_changed_picture_is_detected) {
    const Image golden = read_png(golden_file(GetParam()));
    Style other = style();
    other.background = Background::light;
    EXPECT_FALSE(similar(draw_model(15, other), golden));
    Style coloured = style();
    coloured.colouring = Colouring::role;
    EXPECT_FALSE(similar(draw_model(15, coloured), golden));
    EXPECT_FALSE(similar(draw_model(60, style()), golden));
}

INSTANTIATE_TEST_SUITE_P(Models, Golden, testing::ValuesIn(test::model_ids()),
                         [](const auto& test) { return test.param; });

TEST(Png, reads_back_as_it_was_written) {
    const std::vector<std::uint8_t> rgba{255, 0, 1, 255, 2, 3, 4, 255, 5, 6, 7, 255, 250, 251, 252, 255};
    const std::string bytes = encode_png(2, 2, rgba);
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    ASSERT_TRUE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()));
    png.format = PNG_FORMAT_RGBA;
    std::vector<std::uint8_t> back(PNG_IMAGE_SIZE(png));
    ASSERT_TRUE(png_image_finish_read(&png, nullptr, back.data(), 0, nullptr));
    EXPECT_EQ(back, rgba);
}

}  // namespace
}  // namespace steplab::render
