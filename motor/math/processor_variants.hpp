#pragma once

/// In front of a function of every step: the compiler makes it twice, for processors with AVX and for all others,
/// and the program takes the one that fits when it is loaded. Instructions with three operands save a tenth of
/// them. What such a function calls is put into it, for a function by itself is of the common kind. Both give the
/// same results to the last bit, for neither contracts a product and a sum into one rounding. Not with sanitizers,
/// whose code would run before the program is loaded.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__ELF__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define MOTOR_PROCESSOR_VARIANTS [[gnu::flatten, gnu::target_clones("avx", "default")]]
#else
#define MOTOR_PROCESSOR_VARIANTS
#endif
