// SPDX-License-Identifier: Apache-2.0
/// GMP's C++ classes as numbers: `mpz_class` a ring, `mpq_class` a field. Opt-in: needs gmpxx.h and -lgmp.
///
/// An `mpq_class` made from a numerator and a denominator is not in lowest terms until its `canonicalize()` is called,
/// and `mpq_class(2, 4) == mpq_class(1, 2)` is false before: call it on such values before the library sees them.
/// Results of arithmetic are canonical. `number_traits` canonicalises whatever it makes itself.
#ifndef CLEAVE_NUMBER_GMP_HPP
#define CLEAVE_NUMBER_GMP_HPP

#include <cleave/number/gmp_limbs.hpp>
#include <cleave/number/traits.hpp>

#include <gmpxx.h>

#include <algorithm>
#include <cstddef>
#include <string>

CLEAVE_BEGIN_NAMESPACE

template <>
struct number_traits<mpz_class> : number_traits_defaults<mpz_class> {
    static constexpr bool is_field = false;
    using field_type = mpq_class;

    [[nodiscard]] static Sign sign(const mpz_class& x) { return sign_of_value(sgn(x)); }
    [[nodiscard]] static mpz_class exact_divide(const mpz_class& a, const mpz_class& b) {
        mpz_class q;
        mpz_divexact(q.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
        return q;
    }
    [[nodiscard]] static Fraction to_fraction(const mpz_class& x) { return {gmp::to_integer(x.get_mpz_t()), 1}; }
    [[nodiscard]] static mpz_class from_integer(const Integer& x) {
        mpz_class r;
        gmp::assign(r.get_mpz_t(), x);
        return r;
    }

    [[nodiscard]] static mpz_class gcd(const mpz_class& a, const mpz_class& b) {
        mpz_class r;
        mpz_gcd(r.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
        return r;
    }
    [[nodiscard]] static std::size_t bit_length(const mpz_class& x) { return gmp::bit_length(x.get_mpz_t()); }
    [[nodiscard]] static double to_double(const mpz_class& x, Rounding rounding = Rounding::nearest) {
        return round_limbs(gmp::LimbsOf(x.get_mpz_t()).view(), rounding);
    }
    static void add_product(mpz_class& r, const mpz_class& a, const mpz_class& b) {
        mpz_addmul(r.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
    }
    static void sub_product(mpz_class& r, const mpz_class& a, const mpz_class& b) {
        mpz_submul(r.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
    }
    [[nodiscard]] static std::string to_text(const mpz_class& x) { return x.get_str(); }
};

template <>
struct number_traits<mpq_class> : number_traits_defaults<mpq_class> {
    static constexpr bool is_field = true;
    using field_type = mpq_class;

    [[nodiscard]] static Sign sign(const mpq_class& x) { return sign_of_value(sgn(x)); }
    [[nodiscard]] static mpq_class exact_divide(const mpq_class& a, const mpq_class& b) { return a / b; }
    [[nodiscard]] static Fraction to_fraction(const mpq_class& x) {
        return {gmp::to_integer(x.get_num_mpz_t()), gmp::to_integer(x.get_den_mpz_t())};
    }
    [[nodiscard]] static mpq_class from_integer(const Integer& x) {
        mpq_class r;
        gmp::assign(r.get_num_mpz_t(), x);
        return r;
    }
    [[nodiscard]] static mpq_class from_fraction(const Integer& num, const Integer& den) {
        if (den.is_zero()) throw NumberError("a fraction with denominator zero is not a number");
        mpq_class r;
        gmp::assign(r.get_num_mpz_t(), num);
        gmp::assign(r.get_den_mpz_t(), den);
        r.canonicalize();
        return r;
    }

    [[nodiscard]] static mpq_class gcd(const mpq_class& a, const mpq_class& b) {
        // gcd(n, p) / lcm(d, q): a prime that divides n and p divides neither d nor q, so this is in lowest terms.
        mpq_class r;
        mpz_gcd(r.get_num_mpz_t(), a.get_num_mpz_t(), b.get_num_mpz_t());
        if (sgn(r) != 0) mpz_lcm(r.get_den_mpz_t(), a.get_den_mpz_t(), b.get_den_mpz_t());
        return r;
    }
    [[nodiscard]] static std::size_t bit_length(const mpq_class& x) {
        return std::max(gmp::bit_length(x.get_num_mpz_t()), gmp::bit_length(x.get_den_mpz_t()));
    }
    [[nodiscard]] static mpq_class from_double(double x) {
        static_cast<void>(decompose(x));  // throws for what is not a number
        return mpq_class(x);
    }
    [[nodiscard]] static double to_double(const mpq_class& x, Rounding rounding = Rounding::nearest) {
        return round_limbs(gmp::LimbsOf(x.get_num_mpz_t()).view(), gmp::LimbsOf(x.get_den_mpz_t()).view(), rounding);
    }
    [[nodiscard]] static std::string to_text(const mpq_class& x) { return x.get_str(); }
};

CLEAVE_END_NAMESPACE

#endif
