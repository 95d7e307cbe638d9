#pragma once

#include "session/changed_run.hpp"
#include "session/session.hpp"
#include "support/runs.hpp"

#include <cstdint>
#include <string_view>

namespace steplab::test {

inline RunDescription chain(std::string_view method = "verlet", Precision precision = Precision::double_) {
    return run_of("chain", method, precision, 0.1);
}

inline void go_to(Session& session, std::uint64_t step) {
    session.handle(event::Seek{step});
    session.finish();
}

}  // namespace steplab::test
