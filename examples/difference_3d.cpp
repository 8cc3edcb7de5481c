// SPDX-License-Identifier: Apache-2.0
// A difference of solids, with everything that floating point gets wrong: faces that coincide, edges that touch, a wall
// of no thickness. Then a chain: results are operands, and numbers do not grow.
#include <cleave.hpp>
#include <iostream>

using namespace cleave;

int main() {
    // [difference]
    const Region<3> block = box<3>({0, 0, 0}, {6, 4, 2});
    const Region<3> slot = box<3>({1, 1, 0}, {2, 3, 2});   // its ends lie in the block's faces
    const Region<3> notch = box<3>({2, 3, 1}, {5, 4, 2});  // touches the slot in an edge
    const Region<3> drill = prism(disc<Rational>({4, 2}, 1), Rational(1, 3), 2);
    const Region<3> part = block - slot - notch - drill;
    std::cout << "volume " << *measure(part) << " = " << measure_digits(part, 20).value() << '\n';
    // [/difference]

    std::cout << "block minus itself is empty: " << std::boolalpha << (block - block).is_empty() << '\n';
    std::cout << "put together again, it is the block: " << ((part | slot | notch | drill) ^ block).is_empty() << '\n';

    // A slice is cut off and put back, a hundred times.
    Region<3> chain = part;
    for (int i = 0; i < 100; ++i) {
        const Region<3> slice = box<3>({Rational(i, 100), 0, 0}, {Rational(i + 1, 100), 4, 2});
        chain = (chain - slice) | (part & slice);
    }
    std::cout << "after 300 more operations nothing has changed: " << (chain ^ part).is_empty() << '\n';

    write_mesh("part.off", to_mesh(part));
    const Mesh mesh = read_mesh("part.off");
    std::cout << "part.off: " << mesh.point_count() << " points, " << mesh.face_count()
              << " triangles, closed: " << validate(mesh).is_closed() << '\n';
    return 0;
}
