#pragma once

#include "core/error.hpp"
#include "io/scene_file.hpp"

#include <gtest/gtest.h>

#include <string>

namespace steplab::test {

/// A scene file of this text, named a.toml.
inline SceneOrigin read_scene(const std::string& text) { return scene_from({{.name = "", .content = text}}, "a.toml"); }

/// The text of a scene of so many particles in a row, 1 m apart, on springs of k = 4 N/m between two that are fixed.
inline std::string row_between_walls(int moving) {
    return "steplab = 1\n[[particles]]\ngroup = \"row\"\nline = { count = " + std::to_string(moving + 2) +
           ", step = [1, 0, 0] }\n[[fix]]\nparticles = [\"row[0]\", \"row[-1]\"]\nfixed = true\n"
           "[[springs]]\nbetween = \"row\"\nk = 4\n";
}

/// Why such a file is refused; "read" if it is not.
inline std::string refusal_of_scene(const std::string& text) {
    try {
        read_scene(text);
        return "read";
    } catch (const FileError& error) {
        return error.what();
    }
}

/// The text with the first `from` replaced, which must be there.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

}  // namespace steplab::test
