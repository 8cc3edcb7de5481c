// SPDX-License-Identifier: Apache-2.0
// The same operation by one thread and by several: the same bytes.
#include <cleave.hpp>

#include <iostream>
using namespace cleave;

int main() {
    const Mesh first = to_mesh(sphere<Rational>({0, 0, 0}, 2, {96, 48}));
    const Mesh second = to_mesh(sphere<Rational>({1, Rational(1, 3), Rational(1, 2)}, 2, {96, 48}));

    const Mesh alone = to_mesh(to_region(first) | to_region(second));
    // [threads]
    const ThreadPool pool;  // as many threads as the machine offers; or TbbExecutor, or an executor of your own
    ToRegionOptions reading;
    reading.executor = pool;
    OperationOptions operating;
    operating.executor = pool;
    const Region<3> a = to_region(first, reading);
    const Region<3> b = to_region(second, reading);
    const Mesh together = to_mesh(union_(a, b, operating), {pool});
    // [/threads]
    std::cout << first.face_count() << " and " << second.face_count() << " triangles\n";
    std::cout << (together == alone ? "the same mesh, to the last bit\n" : "another mesh\n");
    return together == alone ? 0 : 1;
}
