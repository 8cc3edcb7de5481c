// SPDX-License-Identifier: Apache-2.0
/// Integers to and from Boost's `cpp_int`, by whole limbs: the cost is that of a copy, however many bits there are.
#ifndef CLEAVE_NUMBER_CPP_INT_LIMBS_HPP
#define CLEAVE_NUMBER_CPP_INT_LIMBS_HPP

#include <cleave/number/integer.hpp>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

namespace cpp_int_limbs {

using boost::multiprecision::cpp_int;

/// Boost's limbs have 64 bits where the compiler has 128-bit integers, else 32.
inline constexpr std::size_t per_limb = sizeof(Limb) / sizeof(boost::multiprecision::limb_type);
inline constexpr unsigned boost_bits = static_cast<unsigned>(8 * sizeof(boost::multiprecision::limb_type));

/// The value of `x`.
[[nodiscard]] inline Integer to_integer(const cpp_int& x) {
    const auto& backend = x.backend();
    const std::size_t size = backend.size();
    const std::size_t count = (size + per_limb - 1) / per_limb;
    Integer r;
    r.buffer().reserve(count, 0);
    Limb* out = r.buffer().data();
    for (std::size_t i = 0; i < count; ++i) {
        Limb limb = 0;
        for (std::size_t k = 0; k < per_limb && i * per_limb + k < size; ++k)
            limb |= Limb(backend.limbs()[i * per_limb + k]) << (k * boost_bits);
        out[i] = limb;
    }
    r.buffer().set_size_normalised(count, backend.sign());
    return r;
}

/// The value of `x`.
template <unsigned InlineLimbs>
[[nodiscard]] cpp_int from_integer(const BasicInteger<InlineLimbs>& x) {
    cpp_int r;
    if (x.is_zero()) return r;
    auto& backend = r.backend();
    const auto size = static_cast<unsigned>(x.limbs().size() * per_limb);
    backend.resize(size, size);
    for (unsigned i = 0; i < size; ++i) {
        const Limb limb = x.limbs()[i / per_limb];
        backend.limbs()[i] = static_cast<boost::multiprecision::limb_type>(limb >> (i % per_limb * boost_bits));
    }
    backend.normalize();
    backend.sign(x.sign() == Sign::minus);
    return r;
}

}  // namespace cpp_int_limbs

CLEAVE_END_NAMESPACE

#endif
