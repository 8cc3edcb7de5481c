// SPDX-License-Identifier: Apache-2.0
/// Integers to and from GMP's `mpz_t`, by whole limbs: the cost is that of a copy, however many bits there are.
#ifndef CLEAVE_NUMBER_GMP_LIMBS_HPP
#define CLEAVE_NUMBER_GMP_LIMBS_HPP

#include <cleave/number/integer.hpp>

#include <gmp.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

CLEAVE_BEGIN_NAMESPACE

namespace gmp {

/// The value of `z`.
template <unsigned InlineLimbs = Integer::inline_limbs>
[[nodiscard]] BasicInteger<InlineLimbs> to_integer(mpz_srcptr z) {
    BasicInteger<InlineLimbs> r;
    std::size_t count = (mpz_sizeinbase(z, 2) + limbs::bits - 1) / limbs::bits;
    r.buffer().reserve(count, 0);
    mpz_export(r.buffer().data(), &count, -1, sizeof(Limb), 0, 0, z);
    r.buffer().set_size(count, mpz_sgn(z) < 0);
    return r;
}

/// z = x. Requires: `z` is initialised.
template <unsigned InlineLimbs>
void assign(mpz_ptr z, const BasicInteger<InlineLimbs>& x) {
    mpz_import(z, x.limbs().size(), -1, sizeof(Limb), 0, 0, x.limbs().data());
    if (x.sign() == Sign::minus) mpz_neg(z, z);
}

/// The least n with |z| < 2^n.
[[nodiscard]] inline std::size_t bit_length(mpz_srcptr z) {
    return mpz_sgn(z) == 0 ? 0 : mpz_sizeinbase(z, 2);  // which says 1 of zero
}

/// The magnitude and sign of a GMP integer for as long as that lives unchanged: its own limbs where GMP's limbs have
/// our type, copies elsewhere.
class LimbsOf {
public:
    explicit LimbsOf(mpz_srcptr z) : z_(z) {
        if constexpr (!shared) copy_ = to_integer(z);
    }

    [[nodiscard]] LimbView view() const { return view_as<mp_limb_t>(); }

private:
    static constexpr bool shared = std::is_same_v<mp_limb_t, Limb>;

    template <class GmpLimb>
    [[nodiscard]] LimbView view_as() const {
        if constexpr (std::is_same_v<GmpLimb, Limb>) {
            const auto count = static_cast<std::int32_t>(mpz_size(z_));
            return {mpz_limbs_read(z_), mpz_sgn(z_) < 0 ? -count : count};
        } else {
            return copy_.view();
        }
    }

    mpz_srcptr z_;
    Integer copy_;
};

}  // namespace gmp

CLEAVE_END_NAMESPACE

#endif
