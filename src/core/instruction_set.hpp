#pragma once

// STEPLAB_INSTRUCTION_SET: the namespace of what a source defines that is compiled once for each instruction set. The
// build defines it for all but the first of them, the baseline.

#ifndef STEPLAB_INSTRUCTION_SET
#define STEPLAB_INSTRUCTION_SET baseline
#endif
