// SPDX-License-Identifier: Apache-2.0
// The least program of a project that uses cleave. Returns 0 if the library works.
#include <cleave.hpp>

int main() {
    return cleave::apply(cleave::Operation::difference, true, false) ? 0 : 1;
}
