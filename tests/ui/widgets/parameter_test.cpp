#include "core/error.hpp"
#include "sim/catalogue.hpp"
#include "ui/desk.hpp"
#include "ui/widgets/parameter_rows.hpp"

#include <gtest/gtest.h>

namespace steplab::ui {
namespace {

bool has_slider(const ParameterInfo& info) {
    const bool is_switch = info.kind == ParameterInfo::Kind::integer && info.minimum == 0 && info.maximum == 1;
    return info.kind != ParameterInfo::Kind::choice && !is_switch;
}

/// A parameter of a model or method in the panel.
struct Place {
    RunDescription description;
    std::string widget;
    ParameterInfo info;
    bool of_scene = true;

    const ParameterValues& values(const RunDescription& run) const {
        return of_scene ? run.scene : run.method_parameters;
    }
};

/// Of every model and method: one test, as the catalogue is.
std::vector<Place> all_parameters() {
    std::vector<Place> places;
    for (const Model& model : models()) {
        for (const ParameterInfo& info : model.info.parameters) {
            places.push_back({describe(model.info.id), "scene." + std::string(info.name), info, true});
        }
    }
    for (const Method& method : methods()) {
        for (const ParameterInfo& info : method.info.parameters) {
            places.push_back({describe("chain", method.info.id), "method." + std::string(info.name), info, false});
        }
    }
    return places;
}

/// Those of them with a slider, or those without.
std::vector<Place> parameters_with_slider(bool slider) {
    std::vector<Place> places = all_parameters();
    std::erase_if(places, [&](const Place& place) { return has_slider(place.info) != slider; });
    EXPECT_FALSE(places.empty());
    return places;
}

TEST(parameters, every_slider_moves_its_parameter_alone) {
    for (const Place& place : parameters_with_slider(true)) {
        SCOPED_TRACE(place.description.model + " " + place.widget);
        Desk desk(place.description);
        desk.drag(place.widget, 0.3f, 0.6f);
        ASSERT_FALSE(desk.recorder.changes.empty());
        const double value = place.values(desk.wanted())[place.info.name];
        EXPECT_NE(value, place.info.default_value);
        EXPECT_GE(value, place.info.slider_low);
        EXPECT_LE(value, place.info.slider_high);
        RunDescription back = desk.wanted();
        (place.of_scene ? back.scene : back.method_parameters).set(place.info.name, place.info.default_value);
        EXPECT_EQ(back, place.description);
    }
}

TEST(parameters, double_click_gives_every_slider_its_default) {
    for (const Place& place : parameters_with_slider(true)) {
        SCOPED_TRACE(place.description.model + " " + place.widget);
        Desk desk(place.description);
        desk.drag(place.widget, 0.3f, 0.8f);
        desk.double_click(place.widget);
        EXPECT_EQ(desk.wanted(), place.description);
    }
}

/// False where values that are allowed by themselves do not go together.
bool is_scene(const RunDescription& description) {
    try {
        check(description);
        return true;
    } catch (const UsageError&) {
        return false;
    }
}

TEST(parameters, every_slider_takes_a_typed_value_of_any_size) {
    std::size_t typed_in = 0;
    for (const Place& place : parameters_with_slider(true)) {
        SCOPED_TRACE(place.description.model + " " + place.widget);
        Desk desk(place.description);
        const double beyond = place.info.slider_high + 1;
        if (beyond > place.info.maximum) continue;
        ++typed_in;
        desk.click(place.widget + ".value");
        desk.type(format_value(place.info, beyond));
        desk.key(Key::enter);
        RunDescription typed = place.description;
        set_parameter(typed, std::string(place.info.name), format_value(place.info, beyond));
        if (is_scene(typed)) {
            ASSERT_EQ(desk.recorder.changes.size(), 1u);
            EXPECT_EQ(place.values(desk.wanted())[place.info.name], beyond);
        } else {
            EXPECT_TRUE(desk.recorder.changes.empty());
        }
    }
    EXPECT_GT(typed_in, models().size());
}

TEST(parameters, text_entries_share_the_clipboard_of_other_programs) {
    Desk desk(describe("oscillator"));
    std::string clipboard = "0.25";
    desk.interface.use_clipboard({[&] { return clipboard; }, [&](const std::string& text) { clipboard = text; }});
    desk.click("dt.value");
    desk.key(Key::v, true);
    desk.key(Key::enter);
    EXPECT_EQ(desk.wanted().dt, 0.25);
    desk.click("dt.value");
    desk.type("0.5");
    desk.key(Key::a, true);
    desk.key(Key::x, true);
    EXPECT_EQ(clipboard, "0.5");
}

TEST(parameters, choices_and_switches_are_clicked) {
    for (const Place& place : parameters_with_slider(false)) {
        SCOPED_TRACE(place.description.model + " " + place.widget);
        Desk desk(place.description);
        const double other = place.info.default_value == 0 ? 1 : 0;
        const bool choice = place.info.kind == ParameterInfo::Kind::choice;
        desk.click(choice ? place.widget + "/" + std::string(place.info.choices[static_cast<std::size_t>(other)])
                          : place.widget);
        ASSERT_EQ(desk.recorder.changes.size(), 1u);
        EXPECT_EQ(place.values(desk.wanted())[place.info.name], other);
    }
}

TEST(parameters, help_has_range_default_and_effect) {
    for (const Place& place : all_parameters()) {
        const std::string help = parameter_help(place.info);
        EXPECT_NE(help.find(place.info.what), std::string::npos) << help;
        EXPECT_NE(help.find(range_text(place.info)), std::string::npos) << help;
        EXPECT_NE(help.find("default " + format_value(place.info, place.info.default_value)), std::string::npos);
        const bool restarts = place.info.on_change == OnChange::restarts;
        EXPECT_NE(help.find(restarts ? "restarts" : "at once"), std::string::npos) << help;
    }
}

}  // namespace
}  // namespace steplab::ui
