#pragma once
#include "core/field.hpp"
#include "core/vec3.hpp"

#include <string>
namespace steplab {
struct Reference {
    Field<double> displacement;
    double error = 0;
    std::string how;
    double distance(const Field<double>& d, std::size_t i) const { return length(d.at(i) - displacement.at(i)); }
};
struct StudyPlan;
Reference reference_for(const StudyPlan& plan);
}  // namespace steplab
