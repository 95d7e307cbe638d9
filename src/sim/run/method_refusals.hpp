#pragma once

#include "models/model.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/run_description.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace steplab {

/// Why the method cannot step with the run's dt, which is negative; nullopt if it can, or dt is not.
std::optional<std::string> backward_refusal(const RunDescription& description);

/// Why a method cannot run the scene of a description, of which this is the plan: "taylor cannot run this scene: ...";
/// none if it can.
std::optional<std::string> method_refusal(const Method& method, const RunDescription& description, const Plan& plan);

/// The same where a parameter of the scene has the name of one of the method's, so that --set could mean both.
std::optional<std::string> name_refusal(const MethodInfo& method, const RunDescription& description);

/// The reasons of all methods that cannot run a scene, by their ids.
using MethodRefusals = std::map<std::string, std::string, std::less<>>;
MethodRefusals method_refusals(const RunDescription& description, const Plan& plan);

}  // namespace steplab
