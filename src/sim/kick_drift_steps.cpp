#include "sim/kick_drift_steps.hpp"

namespace steplab {

template void KickDriftSteps<float>::advance(System<float, Constant<float>>&, std::uint64_t);
template void KickDriftSteps<float>::advance(System<float, Line<float>>&, std::uint64_t);
template void KickDriftSteps<float>::advance(System<float, Grid<float>>&, std::uint64_t);
template void KickDriftSteps<float>::advance(System<float, Pairs<float>>&, std::uint64_t);
template void KickDriftSteps<float>::advance(System<float, NearPairs<float>>&, std::uint64_t);
template void KickDriftSteps<double>::advance(System<double, Constant<double>>&, std::uint64_t);
template void KickDriftSteps<double>::advance(System<double, Line<double>>&, std::uint64_t);
template void KickDriftSteps<double>::advance(System<double, Grid<double>>&, std::uint64_t);
template void KickDriftSteps<double>::advance(System<double, Pairs<double>>&, std::uint64_t);
template void KickDriftSteps<double>::advance(System<double, NearPairs<double>>&, std::uint64_t);
template void KickDriftSteps<InLanes<float>>::advance(System<InLanes<float>, Line<InLanes<float>>>&, std::uint64_t);
template void KickDriftSteps<InLanes<float>>::advance(System<InLanes<float>, Grid<InLanes<float>>>&, std::uint64_t);
template void KickDriftSteps<InLanes<float>>::advance(System<InLanes<float>, Pairs<InLanes<float>>>&, std::uint64_t);
template void KickDriftSteps<InLanes<double>>::advance(System<InLanes<double>, Line<InLanes<double>>>&, std::uint64_t);
template void KickDriftSteps<InLanes<double>>::advance(System<InLanes<double>, Grid<InLanes<double>>>&, std::uint64_t);
template void KickDriftSteps<InLanes<double>>::advance(System<InLanes<double>, Pairs<InLanes<double>>>&, std::uint64_t);

}  // namespace steplab
