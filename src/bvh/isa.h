#pragma once
#include <rayscope/settings.h>

#include "bvh/kernel/kernels.h"

namespace rayscope::bvh {

/// Whether this build has kernels for an instruction set. Isa::Auto: yes.
bool isBuilt(Isa isa);

/// Whether this build has kernels for an instruction set and this machine can run them.
bool isAvailable(Isa isa);

/// The best available one, which Isa::Auto selects.
Isa bestIsa();

/// Throws std::invalid_argument for an instruction set that is not available.
const kernel::Kernels& kernelsFor(Isa isa);

}  // namespace rayscope::bvh
