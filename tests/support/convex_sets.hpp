// SPDX-License-Identifier: Apache-2.0
/// Sets of any dimension whose membership is plain to see: unions of convex sets given by half-spaces with small
/// integers, as trees over the indexed kernel, and points off all their planes.
#ifndef CLEAVE_TESTS_SUPPORT_CONVEX_SETS_HPP
#define CLEAVE_TESTS_SUPPORT_CONVEX_SETS_HPP

#include <cleave/bsp/merge.hpp>
#include <cleave/bsp/tree.hpp>
#include <cleave/clip/polytope_clip.hpp>

#include "support/dice.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace support {

template <int D>
using IntegerPlane = std::array<int, std::size_t(D) + 1>;

/// The intersection of the half-spaces n . x + c <= 0.
template <int D>
struct HalfSpaces {
    std::vector<IntegerPlane<D>> planes;
};

/// A box with integer corners; empty where lo >= hi for some axis.
template <int D>
HalfSpaces<D> integer_box(const std::array<int, std::size_t(D)>& lo, const std::array<int, std::size_t(D)>& hi) {
    HalfSpaces<D> h;
    for (std::size_t i = 0; i < std::size_t(D); ++i) {
        IntegerPlane<D> low{};
        low[i] = -1;
        low[std::size_t(D)] = lo[i];
        IntegerPlane<D> high{};
        high[i] = 1;
        high[std::size_t(D)] = -hi[i];
        h.planes.push_back(low);
        h.planes.push_back(high);
    }
    return h;
}

/// Boxes, simplices, half-spaces, slabs, wedges, cones and whatever a few random planes give; bounded ones on request.
template <int D>
HalfSpaces<D> random_convex(Dice& dice, bool bounded) {
    std::array<int, std::size_t(D)> lo{};
    std::array<int, std::size_t(D)> hi{};
    for (std::size_t i = 0; i < std::size_t(D); ++i) {
        lo[i] = dice.between(-3, 2);
        hi[i] = lo[i] + dice.between(1, 3);
    }
    HalfSpaces<D> h;
    const int kind = dice.below(4);
    if (bounded || kind == 0) h = integer_box<D>(lo, hi);
    const int more = kind == 0 ? 0 : dice.between(bounded ? 0 : 1, D + 1);
    for (int n = 0; n < more; ++n) {
        IntegerPlane<D> p{};
        bool zero = true;
        while (zero) {
            for (std::size_t i = 0; i < std::size_t(D); ++i) {
                p[i] = dice.between(-1, 1);
                zero = zero && p[i] == 0;
            }
        }
        p[std::size_t(D)] = dice.between(-3, 3);
        h.planes.push_back(p);
    }
    return h;
}

template <int D>
cleave::PlaneId intern(cleave::Kernel<D>& kernel, const IntegerPlane<D>& p) {
    typename cleave::PlaneTable<D>::Coefficients c;
    for (std::size_t i = 0; i <= std::size_t(D); ++i) c[i] = cleave::Integer(p[i]);
    return kernel.planes.intern(c);
}

/// A chain of the cuts that bound the set, none of them superfluous.
template <int D>
cleave::PlaneTree<cleave::PlaneId> tree_of(cleave::PolytopeClip<D>& model, const HalfSpaces<D>& set) {
    std::vector<cleave::PlaneId> cuts;
    cleave::Polytope cell = model.universe();
    for (const IntegerPlane<D>& p : set.planes) {
        const cleave::PlaneId h = intern(model.kernel(), p);
        auto s = model.split_cell(h, cell);
        if (s.side == cleave::FacetSide::plus) return cleave::PlaneTree<cleave::PlaneId>(false);
        if (s.side == cleave::FacetSide::minus) continue;
        cuts.push_back(h);
        cell = std::move(*s.minus);
    }
    cleave::PlaneTree<cleave::PlaneId> tree(true);
    for (std::size_t i = cuts.size(); i-- > 0;)
        tree = cleave::PlaneTree<cleave::PlaneId>(cuts[i], std::move(tree), cleave::PlaneTree<cleave::PlaneId>(false));
    return tree;
}

/// A point off all planes of small integer coefficients: coordinates with large different prime denominators.
template <int D>
struct GenericPoint {
    std::array<std::int64_t, std::size_t(D) + 1> homogeneous{};

    static GenericPoint random(Dice& dice, int range) {
        constexpr std::array<std::int64_t, 5> primes{10007, 10009, 10037, 10039, 10061};
        GenericPoint p;
        std::int64_t weight = 1;
        for (std::size_t i = 0; i < std::size_t(D); ++i) weight *= i < 3 ? primes[i] : 1;
        for (std::size_t i = 0; i < std::size_t(D); ++i) {
            const std::int64_t denominator = primes[i % 3];
            std::int64_t numerator = 0;
            while (numerator % denominator == 0)
                numerator = std::int64_t(dice.between(-range, range)) * denominator + dice.between(1, 10000);
            p.homogeneous[i] = numerator * (weight / denominator);
        }
        p.homogeneous[std::size_t(D)] = weight;
        return p;
    }

    /// The sign of n . x + c.
    [[nodiscard]] int side(const IntegerPlane<D>& h) const {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i <= std::size_t(D); ++i) sum += h[i] * homogeneous[i];
        return sum < 0 ? -1 : (sum > 0 ? 1 : 0);
    }

    /// -1 outside, 1 inside, 0 on one of the planes.
    [[nodiscard]] int in(const HalfSpaces<D>& set) const {
        int where = 1;
        for (const IntegerPlane<D>& h : set.planes) {
            const int s = side(h);
            if (s == 0) return 0;
            if (s > 0) where = -1;
        }
        return where;
    }

    cleave::PointId add_to(cleave::Kernel<D>& kernel) const {
        cleave::Homogeneous<D> x;
        for (std::size_t i = 0; i <= std::size_t(D); ++i) x[i] = cleave::Integer(homogeneous[i]);
        return kernel.add_point(x);
    }
};

}  // namespace support

#endif
