// The lanes for code that is compiled once, for every processor of the architecture.
#ifdef __SSE2__
#include "bvh/kernel/lanes_sse2.inl"
#else
#include "bvh/kernel/lanes_portable.inl"
#endif
