// SPDX-License-Identifier: Apache-2.0
// The boundary filter over rings of integers against regions.
#include <cleave/setop/boundary_filter.hpp>

#include "support/backends.hpp"
#include "support/number_agreement.hpp"

#include <cleave/number/fixed_int.hpp>

using Rings =
    backends::Join<std::tuple<cleave::Integer, cleave::FixedInt<512>>, backends::GmpRings, backends::BoostRings>;

TEMPLATE_LIST_TEST_CASE("agreement: rings of integers give the measure that regions have", "", Rings) {
    support::law_of_agreement<1, TestType>(60);
    support::law_of_agreement<2, TestType>(40);
    support::law_of_agreement<3, TestType>(30);
}
