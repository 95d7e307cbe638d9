#pragma once

// STEPLAB_INSTRUCTION_SET: the namespace of the definitions in sources that are compiled once per instruction set. The
// build defines it for all sets but the first, the baseline.

#ifndef STEPLAB_INSTRUCTION_SET
#define STEPLAB_INSTRUCTION_SET baseline
#endif
