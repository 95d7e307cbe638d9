#include "core/precision.hpp"

namespace steplab {

// Not in the header: where g++ 12 vectorises a few such roundings in a row, it drops them (to float and back to double
// is taken for no conversion at all). By itself the function is compiled right, and a test holds it to that.
double rounded_to(Precision precision, double value) {
    return precision == Precision::float_ ? static_cast<double>(static_cast<float>(value)) : value;
}

}  // namespace steplab
