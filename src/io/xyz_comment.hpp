#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace steplab {

/// The second line of a frame of extended XYZ: pairs of key=value or key="a value of words".
class XyzComment {
public:
    explicit XyzComment(std::string_view line);
    /// None if the line does not have the key.
    std::optional<std::string> value(std::string_view key) const;

private:
    std::map<std::string, std::string, std::less<>> pairs_;
};

}  // namespace steplab
