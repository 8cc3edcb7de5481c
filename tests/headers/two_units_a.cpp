// SPDX-License-Identifier: Apache-2.0
// One of two translation units that include everything: they link only if every function is inline or a template.
#include <cleave.hpp>

#include <string>

std::string version_seen_by_the_other_unit();

int main() {
    return version_seen_by_the_other_unit() == CLEAVE_VERSION_STRING ? 0 : 1;
}
