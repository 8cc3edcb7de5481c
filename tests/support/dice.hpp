// SPDX-License-Identifier: Apache-2.0
/// Random numbers for tests that count cases instead of shrinking them.
#ifndef CLEAVE_TESTS_SUPPORT_DICE_HPP
#define CLEAVE_TESTS_SUPPORT_DICE_HPP

#include <random>

namespace support {

/// The same stream on every machine.
class Dice {
public:
    explicit Dice(unsigned seed) : random_(seed) {}
    /// 0 .. n - 1.
    int below(int n) { return int(random_() % unsigned(n)); }
    /// lo .. hi.
    int between(int lo, int hi) { return lo + below(hi - lo + 1); }

private:
    std::mt19937 random_;
};

}  // namespace support

#endif
