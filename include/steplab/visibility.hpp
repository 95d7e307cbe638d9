#pragma once

/// What a shared library offers to programs: everything else of it is hidden.
#define STEPLAB_PUBLIC __attribute__((visibility("default")))
