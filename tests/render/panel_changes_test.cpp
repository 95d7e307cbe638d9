// Drawing only what has changed: the picture is the same as one drawn from scratch.
#include "render/panel_changes.hpp"

#include "render/panel_studio.hpp"

#include <numeric>

namespace steplab::render {
namespace {

using namespace steplab::test;

constexpr PictureSize size = panel_picture;
constexpr ImU32 opaque_red = IM_COL32(255, 0, 0, 255), half_blue = IM_COL32(0, 0, 255, 128);

int pixels_of(const std::vector<PictureArea>& areas) {
    return std::accumulate(areas.begin(), areas.end(), 0,
                           [](int sum, const PictureArea& area) { return sum + area.size.width * area.size.height; });
}

class PanelDrawing : public PanelStudio {
public:
    PanelDrawing() : kept_(size) {}

protected:
    static void clear(const PictureArea& area) {
        glScissor(area.left, size.height - area.top - area.size.height, area.size.width, area.size.height);
        glEnable(GL_SCISSOR_TEST);
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glDisable(GL_SCISSOR_TEST);
    }
    /// Draws what has changed since the last call into a picture that is kept.
    std::vector<PictureArea> draw_changes(const Paint& paint, const PictureArea& covered = {0, 0, {0, 0}}) {
        const ImDrawData& data = data_of(paint);
        kept_.bind_picture();
        const std::vector<PictureArea> areas = changes_.take(data, covered);
        for (const PictureArea& area : areas) clear(area);
        renderer().draw(data, areas);
        return areas;
    }
    Image kept() const { return {size, kept_.read()}; }
    Image drawn_from_scratch(const Paint& paint) const {
        const RenderTarget target(size);
        target.bind_picture();
        clear({0, 0, size});
        renderer().draw(data_of(paint));
        return {size, target.read()};
    }
    void expect_same_as_from_scratch(const std::vector<Paint>& steps) {
        for (std::size_t i = 0; i < steps.size(); ++i) {
            draw_changes(steps[i]);
            ASSERT_EQ(kept().rgba, drawn_from_scratch(steps[i]).rgba) << "step " << i;
        }
    }

    PanelChanges changes_;

private:
    RenderTarget kept_;
};

TEST_F(PanelDrawing, changes_leave_the_picture_as_if_it_were_drawn_from_scratch) {
    const Paint nothing = [](ImDrawList&) {};
    expect_same_as_from_scratch({panel("step 1"), panel("step 2"), panel("step 2"), panel("step 100"),
                                 panel("step 100", 11), panel("step 100", 11, opaque_red), nothing, panel("step 1")});
}

TEST_F(PanelDrawing, order_and_clipping_count) {
    const auto two = [](bool red_first, float clip) -> Paint {
        return [=](ImDrawList& list) {
            list.PushClipRect({0, 0}, {clip, 100});
            for (const bool is_red : {red_first, !red_first})
                list.AddRectFilled({20, 20}, {80, 60}, is_red ? opaque_red : half_blue);
            list.PopClipRect();
        };
    };
    expect_same_as_from_scratch({two(true, 200), two(false, 200), two(false, 50), two(true, 50)});
}

TEST_F(PanelDrawing, nothing_is_drawn_where_nothing_changes) {
    EXPECT_EQ(pixels_of(draw_changes(panel("step 1"))), size.width * size.height);
    EXPECT_EQ(pixels_of(draw_changes(panel("step 1"))), 0);
    const int changed = pixels_of(draw_changes(panel("step 2")));
    EXPECT_GT(changed, 0);
    EXPECT_LT(changed, size.width * size.height / 4);
}

TEST_F(PanelDrawing, after_forgetting_all_is_drawn) {
    draw_changes(panel("step 1"));
    changes_.forget();
    EXPECT_EQ(pixels_of(draw_changes(panel("step 1"))), size.width * size.height);
}

TEST_F(PanelDrawing, areas_share_no_pixel_and_leave_out_what_is_covered) {
    const PictureArea covered{50, 30, {70, 40}};
    const std::vector<PictureArea> areas = draw_changes(panel("step 1"), covered);
    EXPECT_EQ(pixels_of(areas), size.width * size.height - 70 * 40);
    for (std::size_t i = 0; i < areas.size(); ++i) {
        EXPECT_FALSE(shared_part(areas[i], covered));
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(shared_part(areas[i], areas[j]));
    }
}

}  // namespace
}  // namespace steplab::render
