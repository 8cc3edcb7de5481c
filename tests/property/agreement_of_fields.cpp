// SPDX-License-Identifier: Apache-2.0
// The boundary filter over fields of fractions against regions.
#include <cleave/setop/boundary_filter.hpp>

#include "support/backends.hpp"
#include "support/number_agreement.hpp"

using Fields = backends::Join<backends::GmpFields, backends::BoostFields>;

TEMPLATE_LIST_TEST_CASE("agreement: fields of fractions give the measure that regions have", "", Fields) {
    support::law_of_agreement<1, TestType>(60);
    support::law_of_agreement<2, TestType>(40);
    support::law_of_agreement<3, TestType>(30);
}
