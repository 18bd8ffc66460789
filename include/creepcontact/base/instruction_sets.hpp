#pragma once
/// Functions that are compiled for several instruction sets; the loader takes the best version that the processor has.
/// What they call must be inlined to be compiled so too.

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
/// With fused multiply-add, whose last bits differ from those of a product and a sum.
#define CREEPCONTACT_BEST_INSTRUCTIONS [[gnu::target_clones("avx512f", "arch=haswell", "default")]]
/// With the same bits in all versions.
#define CREEPCONTACT_LONG_VECTORS [[gnu::target_clones("avx2", "default")]]
#else
#define CREEPCONTACT_BEST_INSTRUCTIONS
#define CREEPCONTACT_LONG_VECTORS
#endif
#define CREEPCONTACT_INLINE [[gnu::always_inline]] inline
