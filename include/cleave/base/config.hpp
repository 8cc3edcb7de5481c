// SPDX-License-Identifier: Apache-2.0
/// Compiler requirements and the namespace macros that every header uses.
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

#endif
