// SPDX-License-Identifier: Apache-2.0
// One dimension: sets of times. The same operators as for solids; a set may be unbounded.
#include <cleave.hpp>
#include <iostream>

using namespace cleave;

namespace {

void print(const char* what, const Region<1>& set) {
    std::cout << what << ": ";
    if (const auto length = measure(set))
        std::cout << *length << " hours";
    else
        std::cout << "without end";
    std::cout << ", " << set.face_count() << " ends\n";
}

}  // namespace

int main() {
    // [intervals]
    const Region<1> open = intervals<Rational>({{8, 12}, {13, 18}});
    const Region<1> meeting = intervals<Rational>({{Rational(35, 3), Rational(40, 3)}});  // 11:40 to 13:20
    const Region<1> free = open - meeting;
    const Region<1> closed = ~open;
    // [/intervals]
    print("open", open);
    print("free", free);
    print("closed", closed);
    print("closed by day", closed & intervals<Rational>({{0, 24}}));
    return 0;
}
