// SPDX-License-Identifier: Apache-2.0
/// The sign of the 4 x 4 determinant of four planes in 3-D, every intermediate as wide as its bound and no wider.
///
/// The determinant of planes (n_i, c_i), i = 0..3, is the meeting point of three of them put into the fourth, times the
/// point's weight: the predicate "a constructed vertex against a plane". With |n| < 2^N and |c| < 2^O, and h(k) the
/// largest determinant of order k with entries +-1 (h = 1, 2, 4, 16; an entry of absolute value below 2^p scales it by
/// 2^p):
///
/// | value                           | below          | bits with sign |
/// |---------------------------------|----------------|----------------|
/// | 2 x 2 minors of the normals     | 2^(2 N + 1)    | 2 N + 2        |
/// | 3 x 3 minors of the normals     | 2^(3 N + 2)    | 3 N + 3        |
/// | determinant                     | 2^(3 N + O + 4)| 3 N + O + 5    |
///
/// On a grid |x| <= 2^b planes through input points have N = 2 b + 2 and O = 3 b + 2: 256 bits hold b = 27, 1088 hold
/// the 1039 bits of b = 114.
#ifndef CLEAVE_NUMBER_FIXED_INT_DETERMINANT_HPP
#define CLEAVE_NUMBER_FIXED_INT_DETERMINANT_HPP

#include <cleave/number/fixed_digits.hpp>

#include <array>
#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

/// Four planes with |normal entries| < 2^NormalBits and |offsets| < 2^OffsetBits.
template <unsigned NormalBits, unsigned OffsetBits>
class PlaneDeterminant {
public:
    using Normal = FixedDigits<NormalBits>;
    using Offset = FixedDigits<OffsetBits>;
    using Minor2 = FixedDigits<2 * NormalBits + 1>;
    using Minor3 = FixedDigits<3 * NormalBits + 2>;
    using Value = FixedDigits<3 * NormalBits + OffsetBits + 4>;

    struct Plane {
        std::array<Normal, 3> normal;
        Offset offset;
    };

    /// The exact determinant of the rows (n_0, n_1, n_2, c), top to bottom.
    /// Cost: 28 mixed-width products; at 256 bits 60 products of digits.
    [[nodiscard]] static constexpr Value determinant(const std::array<Plane, 4>& p) noexcept {
        // Laplace expansion from the narrow columns to the wide one, so that every product has a narrow operand.
        const auto minor2 = [&](std::size_t i, std::size_t j) {  // columns 0 and 1 of rows i and j
            return sum_of_products<Minor2::bits>(plus_product(p[i].normal[0], p[j].normal[1]),
                                                 minus_product(p[j].normal[0], p[i].normal[1]));
        };
        const Minor2 m01 = minor2(0, 1);
        const Minor2 m02 = minor2(0, 2);
        const Minor2 m03 = minor2(0, 3);
        const Minor2 m12 = minor2(1, 2);
        const Minor2 m13 = minor2(1, 3);
        const Minor2 m23 = minor2(2, 3);
        // The normals of three rows: i, j, k against the minors of the other two.
        const auto minor3 = [&](std::size_t i, const Minor2& jk, std::size_t j, const Minor2& ik, std::size_t k,
                                const Minor2& ij) {
            return sum_of_products<Minor3::bits>(plus_product(jk, p[i].normal[2]), minus_product(ik, p[j].normal[2]),
                                                 plus_product(ij, p[k].normal[2]));
        };
        const Minor3 w0 = minor3(1, m23, 2, m13, 3, m12);
        const Minor3 w1 = minor3(0, m23, 2, m03, 3, m02);
        const Minor3 w2 = minor3(0, m13, 1, m03, 3, m01);
        const Minor3 w3 = minor3(0, m12, 1, m02, 2, m01);
        return sum_of_products<Value::bits>(plus_product(w3, p[3].offset), minus_product(w2, p[2].offset),
                                            plus_product(w1, p[1].offset), minus_product(w0, p[0].offset));
    }

    /// The sign of `determinant`.
    [[nodiscard]] static constexpr Sign sign(const std::array<Plane, 4>& p) noexcept { return determinant(p).sign(); }
};

CLEAVE_END_NAMESPACE

#endif
