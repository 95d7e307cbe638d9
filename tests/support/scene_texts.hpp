#pragma once

#include "core/error.hpp"
#include "io/scene_file.hpp"

#include <gtest/gtest.h>

#include <string>

namespace steplab::test {

/// A scene file of this text, named a.toml.
inline SceneOrigin read_scene(const std::string& text) { return scene_from({{.name = "", .content = text}}, "a.toml"); }

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
