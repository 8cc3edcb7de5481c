// SPDX-License-Identifier: Apache-2.0
/// Compiler requirements, the namespace macros that every header uses, and which optional numbers there are.
#ifndef CLEAVE_BASE_CONFIG_HPP
#define CLEAVE_BASE_CONFIG_HPP

#include <cleave/version.hpp>

#if !defined(_MSVC_LANG) && __cplusplus < 202002L
#error "cleave needs C++20: compile with -std=c++20 or newer"
#endif

// A proven error bound is a statement about IEEE arithmetic; -ffast-math voids it.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "cleave cannot be compiled with -ffast-math: its floating-point filters would no longer be proofs"
#endif

// CLEAVE_HAS_GMP and CLEAVE_HAS_BOOST say which numbers of others may be used. CMake's targets decide by what is linked
// (CLEAVE_PARTS_CHOSEN, CLEAVE_WITH_...): a header in a system folder does not mean that its library is linked. Without
// them, what the compiler can include decides. CLEAVE_NO_GMP and CLEAVE_NO_BOOST forbid, either way.
#if !defined(CLEAVE_NO_GMP) && !defined(CLEAVE_HAS_GMP)
#if defined(CLEAVE_WITH_GMP)
#define CLEAVE_HAS_GMP 1
#elif !defined(CLEAVE_PARTS_CHOSEN) && __has_include(<gmpxx.h>)
#define CLEAVE_HAS_GMP 1
#endif
#endif

#if !defined(CLEAVE_NO_BOOST) && !defined(CLEAVE_HAS_BOOST)
#if defined(CLEAVE_WITH_BOOST)
#define CLEAVE_HAS_BOOST 1
#elif !defined(CLEAVE_PARTS_CHOSEN) && __has_include(<boost/multiprecision/cpp_int.hpp>)
#define CLEAVE_HAS_BOOST 1
#endif
#endif

#endif
