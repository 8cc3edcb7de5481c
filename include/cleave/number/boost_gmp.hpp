// SPDX-License-Identifier: Apache-2.0
/// Boost's wrappers of GMP: `mpz_int` a ring, `mpq_rational` a field. Opt-in: needs Boost.Multiprecision, gmp.h, -lgmp.
#ifndef CLEAVE_NUMBER_BOOST_GMP_HPP
#define CLEAVE_NUMBER_BOOST_GMP_HPP

#include <cleave/number/gmp_limbs.hpp>
#include <cleave/number/traits.hpp>

#include <boost/multiprecision/gmp.hpp>

#include <algorithm>
#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

template <>
struct number_traits<boost::multiprecision::mpz_int> : number_traits_defaults<boost::multiprecision::mpz_int> {
    using mpz_int = boost::multiprecision::mpz_int;

    static constexpr bool is_field = false;
    using field_type = boost::multiprecision::mpq_rational;

    [[nodiscard]] static Sign sign(const mpz_int& x) { return sign_of_value(x.sign()); }
    [[nodiscard]] static mpz_int exact_divide(const mpz_int& a, const mpz_int& b) {
        mpz_int q;
        mpz_divexact(q.backend().data(), a.backend().data(), b.backend().data());
        return q;
    }
    [[nodiscard]] static Fraction to_fraction(const mpz_int& x) { return {gmp::to_integer(x.backend().data()), 1}; }
    [[nodiscard]] static mpz_int from_integer(const Integer& x) {
        mpz_int r;
        gmp::assign(r.backend().data(), x);
        return r;
    }

    [[nodiscard]] static mpz_int gcd(const mpz_int& a, const mpz_int& b) { return boost::multiprecision::gcd(a, b); }
    [[nodiscard]] static std::size_t bit_length(const mpz_int& x) { return gmp::bit_length(x.backend().data()); }
    [[nodiscard]] static double to_double(const mpz_int& x, Rounding rounding = Rounding::nearest) {
        return round_limbs(gmp::LimbsOf(x.backend().data()).view(), rounding);
    }
    static void add_product(mpz_int& r, const mpz_int& a, const mpz_int& b) {
        mpz_addmul(r.backend().data(), a.backend().data(), b.backend().data());
    }
    static void sub_product(mpz_int& r, const mpz_int& a, const mpz_int& b) {
        mpz_submul(r.backend().data(), a.backend().data(), b.backend().data());
    }
};

template <>
struct number_traits<boost::multiprecision::mpq_rational>
    : number_traits_defaults<boost::multiprecision::mpq_rational> {
    using mpq_rational = boost::multiprecision::mpq_rational;

    static constexpr bool is_field = true;
    using field_type = mpq_rational;

    [[nodiscard]] static Sign sign(const mpq_rational& x) { return sign_of_value(x.sign()); }
    [[nodiscard]] static mpq_rational exact_divide(const mpq_rational& a, const mpq_rational& b) { return a / b; }
    [[nodiscard]] static Fraction to_fraction(const mpq_rational& x) {
        return {gmp::to_integer(num(x)), gmp::to_integer(den(x))};
    }
    [[nodiscard]] static mpq_rational from_integer(const Integer& x) {
        mpq_rational r;
        gmp::assign(mpq_numref(r.backend().data()), x);
        return r;
    }
    [[nodiscard]] static mpq_rational from_fraction(const Integer& n, const Integer& d) {
        if (d.is_zero()) throw NumberError("a fraction with denominator zero is not a number");
        mpq_rational r;
        gmp::assign(mpq_numref(r.backend().data()), n);
        gmp::assign(mpq_denref(r.backend().data()), d);
        mpq_canonicalize(r.backend().data());
        return r;
    }

    [[nodiscard]] static std::size_t bit_length(const mpq_rational& x) {
        return std::max(gmp::bit_length(num(x)), gmp::bit_length(den(x)));
    }
    [[nodiscard]] static double to_double(const mpq_rational& x, Rounding rounding = Rounding::nearest) {
        return round_limbs(gmp::LimbsOf(num(x)).view(), gmp::LimbsOf(den(x)).view(), rounding);
    }

private:
    [[nodiscard]] static mpz_srcptr num(const mpq_rational& x) { return mpq_numref(x.backend().data()); }
    [[nodiscard]] static mpz_srcptr den(const mpq_rational& x) { return mpq_denref(x.backend().data()); }
};

CLEAVE_END_NAMESPACE

#endif
