// SPDX-License-Identifier: Apache-2.0
// A small program of a project that uses cleave: two cubes that overlap in a unit cube.
#include <cleave.hpp>

int main() {
    const cleave::Region<3> a = cleave::box<3>({0, 0, 0}, {2, 2, 2});
    const cleave::Region<3> b = cleave::box<3>({1, 1, 1}, {3, 3, 3});
    return *cleave::measure(a | b) == 15 ? 0 : 1;
}
