// SPDX-License-Identifier: Apache-2.0
// Meshes from files, a Boolean, a mesh to a file:
//
//     mesh_boolean A.off B.off UNION.off
//
// Without arguments it makes two meshes first.
#include <cleave.hpp>
#include <exception>
#include <iostream>
#include <string>

using namespace cleave;

namespace {

// [files]
void unite(const std::string& first, const std::string& second, const std::string& output) {
    const Region<3> a = to_region(read_mesh(first));
    const Region<3> b = to_region(read_mesh(second));
    const Region<3> both = a | b;
    write_mesh(output, to_mesh(both));
}
// [/files]

void make_operands() {
    write_mesh("tower.off", to_mesh(box<3>({-1, -1, 0}, {1, 1, 5})));
    write_mesh("dome.off", to_mesh(sphere<Rational>({0, 0, 4}, 2)));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc != 1 && argc != 4) {
            std::cerr << "usage: mesh_boolean A.off B.off UNION.off\n";
            return 2;
        }
        if (argc == 1) make_operands();
        const std::string output = argc == 1 ? "union.off" : argv[3];
        unite(argc == 1 ? "tower.off" : argv[1], argc == 1 ? "dome.off" : argv[2], output);
        // What was written is closed: it can be an operand again.
        const Mesh mesh = read_mesh(output);
        std::cout << output << ": " << mesh.point_count() << " points, " << mesh.face_count() << " triangles, volume "
                  << measure_digits(to_region(mesh), 15).value() << '\n';
        return 0;
    } catch (const Error& error) {  // says which file, which line or face, and what to do
        std::cerr << error.what() << '\n';
        return 1;
    }
}
