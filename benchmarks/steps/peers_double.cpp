#include "peers.hpp"

namespace steplab::benchmark {

std::vector<Contestant> peers_in_double(const Problem& problem) { return peers_in<double>(problem); }

}  // namespace steplab::benchmark
