// SPDX-License-Identifier: Apache-2.0
/// Every number that the library knows on this machine, as type lists for TEMPLATE_LIST_TEST_CASE.
#ifndef CLEAVE_TESTS_SUPPORT_BACKENDS_HPP
#define CLEAVE_TESTS_SUPPORT_BACKENDS_HPP

#include "support/archetype.hpp"

#include <cleave/number/builtin.hpp>
#if defined(CLEAVE_HAS_GMP)
#include <cleave/number/gmp.hpp>
#endif
#if defined(CLEAVE_HAS_BOOST)
#include <cleave/number/boost_cpp.hpp>
#if defined(CLEAVE_HAS_GMP)
#include <cleave/number/boost_gmp.hpp>
#endif
#endif

#include <tuple>
#include <utility>

namespace backends {

template <class... Lists>
using Join = decltype(std::tuple_cat(std::declval<Lists>()...));

using OwnRings = std::tuple<cleave::Integer, cleave::FixedInt<2048>, archetype::Ring>;
using OwnFields = std::tuple<archetype::Field>;

#if defined(CLEAVE_HAS_GMP)
using GmpRings = std::tuple<mpz_class>;
using GmpFields = std::tuple<mpq_class>;
#else
using GmpRings = std::tuple<>;
using GmpFields = std::tuple<>;
#endif

#if defined(CLEAVE_HAS_BOOST)
using BoostRings = std::tuple<boost::multiprecision::cpp_int>;
using BoostFields = std::tuple<boost::multiprecision::cpp_rational>;
#else
using BoostRings = std::tuple<>;
using BoostFields = std::tuple<>;
#endif

#if defined(CLEAVE_HAS_BOOST) && defined(CLEAVE_HAS_GMP)
using BoostGmpRings = std::tuple<boost::multiprecision::mpz_int>;
using BoostGmpFields = std::tuple<boost::multiprecision::mpq_rational>;
#else
using BoostGmpRings = std::tuple<>;
using BoostGmpFields = std::tuple<>;
#endif

/// Numbers without division. All but FixedInt<2048> have no limit.
using Rings = Join<OwnRings, GmpRings, BoostRings, BoostGmpRings>;

/// Numbers with division.
using Fields = Join<OwnFields, GmpFields, BoostFields, BoostGmpFields>;

/// All of them.
using Numbers = Join<Rings, Fields>;

}  // namespace backends

#endif
