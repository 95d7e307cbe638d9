#include "core/precision.hpp"

namespace steplab {

// Not in the header: where g++ 12 vectorises several such roundings in a row, it drops them (it takes the conversion to
// float and back for none at all). As a separate function it is compiled correctly, which a test checks.
double rounded_to(Precision precision, double value) {
    return precision == Precision::float_ ? static_cast<double>(static_cast<float>(value)) : value;
}

}  // namespace steplab
