// SPDX-License-Identifier: Apache-2.0
// The other translation unit.
#include <cleave.hpp>

#include <string>

std::string version_seen_by_the_other_unit();

std::string version_seen_by_the_other_unit() {
    return CLEAVE_VERSION_STRING;
}
