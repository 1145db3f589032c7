#pragma once

namespace rayscope::render {

/// To be called once at the start of the program, while there is memory: lets TBB load its allocator. Without
/// memory dlopen() of glibc 2.36 crashes.
void prepareThreads() noexcept;

}  // namespace rayscope::render
