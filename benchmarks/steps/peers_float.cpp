#include "peers.hpp"

namespace steplab::benchmark {

std::vector<Contestant> peers_in_float(const Problem& problem) { return peers_in<float>(problem); }

}  // namespace steplab::benchmark
