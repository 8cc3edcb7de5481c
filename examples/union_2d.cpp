// SPDX-License-Identifier: Apache-2.0
// The union of two polygons: the set itself, its area a fraction.
// [operations]
#include <cleave.hpp>
#include <iostream>
using namespace cleave;

int main() {
    const Region<2> a = polygon<Rational>({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    const Region<2> b = polygon<Rational>({{3, 1}, {7, 2}, {3, 5}});
    const Region<2> c = a | b;  // also & - ^ and ~, the complement
    std::cout << "area " << *measure(c) << ", in common " << *measure(a & b) << '\n';
    return *measure(c) + *measure(a & b) == *measure(a) + *measure(b) ? 0 : 1;  // exactly
}
// [/operations]
